--  SPDX-License-Identifier: GPL-3.0-or-later
--  The call of the console's streams: returns what the system says, and
--  decides nothing.

private package Console.Calls with
  SPARK_Mode,
  Abstract_State =>
    (Streams with
       Synchronous, External => (Async_Readers, Async_Writers),
       Part_Of => Terminal),
  Initializes => Streams
is
   pragma Elaborate_Body;
   --  Opens closed standard streams. Otherwise a socket or the serial line
   --  could get their descriptors, and receive the log

   subtype Outcome is Integer range -Integer'Last .. Integer'Last;
   --  What a call returns, or, if it fails, its error (errno), negative

   Interrupted : constant Outcome := -4;  --  EINTR

   type Stream is (Standard_Output, Standard_Error);

   procedure Write (To : Stream; Text : String; Result : out Outcome)
   with
     Global => (In_Out => Streams),
     Post   => Result <= Text'Length;
   --  Result: how many characters have been accepted

end Console.Calls;
