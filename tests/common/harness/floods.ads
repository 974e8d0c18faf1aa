--  SPDX-License-Identifier: GPL-3.0-or-later
--  Floods of connections: several senders, each with its own address and many
--  connections at a time; or many connections from one address at once.

private with Ada.Finalization;
private with GNAT.Sockets;

package Floods is

   type Flood is tagged limited private;
   --  Ends at the end of its scope

   type Manner is
     (Patient,    --  reconnects after the server's message
      Restless,   --  sends a wrong line and reconnects at once
      Slow);      --  sends its first line byte by byte

   procedure Start
     (Object : in out Flood; Port : Positive; How : Manner := Patient);
   --  Against a supervisor that listens on 127.0.0.1

   function Served (Object : Flood) return Natural;
   --  Connections that were sent a message, or closed

   procedure Stop (Object : in out Flood);

   function Address (Number : Positive) return String;
   --  Of a sender

   Senders : constant := 4;

   type Crowd (Count : Positive) is tagged limited private;
   --  Ends at the end of its scope

   procedure Come (Object : in out Crowd; Port : Positive; Own : String);
   --  Connections with noise, from the address Own: half of them stay open,
   --  the others are closed at once

private

   type Progress is limited record
      Served : Natural := 0 with Atomic;
      Over   : Boolean := False with Atomic;
   end record;

   task type Sender
     (Number : Positive;
      Port   : Positive;
      How    : Manner;
      Seen   : not null access Progress)
   is
      pragma Storage_Size (512 * 1024);
   end Sender;

   type Sender_Access is access Sender;

   type Progress_Array is array (1 .. Senders) of aliased Progress;
   type Sender_Array is array (1 .. Senders) of Sender_Access;

   type Flood is new Ada.Finalization.Limited_Controlled with record
      Seen  : Progress_Array;
      Tasks : Sender_Array;
   end record;

   overriding procedure Finalize (Object : in out Flood) renames Stop;

   type Socket_Array is array (Positive range <>) of GNAT.Sockets.Socket_Type;

   type Crowd (Count : Positive) is
     new Ada.Finalization.Limited_Controlled with record
      Sockets : Socket_Array (1 .. Count) :=
        (others => GNAT.Sockets.No_Socket);
   end record;

   overriding procedure Finalize (Object : in out Crowd);

end Floods;
