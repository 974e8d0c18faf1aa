--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Vision.State with SPARK_Mode is

   use Vision.Mode;

   package Asked is new Event (Schedule.Th_Camera);
   package Answered is new Event (Schedule.Th_Camera_Control);
   package Images_Begin is new Event (Schedule.Th_Capture_Img);
   package Searched is new Event (Schedule.Th_Mission);

   procedure Apply
     (What    : Vision.Mode.Change;
      Number  : Ticket;
      Current : in out Vision.Mode.State;
      Done    : out Boolean;
      Arena   : Arena_Corners := No_Arena) is
   begin
      Done := Counts (Current, Number) and then Is_Possible (Current, What);
      if Done then
         Current := After (Current, What, Arena);
      end if;
   end Apply;

   protected body Store is

      procedure Begin_Session (First : Ticket) is
      begin
         Current := (First => First, others => <>);
      end Begin_Session;

      procedure Get (Now : out Vision.Mode.State) is
      begin
         Now := Current;
      end Get;

      procedure Change
        (What   : Vision.Mode.Change;
         Number : Ticket;
         Done   : out Boolean;
         Arena  : Arena_Corners := No_Arena) is
      begin
         Apply (What, Number, Current, Done, Arena);
      end Change;

      procedure Give_Up (Was_Open : out Boolean) is
      begin
         Was_Open := Is_Open (Current);
         Current := After (Current, Camera_Closed);
      end Give_Up;

      procedure Ask_Open
        (Number : Ticket; Needed : out Boolean; Is_Open : out Boolean) is
      begin
         Is_Open := Counts (Current, Number)
           and then Vision.Mode.Is_Open (Current);
         Apply (Open_Order, Number, Current, Needed);
         if Needed then
            Opener := Number;
            Pending := True;
         end if;
      end Ask_Open;

      procedure Take (Number : out Ticket; Found : out Boolean) is
      begin
         Found := Pending;
         Number := Opener;
         Pending := False;
         Held := Held or else Found;
      end Take;

      procedure Get_Wanted (Number : Ticket; Wanted : out Boolean) is
      begin
         Wanted := Current.Stage /= Closed and then Number = Opener;
      end Get_Wanted;

      procedure Report (Success : Boolean) is
      begin
         Outcome := Success;
      end Report;

      procedure Opened (Number : Ticket; Is_Open : out Boolean) is
         Done : Boolean;
      begin
         Apply
           ((if Outcome then Camera_Opened else Camera_Missing),
            Number, Current, Done);
         Is_Open := Done and then Outcome;
         Known := (others => <>);
      end Opened;

      procedure Released is
      begin
         Held := False;
      end Released;

      procedure Get_Idle (Idle : out Boolean) is
      begin
         Idle := not Held and then not Pending;
      end Get_Idle;

      procedure Put
        (Came    : Time;
         Robots  : Robot_Array;
         Count   : Robot_Count;
         Awaited : out Boolean) is
      begin
         Known := Vision.Following.Next (Known, Came, Robots, Count);
         Awaited := Watched;
      end Put;

      procedure Get_Sighting (Newest : out Vision.Following.Sighting) is
      begin
         Newest := Known;
      end Get_Sighting;

      procedure Watch (On : Boolean) is
      begin
         Watched := On;
      end Watch;

   end Store;

   procedure Open (Number : Ticket; Is_Open : out Boolean) is
      Needed : Boolean;
   begin
      Store.Ask_Open (Number, Needed, Is_Open);
      if Needed then
         Asked.Set;
         Answered.Wait_In_Job (Trace.Camera);
         Store.Opened (Number, Is_Open);
         if Is_Open then
            Images_Begin.Set;
         end if;
      end if;
   end Open;

   procedure Wait_Open (Number : out Ticket) is
      Found : Boolean;
   begin
      loop
         Store.Take (Number, Found);
         exit when Found;
         Asked.Wait;
      end loop;
   end Wait_Open;

   procedure Report (Success : Boolean) is
   begin
      Store.Report (Success);
      Answered.Set;
   end Report;

   procedure Wait_Images is
   begin
      Images_Begin.Wait;
   end Wait_Images;

   procedure Put (Came : Time; Robots : Robot_Array; Count : Robot_Count) is
      Awaited : Boolean;
   begin
      Store.Put (Came, Robots, Count, Awaited);
      if Awaited then
         Searched.Set;
      end if;
   end Put;

   procedure Wait_Sighting (Limit : Time) is
      Ignored : Boolean;
   begin
      Searched.Wait_Until (Limit, Ignored);
   end Wait_Sighting;

end Vision.State;
