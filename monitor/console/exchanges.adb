--  SPDX-License-Identifier: GPL-3.0-or-later
--  Matches answers to commands.

with Commands; use Commands;

package body Exchanges is

   Longest_Kept : constant := 16;
   --  Of an answer. Of a longer one, an image, only the label is kept.

   function Can_Answer
     (Line : String; Begun_At : Time; Given : Command) return Boolean
   is
      --  Battery levels, images and the loss of the robot are also sent
      --  unsolicited: they only answer the commands that request them. An
      --  image begun before the arena order is no answer.
      Label : constant String :=
        Line (Line'First .. Integer'Min (Line'First + 3, Line'Last));
   begin
      return
        (if Label in Done_Label | "ANAK" | "ACRJ" | "ACER" then True
         elsif Label = "ATIM" then Given.Name in Robot_Command
         else Label = Table (Given.Name).Reply
           and then (Given.Name /= Ask_Arena
                     or else Begun_At >= Given.Sent_At));
   end Can_Answer;

   protected body Exchange is

      function Answered return Natural is (Served);

      procedure Claim_End (First : out Boolean) is
      begin
         First := not Ending;
         Ending := True;
      end Claim_End;

      procedure End_Reading is
      begin
         Silent := True;
      end End_Reading;

      procedure Give_Up
        (Before : Time; Found : out Boolean; Given : out Command) is
      begin
         Found := False;
         for C of Pending (1 .. Waiting) loop
            if not C.Overdue and then C.Sent_At < Before then
               C.Overdue := True;
               Due := Due - 1;
               Missed := Missed + 1;
               Untold := Untold + 1;
               Found := True;
               Given := C;
               return;
            end if;
         end loop;
      end Give_Up;

      function Is_Ending return Boolean is (Ending);

      function Last_Answer return Unbounded_String is (Answer);

      function Last_End return Unbounded_String is (Ended);

      procedure Match
        (Line     : String;
         Begun_At : Time;
         Found    : out Boolean;
         Given    : out Command) is
      begin
         Found := False;
         for I in 1 .. Waiting loop
            if Can_Answer (Line, Begun_At, Pending (I)) then
               Found := True;
               Given := Pending (I);
               Untold := Untold + 1;
               if not Given.Overdue then
                  Due := Due - 1;
                  Served := Served + 1;
                  Answer := To_Unbounded_String
                    (if Line'Length > Longest_Kept
                     then Line (Line'First .. Line'First + 3)
                     else Line);
               end if;

               --  Earlier ones were overdue, and are removed
               Pending (1 .. Waiting - I) := Pending (I + 1 .. Waiting);
               Waiting := Waiting - I;
               return;
            end if;

            exit when not Pending (I).Overdue;
         end loop;
      end Match;

      procedure Note_Sent (Given : Command; OK : out Boolean) is
      begin
         OK := Waiting < Capacity;
         if OK then
            Waiting := Waiting + 1;
            Pending (Waiting) := Given;
            Due := Due + 1;
            Answer := Null_Unbounded_String;
         end if;
      end Note_Sent;

      procedure Published is
      begin
         Untold := Untold - 1;
      end Published;

      entry Reading_Ended when Silent is
      begin
         null;
      end Reading_Ended;

      procedure See (Class : Words.Message_Class) is
      begin
         Flags (Class) := True;
      end See;

      procedure See_End (Text : String) is
      begin
         Ended := To_Unbounded_String (Text);
         Flags (Words.Mission) := True;
      end See_End;

      entry Seen (for Class in Words.Message_Class) when Flags (Class) is
      begin
         null;
      end Seen;

      entry Settled when Untold = 0 and then Due = 0 is
      begin
         null;
      end Settled;

      function Unanswered return Natural is (Missed + Due);

      procedure Watch (Class : Words.Message_Class) is
      begin
         Flags (Class) := False;
      end Watch;

   end Exchange;

end Exchanges;
