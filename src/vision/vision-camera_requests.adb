--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Vision.Camera_Requests with SPARK_Mode is

   package Asked is new Event;
   package Answered is new Event;
   package Images_Begin is new Event;

   protected body Requests is

      procedure Open is
      begin
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

      procedure Collect (Success : out Boolean) is
      begin
         Success := Opened;
      end Collect;

      procedure Released is
      begin
         Held := False;
      end Released;

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

   procedure Report (Success : Boolean) is
   begin
      Requests.Report (Success);
      Trace.Release (Schedule.Th_Camera_Control);
      Answered.Set;
   end Report;

   procedure Begin_Images is
   begin
      Trace.Release (Schedule.Th_Capture_Img);
      Images_Begin.Set;
   end Begin_Images;

   procedure Wait_Images is
   begin
      Trace.Done (Schedule.Th_Capture_Img);
      Images_Begin.Wait;
   end Wait_Images;

end Vision.Camera_Requests;
