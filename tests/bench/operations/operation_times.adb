--  SPDX-License-Identifier: GPL-3.0-or-later
--  Prints how long operations of the protected objects take, as a task sees
--  them, with the events that they set; with --trace, what they record, too.

with Ada.Command_Line;
with Ada.Containers.Generic_Array_Sort;
with Ada.Real_Time;  use Ada.Real_Time;
with Ada.Text_IO;    use Ada.Text_IO;
with GNAT.OS_Lib;

with Commands;
with Journal;
with Missions.Requests;
with Monitor.Mailboxes;
with Monitor.Outbox;
with Monitor.Protocol;
with Monitor.Session;
with Options;
with Process.Privileges;
pragma Unreferenced (Process.Privileges);  --  it has the wrapped geteuid
with Robot.Line;
with Robot.Line_Status;
with Robot.Requests;
with Schedule;
with Texts;
with Trace;
with Vision;
with Vision.Following;
with Vision.Mode;
with Vision.State;
with Vision.Turns;

procedure Operation_Times with Priority => Schedule.Camera_Control_Priority is

   Calls : constant := 20_000;

   type Line_Operation is (Put, Take, Finish);

   type Sample_Index is range 1 .. Calls;
   type Sample_Array is array (Sample_Index range <>) of Natural;

   procedure Sort is new Ada.Containers.Generic_Array_Sort
     (Sample_Index, Natural, Sample_Array);
   --  tests/common's Samples allocate, and are not made for this profile

   Samples : Sample_Array (Sample_Index);  --  in nanoseconds
   Sample  : Sample_Index := 1;
   Begun   : Time;

   Image : Monitor.Outbox.Message_Access :=
     new Monitor.Outbox.Message;
   Sent  : Monitor.Outbox.Message_Access :=
     new Monitor.Outbox.Message;

   procedure Start is
   begin
      Begun := Clock;
   end Start;

   procedure Stop is
   begin
      Samples (Sample) := (Clock - Begun) / Nanoseconds (1);
      if Sample < Sample_Index'Last then
         Sample := Sample + 1;
      end if;
   end Stop;

   procedure Report (Name : String) is
      Last : constant Sample_Index := Sample;
   begin
      Sort (Samples (1 .. Last));
      Put_Line (Name & (Name'Length + 1 .. 26 => ' ')
                & Integer'Image (Samples (Last / 2 + 1))
                & Integer'Image (Samples (Last - Last / 100))
                & Integer'Image (Samples (Last - Last / 1000))
                & Integer'Image (Samples (Last)));
      Sample := 1;
   end Report;

   Open   : Boolean;
   Outbox : Monitor.Mailboxes.Status;
   Next   : Monitor.Mailboxes.Item;
   Order  : Commands.Order;
   Status : Robot.Line_Status.Status;
   Job    : Robot.Requests.Job;
   Held   : Robot.Line_Status.Dialogue;
   Found  : Boolean;
   Due    : Time;
   Verdict : Robot.Requests.Verdict_Kind;
   View   : Vision.Mode.State;
   Stage  : Monitor.Session.Status;
   Wanted : Boolean;
   Path   : Missions.Path :=
     (Missions.Centimetres, Missions.Max_Points, others => <>);
   Robots : constant Vision.Robot_Array := (others => <>);
   Seen   : Vision.Following.Sighting;
   Text   : Texts.Text;

begin
   Put_Line ("nanoseconds: median, 99 %, 99.9 %, longest");
   for I in Sample_Index loop
      Start;
      for Turn in 1 .. 100 loop
         Trace.Put (Trace.Done, Schedule.Th_Move);
      end loop;
      Stop;
   end loop;
   Report ("100 Trace.Put, off");

   if Ada.Command_Line.Argument_Count = 1
     and then Ada.Command_Line.Argument (1) = "--trace"
   then
      Trace.Open (Texts.To_Text ("/dev/null"), Open, Text);
      for I in Sample_Index loop
         Start;
         for Turn in 1 .. 100 loop
            Trace.Put (Trace.Done, Schedule.Th_Move);
         end loop;
         Stop;
      end loop;
      Report ("100 Trace.Put, on");
   end if;

   Monitor.Outbox.Open_Session;
   for I in Sample_Index loop
      Start;
      Monitor.Outbox.Reserve (Order);
      Stop;
      Monitor.Outbox.Answer (Order, Monitor.Protocol.Acknowledged);
      Monitor.Outbox.Take (0, Time_First, Next, Sent);
   end loop;
   Report ("Monitor.Outbox.Reserve");

   for I in Sample_Index loop
      Monitor.Outbox.Reserve (Order);
      Start;
      Monitor.Outbox.Answer (Order, Monitor.Protocol.Acknowledged);
      Stop;
      Monitor.Outbox.Take (0, Time_First, Next, Sent);
   end loop;
   Report ("Monitor.Outbox.Answer");

   for I in Sample_Index loop
      Monitor.Outbox.Get (Outbox);
      Start;
      Monitor.Outbox.Put_Image (Image, Outbox.Made);
      Stop;
   end loop;
   Report ("Monitor.Outbox.Put_Image");

   for I in Sample_Index range 1 .. 5_000 loop
      Monitor.Outbox.Get (Outbox);
      Monitor.Outbox.Put_Image (Image, Outbox.Made);
      Start;
      Monitor.Outbox.Take (0, Time_First, Next, Sent);
      Stop;
   end loop;
   Report ("Monitor.Outbox.Take, an image");

   for Measured in Line_Operation loop
      for I in Sample_Index loop
         Order := (Number => Commands.Ticket (I),
                   Command => (Name => Commands.Go_Forward, others => <>),
                   Owed => True, others => <>);
         Job := (others => <>);
         Start;
         Robot.Line.Put (Order);
         if Measured = Put then
            Stop;
         end if;
         Start;
         Robot.Line.Grant.Take (Schedule.Th_Move, Job, Verdict, Held, Found);
         if Measured = Take then
            Stop;
         end if;
         Start;
         Robot.Line.Finish (Job, Held, (others => <>));
         if Measured = Finish then
            Stop;
         end if;
      end loop;
      Report ("Robot.Line." & Measured'Image);
   end loop;

   for I in Sample_Index loop
      Start;
      Robot.Line.Look (Robot.Requests.Keep_Alive, Due);
      Stop;
   end loop;
   Report ("Robot.Line.Look");

   for I in Sample_Index loop
      Start;
      Robot.Line.Grant.Get_Status (Status);
      Stop;
   end loop;
   Report ("Robot.Line.Get_Status");

   Order.Command := (Name => Commands.Open_Camera, others => <>);
   Order.Owed := True;
   for I in Sample_Index loop
      Start;
      Vision.Turns.Put (Order);
      Vision.Turns.Wait_Camera_Control (Order);
      Vision.Turns.Finish;
      Stop;
   end loop;
   Report ("Vision.Turns, all three");

   for I in Sample_Index loop
      Order.Owed := True;
      Start;
      Missions.Requests.Put (Order, Path);
      Stop;
      Missions.Requests.Wait (Order, Path);
      Missions.Requests.Place.Release;
   end loop;
   Report ("Missions.Requests.Put");

   for I in Sample_Index loop
      Start;
      Vision.State.Put (Time_First, Robots, 1);
      Stop;
   end loop;
   Report ("Vision.State.Put");

   for I in Sample_Index loop
      Start;
      Vision.State.Store.Get_Sighting (Seen);
      Stop;
   end loop;
   Report ("Vision.State.Store.Get_Sighting");

   for I in Sample_Index loop
      Start;
      Vision.State.Store.Get (View);
      Stop;
   end loop;
   Report ("Vision.State.Store.Get");

   for I in Sample_Index loop
      Start;
      Vision.State.Store.Get_Wanted (0, Wanted);
      Stop;
   end loop;
   Report ("Vision.State.Store.Get_Wanted");

   for I in Sample_Index loop
      Start;
      Monitor.Session.State.Get (Stage);
      Stop;
   end loop;
   Report ("Monitor.Session.Get");

   Texts.Set (Text, "received RMOV:-12345");
   for I in Sample_Index loop
      Start;
      Journal.Put (Options.Debug, Texts.Image (Text));
      Stop;
   end loop;
   Report ("Journal.Put, not kept");

   for I in Sample_Index range 1 .. 256 loop
      Start;
      Journal.Put (Options.Info, Texts.Image (Text));
      Stop;
   end loop;
   Report ("Journal.Put, kept");

   GNAT.OS_Lib.OS_Exit (0);
end Operation_Times;
