--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a fault is, and the list of them all.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Worlds;                use Worlds;

package Faults is

   type Group_Kind is (Network, Robot, Camera, Machine);

   type Consequence is
     (Nothing,             --  the session goes on, every command answered
      Session_May_End,     --  either way is right
      Session_Ends,        --  it does, and the supervisor finds it in time
      Supervisor_Ends);    --  with the status that Inject has announced

   type Robot_Need is (Any_Robot, Robot_Started, Robot_Moving);
   type Camera_Need is (Any_Camera, Camera_Streaming, No_Camera);

   type Fault is abstract tagged limited record
      Group  : Group_Kind := Network;
      Name   : Unbounded_String;
      --  as in the table, such as "stall of 5 s"
      Ends   : Consequence := Nothing;
      Robot  : Robot_Need := Any_Robot;
      Camera : Camera_Need := Any_Camera;
      --  what the session must have when the fault comes
      Cost   : Duration := 1.0;
      --  about how long Inject and Lift take: the long ones are begun first
      Heavy  : Boolean := False;
      --  it takes a processor: no more than two at the same time
      Alone  : Boolean := False;
      --  it is not combined with others
   end record;

   procedure Prepare (F : Fault; P : in out Plan) is null;
   --  How the programs have to be started for it

   procedure Inject (F : in out Fault; W : in out World) is abstract;
   --  At a random moment of a session. Whatever it draws comes from
   --  W.Source. It says in W what the checks must know, such as Lose,
   --  Supervisor_Ends, Line_Works. In a pair the monitor may be absent
   --  (W.Present) and another fault under way. Raises Failed where what it
   --  demands itself does not happen, Skipped where this machine does not
   --  allow it.

   procedure Lift (F : in out Fault; W : in out World) is null;
   --  Takes it away again: the checks begin afterwards. Called even where
   --  Inject failed.

   type Fault_Access is access all Fault'Class;

   procedure Add (F : not null Fault_Access);

   function Count return Natural;

   function Element (Number : Positive) return not null Fault_Access;

   function Go_Together (A, B : Fault'Class) return Boolean;
   --  A first, then B

end Faults;
