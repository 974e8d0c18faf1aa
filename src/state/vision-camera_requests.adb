--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Vision.Camera_Demands decides.

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
      State  : Vision.Camera_Demands.State;
      Opened : Boolean := False;
   end Requests;

   protected body Requests is

      procedure Open is
      begin
         Vision.Camera_Demands.Ask (State);
      end Open;

      procedure Close is
      begin
         Vision.Camera_Demands.Withdraw (State);
      end Close;

      procedure Get_Idle (Value : out Boolean) is
      begin
         Value := Vision.Camera_Demands.Is_Idle (State);
      end Get_Idle;

      procedure Take (Number : out Request_Number; Found : out Boolean) is
      begin
         Vision.Camera_Demands.Take (State, Number, Found);
      end Take;

      procedure Get_Wanted (Number : Request_Number; Value : out Boolean) is
      begin
         Value := Vision.Camera_Demands.Is_Wanted (State, Number);
      end Get_Wanted;

      procedure Report (Success : Boolean) is
      begin
         Opened := Success;
      end Report;

      procedure Released is
      begin
         Vision.Camera_Demands.Release (State);
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
