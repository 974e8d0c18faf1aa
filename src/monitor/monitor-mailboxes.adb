--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Mailboxes with SPARK_Mode is

   use type Text_Queues.Queue;

   procedure Drop_Unsolicited (B : in out Mailbox)
   with
     Post => Is_Quiet (B)
       and then B.Open = B'Old.Open
       and then B.Busy = B'Old.Busy
       and then B.Answers = B'Old.Answers
       and then B.Arena = B'Old.Arena
       and then B.First = B'Old.First
       and then B.Made = B'Old.Made
       and then B.Last = B'Old.Last
       and then B.Imaged = B'Old.Imaged
   is
   begin
      Text_Queues.Clear (B.Texts);
      B.Lines := (others => No_Line);
      B.Image := False;
      B.Held := (others => <>);
   end Drop_Unsolicited;

   function Is_Same_Mail (B, Before : Mailbox) return Boolean is
     (B.Open = Before.Open
      and then B.Busy = Before.Busy
      and then B.Answers = Before.Answers
      and then B.Arena = Before.Arena
      and then B.First = Before.First
      and then B.Texts = Before.Texts
      and then B.Lines = Before.Lines
      and then B.Image = Before.Image
      and then B.Made = Before.Made
      and then B.Last = Before.Last
      and then B.Imaged = Before.Imaged)
   with Ghost;
   --  All components except the hold

   procedure Begin_Hold
     (B : in out Mailbox; New_Command : Boolean; Now : Time)
   with
     Post => Is_Same_Mail (B, B'Old)
       and then B.Held.Released = B'Old.Held.Released
   is
      --  If a message waits because a command waits. New_Command: it has
      --  arrived just now, and no other was waiting
   begin
      if Any_Unsolicited (Waits (B)) and then Commands (B) > 0 then
         if not B.Held.On then
            B.Held.First := Now;
         end if;
         if not B.Held.On or else New_Command then
            B.Held.Since := Now;
         end if;
         B.Held.On := True;
      end if;
   end Begin_Hold;

   procedure Close_Session (B : in out Mailbox; Next : out Orders.Ticket) is
   begin
      B.Open := False;
      Clear (B.Answers);
      Next := Next_Number (B);
      B.Arena := False;
      B.Made := B.Made + 1;
      Drop_Unsolicited (B);
   end Close_Session;

   procedure End_Hold (B : in out Mailbox; Now : Time) is
   begin
      if B.Held.On and then Now >= Ending (B.Held) then
         B.Held.Released := True;
      end if;
   end End_Hold;

   procedure End_Quiet_Hold (B : in out Mailbox)
   with
     Post => Is_Same_Mail (B, B'Old)
       and then
         (if Any_Unsolicited (Waits (B)) then
             B.Held.On = B'Old.Held.On
             and then B.Held.Released = B'Old.Held.Released
          else Is_Quiet (B))
   is
      --  No hold unless a message is held back
   begin
      if not Any_Unsolicited (Waits (B)) then
         B.Held := (others => <>);
      end if;
   end End_Quiet_Hold;

   procedure Open_Session (B : in out Mailbox) is
   begin
      B.Open := True;
      B.First := Next_Number (B);
      B.Last := Nothing;
      B.Imaged := False;
      Drop_Unsolicited (B);
   end Open_Session;

   procedure Put
     (B      : in out Mailbox;
      Number : Orders.Ticket;
      Item   : Monitor.Answer_Queues.Answer)
   with
     Pre  => Item.State /= Awaited,
     Post => Next_Number (B) = Next_Number (B'Old)
       and then Commands (B) <= Commands (B'Old)
       and then B.Arena = B'Old.Arena
       and then B.Lines = B'Old.Lines
   is
   begin
      Put (B.Answers, Number, Item);
      pragma Assert (not Is_Awaited (B, Number));
      Skip_Nothing (B.Answers);
   end Put;

   procedure Put_Arena
     (B        : in out Mailbox;
      Number   : Orders.Ticket;
      Accepted : out Boolean;
      Kept     : out Boolean)
   is
      Held : constant Boolean := Holds (B, Number);
   begin
      Accepted := not Held or else not B.Arena;
      Kept := Held and then not B.Arena;
      if Kept then
         Put (B, Number, (State => Ready_Image, others => <>));
         B.Arena := True;
      end if;
   end Put_Arena;

   procedure Put_Answer
     (B : in out Mailbox; Number : Orders.Ticket; Line : Short_Text) is
   begin
      Put (B, Number,
           ((if Line.Length > 0 then Ready_Text else Ready_Nothing), Line));
   end Put_Answer;

   procedure Put (B : in out Mailbox; Item : Notice; Now : Time) is
   begin
      if Is_Wanted (B, Item) then
         if Item.Kind = User_Text then
            Text_Queues.Put_Over_Oldest (B.Texts, Item.Line);
         else
            B.Lines (Item.Kind) := Item.Line;
         end if;
         if Item.Kind = Ending then
            B.Lines (Progress) := No_Line;
         end if;
         Begin_Hold (B, False, Now);
      end if;
   end Put;

   procedure Put_Image
     (B    : in out Mailbox;
      Made : Generation;
      Now  : Time;
      Kept : out Boolean) is
   begin
      Kept := B.Open and then Made = B.Made;
      if Kept then
         B.Image := True;
         Begin_Hold (B, False, Now);
      end if;
   end Put_Image;

   procedure Reserve
     (B      : in out Mailbox;
      Now    : Time;
      Number : out Orders.Ticket;
      Result : out Reservation) is
   begin
      Number := Next_Number (B);
      if not B.Open then
         Result := Closed;
      elsif Is_Full (B) then
         Result := Full;
      else
         Reserve (B.Answers);
         Result := Reserved;
         Begin_Hold (B, Commands (B) = 1, Now);
      end if;
   end Reserve;

   procedure Stop_Images (B : in out Mailbox) is
   begin
      B.Made := B.Made + 1;
      B.Image := False;
      B.Lines (Place) := No_Line;
      End_Quiet_Hold (B);
   end Stop_Images;

   procedure Take
     (B         : in out Mailbox;
      Between   : Milliseconds;
      Now       : Time;
      Last_Sent : Time;
      Next      : out Item;
      Gap       : out Milliseconds;
      Left      : out Boolean)
   is
      Chosen : constant Choice := Monitor.Send_Order.Next (Waits (B));
      Kind   : Newest_Kind;
   begin
      Next := (others => <>);
      Left := B.Busy and then not B.Open;
      Gap := Due (B, Between);
      if Now >= Last_Sent + Ada.Real_Time.Milliseconds (Gap) then
         Next.Kind := Chosen;
      end if;
      B.Busy := Next.Kind /= Nothing;
      Next.Unsent := B.Busy;
      case Next.Kind is
         when Nothing    =>
            null;
         when Answer     =>
            Next.Is_Image := First (B).State = Ready_Image;
            Next.Line := First (B).Line;
            Remove_First (B.Answers);
            Skip_Nothing (B.Answers);
            if Next.Is_Image then
               B.Arena := False;
            end if;
         when Text       =>
            Next.Line := Text_Queues.Element_At (B.Texts, 1);
            Text_Queues.Remove_First (B.Texts);
         when Robot_Lost | Mission | Battery | Position =>
            Kind := Kind_Of (B, Next.Kind);
            Next.Line := B.Lines (Kind);
            B.Lines (Kind) := No_Line;
            if Kind = Place then
               B.Imaged := False;
            end if;
         when Image      =>
            Next.Is_Image := True;
            B.Image := False;
            B.Imaged := True;
      end case;
      if Next.Kind /= Nothing then
         B.Last := Next.Kind;
      end if;
      if Next.Kind in Unsolicited and then Commands (B) = 0 then
         B.Held := (others => <>);
      end if;
      End_Quiet_Hold (B);
   end Take;

end Monitor.Mailboxes;
