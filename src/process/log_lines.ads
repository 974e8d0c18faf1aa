--  SPDX-License-Identifier: GPL-3.0-or-later
--  Log lines that wait for the console, and the count of lines dropped because
--  there was no room: a message takes their place.

with Bounded_Queues;
with Options;

package Log_Lines with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Log_Lines);

   Capacity : constant := 256;

   type Instant is record
      Seconds     : Natural := 0;
      Thousandths : Natural range 0 .. 999 := 0;
   end record;
   --  The time since the supervisor started

   Max_Text : constant := 232;
   --  Characters of a line: at most 256 bytes are copied under the lock

   subtype Text_Length is Natural range 0 .. Max_Text;

   type Line is record
      Level  : Options.Level := Options.Info;
      Time   : Instant;
      Length : Text_Length := 0;
      Text   : String (1 .. Max_Text) := (others => ' ');
   end record;

   package Queues is new Bounded_Queues (Line, Capacity);

   type State is record
      Kept     : Queues.Queue;
      Not_Kept : Natural := 0;
      Writing  : Boolean := False;
      --  the line taken last is not yet on the console
   end record;

   function Waiting (S : State) return Natural is
     (Queues.Length (S.Kept) + (if S.Writing then 1 else 0));
   --  Lines that are not yet written

   procedure Put (S : in out State; Item : Line)
   with
     Post => S.Writing = S'Old.Writing
       and then
         (if Queues.Is_Full (S'Old.Kept) then
             Queues.Is_Same (S.Kept, S'Old.Kept)
             and then S.Not_Kept =
               Natural'Min (Natural'Last - 1, S'Old.Not_Kept) + 1
          else Queues.Begins_With (S.Kept, S'Old.Kept)
             and then Queues.Length (S.Kept) =
               Queues.Length (S'Old.Kept) + 1
             and then Queues.Element_At
               (S.Kept, Queues.Length (S.Kept)) = Item
             and then S.Not_Kept = S'Old.Not_Kept);

   procedure Take
     (S       : in out State;
      Item    : out Line;
      Found   : out Boolean;
      Missing : out Natural)
   with
     Post => Found = (Queues.Length (S'Old.Kept) > 0)
       and then S.Writing = Found
       and then Missing = (if Found then S'Old.Not_Kept else 0)
       and then
         (if Missing > 0 then
             Queues.Is_Same (S.Kept, S'Old.Kept) and then S.Not_Kept = 0
          else S.Not_Kept = S'Old.Not_Kept
            and then
              (if Found then
                  Item = Queues.Element_At (S'Old.Kept, 1)
                  and then Queues.Is_Without_First (S.Kept, S'Old.Kept)));
   --  The oldest line. Missing > 0: the number of lines dropped before it;
   --  then Item has only a level and a time

   procedure Written (S : in out State)
   with Post => not S.Writing
     and then S.Not_Kept = S'Old.Not_Kept
     and then Queues.Is_Same (S.Kept, S'Old.Kept);

end Log_Lines;
