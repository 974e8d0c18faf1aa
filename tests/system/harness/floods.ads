--  SPDX-License-Identifier: GPL-3.0-or-later
--  Others who connect, as fast as they are seen to: several senders, each
--  with an address of its own and many connections at a time.

private with Ada.Finalization;

package Floods is

   type Flood is tagged limited private;
   --  Ends when it leaves its scope

   procedure Start (Object : in out Flood; Port : Positive);
   --  Of a supervisor on this machine

   function Served (Object : Flood) return Natural;
   --  How many of them it has told something, or closed

   procedure Stop (Object : in out Flood);

private

   Senders : constant := 4;

   type Sender;
   type Sender_Access is access Sender;
   type Sender_Array is array (1 .. Senders) of Sender_Access;

   protected type Progress is
      procedure Count_One;
      procedure Finish;
      function Count return Natural;
      function Is_Over return Boolean;
   private
      Counted : Natural := 0;
      Over    : Boolean := False;
   end Progress;

   task type Sender
     (Number : Positive; Port : Positive; Seen : not null access Progress)
   is
      pragma Storage_Size (512 * 1024);
   end Sender;

   type Flood is new Ada.Finalization.Limited_Controlled with record
      Seen  : aliased Progress;
      Tasks : Sender_Array;
   end record;

   overriding procedure Finalize (Object : in out Flood) renames Stop;

end Floods;
