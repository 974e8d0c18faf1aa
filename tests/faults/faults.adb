--  SPDX-License-Identifier: GPL-3.0-or-later
--  The list of the faults.

with Ada.Containers.Vectors;

package body Faults is

   package Fault_Vectors is new Ada.Containers.Vectors
     (Positive, Fault_Access);

   List : Fault_Vectors.Vector;

   type Plain is new Fault with record
      Injecting, Lifting : World_Action;
      Preparing          : Plan_Action;
   end record;

   overriding procedure Prepare (F : Plain; P : in out Plan);
   overriding procedure Inject (F : in out Plain; W : in out World);
   overriding procedure Lift (F : in out Plain; W : in out World);

   overriding procedure Prepare (F : Plain; P : in out Plan) is
   begin
      if F.Preparing /= null then
         F.Preparing (P);
      end if;
   end Prepare;

   overriding procedure Inject (F : in out Plain; W : in out World) is
   begin
      F.Injecting (W);
   end Inject;

   overriding procedure Lift (F : in out Plain; W : in out World) is
   begin
      if F.Lifting /= null then
         F.Lifting (W);
      end if;
   end Lift;

   procedure Add
     (Group  : Group_Kind;
      Name   : String;
      F      : not null Fault_Access;
      Cost   : Duration    := 1.0;
      Ends   : Consequence := Nothing;
      Robot  : Robot_Need  := Any_Robot;
      Camera : Camera_Need := Any_Camera;
      Heavy  : Boolean     := False;
      Alone  : Boolean     := False) is
   begin
      F.Group := Group;
      F.Name := To_Unbounded_String (Name);
      F.Cost := Cost;
      F.Ends := Ends;
      F.Robot := Robot;
      F.Camera := Camera;
      F.Heavy := Heavy;
      F.Alone := Alone;
      List.Append (F);
   end Add;

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
      Alone   : Boolean      := False) is
   begin
      Add (Group, Name, new Plain'(Injecting => Inject,
                                   Lifting   => Lift,
                                   Preparing => Prepare,
                                   others    => <>),
           Cost, Ends, Robot, Camera, Heavy, Alone);
   end Add;

   function Count return Natural is (Natural (List.Length));

   function Element (Number : Positive) return not null Fault_Access is
     (List.Element (Number));

   function Go_Together (A, B : Fault'Class) return Boolean is
      First  : Plan;
      Second : Plan;

      function Both_Set (Left, Right : Unbounded_String) return Boolean is
        (Left /= Null_Unbounded_String
         and then Right /= Null_Unbounded_String);
   begin
      A.Prepare (First);
      B.Prepare (Second);
      --  two faults that change the start need different worlds, there is one
      --  link to cut, and nothing can follow the supervisor's end
      return A.Name /= B.Name
        and then not A.Alone
        and then not B.Alone
        and then A.Ends /= Supervisor_Ends
        and then not (First.Through_Link and then Second.Through_Link)
        and then not Both_Set (First.Launcher, Second.Launcher)
        and then not Both_Set (First.Program, Second.Program)
        and then not Both_Set (First.Camera, Second.Camera)
        and then not Both_Set
          (First.Emulator_Options, Second.Emulator_Options)
        and then not (A.Camera = Camera_Streaming
                      and then B.Camera = No_Camera)
        and then not (A.Camera = No_Camera
                      and then B.Camera = Camera_Streaming);
   end Go_Together;

end Faults;
