--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Bounded_Queues;
with Event;
with Schedule;

package body Journal with SPARK_Mode is

   use type Options.Level;

   package Arrived is new Event (Schedule.Th_Console);

   package Queues is new Bounded_Queues (Line, Capacity);

   type Lines is record
      Kept     : Queues.Queue;
      Not_Kept : Natural := 0;
      --  dropped after those, for lack of room
      Writing  : Boolean := False;
      --  the line taken last is not yet on the console
   end record;

   Start : constant Time := Clock;

   Least : Options.Level := Options.Info
     with Atomic, Async_Readers, Async_Writers;
   --  The most detailed level logged. Outside the buffer: a line that is not
   --  logged needs neither a lock nor the time of day

   procedure Keep (S : in out Lines; Item : Line)
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
             and then S.Not_Kept = S'Old.Not_Kept)
   is
   begin
      if not Queues.Is_Full (S.Kept) then
         Queues.Put (S.Kept, Item);
      elsif S.Not_Kept < Natural'Last then
         S.Not_Kept := S.Not_Kept + 1;
      end if;
   end Keep;

   procedure Remove
     (S       : in out Lines;
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
                  and then Queues.Is_Without_First (S.Kept, S'Old.Kept)))
   is
      --  The oldest line. Missing > 0: the number of lines dropped before it;
      --  then Item has only a level and a time
   begin
      if Queues.Length (S.Kept) > 0 and then S.Not_Kept > 0 then
         Found := True;
         Missing := S.Not_Kept;
         Item :=
           (Level  => Options.Warning,
            Time   => Queues.Element_At (S.Kept, 1).Time,
            others => <>);
         S.Not_Kept := 0;
      else
         Queues.Take (S.Kept, Item, Found);
         Missing := 0;
      end if;
      S.Writing := Found;
   end Remove;

   protected Buffer with Priority => Schedule.Journal_Ceiling is
      procedure Put (Item : Line);
      procedure Take
        (Item : out Line; Found : out Boolean; Missing : out Natural);
      procedure Get_Waiting (Waiting : out Natural);
   private
      State : Lines;
   end Buffer;

   protected body Buffer is

      procedure Put (Item : Line) is
      begin
         Keep (State, Item);
      end Put;

      procedure Take
        (Item : out Line; Found : out Boolean; Missing : out Natural) is
      begin
         Remove (State, Item, Found, Missing);
      end Take;

      procedure Get_Waiting (Waiting : out Natural) is
      begin
         Waiting := Queues.Length (State.Kept)
           + (if State.Writing then 1 else 0);
      end Get_Waiting;

   end Buffer;

   procedure Get_Now (Now : out Instant)
   with Global => (Input => (Start, Clock_Time))
   is
      Read  : constant Time := Clock;
      Whole : Seconds_Count;
      Rest  : Time_Span;
   begin
      --  no division of the whole time: its result is an Integer, which
      --  overflows after 24 days
      Split (Time_Of (0, Read - Start), Whole, Rest);
      Now :=
        (Seconds     => Natural
           (Seconds_Count'Max
              (0, Seconds_Count'Min (Whole, Seconds_Count (Natural'Last)))),
         Thousandths =>
           Integer'Max (0, Integer'Min (Rest / Milliseconds (1), 999)));
   end Get_Now;

   procedure Set_Level (Least : Options.Level) is
   begin
      Journal.Least := Least;
   end Set_Level;

   procedure Get_Kept (Level : Options.Level; Kept : out Boolean) is
      Last_Kept : constant Options.Level := Least;
   begin
      Kept := Level <= Last_Kept;
   end Get_Kept;

   procedure Put_Part
     (Level : Options.Level; Now : Instant; Text : String; After : Natural)
   with Pre => After <= Text'Length
   is
      --  A line of Text, without its first After characters
      Item : Line := (Level => Level, Time => Now, others => <>);
   begin
      Item.Length := Natural'Min (Max_Text, Text'Length - After);
      for K in 1 .. Item.Length loop
         Item.Text (K) := Text (Text'First + (After + (K - 1)));
         if Item.Text (K) not in ' ' .. '~' then
            Item.Text (K) := '?';
         end if;
      end loop;
      Buffer.Put (Item);
   end Put_Part;

   procedure Put (Level : Options.Level; Text : String) is
      Kept : Boolean;
      Now  : Instant;
      Done : Natural := 0;
   begin
      Get_Kept (Level, Kept);
      if Kept then
         Get_Now (Now);
         loop
            Put_Part (Level, Now, Text, Done);
            exit when Text'Length - Done <= Max_Text;
            Done := Done + Max_Text;
            pragma Loop_Invariant (Done <= Text'Length);
            pragma Loop_Variant (Increases => Done);
         end loop;
         Arrived.Set;
      end if;
   end Put;

   procedure Put (Level : Options.Level; Text : Texts.Text) is
   begin
      Put (Level, Text.Data (1 .. Text.Length));
   end Put;

   procedure Take (Item : out Line) is
      Found   : Boolean;
      Missing : Natural;
      Told    : Texts.Text;
   begin
      loop
         Buffer.Take (Item, Found, Missing);
         exit when Found;
         Arrived.Wait;
      end loop;
      if Missing > 0 then
         Texts.Append (Told, Missing);
         Texts.Append
           (Told, " lines were not kept: the console is too slow");
         Item.Length := Told.Length;
         Item.Text (1 .. Told.Length) := Told.Data (1 .. Told.Length);
      end if;
   end Take;

   procedure Get_Waiting (Count : out Natural) is
   begin
      Buffer.Get_Waiting (Count);
   end Get_Waiting;

end Journal;
