--  SPDX-License-Identifier: GPL-3.0-or-later
--  Follows all interpretations of the messages in parallel: a message that may
--  be an answer or unsolicited is taken as both, until others decide.

with Ada.Containers;    use Ada.Containers;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

package body Answer_Ledgers is

   Shown : constant := 60;
   --  Characters of a command in a complaint

   function Is_Answer (Kind : Answer_Kind; Label : String) return Boolean is
     (case Kind is
         when Usual   => Label in "AACK" | "ANAK" | "ACRJ" | "ATIM" | "ACER",
         when Battery =>
           Label in "AACK" | "ANAK" | "ACRJ" | "ATIM" | "ACER" | "RBLV",
         when State   =>
           Label in "AACK" | "ANAK" | "ACRJ" | "ATIM" | "ACER" | "RCST",
         when Arena   =>
           Label in "AACK" | "ANAK" | "ACRJ" | "ATIM" | "ACER" | "CIMG",
         when Refused | Perhaps => Label = "ACER",
         when Silent  => False);

   function Is_Unasked (Label : String) return Boolean is
     (Label in
        "CIMG" | "CPOS" | "RBLV" | "MSSG" | "MPRG" | "MEND" | "ATIM");

   function Certain (L : Ledger) return Natural is
      --  Commands that are answered for certain
   begin
      for Number in 0 .. Natural (L.Sent.Length) loop
         if L.Costs (Number) /= Impossible then
            return Number;
         end if;
      end loop;
      return Natural (L.Sent.Length);
   end Certain;

   function Kind_Of (Command : String) return Answer_Kind is
      Name : constant String := Head (Command, 4);
   begin
      return
        (if Name = "RGBT" then Battery
         elsif Name = "RGST" then State
         elsif Name = "CASA" then Arena
         elsif Name in "CACO" | "CAIN" | "LIVE" | "MSSG" then Silent
         else Usual);
   end Kind_Of;

   function Image (Text : Unbounded_String) return String is
      --  Printing characters only
      Plain : String := Slice (Text, 1, Natural'Min (Shown, Length (Text)));
   begin
      for C of Plain loop
         if C not in ' ' .. '~' then
            C := '?';
         end if;
      end loop;
      return Plain;
   end Image;

   procedure Clear (L : in out Ledger) is
   begin
      L := (others => <>);
   end Clear;

   procedure Pass_Over (L : in out Ledger) is
      --  What may go without an answer
   begin
      for Number in 1 .. Natural (L.Sent.Length) loop
         if L.Sent (Number).Kind in Perhaps | Silent then
            L.Costs (Number) := Natural'Min
              (L.Costs (Number), L.Costs (Number - 1));
            if L.Sent (Number).Kind = Silent then
               --  there is but one way
               L.Costs (Number - 1) := Impossible;
            end if;
         end if;
      end loop;
   end Pass_Over;

   procedure Put_Command
     (L : in out Ledger; Text : String; Kind : Answer_Kind) is
   begin
      L.Sent.Append
        ((To_Unbounded_String (Text (Text'First .. Natural'Min
            (Text'Last, Text'First + Shown - 1))), Kind, Now));
      L.Costs.Append (Impossible);
      Pass_Over (L);
   end Put_Command;

   procedure Put_Message (L : in out Ledger; Item : Message) is
      Before : constant Cost_Vectors.Vector := L.Costs;
      Price  : constant Natural := (if Item.Label = "ATIM" then 1 else 0);
      Best   : Natural;
      Any    : Boolean := False;
   begin
      if L.Broken then
         return;
      end if;
      for Number in 0 .. Natural (L.Sent.Length) loop
         Best := Impossible;
         if Is_Unasked (Item.Label) and then Before (Number) /= Impossible
         then
            Best := Before (Number) + Price;
         end if;
         if Number > 0 and then Before (Number - 1) /= Impossible
           and then L.Sent (Number).Time <= Item.Time
           and then Is_Answer (L.Sent (Number).Kind, Item.Label)
         then
            Best := Natural'Min (Best, Before (Number - 1));
         end if;
         L.Costs (Number) := Best;
         Any := Any or else Best /= Impossible;
      end loop;
      if Any then
         Pass_Over (L);
      else
         L.Costs := Before;
         L.Broken := True;
         L.Breach := To_Unbounded_String
           ("message" & Item.Number'Image & ", " & Item.Label
            & (if Length (Item.Data) = 0 then "" else ":")
            & Image (Item.Data) & ", answers no command: after"
            & L.Sent.Length'Image & " commands, of which"
            & Natural'Image (Certain (L)) & " had been answered"
            & (if Waiting (L) = 0 then ""
               else ", the next was " & First_Waiting (L)));
      end if;
   end Put_Message;

   function Is_Broken (L : Ledger) return Boolean is (L.Broken);

   function Complaint (L : Ledger) return String is (To_String (L.Breach));

   function Is_Complete (L : Ledger) return Boolean is
     (not L.Broken and then L.Costs.Last_Element /= Impossible);

   function Unasked_Losses (L : Ledger) return Natural is
      Least : Natural := Impossible;
   begin
      if Is_Complete (L) then
         return L.Costs.Last_Element;
      end if;
      for Cost of L.Costs loop
         Least := Natural'Min (Least, Cost);
      end loop;
      return Least;
   end Unasked_Losses;

   function Commands (L : Ledger) return Natural is
     (Natural (L.Sent.Length));

   function Waiting (L : Ledger) return Natural is
     (Commands (L) - Certain (L));

   function First_Waiting (L : Ledger) return String is
     (if Waiting (L) = 0 then ""
      else """" & Image (L.Sent (Certain (L) + 1).Text) & """");

end Answer_Ledgers;
