--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the emulator remembers of every command.

with Ada.Characters.Handling;

package body Journals is

   use type Answer_Faults.Effect_Kind;
   use type Robot_Core.Octet;

   Hexadecimal : constant array (Robot_Core.Octet range 0 .. 15) of Character
     := "0123456789ABCDEF";

   function Text (Data : Robot_Core.Octets) return String is
      --  Escaped
      Result : String (1 .. 4 * Data'Length);
      Last   : Natural := 0;
   begin
      for Byte of Data loop
         if Byte in 33 .. 126 and then Byte /= Character'Pos ('\') then
            Last := Last + 1;
            Result (Last) := Character'Val (Byte);
         else
            Result (Last + 1 .. Last + 4) :=
              "\x" & Hexadecimal (Byte / 16) & Hexadecimal (Byte mod 16);
            Last := Last + 4;
         end if;
      end loop;
      return Result (1 .. Last);
   end Text;

   function Decimals
     (Value : Instant; Unit, Digit_Count : Positive) return String
   is
      --  Value in multiples of 10 ** Digit_Count * Unit nanoseconds
      Scale : constant Instant := 10 ** Digit_Count;
      Units : constant Instant := abs Value / Instant (Unit);
      Whole : constant String := Instant'Image (Units / Scale);
      Part  : constant String := Instant'Image (Scale + Units mod Scale);
      --  With a leading 1 that keeps the zeros
   begin
      return (if Value < 0 then "-" else "")
        & Whole (Whole'First + 1 .. Whole'Last)
        & '.' & Part (Part'First + 2 .. Part'Last);
   end Decimals;

   function Milliseconds (Time : Instant) return String is
     (Decimals (Time, Unit => 1_000, Digit_Count => 3));

   procedure Add (J : in out Journal; N : Note) is
   begin
      J.Notes (J.Next mod Capacity) := N;
      if J.Next < Note_Number'Last then
         J.Next := J.Next + 1;
      end if;
   end Add;

   procedure Clear (J : in out Journal) is
   begin
      J.Cleared := J.Next - 1;
   end Clear;

   procedure Find
     (J     : Journal;
      After : Note_Number;
      N     : out Note;
      Found : out Note_Number)
   is
      Oldest : constant Note_Number :=
        Natural'Max (J.Cleared + 1, J.Next - Natural'Min (J.Next, Capacity));
      Wanted : constant Note_Number :=
        Natural'Max (Natural'Max (Oldest, 1), After + 1);
   begin
      if Wanted < J.Next then
         N     := J.Notes (Wanted mod Capacity);
         Found := Wanted;
      else
         N     := (others => <>);
         Found := 0;
      end if;
   end Find;

   function Image (N : Note) return String is
      use type Robot_Core.Command_Kind;

      E : Robot_Core.Exchange renames N.Exchange;

      Good   : constant Boolean := E.Kind /= Robot_Core.Bad_Checksum;
      Length : constant Natural :=
        (if Good then E.Command.Length - 1 else E.Command.Length);
      Answer : constant String :=
        (if E.Reply.Length = 0 then "-"
         else Text (E.Reply.Data (1 .. E.Reply.Length - 2)));
      Ticks  : constant String := E.Ticks'Image;
      Taken  : constant Boolean :=
        Answer'Length = 1 and then Answer (Answer'First) = 'O';
   begin
      return "first=" & Image (N.First) & " last=" & Image (N.Last)
        & " command=" & Text (E.Command.Data (1 .. Length))
        & " checksum=" & (if Good then "ok" else "bad")
        & " before=" & Image (E.Before) & " after=" & Image (E.After)
        & " answer=" & Answer
        & (if E.Kind = Robot_Core.Reload
             and then N.Effect /= Answer_Faults.Lost
           then " reload=" & (if Taken then "accepted" else "refused")
                & " interval=" & Milliseconds (N.Interval)
                & " ticks=" & Ticks (Ticks'First + 1 .. Ticks'Last)
           else "")
        & (if N.Effect /= Answer_Faults.None
           then " fault="
                & Ada.Characters.Handling.To_Lower (N.Effect'Image)
           else "")
        & (if N.Late /= 0 then " late=" & Milliseconds (N.Late) else "");
   end Image;

   function Image (Time : Instant) return String is
     (Decimals (Time, Unit => 1_000, Digit_Count => 6));

   function Image (State : Robot_Core.State_Kind) return String is
     (Ada.Characters.Handling.To_Lower (State'Image));

end Journals;
