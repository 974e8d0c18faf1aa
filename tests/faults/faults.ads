--  SPDX-License-Identifier: GPL-3.0-or-later
--  The type of a fault, and the list of all.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Worlds;                use Worlds;

package Faults is

   type Group_Kind is (Network, Robot, Camera, Machine);

   type Consequence is
     (Nothing,             --  the session continues, every command is answered
      Session_May_End,     --  both are right
      Session_Ends,        --  it ends, and the supervisor detects it in time
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
      --  required state of the session when the fault comes
      Cost   : Duration := 1.0;
      --  approximate duration of Inject and Lift: long ones are started first
      Heavy  : Boolean := False;
      --  takes a processor: at most two at a time
      Alone  : Boolean := False;
      --  not combined with others
   end record;

   procedure Prepare (F : Fault; P : in out Plan) is null;
   --  How the programs must be started for it

   procedure Inject (F : in out Fault; W : in out World) is abstract;
   --  Injects it at a random time of a session. All random values come from
   --  W.Source. Sets in W what the checks must know, such as Lose,
   --  Supervisor_Ends, Line_Works. In a pair the monitor may be absent
   --  (W.Present) and another fault active. Raises Failed if its own
   --  requirements are not met, Skipped if this machine does not permit it.

   procedure Lift (F : in out Fault; W : in out World) is null;
   --  Removes it; the checks follow. Also called if Inject failed.

   type Fault_Access is access all Fault'Class;

   procedure Add
     (Group  : Group_Kind;
      Name   : String;
      F      : not null Fault_Access;
      Cost   : Duration    := 1.0;
      Ends   : Consequence := Nothing;
      Robot  : Robot_Need  := Any_Robot;
      Camera : Camera_Need := Any_Camera;
      Heavy  : Boolean     := False;
      Alone  : Boolean     := False);

   --  A fault that needs no more than procedures

   type World_Action is access procedure (W : in out World);
   type Plan_Action is access procedure (P : in out Plan);

   procedure Add
     (Group   : Group_Kind;
      Name    : String;
      Inject  : not null World_Action;
      Lift    : World_Action := null;
      Prepare : Plan_Action  := null;
      Cost    : Duration     := 1.0;
      Ends    : Consequence  := Nothing;
      Robot   : Robot_Need   := Any_Robot;
      Camera  : Camera_Need  := Any_Camera;
      Heavy   : Boolean      := False;
      Alone   : Boolean      := False);

   function Count return Natural;

   function Element (Number : Positive) return not null Fault_Access;

   function Go_Together (A, B : Fault'Class) return Boolean;
   --  First A, then B

end Faults;
