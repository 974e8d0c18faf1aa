--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;    use Ada.Real_Time;
with Base64;
with Command_Lines;
with Commands;        use Commands;
with Journal;
with Missions.Driving;
with Monitor.Mailboxes;
with Monitor.Notices; use Monitor.Notices;
with Monitor.Protocol; use Monitor.Protocol;
with Options;
with Process.Threads;
with Texts;
with Vision.Following;
with Vision.Frames;
with Vision.Image_Grid;
with Vision.Library;
with Vision.Mode;           use Vision.Mode;
with Vision.State;
with Vision.Turns;

package body Vision.Tasks with SPARK_Mode is

   use type Monitor.Outbox.Message_Access;
   use type Options.Drawing_Kind;
   use type Vision.Image_Grid.Microseconds;
   use type Vision.Library.Status;

   Target_Margin : constant Natural :=
     Natural (Missions.Driving.Target_Margin) / 10_000;
   --  Centimetres

   procedure Check (Result : Vision.Library.Status; What : String) is
      --  Logs what has failed, if it has, and the reason that vision_c gives
      Reason : Vision.Library.Reason_Text;
      Last   : Natural;
      Line   : Texts.Text;
   begin
      if Result /= Vision.Library.Done then
         Vision.Library.Reason (Reason, Last);
         Texts.Set (Line, What);
         Texts.Append (Line, Reason (1 .. Last));
         Journal.Put (Options.Warning, Texts.Image (Line));
      end if;
   end Check;

   procedure Encode
     (Slot    : Vision.Slot;
      Quality : Options.Percentage;
      Jpeg    : in out Jpeg_Buffer;
      Message : in out Monitor.Outbox.Message)
   is
      --  The message that shows the image of Slot; its length is 0 where it
      --  cannot be made (the log says why)
      Result : Vision.Library.Status;
      Size   : Natural;
      Last   : Natural;
   begin
      Message.Length := 0;
      Vision.Library.Encode (Slot, Quality, Jpeg, Size, Result);
      Check (Result, "image left out: ");
      if Result = Vision.Library.Done then
         Message.Data (1 .. 4) := Image_Label;
         Message.Data (5) := Separator;
         Base64.Encode (Jpeg, Size, Message.Data, 6, Last);
         Message.Length := Last + 1;
         Message.Data (Message.Length) := Line_Feed;
      end if;
   end Encode;

   procedure Find_Robots
     (Slot   : Vision.Slot;
      Marker : Options.Marker_Kind;
      Seen   : Vision.Mode.State;
      Gap    : Vision.Following.Milliseconds;
      Known  : in out Vision.Following.State;
      Robots : out Robot_Array;
      Count  : out Robot_Count)
   is
      --  Where they are in the image of Slot, which has come Gap after the one
      --  that was searched last
      In_Arena : constant Boolean := Seen.Confirmed;
      Areas    : Area_Array;
      Number   : Robot_Count;
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

   function Position_Of (Robots : Robot_Array; Count : Robot_Count)
     return Position
   is (if Count = 0 then Not_Found
       else
         (Id    => Integer (Robots (1).Id),
          Angle => Micro (Robots (1).Angle),
          Cx    => Micro (Robots (1).Centre.X),
          Cy    => Micro (Robots (1).Centre.Y),
          Dx    => Micro (Robots (1).Direction.X),
          Dy    => Micro (Robots (1).Direction.Y)));
   --  The position reported to the monitor: that of Robots (1)

   function Are_Coordinates (Arena : Arena_Corners) return Boolean is
     (for all P of Arena =>
        Micro (P.X) in Coordinate and then Micro (P.Y) in Coordinate);

   function Corners_Of (Arena : Arena_Corners) return Corners is
     (1 => Micro (Arena (Top_Left).X),
      2 => Micro (Arena (Top_Left).Y),
      3 => Micro (Arena (Top_Right).X),
      4 => Micro (Arena (Top_Right).Y),
      5 => Micro (Arena (Bottom_Right).X),
      6 => Micro (Arena (Bottom_Right).Y),
      7 => Micro (Arena (Bottom_Left).X),
      8 => Micro (Arena (Bottom_Left).Y))
   with Pre => Are_Coordinates (Arena);

   function Gap_Between
     (First, Last : Time) return Vision.Following.Milliseconds is
     (Vision.Following.Milliseconds
        ((Vision.Image_Grid.Elapsed (First, Last) + 999) / 1_000));
   --  Rounded up; the longest there is where it is longer

   procedure Camera_Failed (Why : String)
   with Pre => Why'Length in 1 .. 80
   is
      --  The camera delivers no more: say so, and close it (once)
      Was_Open : Boolean;
   begin
      Vision.State.Store.Give_Up (Was_Open);
      if Was_Open then
         Monitor.Outbox.Stop_Images;
         Vision.Frames.End_Delivery;
         Journal.Put (Options.Error, Why);
         Monitor.Outbox.Put (Monitor.Mailboxes.Told (Why));
      end if;
   end Camera_Failed;

   task body Th_Camera_Control is
      Order   : Commands.Order;
      Success : Boolean;
   begin
      Process.Threads.Name_Task (Schedule.Th_Camera_Control);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Vision.Turns.Wait_Camera_Control (Order);
         case Order.Command.Name is
            when Open_Camera =>
               Vision.State.Open (Order.Number, Success);
            when Close_Camera =>
               Vision.State.Store.Change
                 (Camera_Closed, Order.Number, Success);
               if Success then
                  Monitor.Outbox.Stop_Images;
               end if;
            when others =>
               Vision.State.Store.Change
                 ((if Order.Command.Name = Start_Position then Position_Start
                   else Position_End),
                  Order.Number, Success);
         end case;
         Monitor.Outbox.Answer (Order, Reply_To (Success));
         Vision.Turns.Finish;
      end loop;
   end Th_Camera_Control;

   task body Th_Capture_Img is
      Chosen   : Options.Values renames Command_Lines.Given.Chosen;
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
      Slot     : Vision.Slot;
      Found    : Boolean;
      Result   : Vision.Library.Status;
      Robots   : Robot_Array := (others => <>);
      Count    : Robot_Count;
      Known    : Vision.Following.State;
      Known_At : Time;
      Arena    : Arena_Corners;  --  in which Known were found
      Image    : Monitor.Outbox.Message_Access :=
        new Monitor.Outbox.Message;
   begin
      Process.Threads.Name_Task (Schedule.Th_Capture_Img);
      loop
         pragma Loop_Invariant (Image /= null);
         Vision.State.Wait_Images;
         Grid := Vision.Image_Grid.Initial;
         Waited := False;
         Vision.Following.Forget (Known);
         Arena := No_Arena;
         Next := Clock;
         Known_At := Next;
         loop
            pragma Loop_Invariant (Image /= null);
            Step := Period;
            Coming := False;
            --  the generation before the mode: an image made for a mode
            --  that has ended meanwhile is then not sent
            Monitor.Outbox.Get (Outbox);
            Vision.State.Store.Get (Seen);
            Now := Clock;
            Vision.Frames.Store.Get_Silent (Now, Silent);
            exit when not Vision.Mode.Is_Open (Seen);
            if Silent then
               Camera_Failed (Monitor.Notices.Camera_Silent);
            elsif Vision.Mode.Images_Flow (Seen) then
               Vision.Frames.Store.Claim_Due
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
                     Vision.State.Put (Came, Robots, Count);
                  end if;
                  if Seen.Confirmed
                    and then Chosen.Drawing >= Options.Arena
                  then
                     Vision.Library.Draw_Arena (Slot, Seen.Arena, Result);
                     Check (Result, "arena not drawn: ");
                  end if;
                  if Seen.Position_On
                    and then Chosen.Drawing = Options.All_Of_It
                  then
                     --  over the arena's line
                     for I in 1 .. Count loop
                        Vision.Library.Draw_Robot (Slot, Robots (I), Result);
                        Check (Result, "robot not drawn: ");
                     end loop;
                  end if;
                  Encode (Slot, Chosen.Quality, Image_Jpeg, Image.all);
                  if Image.Length > 0 then
                     Monitor.Outbox.Put_Image (Image, Outbox.Made);
                  end if;
                  Vision.Frames.Store.Release (Slot);
                  if Seen.Position_On then
                     --  after its image, which is to be punctual
                     Monitor.Outbox.Put
                       ((Kind   => Monitor.Mailboxes.Position,
                         Line   => Position_Line (Position_Of (Robots, Count)),
                         Made   => Outbox.Made,
                         others => <>));
                  end if;
               end if;
            end if;
            Waited := Coming;
            if Coming then
               Vision.Frames.Wait_Look;
            else
               Now := Clock;
               loop
                  Next := Next + Microseconds (Integer (Step));
                  exit when Next > Now;
                  Step := Period;
               end loop;
               Process.Threads.Sleep_Until (Schedule.Th_Capture_Img, Next);
            end if;
         end loop;
      end loop;
   end Th_Capture_Img;

   task body Th_Arene is
      Order  : Commands.Order;
      Chosen : Options.Values renames Command_Lines.Given.Chosen;
      Valid  : Boolean;
      Slot   : Vision.Slot;
      Found  : Boolean;
      Arena  : Arena_Corners;
      Result : Vision.Library.Status;
      Shown  : Boolean;
      Seen   : Vision.Mode.State;
      Image  : Monitor.Outbox.Message_Access :=
        new Monitor.Outbox.Message;
   begin
      Process.Threads.Name_Task (Schedule.Th_Arene);
      loop
         pragma Loop_Invariant (not Order.Owed and then Image /= null);
         Vision.Turns.Wait_Arena (Order);
         if Order.Command.Name = Commands.Get_Ground then
            Vision.State.Store.Get (Seen);
            Monitor.Outbox.Answer
              (Order,
               (if Seen.Confirmed
                  and then Are_Coordinates (Seen.Arena)
                then Ground
                  (Chosen.Arena_Size, Target_Margin,
                   Corners_Of (Seen.Arena))
                else Reply_To (False)));
         elsif Order.Command.Name = Ask_Arena then
            Vision.State.Store.Change (Arena_Order, Order.Number, Valid);
            if Valid then
               Monitor.Outbox.Stop_Images;
               Arena := No_Arena;
               Shown := False;
               Vision.Frames.Wait_Newest (Slot, Found);
               if Found then
                  Vision.Library.Find_Arena (Slot, Arena, Result);
                  if Result = Vision.Library.Done then
                     Vision.Library.Draw_Arena (Slot, Arena, Result);
                     Check (Result, "arena not drawn: ");
                     Encode (Slot, Chosen.Quality, Arena_Jpeg, Image.all);
                     Shown := Image.Length > 0;
                  end if;
                  Vision.Frames.Store.Release (Slot);
               end if;
               Vision.State.Store.Change
                 ((if Shown then Arena_Found else Arena_Missing),
                  Order.Number, Valid, Arena);
               if Valid and then Shown then
                  Monitor.Outbox.Answer_With_Image (Order, Image);
               else
                  Monitor.Outbox.Answer (Order, Reply_To (False));
               end if;
            else
               Monitor.Outbox.Answer (Order, Reply_To (False));
            end if;
         else
            Vision.State.Store.Change
              ((if Order.Command.Name = Confirm_Arena then Confirmation
                else Rejection),
               Order.Number, Valid);
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
      Chosen : Options.Values renames Command_Lines.Given.Chosen;
      Number : Commands.Ticket;
      Wanted : Boolean;
      Result : Vision.Library.Status;
      Slot   : Vision.Slot;
      Now    : Time;
   begin
      Process.Threads.Name_Task (Schedule.Th_Camera);
      loop
         Vision.State.Wait_Open (Number);
         Vision.Library.Open
           (Chosen.Camera.Data (1 .. Chosen.Camera.Length),
            Chosen.Width, Chosen.Height,
            Integer'Max (Options.Camera_Rate, Chosen.Frame_Rate), Result);
         Vision.State.Store.Get_Wanted (Number, Wanted);
         Check (Result, "camera cannot be opened: ");
         if Result /= Vision.Library.Done or else not Wanted then
            Vision.State.Report (False);
         else
            Now := Clock;
            Vision.Frames.Store.Begin_Delivery (Now);
            Journal.Put (Options.Info, "camera open");
            Vision.State.Report (True);
            loop
               Vision.Frames.Store.Claim_Empty (Slot);
               Vision.Library.Grab (Slot, Result);
               if Result = Vision.Library.Done then
                  Now := Clock;
                  Vision.Frames.Publish (Slot, Now);
               else
                  Vision.Frames.Store.Release (Slot);
               end if;
               Vision.State.Store.Get_Wanted (Number, Wanted);
               exit when not Wanted;
               if Result /= Vision.Library.Done then
                  Check (Result, "no image from the camera: ");
                  Camera_Failed (Monitor.Notices.Camera_Stopped);
                  exit;
               end if;
            end loop;
            Vision.Frames.End_Delivery;
            Journal.Put (Options.Info, "camera closed");
         end if;
         Vision.Library.Close;
         Vision.State.Store.Released;
      end loop;
   end Th_Camera;

end Vision.Tasks;
