--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Schedule;
with Trace;

package body Vision.Camera_Requests with SPARK_Mode is

   package Asked is new Event;
   package Answered is new Event;

   protected Requests with Priority => Schedule.Camera_Ceiling is
      procedure Open;
      procedure Close;
      procedure Get_Idle (Value : out Boolean);
      procedure Take (Number : out Request_Number; Found : out Boolean);
      procedure Get_Wanted (Number : Request_Number; Value : out Boolean);
      procedure Report (Success : Boolean);
      procedure Released;
      procedure Collect (Success : out Boolean);
   private
      Current : Request_Number := 0;
      Wanted  : Boolean := False;
      Pending : Boolean := False;
      --  requested, not yet accepted
      Held    : Boolean := False;
      --  the owner has accepted, and not closed the camera since
      Opened  : Boolean := False;
   end Requests;

   protected body Requests is

      procedure Open is
      begin
         --  earlier requests are withdrawn
         Current := Current + 1;
         Wanted := True;
         Pending := True;
      end Open;

      procedure Close is
      begin
         Wanted := False;
      end Close;

      procedure Get_Idle (Value : out Boolean) is
      begin
         Value := not Held and then not Pending;
      end Get_Idle;

      procedure Take (Number : out Request_Number; Found : out Boolean) is
      begin
         --  even if withdrawn: the task that asked waits for the outcome
         Found := Pending;
         Number := Current;
         Pending := False;
         Held := Held or else Found;
      end Take;

      procedure Get_Wanted (Number : Request_Number; Value : out Boolean) is
      begin
         Value := Wanted and then Number = Current;
      end Get_Wanted;

      procedure Report (Success : Boolean) is
      begin
         Opened := Success;
      end Report;

      procedure Released is
      begin
         Held := False;
      end Released;

      procedure Collect (Success : out Boolean) is
      begin
         Success := Opened;
      end Collect;

   end Requests;

   procedure Open (Success : out Boolean) is
   begin
      Requests.Open;
      Trace.Release (Schedule.Th_Camera);
      Asked.Set;
      Trace.Wait (Schedule.Th_Camera_Control, Trace.Camera);
      Answered.Wait;
      Trace.Resume (Schedule.Th_Camera_Control);
      Requests.Collect (Success);
   end Open;

   procedure Close is
   begin
      Requests.Close;
   end Close;

   procedure Get_Idle (Idle : out Boolean) is
   begin
      Requests.Get_Idle (Idle);
   end Get_Idle;

   procedure Wait_Open (Number : out Request_Number) is
      Found : Boolean;
   begin
      Trace.Done (Schedule.Th_Camera);
      loop
         Requests.Take (Number, Found);
         exit when Found;
         Trace.Idle (Schedule.Th_Camera);
         Asked.Wait;
      end loop;
      Trace.Start (Schedule.Th_Camera);
   end Wait_Open;

   procedure Get_Wanted (Number : Request_Number; Wanted : out Boolean) is
   begin
      Requests.Get_Wanted (Number, Wanted);
   end Get_Wanted;

   procedure Report (Success : Boolean) is
   begin
      Requests.Report (Success);
      Trace.Release (Schedule.Th_Camera_Control);
      Answered.Set;
   end Report;

   procedure Released is
   begin
      Requests.Released;
   end Released;

end Vision.Camera_Requests;
