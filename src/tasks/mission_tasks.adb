--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;    use Ada.Real_Time;
with Command_Lines;
with Commands;
with Journal;
with Missions;         use Missions;
with Missions.Arenas;
with Missions.Grounds;
with Missions.Requests;
with Missions.Runs;    use Missions.Runs;
with Monitor.Mailboxes;
with Monitor.Notices;
with Monitor.Outbox;
with Monitor.Protocol;
with Options;
with Process.Threads;
with Robot.Line;
with Robot.Requests;
with Robot.Service;
with Trace;
with Vision.State;

package body Mission_Tasks with SPARK_Mode is

   type Mission is record
      Order : Commands.Order;
      --  that has asked for it: answered, its number is the mission's
      Begun : Missions.Grounds.Ground;
      Map   : Missions.Arenas.Map;
      Run   : Missions.Runs.Run;
   end record;

   type Report is record
      Leg     : Point_Count := 0;
      At_Time : Time := Time_First;
   end record;
   --  What the monitor has been told last, and when; Leg 0: nothing yet

   procedure Get_Ground (G : out Missions.Grounds.Ground) is
   begin
      Robot.Line.Grant.Get_Status (G.Line);
      Vision.State.Store.Get (G.View);
      Vision.State.Store.Get_Sighting (G.Seen);
      G.Now := Clock;
   end Get_Ground;

   procedure Tell_Progress (M : Mission; Now : Time; Last : in out Report) is
      --  At each new leg, and once a second
   begin
      if Leg (M.Run) /= Last.Leg
        or else Now >= Last.At_Time + Schedule.Progress_Interval
      then
         Last := (Leg (M.Run), Now);
         Monitor.Outbox.Put
           ((Kind   => Monitor.Mailboxes.Progress,
             Line   => Monitor.Notices.Progress_Line
               (Leg (M.Run), Legs (M.Run),
                Natural (Micrometres'Max (0, Distance (M.Run)) / 1_000)),
             Number => M.Order.Number,
             others => <>));
      end if;
   end Tell_Progress;

   procedure Drive (M : in out Mission)
   with
     Pre  => not M.Order.Owed and then Missions.Arenas.Is_Usable (M.Map),
     Post => not M.Order.Owed and then Has_Ended (M.Run)
   is
      --  Until the mission has ended
      Base     : constant Time := M.Begun.Now;
      Ground   : Missions.Grounds.Ground;
      Told     : Report;
      Is_Over  : Boolean;
      By_Hand  : Boolean;
      Why      : Ending;
      Next     : Action;
      Result   : Commands.Outcome;
      Was_Turn : Boolean;
      Now      : Missions.Microseconds;
      Due      : Missions.Microseconds;
   begin
      loop
         pragma Loop_Invariant
           (not M.Order.Owed and then Missions.Arenas.Is_Usable (M.Map));
         Get_Ground (Ground);
         Robot.Line.Grant.Get_Rights (M.Order.Number, Is_Over, By_Hand);
         Why := Missions.Grounds.Ended_By (M.Begun, Ground, Is_Over, By_Hand);
         if Why /= Completed then
            End_By (M.Run, Why);
         end if;
         See
           (M.Run, Missions.Grounds.Seen_From (Base, M.Map, Ground));
         Now := Missions.Grounds.Since (Base, Ground.Now);
         Step (M.Run, Now, Next);
         exit when Next.Kind = Leave;
         if not Has_Ended (M.Run) then
            Tell_Progress (M, Ground.Now, Told);
         end if;
         if Next.Kind in Ask | Order | Stop then
            Robot.Line.Ask (Robot.Requests.Mission, Next.Request, M.Order);
            loop
               pragma Loop_Invariant
                 (not M.Order.Owed and then Missions.Arenas.Is_Usable (M.Map));
               Robot.Line.Mission.Wait_In_Job (Trace.Line);
               Robot.Service.Serve (Schedule.Th_Mission, Result, Was_Turn);
               exit when Was_Turn;
            end loop;
            Ground.Now := Clock;
            Now := Missions.Grounds.Since (Base, Ground.Now);
            Tell (M.Run, Result, Now);
         end if;
         Due := Next_Look (M.Run, Now);
         Vision.State.Wait_Sighting
           (Missions.Grounds.Next_Time (Base, Ground.Now, Due));
      end loop;
   end Drive;

   procedure Carry_Out (M : in out Mission; Wanted : Path)
   with
     Pre  => M.Order.Owed,
     Post => not M.Order.Owed
   is
      --  Answers the order, and drives to Wanted where that is possible.
      --  Before the monitor learns of a refusal or of the end, there is room
      --  for the next mission
      Size     : constant Arena_Size :=
        Command_Lines.Given.Chosen.Arena_Size;
      Outbox   : Monitor.Mailboxes.Status;
      Is_Over  : Boolean;
      Ignored  : Boolean;
      Targets  : Place_Array;
      Possible : Boolean;
      Why      : Refusal;
   begin
      Monitor.Outbox.Get (Outbox);
      Robot.Line.Grant.Get_Rights (M.Order.Number, Is_Over, Ignored);
      if Outbox.End_Waits or else Is_Over or else Wanted.Count = 0 then
         --  a later session is not told why
         Missions.Requests.Place.Release;
         Monitor.Outbox.Answer (M.Order, Monitor.Protocol.Refused);
         return;
      end if;
      Get_Ground (M.Begun);
      Missions.Grounds.Check
        (M.Begun, Wanted, Size, M.Map, Targets, Possible, Why);
      if not Possible then
         Missions.Requests.Place.Release;
         Monitor.Outbox.Answer (M.Order, Monitor.Protocol.Not_Done);
         Monitor.Outbox.Put
           (Monitor.Mailboxes.Told (Monitor.Notices.Text_Of (Why)));
         return;
      end if;
      Monitor.Outbox.Answer (M.Order, Monitor.Protocol.Acknowledged);
      Missions.Runs.Start
        (M.Run, Size, Targets, Wanted.Count, Missions.Grounds.Lead);
      Journal.Put (Options.Info, "mission begins");
      Vision.State.Store.Watch (True);
      Drive (M);
      Vision.State.Store.Watch (False);
      Missions.Requests.Place.Release;
      Monitor.Outbox.Put
        ((Kind   => Monitor.Mailboxes.Ending,
          Line   => Monitor.Notices.End_Line
             (Ended_By (M.Run), Measured (M.Run)),
          Number => M.Order.Number,
          others => <>));
      Journal.Put
        (Options.Info,
         "mission ended: "
         & Monitor.Notices.Text_Of (Ended_By (M.Run), Measured (M.Run)));
   end Carry_Out;

   task body Th_Mission is
      Current : Mission;
      Wanted  : Path;
   begin
      Process.Threads.Name_Task (Schedule.Th_Mission);
      loop
         pragma Loop_Invariant (not Current.Order.Owed);
         Missions.Requests.Wait (Current.Order, Wanted);
         Carry_Out (Current, Wanted);
      end loop;
   end Th_Mission;

end Mission_Tasks;
