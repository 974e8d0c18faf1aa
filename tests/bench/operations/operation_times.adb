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

   type Operation is
     (Trace_Put_Off, Trace_Put_On,  --  a hundred
      Outbox_Reserve, Outbox_Answer, Outbox_Put_Image, Outbox_Take_Image,
      Line_Put, Line_Take, Line_Finish, Line_Look, Line_Get_Status,
      Turns,                        --  put, wait and finish
      Missions_Put,
      Vision_Put, Vision_Get_Sighting, Vision_Get, Vision_Get_Wanted,
      Session_Get,
      Journal_Not_Kept, Journal_Kept);

   use type Commands.Ticket;

   type Sample_Index is range 1 .. Calls;
   type Sample_Array is array (Sample_Index range <>) of Natural;

   procedure Sort is new Ada.Containers.Generic_Array_Sort
     (Sample_Index, Natural, Sample_Array);
   --  tests/common's Samples allocate, and are not made for this profile

   Samples : Sample_Array (Sample_Index);  --  in nanoseconds

   Image : Monitor.Outbox.Message_Access :=
     new Monitor.Outbox.Message;
   Sent  : Monitor.Outbox.Message_Access :=
     new Monitor.Outbox.Message;

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
   Reason : Texts.Text;

   procedure Put_Order is
   begin
      Order.Number := Order.Number + 1;
      Order.Command := (Name => Commands.Go_Forward, others => <>);
      Order.Owed := True;
      Job := (others => <>);
      Robot.Line.Put (Order);
   end Put_Order;

   procedure Take_Order is
   begin
      Robot.Line.Grant.Take (Schedule.Th_Move, Job, Verdict, Held, Found);
   end Take_Order;

   procedure Prepare (What : Operation) is
   begin
      case What is
         when Outbox_Answer => Monitor.Outbox.Reserve (Order);
         when Outbox_Put_Image => Monitor.Outbox.Get (Outbox);
         when Outbox_Take_Image =>
            Monitor.Outbox.Get (Outbox);
            Monitor.Outbox.Put_Image (Image, Outbox.Made);
         when Line_Take   => Put_Order;
         when Line_Finish =>
            Put_Order;
            Take_Order;
         when Turns | Missions_Put =>
            Order.Command := (Name => Commands.Open_Camera, others => <>);
            Order.Owed := True;
         when others => null;
      end case;
   end Prepare;

   procedure Perform (What : Operation) is
   begin
      case What is
         when Trace_Put_Off | Trace_Put_On =>
            for Turn in 1 .. 100 loop
               Trace.Put (Trace.Done, Schedule.Th_Move);
            end loop;
         when Outbox_Reserve    => Monitor.Outbox.Reserve (Order);
         when Outbox_Answer     =>
            Monitor.Outbox.Answer (Order, Monitor.Protocol.Acknowledged);
         when Outbox_Put_Image  =>
            Monitor.Outbox.Put_Image (Image, Outbox.Made);
         when Outbox_Take_Image =>
            Monitor.Outbox.Take (0, Time_First, Next, Sent);
         when Line_Put          => Put_Order;
         when Line_Take         => Take_Order;
         when Line_Finish       =>
            Robot.Line.Finish (Job, Held, (others => <>));
         when Line_Look         =>
            Robot.Line.Look (Robot.Requests.Keep_Alive, Due);
         when Line_Get_Status   => Robot.Line.Grant.Get_Status (Status);
         when Turns             =>
            Vision.Turns.Put (Order);
            Vision.Turns.Wait_Camera_Control (Order);
            Vision.Turns.Finish;
         when Missions_Put      => Missions.Requests.Put (Order, Path);
         when Vision_Put        => Vision.State.Put (Time_First, Robots, 1);
         when Vision_Get_Sighting => Vision.State.Store.Get_Sighting (Seen);
         when Vision_Get        => Vision.State.Store.Get (View);
         when Vision_Get_Wanted => Vision.State.Store.Get_Wanted (0, Wanted);
         when Session_Get       => Monitor.Session.State.Get (Stage);
         when Journal_Not_Kept  =>
            Journal.Put (Options.Debug, Texts.Image (Text));
         when Journal_Kept      =>
            Journal.Put (Options.Info, Texts.Image (Text));
      end case;
   end Perform;

   procedure Clear_Up (What : Operation) is
   begin
      case What is
         when Outbox_Reserve | Outbox_Answer =>
            if What = Outbox_Reserve then
               Monitor.Outbox.Answer (Order, Monitor.Protocol.Acknowledged);
            end if;
            Monitor.Outbox.Take (0, Time_First, Next, Sent);
         when Line_Put | Line_Take =>
            if What = Line_Put then
               Take_Order;
            end if;
            Robot.Line.Finish (Job, Held, (others => <>));
         when Missions_Put =>
            Missions.Requests.Wait (Order, Path);
            Missions.Requests.Place.Release;
         when others => null;
      end case;
   end Clear_Up;

   procedure Measure (What : Operation; Last : Sample_Index) is
      Name  : constant String := What'Image;
      Begun : Time;
   begin
      for I in 1 .. Last loop
         Prepare (What);
         Begun := Clock;
         Perform (What);
         Samples (I) := (Clock - Begun) / Nanoseconds (1);
         Clear_Up (What);
      end loop;
      Sort (Samples (1 .. Last));
      Put_Line (Name & (Name'Length + 1 .. 20 => ' ')
                & Integer'Image (Samples (Last / 2 + 1))
                & Integer'Image (Samples (Last - Last / 100))
                & Integer'Image (Samples (Last - Last / 1000))
                & Integer'Image (Samples (Last)));
   end Measure;

   Traced : constant Boolean :=
     Ada.Command_Line.Argument_Count = 1
     and then Ada.Command_Line.Argument (1) = "--trace";

begin
   Put_Line ("nanoseconds: median, 99 %, 99.9 %, longest");
   Monitor.Outbox.Open_Session;
   Texts.Set (Text, "received RMOV:-12345");
   for What in Operation loop
      if What = Trace_Put_On and then Traced then
         Trace.Open (Texts.To_Text ("/dev/null"), Found, Reason);
      end if;
      if What /= Trace_Put_On or else Traced then
         Measure
           (What,
            (case What is
                when Outbox_Take_Image => 5_000,
                when Journal_Kept      => 256,
                when others            => Calls));
      end if;
   end loop;
   GNAT.OS_Lib.OS_Exit (0);
end Operation_Times;
