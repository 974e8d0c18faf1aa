--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;       use Ada.Text_IO;

with Expectations;      use Expectations;

package body Trace_Files is

   function Is_Set_By_Others (Item : Event) return Boolean is
     (To_String (Item.What) in "release" | "due");
   --  At a time that is not the task's

   procedure Read_Event (T : in out Trace; Word : Arguments) is
      --  SECONDS TASK EVENT [WHAT] [#COMMAND]
      Kind : constant String := Word (3);
      Item : Event :=
        (Duration'Value (Word (1)), To_Unbounded_String (Word (2)),
         To_Unbounded_String (Kind), 0);
   begin
      Check (Kind in "start" | "take" | "wait" | "resume" | "done" | "release"
               | "due" | "in" | "out" | "robot", "no event: " & Kind);
      Check (T.Tasks.Contains (Word (2)), "no task is called " & Word (2));
      for Place in 4 .. Word.Last_Index loop
         if Index (Word (Place), "#") = 1 then
            Item.Command := Natural'Value (Delete (Word (Place), 1, 1));
         else
            Append (Item.What, " " & Word (Place));
         end if;
      end loop;
      for Before of reverse T.Events loop
         exit when Is_Set_By_Others (Item);
         if Before.Who = Item.Who and then not Is_Set_By_Others (Before) then
            Check (Item.Time >= Before.Time,
                   "back in time at" & Item.Time'Image & ": "
                   & To_String (Item.Who & " " & Item.What));
            exit;
         end if;
      end loop;
      T.Events.Append (Item);
   end Read_Event;

   function Trace_Of (Path : String) return Trace is
      File   : File_Type;
      Result : Trace;
   begin
      Open (File, In_File, Path);
      while not End_Of_File (File) loop
         declare
            Word : constant Arguments := Words (Get_Line (File));
         begin
            if Word (1) /= "#" then
               Read_Event (Result, Word);
            elsif Word (2) = "task" then
               Result.Tasks.Append (Word (3));
            elsif Word (2) = "recorded" then
               Result.Recorded := Natural'Value (Word (3));
            end if;
         end;
      end loop;
      Close (File);
      Check (Result.Recorded > 0, "no event in " & Path);
      return Result;
   end Trace_Of;

   function Count_Of (T : Trace; Who, What : String) return Natural is
      Result : Natural := 0;
   begin
      for Item of T.Events loop
         Result := Result
           + Boolean'Pos (Item.Who = Who and then Item.What = What);
      end loop;
      return Result;
   end Count_Of;

end Trace_Files;
