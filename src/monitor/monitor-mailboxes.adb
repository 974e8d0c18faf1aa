--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Mailboxes with SPARK_Mode is

   procedure Skip_Nothing (Q : in out Answer_Queues.Queue) is
      --  Removes the places at the front that have nothing to send, no others
   begin
      while Answer_Queues.Length (Q) > 0
        and then Answer_Queues.Element_At (Q, 1).State = Ready_Nothing
      loop
         Answer_Queues.Remove_First (Q);
         pragma Loop_Variant (Decreases => Answer_Queues.Length (Q));
         pragma Loop_Invariant
           (Answer_Queues.Length (Q) < Answer_Queues.Length (Q'Loop_Entry));
         pragma Loop_Invariant
           (for all Old in 1 .. Answer_Queues.Length (Q) =>
              At_Age (Q, Old) = At_Age (Q'Loop_Entry, Old));
      end loop;
   end Skip_Nothing;

   function Hold_After
     (B : Mailbox; New_Command : Boolean; Now : Time) return Hold is
     (if not Any_Waits (B) or else Pending (B) = 0 then B.Held
      else
        (On       => True,
         Released => B.Held.Released,
         First    => (if B.Held.On then B.Held.First else Now),
         Since    => (if B.Held.On and then not New_Command
                      then B.Held.Since else Now)));
   --  When something has come: a message is held back if a command waits.
   --  New_Command: it has arrived just now, and no other was waiting

   procedure Open_Session (B : in out Mailbox) is
   begin
      B.Open := True;
      B.First := B.Next;
   end Open_Session;

   procedure Close_Session (B : in out Mailbox) is
   begin
      B.Open := False;
      Answer_Queues.Clear (B.Answers);
      B.Arena := False;
      Text_Queues.Clear (B.Texts);
      B.Lines := (others => No_Line);
      B.Image := False;
      B.Made := B.Made + 1;
      B.Held := (others => <>);
      B.Last := Nothing;
      B.Imaged := False;
   end Close_Session;

   procedure Reserve
     (B      : in out Mailbox;
      Now    : Time;
      Number : out Commands.Ticket;
      Result : out Reservation) is
   begin
      Number := B.Next;
      if not B.Open then
         Result := Closed;
      elsif Pending (B) = Commands.Capacity then
         Result := Full;
      else
         Answer_Queues.Put (B.Answers, (others => <>));
         B.Next := B.Next + 1;
         B.Held := Hold_After (B, Pending (B) = 1, Now);
         Result := Reserved;
      end if;
   end Reserve;

   procedure Put_Answer
     (B : in out Mailbox; Number : Commands.Ticket; Item : Answer_Place)
   is
      Before : constant Mailbox := B with Ghost;
   begin
      if Is_Awaited (B, Number) then
         Answer_Queues.Replace
           (B.Answers, Pending (B) + 1 - Age_Of (B, Number), Item);
         pragma Assert
           (for all Old in 1 .. Pending (B) =>
              At_Age (B.Answers, Old) =
                (if Old = Age_Of (Before, Number) then Item
                 else At_Age (Before.Answers, Old)));
         Skip_Nothing (B.Answers);
      end if;
   end Put_Answer;

   procedure Put_Arena
     (B        : in out Mailbox;
      Number   : Commands.Ticket;
      Accepted : out Boolean;
      Kept     : out Boolean)
   is
      Held : constant Boolean := Holds (B, Number);
   begin
      Accepted := not Held or else not B.Arena;
      Kept := Held and then not B.Arena;
      if Kept then
         Put_Answer (B, Number, (Ready_Image, No_Line));
         B.Arena := True;
      end if;
   end Put_Arena;

   procedure Put (B : in out Mailbox; Item : Notice; Now : Time) is
   begin
      if Is_Wanted (B, Item) then
         if Item.Kind = Text then
            Text_Queues.Put_Over_Oldest (B.Texts, Item.Line);
         else
            B.Lines (Item.Kind) := Item.Line;
         end if;
         if Item.Kind = Ending then
            B.Lines (Progress) := No_Line;
         end if;
         B.Held := Hold_After (B, False, Now);
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
         B.Held := Hold_After (B, False, Now);
      end if;
   end Put_Image;

   procedure Stop_Images (B : in out Mailbox) is
   begin
      B.Made := B.Made + 1;
      B.Image := False;
      B.Lines (Position) := No_Line;
      if not Any_Waits (B) then
         B.Held := (others => <>);
      end if;
   end Stop_Images;

   procedure Take
     (B         : in out Mailbox;
      Between   : Milliseconds;
      Now       : Time;
      Last_Sent : Time;
      Next      : out Item;
      Left      : out Boolean)
   is
      Chosen : constant Choice := Mailboxes.Next (B);
   begin
      Next := (others => <>);
      Left := B.Busy and then not B.Open;
      Next.Gap := Gap (B, Chosen, Between);
      if Now >= Last_Sent + Ada.Real_Time.Milliseconds (Next.Gap) then
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
            Answer_Queues.Remove_First (B.Answers);
            Skip_Nothing (B.Answers);
            if Next.Is_Image then
               B.Arena := False;
            end if;
         when Text       =>
            Next.Line := Text_Queues.Element_At (B.Texts, 1);
            Text_Queues.Remove_First (B.Texts);
         when Image      =>
            Next.Is_Image := True;
            B.Image := False;
            B.Imaged := True;
         when others     =>
            Next.Line := B.Lines (Next.Kind);
            B.Lines (Next.Kind) := No_Line;
            B.Imaged := B.Imaged and then Next.Kind /= Position;
      end case;
      if Next.Kind /= Nothing then
         B.Last := Next.Kind;
      end if;
      if not Any_Waits (B)
        or else (Next.Kind in Unsolicited and then Pending (B) = 0)
      then
         B.Held := (others => <>);
      end if;
      Next.Hold_End := Hold_End (B);
   end Take;

   procedure End_Hold (B : in out Mailbox; Now : Time) is
   begin
      if B.Held.On and then Now >= End_Of (B.Held) then
         B.Held.Released := True;
      end if;
   end End_Hold;

end Monitor.Mailboxes;
