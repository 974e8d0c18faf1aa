--  SPDX-License-Identifier: GPL-3.0-or-later
--  A task that calls an object whose ceiling is below its priority.

with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Interfaces.C;                 use Interfaces.C;
with Schedule;
with System;

package body Violators is

   procedure Get_Parameters (Thread : int; Priority : System.Address)
   with Import, Convention => C, External_Name => "sched_getparam";

   protected Low with Priority => Schedule.Console_Priority is
      procedure Touch;
   private
      Touched : Boolean := False;
   end Low;

   protected High with Priority => Schedule.Stop_Priority is
      procedure Get_Priority (Value : out int);
   private
      Last : int := 0;
   end High;

   task Violator with Priority => Schedule.Move_Priority;

   Done          : Suspension_Object;
   Was_Raised    : Boolean := False with Atomic;
   High_Priority : int := 0 with Atomic;

   protected body High is
      procedure Get_Priority (Value : out int) is
      begin
         Get_Parameters (0, Last'Address);
         Value := Last;
      end Get_Priority;
   end High;

   protected body Low is
      procedure Touch is
      begin
         Touched := not Touched;
      end Touch;
   end Low;

   procedure Await (Raised : out Boolean; Inside : out Integer) is
   begin
      Suspend_Until_True (Done);
      Raised := Was_Raised;
      Inside := Integer (High_Priority);
   end Await;

   task body Violator is
      Value : int;
   begin
      begin
         Low.Touch;
      exception
         when Program_Error =>
            Was_Raised := True;
      end;
      High.Get_Priority (Value);
      High_Priority := Value;
      Set_True (Done);
      delay until Time_Last;  --  no task of this profile ends
   end Violator;

end Violators;
