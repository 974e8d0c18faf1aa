--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits to be sent to the monitor: one answer a command, in the order
--  of the commands; and the unasked messages, of which only the newest counts.

with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Answer_Queues;                use Answer_Queues;
with Message_Holds;
with Schedule;
with Text_Queues;
with Trace;

package body Outbox with SPARK_Mode is

   use type Orders.Ticket;
   use type Send_Order.Choice;

   subtype Position_Index is Natural range 0 .. Position_Length;

   Room           : Suspension_Object;
   Work           : Suspension_Object;
   Arena_Room     : Suspension_Object;
   Sender_Left    : Suspension_Object;
   Hold_Begun     : Suspension_Object;

   type Reserve_Result is (Reserved, Full, Closed);

   protected Box with Priority => Schedule.Outbox_Ceiling is
      procedure Open_Session;
      procedure Close_Session (Next : out Orders.Ticket);
      procedure Get_Busy (Sender_Busy : out Boolean);
      procedure Reserve
        (Now    : Time;
         Number : out Orders.Ticket;
         Result : out Reserve_Result;
         Begun  : out Boolean);
      --  Begun, here and below: unasked messages begin to be held back
      procedure Answer (Number : Orders.Ticket; Item : Answer_Queues.Answer);
      procedure Answer_With_Image
        (Number   : Orders.Ticket;
         Data     : Message_Buffer;
         Length   : Message_Length;
         Accepted : out Boolean);
      procedure Put_Lost (Now : Time; Begun : out Boolean);
      procedure Put_Text
        (Item : Texts.Text; Now : Time; Begun : out Boolean);
      procedure Put_Battery
        (Kind  : Monitor_Protocol.Answer_Kind;
         Now   : Time;
         Begun : out Boolean);
      procedure Get_Generation (Current : out Generation);
      procedure Put_Position
        (Text  : String;
         Made  : Generation;
         Now   : Time;
         Begun : out Boolean);
      procedure Put_Image
        (Data   : Message_Buffer;
         Length : Message_Length;
         Made   : Generation;
         Now    : Time;
         Begun  : out Boolean);
      procedure Stop_Images;
      procedure Get_Ready (Now : out Boolean);
      procedure Get_Gap
        (Between : Send_Order.Milliseconds;
         Gap     : out Send_Order.Milliseconds);
      procedure Take
        (Between : Send_Order.Milliseconds;
         Kept    : Send_Order.Milliseconds;
         Kind    : out Message_Kind;
         Data    : in out Message_Buffer;
         Length  : out Message_Length);
      procedure Sent (Closed : out Boolean);
      procedure Get_Hold_End (Any : out Boolean; At_Time : out Time);
      procedure End_Hold (Now : Time);
      procedure Get_Waiting (Waiting : out Orders.Order_Count);
   private
      Open     : Boolean := False;
      Busy     : Boolean := False;      --  the sender is sending

      Answers  : Answer_Queues.Queue;
      Arena    : Image_Slots.Slot;      --  the answer that is an image

      Lost     : Boolean := False;
      Text     : Text_Queues.Queue;
      Battery  : Boolean := False;
      Level    : Monitor_Protocol.Answer_Kind :=
        Monitor_Protocol.Battery_Unknown;
      Position : String (1 .. Position_Length) := (others => ' ');
      Position_Any : Position_Index := 0;
      Image    : Image_Slots.Slot;
      Now_Made : Generation := 0;

      Hold     : Message_Holds.Hold;
      Released : Boolean := False;      --  held back for long enough
      Last     : Send_Order.Choice := Send_Order.Nothing;  --  taken last
      Imaged   : Boolean := False;      --  an image since the last position
   end Box;

   protected body Box is

      function Waits return Send_Order.Waiting is
        ((Open     => Open,
          Commands => Answer_Queues.Length (Answers) > 0,
          Ready    => First_Is_Ready (Answers),
          Messages => (Send_Order.Robot_Lost => Lost,
                       Send_Order.Text       => Text_Queues.Length (Text) > 0,
                       Send_Order.Battery    => Battery,
                       Send_Order.Position   => Position_Any > 0,
                       Send_Order.Image      =>
                         not Image_Slots.Is_Empty (Image)),
          Released => Released,
          Last     => Last,
          Imaged   => Imaged))
      with Post => (if Waits'Result.Ready then Waits'Result.Commands);

      function Unasked_Waits return Boolean is
        (Send_Order.Any_Unasked (Waits));

      procedure Drop_Unasked is
      begin
         Lost := False;
         Text_Queues.Clear (Text);
         Battery := False;
         Position_Any := 0;
         Image_Slots.Clear (Image);
         Hold.On := False;
         Released := False;
      end Drop_Unasked;

      procedure Refresh is
      begin
         Skip_Nothing (Answers);
         if not Unasked_Waits then
            Hold.On := False;
            Released := False;
         end if;
      end Refresh;

      procedure Begin_Hold
        (New_Command : Boolean; Now : Time; Begun : out Boolean) is
      begin
         Begun := False;
         if Unasked_Waits and then Answer_Queues.Length (Answers) > 0 then
            Message_Holds.Begin_Hold (Hold, New_Command, Now, Begun);
         end if;
      end Begin_Hold;

      ------------------
      -- Open_Session --
      ------------------

      procedure Open_Session is
      begin
         Open := True;
         Last := Send_Order.Nothing;
         Imaged := False;
         Drop_Unasked;
      end Open_Session;

      -------------------
      -- Close_Session --
      -------------------

      procedure Close_Session (Next : out Orders.Ticket) is
      begin
         Open := False;
         Clear (Answers);
         Next := Next_Number (Answers);
         Image_Slots.Clear (Arena);
         Drop_Unasked;
         Now_Made := Now_Made + 1;
      end Close_Session;

      --------------
      -- Get_Busy --
      --------------

      procedure Get_Busy (Sender_Busy : out Boolean) is
      begin
         Sender_Busy := Busy;
      end Get_Busy;

      -------------
      -- Reserve --
      -------------

      procedure Reserve
        (Now    : Time;
         Number : out Orders.Ticket;
         Result : out Reserve_Result;
         Begun  : out Boolean) is
      begin
         Number := Next_Number (Answers);
         Begun := False;
         if not Open then
            Result := Closed;
         elsif Answer_Queues.Length (Answers) = Orders.Capacity then
            Result := Full;
         else
            Reserve (Answers);
            Result := Reserved;
            Begin_Hold
              (New_Command => Answer_Queues.Length (Answers) = 1,
               Now         => Now,
               Begun       => Begun);
         end if;
      end Reserve;

      ------------
      -- Answer --
      ------------

      procedure Answer (Number : Orders.Ticket; Item : Answer_Queues.Answer)
      is
      begin
         Put (Answers, Number, Item);
         Refresh;
      end Answer;

      -----------------------
      -- Answer_With_Image --
      -----------------------

      procedure Answer_With_Image
        (Number   : Orders.Ticket;
         Data     : Message_Buffer;
         Length   : Message_Length;
         Accepted : out Boolean) is
      begin
         Accepted := True;
         if Holds (Answers, Number) then
            if Image_Slots.Is_Empty (Arena) then
               Image_Slots.Put (Arena, Data, Length);
               Answer (Number, (State => Ready_Image, others => <>));
            else
               Accepted := False;
            end if;
         end if;
      end Answer_With_Image;

      --------------
      -- Put_Lost --
      --------------

      procedure Put_Lost (Now : Time; Begun : out Boolean) is
      begin
         Begun := False;
         if Open then
            Lost := True;
            Begin_Hold (False, Now, Begun);
         end if;
      end Put_Lost;

      --------------
      -- Put_Text --
      --------------

      procedure Put_Text
        (Item : Texts.Text; Now : Time; Begun : out Boolean) is
      begin
         Begun := False;
         if Open then
            Text_Queues.Put_Over_Oldest (Text, Item);
            Begin_Hold (False, Now, Begun);
         end if;
      end Put_Text;

      -----------------
      -- Put_Battery --
      -----------------

      procedure Put_Battery
        (Kind  : Monitor_Protocol.Answer_Kind;
         Now   : Time;
         Begun : out Boolean) is
      begin
         Begun := False;
         if Open then
            Battery := True;
            Level := Kind;
            Begin_Hold (False, Now, Begun);
         end if;
      end Put_Battery;

      --------------------
      -- Get_Generation --
      --------------------

      procedure Get_Generation (Current : out Generation) is
      begin
         Current := Now_Made;
      end Get_Generation;

      ------------------
      -- Put_Position --
      ------------------

      procedure Put_Position
        (Text  : String;
         Made  : Generation;
         Now   : Time;
         Begun : out Boolean) is
      begin
         Begun := False;
         if Open and then Made = Now_Made
           and then Text'Length in 1 .. Position_Length
         then
            Position (1 .. Text'Length) := Text;
            Position_Any := Text'Length;
            Begin_Hold (False, Now, Begun);
         end if;
      end Put_Position;

      ---------------
      -- Put_Image --
      ---------------

      procedure Put_Image
        (Data   : Message_Buffer;
         Length : Message_Length;
         Made   : Generation;
         Now    : Time;
         Begun  : out Boolean) is
      begin
         Begun := False;
         if Open and then Made = Now_Made then
            Image_Slots.Put (Image, Data, Length);
            Begin_Hold (False, Now, Begun);
         end if;
      end Put_Image;

      -----------------
      -- Stop_Images --
      -----------------

      procedure Stop_Images is
      begin
         Now_Made := Now_Made + 1;
         Image_Slots.Clear (Image);
         Position_Any := 0;
         Refresh;
      end Stop_Images;

      ---------------
      -- Get_Ready --
      ---------------

      procedure Get_Ready (Now : out Boolean) is
      begin
         Now := Send_Order.Next (Waits) /= Send_Order.Nothing;
      end Get_Ready;

      -------------
      -- Get_Gap --
      -------------

      procedure Get_Gap
        (Between : Send_Order.Milliseconds;
         Gap     : out Send_Order.Milliseconds) is
      begin
         Gap := Send_Order.Gap (Waits, Send_Order.Next (Waits), Between);
      end Get_Gap;

      ----------
      -- Take --
      ----------

      procedure Take
        (Between : Send_Order.Milliseconds;
         Kept    : Send_Order.Milliseconds;
         Kind    : out Message_Kind;
         Data    : in out Message_Buffer;
         Length  : out Message_Length)
      is
         procedure Write (S : String)
         with Pre => S'First = 1 and then S'Last <= Position_Length;

         procedure Write_Answer (Item : Monitor_Protocol.Answer_Kind);

         procedure Write_Text (Item : Texts.Text);

         procedure Write (S : String) is
         begin
            Length := S'Length;
            Data (1 .. S'Length) := S;
         end Write;

         procedure Write_Answer (Item : Monitor_Protocol.Answer_Kind) is
            Line : constant Monitor_Protocol.Short_Text :=
              Monitor_Protocol.Wire_Text (Item);
         begin
            Write (Line.Data (1 .. Line.Length));
         end Write_Answer;

         procedure Write_Text (Item : Texts.Text) is
         begin
            Length := 5 + Item.Length + 1;
            Data (1 .. 5) := "MSSG:";
            Data (6 .. 5 + Item.Length) := Item.Data (1 .. Item.Length);
            Data (Length) := ASCII.LF;
         end Write_Text;

         First  : constant Send_Order.Choice := Send_Order.Next (Waits);
         Chosen : constant Send_Order.Choice :=
           (if Send_Order.Gap (Waits, First, Between) <= Kept then First
            else Send_Order.Nothing);
      begin
         Length := 0;
         case Chosen is
            when Send_Order.Nothing =>
               null;
            when Send_Order.Answer =>
               declare
                  Item : constant Answer_Queues.Answer :=
                    First_Answer (Answers);
               begin
                  Remove_First (Answers);
                  if Item.State = Ready_Image then
                     Image_Slots.Get (Arena, Data, Length);
                     Image_Slots.Clear (Arena);
                  else
                     Write_Answer (Item.Kind);
                  end if;
               end;
            when Send_Order.Robot_Lost =>
               Write_Answer (Monitor_Protocol.Timed_Out);
               Lost := False;
            when Send_Order.Text =>
               declare
                  Item : constant Texts.Text :=
                    Text_Queues.Element_At (Text, 1);
               begin
                  Text_Queues.Remove_First (Text);
                  Write_Text (Item);
               end;
            when Send_Order.Battery =>
               Write_Answer (Level);
               Battery := False;
            when Send_Order.Position =>
               Write (Position (1 .. Position_Any));
               Position_Any := 0;
            when Send_Order.Image =>
               Image_Slots.Get (Image, Data, Length);
               Image_Slots.Clear (Image);
         end case;
         Kind := (case Chosen is
                     when Send_Order.Nothing => Nothing,
                     when Send_Order.Answer  => Outbox.Answer,
                     when Send_Order.Unasked => Unasked);
         if Kind /= Nothing then
            Last := Chosen;
         end if;
         if Kind = Unasked then
            Imaged := Chosen = Send_Order.Image
              or else (Imaged and then Chosen /= Send_Order.Position);
            if Answer_Queues.Length (Answers) = 0 then
               Hold.On := False;
               Released := False;
            end if;
         end if;
         if Open then
            Busy := Kind /= Nothing;
         end if;
         Refresh;
      end Take;

      ----------
      -- Sent --
      ----------

      procedure Sent (Closed : out Boolean) is
      begin
         Busy := False;
         Closed := not Open;
      end Sent;

      ------------------
      -- Get_Hold_End --
      ------------------

      procedure Get_Hold_End (Any : out Boolean; At_Time : out Time) is
      begin
         Any := Hold.On and then not Released;
         At_Time := (if Any then Message_Holds.Ending (Hold) else Time_First);
      end Get_Hold_End;

      --------------
      -- End_Hold --
      --------------

      procedure End_Hold (Now : Time) is
      begin
         if Hold.On and then Now >= Message_Holds.Ending (Hold) then
            Released := True;
         end if;
      end End_Hold;

      -----------------
      -- Get_Waiting --
      -----------------

      procedure Get_Waiting (Waiting : out Orders.Order_Count) is
      begin
         Waiting := Answer_Queues.Length (Answers);
      end Get_Waiting;

   end Box;

   procedure Release_Hold with Annotate => (GNATprove, Terminating);
   --  th_hold: unasked messages begin to be held back

   procedure Release_Unasked (Begun : Boolean)
   with Annotate => (GNATprove, Terminating);
   --  An unasked message has been put into the box

   ------------------
   -- Release_Hold --
   ------------------

   procedure Release_Hold is
   begin
      Trace.Release (Schedule.Th_Hold);
      Set_True (Hold_Begun);
   end Release_Hold;

   ---------------------
   -- Release_Unasked --
   ---------------------

   procedure Release_Unasked (Begun : Boolean) is
   begin
      Trace.Release (Schedule.Th_Send_To_Mon);
      Set_True (Work);
      if Begun then
         Release_Hold;
      end if;
   end Release_Unasked;

   ------------------
   -- Open_Session --
   ------------------

   procedure Open_Session is
   begin
      Box.Open_Session;
   end Open_Session;

   -------------------
   -- Close_Session --
   -------------------

   procedure Close_Session (Next : out Orders.Ticket) is
   begin
      Set_False (Sender_Left);
      Box.Close_Session (Next);
      Set_True (Room);
      Set_True (Arena_Room);
   end Close_Session;

   -----------------
   -- Wait_Sender --
   -----------------

   procedure Wait_Sender is
      Busy : Boolean;
   begin
      --  the event may be a late one of the session before
      loop
         Box.Get_Busy (Busy);
         exit when not Busy;
         Trace.Wait (Schedule.Th_Com_Mon_Perdue, Trace.Tasks);
         Suspend_Until_True (Sender_Left);
         Trace.Resume (Schedule.Th_Com_Mon_Perdue);
      end loop;
   end Wait_Sender;

   -------------
   -- Reserve --
   -------------

   procedure Reserve (Number : out Orders.Ticket; Open : out Boolean) is
      Result : Reserve_Result;
      Now    : Time;
      Begun  : Boolean;
   begin
      loop
         Now := Clock;
         Box.Reserve (Now, Number, Result, Begun);
         exit when Result /= Full;
         Trace.Wait (Schedule.Th_Receive_From_Mon, Trace.Room);
         Suspend_Until_True (Room);
         Trace.Resume (Schedule.Th_Receive_From_Mon);
      end loop;
      Open := Result = Reserved;
      if Begun then
         Release_Hold;
      end if;
   end Reserve;

   ------------
   -- Answer --
   ------------

   procedure Answer
     (Number : Orders.Ticket; Kind : Monitor_Protocol.Answer_Kind) is
   begin
      Box.Answer (Number, (State => Ready_Text, Kind => Kind));
      Trace.Release (Schedule.Th_Send_To_Mon, Number);
      Set_True (Work);
      Set_True (Room);
   end Answer;

   --------------------
   -- Answer_Nothing --
   --------------------

   procedure Answer_Nothing (Number : Orders.Ticket) is
   begin
      Box.Answer (Number, (State => Ready_Nothing, others => <>));
      Trace.Release (Schedule.Th_Send_To_Mon, Number);
      Set_True (Work);
      Set_True (Room);
   end Answer_Nothing;

   -----------------------
   -- Answer_With_Image --
   -----------------------

   procedure Answer_With_Image
     (Number : Orders.Ticket;
      Data   : Message_Buffer;
      Length : Message_Length)
   is
      Accepted : Boolean;
   begin
      loop
         Box.Answer_With_Image (Number, Data, Length, Accepted);
         exit when Accepted;
         Trace.Wait (Schedule.Th_Arene, Trace.Room);
         Suspend_Until_True (Arena_Room);
         Trace.Resume (Schedule.Th_Arene);
      end loop;
      Trace.Release (Schedule.Th_Send_To_Mon, Number);
      Set_True (Work);
   end Answer_With_Image;

   --------------------
   -- Put_Robot_Lost --
   --------------------

   procedure Put_Robot_Lost is
      Now   : constant Time := Clock;
      Begun : Boolean;
   begin
      Box.Put_Lost (Now, Begun);
      Release_Unasked (Begun);
   end Put_Robot_Lost;

   --------------
   -- Put_Text --
   --------------

   procedure Put_Text (Text : Texts.Text) is
      Now   : constant Time := Clock;
      Begun : Boolean;
   begin
      Box.Put_Text (Text, Now, Begun);
      Release_Unasked (Begun);
   end Put_Text;

   -----------------
   -- Put_Battery --
   -----------------

   procedure Put_Battery (Kind : Monitor_Protocol.Answer_Kind) is
      Now   : constant Time := Clock;
      Begun : Boolean;
   begin
      Box.Put_Battery (Kind, Now, Begun);
      Release_Unasked (Begun);
   end Put_Battery;

   --------------------
   -- Get_Generation --
   --------------------

   procedure Get_Generation (Current : out Generation) is
   begin
      Box.Get_Generation (Current);
   end Get_Generation;

   ------------------
   -- Put_Position --
   ------------------

   procedure Put_Position (Text : String; Made : Generation) is
      Now   : constant Time := Clock;
      Begun : Boolean;
   begin
      Box.Put_Position (Text, Made, Now, Begun);
      Release_Unasked (Begun);
   end Put_Position;

   ---------------
   -- Put_Image --
   ---------------

   procedure Put_Image
     (Data   : Message_Buffer;
      Length : Message_Length;
      Made   : Generation)
   is
      Now   : constant Time := Clock;
      Begun : Boolean;
   begin
      Box.Put_Image (Data, Length, Made, Now, Begun);
      Release_Unasked (Begun);
   end Put_Image;

   -----------------
   -- Stop_Images --
   -----------------

   procedure Stop_Images is
   begin
      Box.Stop_Images;
   end Stop_Images;

   ----------
   -- Wait --
   ----------

   procedure Wait is
      Ready : Boolean;
   begin
      Trace.Done (Schedule.Th_Send_To_Mon);
      loop
         Box.Get_Ready (Ready);
         exit when Ready;
         Trace.Idle (Schedule.Th_Send_To_Mon);
         Suspend_Until_True (Work);
      end loop;
      Trace.Start (Schedule.Th_Send_To_Mon);
   end Wait;

   -------------
   -- Get_Gap --
   -------------

   procedure Get_Gap
     (Between : Send_Order.Milliseconds; Gap : out Send_Order.Milliseconds) is
   begin
      Box.Get_Gap (Between, Gap);
   end Get_Gap;

   ----------
   -- Take --
   ----------

   procedure Take
     (Between : Send_Order.Milliseconds;
      Kept    : Send_Order.Milliseconds;
      Kind    : out Message_Kind;
      Data    : in out Message_Buffer;
      Length  : out Message_Length) is
   begin
      Box.Take (Between, Kept, Kind, Data, Length);
      if Kind = Answer then
         Set_True (Room);
         Set_True (Arena_Room);
      end if;
   end Take;

   ----------
   -- Sent --
   ----------

   procedure Sent is
      Closed : Boolean;
   begin
      Box.Sent (Closed);
      if Closed then
         Set_True (Sender_Left);
      end if;
   end Sent;

   ---------------
   -- Wait_Held --
   ---------------

   procedure Wait_Held is
   begin
      Trace.Done (Schedule.Th_Hold);
      Suspend_Until_True (Hold_Begun);
      Trace.Start (Schedule.Th_Hold);
   end Wait_Held;

   ------------------
   -- Get_Hold_End --
   ------------------

   procedure Get_Hold_End
     (Any : out Boolean; At_Time : out Ada.Real_Time.Time) is
   begin
      Box.Get_Hold_End (Any, At_Time);
   end Get_Hold_End;

   --------------
   -- End_Hold --
   --------------

   procedure End_Hold is
      Now : constant Time := Clock;
   begin
      Box.End_Hold (Now);
      Trace.Release (Schedule.Th_Send_To_Mon);
      Set_True (Work);
   end End_Hold;

   -----------------
   -- Get_Waiting --
   -----------------

   procedure Get_Waiting (Count : out Orders.Order_Count) is
   begin
      Box.Get_Waiting (Count);
   end Get_Waiting;

end Outbox;
