--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Text_IO;

with Child_Processes; use Child_Processes;

package body Trace_Files is

   type Job is record
      Depth : Natural := 0;
      --  0: idle, 1: in a job, 2: waiting in it
      Place : Natural := 0;
      --  of its beginning
   end record;

   type Job_Array is array (Thread_Number) of Job;

   function Time_Of (Text : String) return Nanoseconds is
      --  Of seconds with nine decimals
      Point : constant Natural := Text'Last - 9;
   begin
      if Point <= Text'First or else Text (Point) /= '.' then
         raise Bad_Trace with "no time: " & Text;
      end if;
      return Nanoseconds'Value (Text (Text'First .. Point - 1)) * 10 ** 9
        + Nanoseconds'Value (Text (Point + 1 .. Text'Last));
   end Time_Of;

   procedure Append
     (Result  : in out Trace;
      Phase   : Character;
      Thread  : Thread_Number;
      Time    : Nanoseconds;
      Name    : String  := "";
      Command : Natural := 0)
   is
      Item : Event :=
        (Phase, Thread, Time, Command, Length => Name'Length, others => <>);
   begin
      Item.Text (1 .. Name'Length) := Name;
      Result.Events.Append (Item);
   end Append;

   procedure Close
     (Result : in out Trace;
      Open   : in out Job_Array;
      Thread : Thread_Number;
      Time   : Nanoseconds;
      Left   : Natural) is
   begin
      while Open (Thread).Depth > Left loop
         Append (Result, 'E', Thread, Time);
         Open (Thread).Depth := Open (Thread).Depth - 1;
      end loop;
   end Close;

   procedure Read_Event
     (Result : in out Trace; Open : in out Job_Array; Word : Arguments)
   is
      --  SECONDS TASK EVENT [WHAT] [#COMMAND]. A job that begins or ends also
      --  ends the one before, and its wait
      Time    : constant Nanoseconds := Time_Of (Word (1));
      Thread  : constant Thread_Number := Thread_Of (Result, Word (2));
      Kind    : constant String := Word (3);
      Command : Natural := 0;
      What    : Unbounded_String;
   begin
      for Place in 4 .. Word.Last_Index loop
         declare
            Text : constant String := Word (Place);
         begin
            if Text (Text'First) = '#' then
               Command := Natural'Value (Text (Text'First + 1 .. Text'Last));
            else
               What := To_Unbounded_String (" " & Text);
            end if;
         end;
      end loop;
      if Kind = "start" then
         Close (Result, Open, Thread, Time, Left => 0);
         Append (Result, 'B', Thread, Time, "job");
         Open (Thread) := (1, Result.Events.Last_Index);
      elsif Kind = "take" then
         if Open (Thread).Depth > 0 then
            Result.Events (Open (Thread).Place).Command := Command;
         end if;
      elsif Kind = "wait" and then Open (Thread).Depth = 1 then
         Append (Result, 'B', Thread, Time, "wait for" & To_String (What));
         Open (Thread).Depth := 2;
      elsif Kind = "done" then
         Close (Result, Open, Thread, Time, Left => 0);
      elsif Kind in "wait" | "resume" then
         Close (Result, Open, Thread, Time, Left => 1);
      elsif Kind in "release" | "due" | "in" | "out" | "robot" then
         Append (Result, 'i', Thread, Time, Kind & To_String (What), Command);
      else
         raise Bad_Trace with "no event: " & Kind;
      end if;
   end Read_Event;

   procedure Read (Path : String; Result : out Trace) is
      use Ada.Text_IO;
      File  : File_Type;
      Open  : Job_Array;
      Known : Natural := 0;
   begin
      Result.Events.Clear;
      Result.Threads := (others => <>);
      Result.Recorded := 0;
      Ada.Text_IO.Open (File, In_File, Path);
      while not End_Of_File (File) loop
         declare
            Word : constant Arguments := Words (Get_Line (File));
         begin
            if Word (1) /= "#" then
               Read_Event (Result, Open, Word);
            elsif Word (2) = "task" then
               Known := Known + 1;
               Result.Threads (Known) :=
                 (To_Unbounded_String (Word (3)), Natural'Value (Word (4)));
            elsif Word (2) = "recorded" then
               Result.Recorded := Natural'Value (Word (3));
            end if;
         end;
      end loop;
      Close (File);
      if Result.Recorded = 0 then
         raise Bad_Trace with "no event in " & Path;
      end if;
      for Thread in Thread_Number loop
         Close
           (Result, Open, Thread, Result.Events.Last_Element.Time, Left => 0);
      end loop;
   end Read;

   function Thread_Of (T : Trace; Name : String) return Thread_Number is
   begin
      for Number in Thread_Number loop
         if T.Threads (Number).Name = Name then
            return Number;
         end if;
      end loop;
      raise Bad_Trace with "no task is called " & Name;
   end Thread_Of;

end Trace_Files;
