--  SPDX-License-Identifier: GPL-3.0-or-later
--  Sends all of something, or raises Socket_Error.

with Ada.Streams;
with GNAT.Sockets;

package Whole_Sends is

   procedure Send
     (To : GNAT.Sockets.Socket_Type; Data : Ada.Streams.Stream_Element_Array);

   procedure Send (To : GNAT.Sockets.Socket_Type; Text : String);

end Whole_Sends;
