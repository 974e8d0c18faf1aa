--  SPDX-License-Identifier: GPL-3.0-or-later
--  Prints how long operations of the protected objects take, as a task sees
--  them, with the events that they set; with --trace, what they record, too.

with Ada.Command_Line;
with Ada.Containers.Generic_Array_Sort;
with Ada.Real_Time;  use Ada.Real_Time;
with Ada.Text_IO;    use Ada.Text_IO;
with GNAT.OS_Lib;

with Camera_Requests;
with Image_Messages;
with Journal;
with Line_Requests;
with Line_Status;
with Mailboxes;
with Monitor_Protocol;
with Options;
with Orders;
with Outbox;
with Robot_Line;
with Robot_Session;
with Schedule;
with Send_Order;
with Session;
with Task_Ports;
with Texts;
with Trace;
with Vision_State;

procedure Operation_Times with Priority => Schedule.Query_Priority is

   Calls : constant := 20_000;

   type Sample_Index is range 1 .. Calls;
   type Sample_Array is array (Sample_Index range <>) of Natural;

   procedure Sort is new Ada.Containers.Generic_Array_Sort
     (Sample_Index, Natural, Sample_Array);
   --  tests/common's Samples allocate, and are not made for this profile

   Samples : Sample_Array (Sample_Index);  --  in nanoseconds
   Sample  : Sample_Index := 1;
   Begun   : Time;

   Image : Image_Messages.Message_Access := new Image_Messages.Message;
   Sent  : Image_Messages.Message_Access := new Image_Messages.Message;

   procedure Start;
   procedure Stop;
   procedure Report (Name : String);

   -----------
   -- Start --
   -----------

   procedure Start is
   begin
      Begun := Clock;
   end Start;

   ----------
   -- Stop --
   ----------

   procedure Stop is
   begin
      Samples (Sample) := (Clock - Begun) / Nanoseconds (1);
      if Sample < Sample_Index'Last then
         Sample := Sample + 1;
      end if;
   end Stop;

   ------------
   -- Report --
   ------------

   procedure Report (Name : String) is
      Last : constant Sample_Index := Sample;
   begin
      Sort (Samples (1 .. Last));
      Put_Line
        (Name & (Name'Length + 1 .. 26 => ' ')
         & Integer'Image (Samples (Last / 2 + 1))
         & Integer'Image (Samples (Last - Last / 100))
         & Integer'Image (Samples (Last - Last / 1000))
         & Integer'Image (Samples (Last)));
      Sample := 1;
   end Report;

   Open   : Boolean;
   Made   : Mailboxes.Generation;
   Next   : Mailboxes.Item;
   Gap    : Send_Order.Milliseconds;
   Order  : Orders.Order;
   Status : Line_Status.Status;
   Job    : Line_Requests.Job;
   View   : Vision_State.View;
   Stage  : Session.Stage_Kind;
   Wanted : Boolean;
   Text   : Texts.Text;

begin
   Put_Line ("nanoseconds: median, 99 %, 99.9 %, longest");
   for I in Sample_Index loop
      Start;
      for Turn in 1 .. 100 loop
         Trace.Done (Schedule.Th_Line);
      end loop;
      Stop;
   end loop;
   Report ("100 Trace.Done, off");

   if Ada.Command_Line.Argument_Count = 1
     and then Ada.Command_Line.Argument (1) = "--trace"
   then
      Trace.Open (Texts.To_Text ("/dev/null"), Open, Text);
      for I in Sample_Index loop
         Start;
         for Turn in 1 .. 100 loop
            Trace.Done (Schedule.Th_Line);
         end loop;
         Stop;
      end loop;
      Report ("100 Trace.Done, on");
   end if;

   Outbox.Open_Session;
   for I in Sample_Index loop
      Start;
      Outbox.Reserve (Order);
      Stop;
      Outbox.Answer (Order, Monitor_Protocol.Acknowledged);
      Outbox.Take (0, Time_First, Next, Sent, Gap);
   end loop;
   Report ("Outbox.Reserve");

   for I in Sample_Index loop
      Outbox.Reserve (Order);
      Start;
      Outbox.Answer (Order, Monitor_Protocol.Acknowledged);
      Stop;
      Outbox.Take (0, Time_First, Next, Sent, Gap);
   end loop;
   Report ("Outbox.Answer");

   for I in Sample_Index loop
      Outbox.Get_Generation (Made);
      Start;
      Outbox.Put_Image (Image, Made);
      Stop;
   end loop;
   Report ("Outbox.Put_Image");

   for I in Sample_Index range 1 .. 5_000 loop
      Outbox.Get_Generation (Made);
      Outbox.Put_Image (Image, Made);
      Start;
      Outbox.Take (0, Time_First, Next, Sent, Gap);
      Stop;
   end loop;
   Report ("Outbox.Take, an image");

   for I in Sample_Index loop
      Start;
      Robot_Line.Put
        (Line_Requests.Battery,
         Robot_Session.Request'
           (Kind => Robot_Session.Get_Battery, others => <>));
      Stop;
      Robot_Line.Take (Job);
   end loop;
   Report ("Robot_Line.Put");

   for I in Sample_Index loop
      Robot_Line.Put
        (Line_Requests.Battery,
         Robot_Session.Request'
           (Kind => Robot_Session.Get_Battery, others => <>));
      Start;
      Robot_Line.Take (Job);
      Stop;
   end loop;
   Report ("Robot_Line.Take");

   for I in Sample_Index loop
      Start;
      Robot_Line.Get_Status (Status);
      Stop;
   end loop;
   Report ("Robot_Line.Get_Status");

   Order.Message := (Kind => Monitor_Protocol.Go_Forward, others => <>);
   Order.Owed := True;
   for I in Sample_Index loop
      Start;
      Task_Ports.Move.Put (Order);
      Stop;
      Task_Ports.Move.Wait (Order);
   end loop;
   Report ("Order_Ports.Put");

   for I in Sample_Index loop
      Task_Ports.Move.Put (Order);
      Start;
      Task_Ports.Move.Wait (Order);
      Stop;
   end loop;
   Report ("Order_Ports.Wait");

   for I in Sample_Index loop
      Start;
      Vision_State.Store.Get (View);
      Stop;
   end loop;
   Report ("Vision_State.Get");

   for I in Sample_Index loop
      Start;
      Camera_Requests.Get_Wanted (0, Wanted);
      Stop;
   end loop;
   Report ("Camera_Requests.Get_Wanted");

   for I in Sample_Index loop
      Start;
      Session.Get_Stage (Stage);
      Stop;
   end loop;
   Report ("Session.Get_Stage");

   Texts.Set (Text, "received RMOV:-12345");
   for I in Sample_Index loop
      Start;
      Journal.Put (Options.Debug, Text);
      Stop;
   end loop;
   Report ("Journal.Put, not kept");

   for I in Sample_Index range 1 .. 256 loop
      Start;
      Journal.Put (Options.Info, Text);
      Stop;
   end loop;
   Report ("Journal.Put, kept");

   GNAT.OS_Lib.OS_Exit (0);
end Operation_Times;
