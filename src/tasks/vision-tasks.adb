--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;    use Ada.Real_Time;
with Base64;
with Commands;        use Commands;
with Journal;
with Missions.Guards;
with Monitor.Mailboxes;
with Monitor.Notices;
with Monitor.Outbox;
with Monitor.Positions;
with Monitor.Protocol; use Monitor.Protocol;
with Options;
with Orders;
with Process.Threads;
with Settings;
with Texts;
with Trace;
with Vision.Camera_Requests;
with Vision.Following;
with Vision.Frame_Store;
with Vision.Image_Grid;
with Vision.Library;
with Vision.Mode;
with Vision.Reports;
with Vision.Shapes;
with Vision.Sightings;
with Vision.State;
with Vision.Turns;

package body Vision.Tasks with SPARK_Mode is

   use type Monitor.Image_Messages.Message_Access;
   use type Options.Drawing_Kind;
   use type Vision.Image_Grid.Microseconds;
   use type Vision.Library.Status;
   use type Vision.Shapes.Arena_Corners;

   Target_Margin : constant Natural :=
     Natural (Missions.Guards.Target_Margin) / 10_000;
   --  Centimetres

   procedure Log_Reason (What : String) is
      --  What and the reason that vision_c gives
      Reason : Vision.Library.Reason_Text;
      Last   : Natural;
      Line   : Texts.Text;
   begin
      Vision.Library.Reason (Reason, Last);
      Texts.Set (Line, What);
      Texts.Append (Line, Reason (1 .. Last));
      Journal.Put (Options.Warning, Line);
   end Log_Reason;

   procedure Encode
     (Slot    : Vision.Library.Slot;
      Quality : Options.Percentage;
      Jpeg    : in out Jpeg_Buffer;
      Message : in out Monitor.Image_Messages.Message)
   is
      --  The message that shows the image of Slot; its length is 0 where it
      --  cannot be made (the log says why)
      Result : Vision.Library.Status;
      Size   : Natural;
      Last   : Natural;
   begin
      Message.Length := 0;
      Vision.Library.Encode (Slot, Quality, Jpeg, Size, Result);
      if Result = Vision.Library.Done then
         Message.Data (1 .. 4) := Image_Label;
         Message.Data (5) := Separator;
         Base64.Encode (Jpeg, Size, Message.Data, 6, Last);
         Message.Length := Last + 1;
         Message.Data (Message.Length) := Line_Feed;
      else
         Log_Reason ("image left out: ");
      end if;
   end Encode;

   procedure Find_Robots
     (Slot   : Vision.Library.Slot;
      Marker : Options.Marker_Kind;
      Seen   : Vision.Mode.State;
      Gap    : Vision.Following.Milliseconds;
      Known  : in out Vision.Following.State;
      Robots : out Vision.Shapes.Robot_Array;
      Count  : out Vision.Shapes.Robot_Count)
   is
      --  Where they are in the image of Slot, which has come Gap after the one
      --  that was searched last
      In_Arena : constant Boolean := Vision.Mode.Uses_Arena (Seen);
      Areas    : Vision.Shapes.Area_Array;
      Number   : Vision.Shapes.Robot_Count;
      Done     : Boolean := False;
      Ignored  : Vision.Library.Status;
   begin
      Robots := (others => <>);
      Count := 0;
      Vision.Following.Plan (Known, Marker, Gap, Areas, Number);
      if Number > 0 then
         Vision.Library.Find_Robots
           (Slot, Marker, Seen.Arena, In_Arena, Robots, Count, Ignored,
            Areas, Number);
         Vision.Following.Settle (Known, Gap, Robots, Count, Done);
      end if;
      if not Done then
         Vision.Library.Find_Robots
           (Slot, Marker, Seen.Arena, In_Arena, Robots, Count, Ignored);
         Vision.Following.Begin_Anew (Known, Robots, Count);
      end if;
   end Find_Robots;

   procedure Draw_Arena
     (Slot : Vision.Library.Slot; Arena : Vision.Shapes.Arena_Corners)
   is
      Result : Vision.Library.Status;
   begin
      Vision.Library.Draw_Arena (Slot, Arena, Result);
      if Result /= Vision.Library.Done then
         Log_Reason ("arena not drawn: ");
      end if;
   end Draw_Arena;

   procedure Draw_Robots
     (Slot   : Vision.Library.Slot;
      Robots : Vision.Shapes.Robot_Array;
      Count  : Vision.Shapes.Robot_Count)
   is
      --  What cannot be drawn is missing in the image (the log says why)
      Result : Vision.Library.Status;
   begin
      for I in 1 .. Count loop
         Vision.Library.Draw_Robot (Slot, Robots (I), Result);
         if Result /= Vision.Library.Done then
            Log_Reason ("robot not drawn: ");
         end if;
      end loop;
   end Draw_Robots;

   function Gap_Between
     (First, Last : Time) return Vision.Following.Milliseconds is
     (Vision.Following.Milliseconds
        ((Vision.Image_Grid.Elapsed (First, Last) + 999) / 1_000));
   --  Rounded up; the longest there is where it is longer

   procedure Camera_Failed (Why : Monitor.Notices.Notice) is
      --  The camera delivers no more: say so, and close it (once)
      Was_Open : Boolean;
   begin
      Vision.State.Store.Close (Was_Open);
      if Was_Open then
         Monitor.Outbox.Stop_Images;
         Vision.Camera_Requests.Requests.Close;
         Vision.Frame_Store.End_Delivery;
         Journal.Put (Options.Error, Monitor.Notices.Text_Of (Why));
         Monitor.Outbox.Put (Monitor.Mailboxes.Told (Why));
      end if;
   end Camera_Failed;

   task body Th_Camera_Control is
      Order    : Orders.Order;
      Needed   : Boolean;
      Opened   : Boolean;
      Success  : Boolean;
   begin
      Process.Threads.Name_Task (Schedule.Th_Camera_Control);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Vision.Turns.Wait_Camera_Control (Order);
         case Order.Command.Name is
            when Open_Camera =>
               Vision.State.Store.Ask_Open (Order.Number, Needed, Success);
               if Needed then
                  Vision.Camera_Requests.Open (Opened);
                  Vision.State.Store.Opened (Order.Number, Opened, Success);
                  if Success then
                     Vision.Camera_Requests.Begin_Images;
                  else
                     --  opened for nobody, perhaps
                     Vision.Camera_Requests.Requests.Close;
                  end if;
               end if;
            when Close_Camera =>
               Vision.State.Store.Close_By_Order (Order.Number, Success);
               if Success then
                  Monitor.Outbox.Stop_Images;
                  Vision.Camera_Requests.Requests.Close;
               end if;
            when others =>
               Vision.State.Store.Ask_Position
                 (Order.Number, Order.Command.Name = Start_Position,
                  Success);
         end case;
         Monitor.Outbox.Answer (Order, Reply_To (Success));
         Vision.Turns.Finish;
      end loop;
   end Th_Camera_Control;

   task body Th_Capture_Img is
      Chosen   : Options.Values renames Settings.Command_Line.Chosen;
      Period   : constant Vision.Image_Grid.Period_Time :=
        1_000_000 / Vision.Image_Grid.Microseconds (Chosen.Frame_Rate);
      Grid     : Vision.Image_Grid.State;
      Waited   : Boolean;  --  for an image, since the last instant of the grid
      Step     : Vision.Image_Grid.Microseconds;
      Next     : Time;     --  instant of the grid
      Now      : Time;
      Silent   : Boolean;
      Came     : Time;     --  the image that is sent
      Reserve  : Boolean;
      Coming   : Boolean;
      Outbox   : Monitor.Mailboxes.Status;
      Seen     : Vision.Mode.State;
      Slot     : Vision.Library.Slot;
      Found    : Boolean;
      Robots   : Vision.Shapes.Robot_Array := (others => <>);
      Count    : Vision.Shapes.Robot_Count;
      Known    : Vision.Following.State;
      Known_At : Time;
      Arena    : Vision.Shapes.Arena_Corners;  --  in which Known were found
      Line     : Short_Text;
      Image    : Monitor.Image_Messages.Message_Access :=
        new Monitor.Image_Messages.Message;
   begin
      Process.Threads.Name_Task (Schedule.Th_Capture_Img);
      loop
         Vision.Camera_Requests.Wait_Images;
         Vision.Sightings.Store.Clear;
         Grid := Vision.Image_Grid.Initial;
         Waited := False;
         Vision.Following.Forget (Known);
         Arena := Vision.Shapes.No_Arena;
         Next := Clock;
         Known_At := Next;
         loop
            if Waited then
               Trace.Start (Schedule.Th_Capture_Img);
            else
               Trace.Start (Schedule.Th_Capture_Img, Next);
            end if;
            Step := Period;
            Coming := False;
            --  the generation before the mode: an image made for a mode
            --  that has ended meanwhile is then not sent
            Monitor.Outbox.Get (Outbox);
            Vision.State.Store.Get (Seen);
            Now := Clock;
            Vision.Frame_Store.Store.Get_Silent (Now, Silent);
            exit when not Vision.Mode.Is_Open (Seen);
            if Silent then
               Camera_Failed (Monitor.Notices.Camera_Silent);
            elsif Vision.Mode.Images_Flow (Seen) then
               Vision.Frame_Store.Store.Claim_Due
                 (Now, Period, Slot, Came, Reserve, Found, Coming);
               if Found then
                  Coming := False;
                  if Waited then
                     Vision.Image_Grid.Wait_Ended
                       (Grid, Vision.Image_Grid.Elapsed (Next, Came), Period);
                     Next := Came;
                  end if;
                  Vision.Image_Grid.Step
                    (Grid, Vision.Image_Grid.Elapsed (Came, Now), Reserve,
                     Period, Step);
                  if not Seen.Position_On or else Seen.Arena /= Arena then
                     Vision.Following.Forget (Known);
                     Arena := Seen.Arena;
                  end if;
                  Count := 0;
                  if Seen.Position_On then
                     Find_Robots
                       (Slot, Chosen.Marker, Seen,
                        Gap_Between (Known_At, Came), Known, Robots, Count);
                     Known_At := Came;
                     --  before anything is drawn: a mission waits for it
                     Vision.Sightings.Put (Came, Robots, Count);
                  end if;
                  if Vision.Mode.Uses_Arena (Seen)
                    and then Chosen.Drawing >= Options.Arena
                  then
                     Draw_Arena (Slot, Seen.Arena);
                  end if;
                  if Seen.Position_On
                    and then Chosen.Drawing = Options.All_Of_It
                  then
                     --  over the arena's line
                     Draw_Robots (Slot, Robots, Count);
                  end if;
                  if Image /= null then
                     Encode (Slot, Chosen.Quality, Image_Jpeg, Image.all);
                     if Image.Length > 0 then
                        Monitor.Outbox.Put_Image (Image, Outbox.Made);
                     end if;
                  end if;
                  Vision.Frame_Store.Store.Release (Slot);
                  if Seen.Position_On then
                     --  after its image, which is to be punctual
                     Monitor.Positions.Format
                       (Vision.Reports.Position_Of (Robots, Count),
                        Line.Data, Line.Length);
                     Monitor.Outbox.Put
                       ((Kind   => Monitor.Mailboxes.Place,
                         Line   => Line,
                         Made   => Outbox.Made,
                         others => <>));
                  end if;
               end if;
            end if;
            Waited := Coming;
            if Coming then
               Trace.Done (Schedule.Th_Capture_Img);
               Vision.Frame_Store.Wait_Look;
            else
               Now := Clock;
               loop
                  Next := Next + Microseconds (Integer (Step));
                  exit when Next > Now;
                  Step := Period;
               end loop;
               Trace.Done (Schedule.Th_Capture_Img);
               delay until Next;
            end if;
         end loop;
         Vision.Sightings.Store.Clear;
      end loop;
   end Th_Capture_Img;

   task body Th_Arene is
      Order  : Orders.Order;
      Chosen : Options.Values renames Settings.Command_Line.Chosen;
      Valid  : Boolean;
      Slot   : Vision.Library.Slot;
      Found  : Boolean;
      Arena  : Vision.Shapes.Arena_Corners;
      Result : Vision.Library.Status;
      Shown  : Boolean;
      Seen   : Vision.Mode.State;
      Image  : Monitor.Image_Messages.Message_Access :=
        new Monitor.Image_Messages.Message;
   begin
      Process.Threads.Name_Task (Schedule.Th_Arene);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Vision.Turns.Wait_Arena (Order);
         if Order.Command.Name = Commands.Get_Ground then
            Vision.State.Store.Get (Seen);
            Monitor.Outbox.Answer
              (Order,
               (if Seen.Confirmed
                  and then Vision.Reports.Are_Coordinates (Seen.Arena)
                then Monitor.Positions.Ground
                  (Chosen.Arena_Size, Target_Margin,
                   Vision.Reports.Corners_Of (Seen.Arena))
                else Reply_To (False)));
         elsif Order.Command.Name = Ask_Arena then
            Vision.State.Store.Ask_Arena (Order.Number, Valid);
            if Valid then
               Monitor.Outbox.Stop_Images;
               Arena := Vision.Shapes.No_Arena;
               Shown := False;
               Vision.Frame_Store.Wait_Newest (Slot, Found);
               if Found then
                  Vision.Library.Find_Arena (Slot, Arena, Result);
                  if Result = Vision.Library.Done and then Image /= null then
                     Draw_Arena (Slot, Arena);
                     Encode
                       (Slot, Chosen.Quality, Arena_Jpeg, Image.all);
                     Shown := Image.Length > 0;
                  end if;
                  Vision.Frame_Store.Store.Release (Slot);
               end if;
               Vision.State.Store.Searched (Order.Number, Shown, Arena, Valid);
               if Valid and then Shown then
                  Monitor.Outbox.Answer_With_Image (Order, Image);
               else
                  Monitor.Outbox.Answer
                    (Order, Reply_To (False));
               end if;
            else
               Monitor.Outbox.Answer (Order, Reply_To (False));
            end if;
         else
            Vision.State.Store.Decide
              (Order.Number, Order.Command.Name = Confirm_Arena, Valid);
            Monitor.Outbox.Answer (Order, No_Line);
            if not Valid then
               Journal.Put
                 (Options.Warning,
                  "arena confirmed or rejected, but none was awaiting it");
            end if;
         end if;
         Vision.Turns.Finish;
      end loop;
   end Th_Arene;

   task body Th_Camera is
      Chosen : Options.Values renames Settings.Command_Line.Chosen;
      Number : Vision.Camera_Requests.Request_Number;
      Wanted : Boolean;
      Result : Vision.Library.Status;
      Slot   : Vision.Library.Slot;
      Now    : Time;
   begin
      Process.Threads.Name_Task (Schedule.Th_Camera);
      loop
         Vision.Camera_Requests.Wait_Open (Number);
         Vision.Library.Open
           (Chosen.Camera.Data (1 .. Chosen.Camera.Length),
            Chosen.Width, Chosen.Height,
            Integer'Max (Options.Camera_Rate, Chosen.Frame_Rate), Result);
         Vision.Camera_Requests.Requests.Get_Wanted (Number, Wanted);
         if Result /= Vision.Library.Done then
            Log_Reason ("camera cannot be opened: ");
            Vision.Camera_Requests.Report (False);
         elsif not Wanted then
            Vision.Camera_Requests.Report (False);
         else
            Now := Clock;
            Vision.Frame_Store.Store.Begin_Delivery (Now);
            Journal.Put (Options.Info, "camera open");
            Vision.Camera_Requests.Report (True);
            loop
               Trace.Start (Schedule.Th_Camera);
               Vision.Frame_Store.Store.Claim_Empty (Slot);
               Trace.Wait (Schedule.Th_Camera, Trace.Camera);
               Vision.Library.Grab (Slot, Result);
               Trace.Resume (Schedule.Th_Camera);
               if Result = Vision.Library.Done then
                  Now := Clock;
                  Vision.Frame_Store.Publish (Slot, Now);
               else
                  Vision.Frame_Store.Store.Release (Slot);
               end if;
               Vision.Camera_Requests.Requests.Get_Wanted (Number, Wanted);
               exit when not Wanted;
               if Result /= Vision.Library.Done then
                  Log_Reason ("no image from the camera: ");
                  Camera_Failed (Monitor.Notices.Camera_Ended);
                  exit;
               end if;
            end loop;
            Vision.Frame_Store.End_Delivery;
            Journal.Put (Options.Info, "camera closed");
         end if;
         Vision.Library.Close;
         Vision.Camera_Requests.Requests.Released;
      end loop;
   end Th_Camera;

end Vision.Tasks;
