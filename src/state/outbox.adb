--  SPDX-License-Identifier: GPL-3.0-or-later
--  What waits to be sent to the monitor: one answer a command, in the order
--  of the commands; and the unasked messages, of which only the newest counts.

with Ada.Real_Time;                use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Schedule;

package body Outbox with SPARK_Mode is

   use type Orders.Ticket;

   type Place_State is (Awaited, Ready_Text, Ready_Image, Ready_Nothing);

   type Place is record
      State : Place_State := Awaited;
      Kind  : Monitor_Protocol.Answer_Kind := Monitor_Protocol.Acknowledged;
   end record;

   subtype Place_Index is Natural range 0 .. Orders.Capacity - 1;
   type Place_Array is array (Place_Index) of Place;

   Text_Capacity : constant := 8;
   subtype Text_Count is Natural range 0 .. Text_Capacity;
   type Text_Array is array (1 .. Text_Capacity) of Texts.Text;

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
        (Number : out Orders.Ticket; Result : out Reserve_Result);
      procedure Answer (Number : Orders.Ticket; Item : Place);
      procedure Answer_With_Image
        (Number   : Orders.Ticket;
         Data     : Message_Buffer;
         Length   : Message_Length;
         Accepted : out Boolean);
      procedure Put_Lost (Now : Time);
      procedure Put_Text (Text : Texts.Text; Now : Time);
      procedure Put_Battery
        (Kind : Monitor_Protocol.Answer_Kind; Now : Time);
      procedure Get_Generation (Current : out Generation);
      procedure Put_Position (Text : String; Made : Generation; Now : Time);
      procedure Put_Image
        (Data   : Message_Buffer;
         Length : Message_Length;
         Made   : Generation;
         Now    : Time);
      procedure Stop_Images;
      procedure Get_Ready (Now : out Boolean; Answer_Is_Next : out Boolean);
      procedure Take
        (Kind   : out Message_Kind;
         Data   : in out Message_Buffer;
         Length : out Message_Length);
      procedure Sent (Closed : out Boolean);
      procedure Get_Hold_End (Any : out Boolean; At_Time : out Time);
      procedure End_Hold (Now : Time);
      procedure Get_Waiting (Waiting : out Orders.Order_Count);
   private
      Open   : Boolean := False;
      Ready  : Boolean := False;   --  something may be sent
      Busy   : Boolean := False;   --  the sender is sending

      Places : Place_Array;        --  the answers, a ring
      First  : Place_Index := 0;
      Count  : Orders.Order_Count := 0;
      Head   : Orders.Ticket := 1; --  number of the place First

      Arena_Data   : Message_Buffer := (others => ' ');
      Arena_Length : Message_Length := 0;

      Lost     : Boolean := False;
      Text     : Text_Array;
      Text_Any : Text_Count := 0;
      Battery  : Boolean := False;
      Level    : Monitor_Protocol.Answer_Kind :=
        Monitor_Protocol.Battery_Unknown;
      Position : String (1 .. Position_Length) := (others => ' ');
      Position_Any : Position_Index := 0;
      Image    : Message_Buffer := (others => ' ');
      Image_Any : Message_Length := 0;
      Now_Made : Generation := 0;

      Held_Since : Time := Time_First;  --  of the oldest unasked one
      Released   : Boolean := False;    --  held back for long enough
      Answered   : Boolean := False;    --  the message taken last
   end Box;

   protected body Box is

      function Unasked_Waits return Boolean is
        (Lost or else Text_Any > 0 or else Battery or else Position_Any > 0
         or else Image_Any > 0);

      function Answer_Waits return Boolean is
        (Count > 0 and then Places (First).State /= Awaited);

      procedure Drop_Unasked is
      begin
         Lost := False;
         Text_Any := 0;
         Battery := False;
         Position_Any := 0;
         Image_Any := 0;
         Released := False;
      end Drop_Unasked;

      procedure Next_Place is
      begin
         First := (First + 1) mod Orders.Capacity;
         if Count > 0 then
            Count := Count - 1;
         end if;
         Head := Head + 1;
      end Next_Place;

      procedure Refresh is
      begin
         for I in 1 .. Orders.Capacity loop
            exit when Count = 0
              or else Places (First).State /= Ready_Nothing;
            Next_Place;
         end loop;
         if not Unasked_Waits then
            Released := False;
         end if;
         Ready := Open and then
           (Answer_Waits
            or else (Unasked_Waits and then (Count = 0 or else Released)));
      end Refresh;

      procedure Begin_Unasked (Now : Time) is
      begin
         if not Unasked_Waits then
            Held_Since := Now;
         end if;
      end Begin_Unasked;

      ------------------
      -- Open_Session --
      ------------------

      procedure Open_Session is
      begin
         Open := True;
         Answered := False;
         Drop_Unasked;
         Refresh;
      end Open_Session;

      -------------------
      -- Close_Session --
      -------------------

      procedure Close_Session (Next : out Orders.Ticket) is
      begin
         Open := False;
         Head := Head + Orders.Ticket (Count);
         Next := Head;
         Count := 0;
         Arena_Length := 0;
         Drop_Unasked;
         Now_Made := Now_Made + 1;
         Refresh;
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
        (Number : out Orders.Ticket; Result : out Reserve_Result) is
      begin
         Number := Head + Orders.Ticket (Count);
         if not Open then
            Result := Closed;
         elsif Count = Orders.Capacity then
            Result := Full;
         else
            Places ((First + Count) mod Orders.Capacity) := (others => <>);
            Count := Count + 1;
            Result := Reserved;
            Refresh;
         end if;
      end Reserve;

      ------------
      -- Answer --
      ------------

      procedure Answer (Number : Orders.Ticket; Item : Place) is
      begin
         if Number >= Head and then Number - Head < Orders.Ticket (Count) then
            declare
               Index : constant Place_Index :=
                 (First + Natural (Number - Head)) mod Orders.Capacity;
            begin
               if Places (Index).State = Awaited then
                  Places (Index) := Item;
               end if;
            end;
            Refresh;
         end if;
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
         if Number >= Head and then Number - Head < Orders.Ticket (Count) then
            if Arena_Length > 0 then
               Accepted := False;
            else
               Arena_Data (1 .. Length) := Data (1 .. Length);
               Arena_Length := Length;
               Answer (Number, (State => Ready_Image, others => <>));
            end if;
         end if;
      end Answer_With_Image;

      --------------
      -- Put_Lost --
      --------------

      procedure Put_Lost (Now : Time) is
      begin
         if Open then
            Begin_Unasked (Now);
            Lost := True;
            Refresh;
         end if;
      end Put_Lost;

      --------------
      -- Put_Text --
      --------------

      procedure Put_Text (Text : Texts.Text; Now : Time) is
      begin
         if Open then
            Begin_Unasked (Now);
            if Text_Any = Text_Capacity then
               Box.Text (1 .. Text_Capacity - 1) :=
                 Box.Text (2 .. Text_Capacity);
            else
               Text_Any := Text_Any + 1;
            end if;
            Box.Text (Text_Any) := Text;
            Refresh;
         end if;
      end Put_Text;

      -----------------
      -- Put_Battery --
      -----------------

      procedure Put_Battery
        (Kind : Monitor_Protocol.Answer_Kind; Now : Time) is
      begin
         if Open then
            Begin_Unasked (Now);
            Battery := True;
            Level := Kind;
            Refresh;
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

      procedure Put_Position (Text : String; Made : Generation; Now : Time) is
      begin
         if Open and then Made = Now_Made
           and then Text'Length in 1 .. Position_Length
         then
            Begin_Unasked (Now);
            Position (1 .. Text'Length) := Text;
            Position_Any := Text'Length;
            Refresh;
         end if;
      end Put_Position;

      ---------------
      -- Put_Image --
      ---------------

      procedure Put_Image
        (Data   : Message_Buffer;
         Length : Message_Length;
         Made   : Generation;
         Now    : Time) is
      begin
         if Open and then Made = Now_Made then
            Begin_Unasked (Now);
            Image (1 .. Length) := Data (1 .. Length);
            Image_Any := Length;
            Refresh;
         end if;
      end Put_Image;

      -----------------
      -- Stop_Images --
      -----------------

      procedure Stop_Images is
      begin
         Now_Made := Now_Made + 1;
         Image_Any := 0;
         Position_Any := 0;
         Refresh;
      end Stop_Images;

      ---------------
      -- Get_Ready --
      ---------------

      procedure Get_Ready
        (Now : out Boolean; Answer_Is_Next : out Boolean) is
      begin
         Now := Ready;
         Answer_Is_Next := Answer_Waits and then not Released;
      end Get_Ready;

      ----------
      -- Take --
      ----------

      procedure Take
        (Kind   : out Message_Kind;
         Data   : in out Message_Buffer;
         Length : out Message_Length)
      is
         procedure Write (S : String);
         procedure Write (S : String) is
         begin
            Length := S'Length;
            Data (1 .. S'Length) := S;
         end Write;

         Unasked_May : constant Boolean :=
           Unasked_Waits and then (Count = 0 or else Released);
         Answer_May  : constant Boolean := Answer_Waits;
      begin
         Kind := Nothing;
         Length := 0;
         if not Open then
            return;
         end if;
         --  answers first; where unasked ones have waited their time, the
         --  two take turns
         if Answer_May
           and then not (Unasked_May and then Released and then Answered)
         then
            Kind := Answer;
            Answered := True;
            case Places (First).State is
               when Ready_Image =>
                  Length := Arena_Length;
                  Data (1 .. Arena_Length) := Arena_Data (1 .. Arena_Length);
                  Arena_Length := 0;
               when others =>
                  declare
                     Text : constant Monitor_Protocol.Short_Text :=
                       Monitor_Protocol.Wire_Text (Places (First).Kind);
                  begin
                     Write (Text.Data (1 .. Text.Length));
                  end;
            end case;
            Next_Place;
         elsif Unasked_May then
            Kind := Unasked;
            Answered := False;
            if Lost then
               Lost := False;
               declare
                  Text : constant Monitor_Protocol.Short_Text :=
                    Monitor_Protocol.Wire_Text (Monitor_Protocol.Timed_Out);
               begin
                  Write (Text.Data (1 .. Text.Length));
               end;
            elsif Text_Any > 0 then
               Length := 5 + Text (1).Length + 1;
               Data (1 .. 5) := "MSSG:";
               Data (6 .. 5 + Text (1).Length) :=
                 Text (1).Data (1 .. Text (1).Length);
               Data (Length) := ASCII.LF;
               Text (1 .. Text_Capacity - 1) := Text (2 .. Text_Capacity);
               Text_Any := Text_Any - 1;
            elsif Battery then
               Battery := False;
               declare
                  Text : constant Monitor_Protocol.Short_Text :=
                    Monitor_Protocol.Wire_Text (Level);
               begin
                  Write (Text.Data (1 .. Text.Length));
               end;
            elsif Position_Any > 0 then
               Write (Position (1 .. Position_Any));
               Position_Any := 0;
            else
               Length := Image_Any;
               Data (1 .. Image_Any) := Image (1 .. Image_Any);
               Image_Any := 0;
            end if;
         end if;
         Busy := Kind /= Nothing;
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
         Any := Unasked_Waits and then not Released;
         At_Time := Held_Since + Schedule.Hold_Limit;
      end Get_Hold_End;

      --------------
      -- End_Hold --
      --------------

      procedure End_Hold (Now : Time) is
      begin
         if Unasked_Waits and then Now - Held_Since >= Schedule.Hold_Limit
         then
            Released := True;
            Refresh;
         end if;
      end End_Hold;

      -----------------
      -- Get_Waiting --
      -----------------

      procedure Get_Waiting (Waiting : out Orders.Order_Count) is
      begin
         Waiting := Count;
      end Get_Waiting;

   end Box;

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
      Box.Get_Busy (Busy);
      if Busy then
         Suspend_Until_True (Sender_Left);
      end if;
   end Wait_Sender;

   -------------
   -- Reserve --
   -------------

   procedure Reserve (Number : out Orders.Ticket; Open : out Boolean) is
      Result : Reserve_Result;
   begin
      loop
         Box.Reserve (Number, Result);
         exit when Result /= Full;
         Suspend_Until_True (Room);
      end loop;
      Open := Result = Reserved;
   end Reserve;

   ------------
   -- Answer --
   ------------

   procedure Answer
     (Number : Orders.Ticket; Kind : Monitor_Protocol.Answer_Kind) is
   begin
      Box.Answer (Number, (State => Ready_Text, Kind => Kind));
      Set_True (Work);
      Set_True (Room);
   end Answer;

   --------------------
   -- Answer_Nothing --
   --------------------

   procedure Answer_Nothing (Number : Orders.Ticket) is
   begin
      Box.Answer (Number, (State => Ready_Nothing, others => <>));
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
         Suspend_Until_True (Arena_Room);
      end loop;
      Set_True (Work);
   end Answer_With_Image;

   --------------------
   -- Put_Robot_Lost --
   --------------------

   procedure Put_Robot_Lost is
      Now : constant Time := Clock;
   begin
      Box.Put_Lost (Now);
      Set_True (Work);
      Set_True (Hold_Begun);
   end Put_Robot_Lost;

   --------------
   -- Put_Text --
   --------------

   procedure Put_Text (Text : Texts.Text) is
      Now : constant Time := Clock;
   begin
      Box.Put_Text (Text, Now);
      Set_True (Work);
      Set_True (Hold_Begun);
   end Put_Text;

   -----------------
   -- Put_Battery --
   -----------------

   procedure Put_Battery (Kind : Monitor_Protocol.Answer_Kind) is
      Now : constant Time := Clock;
   begin
      Box.Put_Battery (Kind, Now);
      Set_True (Work);
      Set_True (Hold_Begun);
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
      Now : constant Time := Clock;
   begin
      Box.Put_Position (Text, Made, Now);
      Set_True (Work);
      Set_True (Hold_Begun);
   end Put_Position;

   ---------------
   -- Put_Image --
   ---------------

   procedure Put_Image
     (Data   : Message_Buffer;
      Length : Message_Length;
      Made   : Generation)
   is
      Now : constant Time := Clock;
   begin
      Box.Put_Image (Data, Length, Made, Now);
      Set_True (Work);
      Set_True (Hold_Begun);
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

   procedure Wait (Answer_Is_Next : out Boolean) is
      Ready : Boolean;
   begin
      loop
         Box.Get_Ready (Ready, Answer_Is_Next);
         exit when Ready;
         Suspend_Until_True (Work);
      end loop;
   end Wait;

   ----------
   -- Take --
   ----------

   procedure Take
     (Kind   : out Message_Kind;
      Data   : in out Message_Buffer;
      Length : out Message_Length) is
   begin
      Box.Take (Kind, Data, Length);
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
      Suspend_Until_True (Hold_Begun);
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
