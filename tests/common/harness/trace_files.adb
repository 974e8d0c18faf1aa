--  SPDX-License-Identifier: GPL-3.0-or-later
--  The file that the supervisor writes with --trace: read as strictly as the
--  grammar of JSON has it, and given back as the events in it.

with Ada.Directories;
with Ada.Streams.Stream_IO;
with Ada.Unchecked_Deallocation;

package body Trace_Files is

   type Text_Access is access String;

   procedure Free is new Ada.Unchecked_Deallocation (String, Text_Access);

   procedure Parse (Text : String; Result : in out Trace) is

      Next : Positive := Text'First;

      procedure Fail (Why : String) with No_Return;

      generic
         with procedure Member (Name : String);
         --  Must go past its value
      procedure Parse_Object;

      generic
         with procedure Element;
      procedure Parse_Array;

      procedure Fail (Why : String) is
      begin
         raise Bad_Trace with Why & " at character" & Next'Image;
      end Fail;

      procedure Skip_Space is
      begin
         while Next <= Text'Last
           and then Text (Next) in ' ' | ASCII.HT | ASCII.LF | ASCII.CR
         loop
            Next := Next + 1;
         end loop;
      end Skip_Space;

      function Is_Next (C : Character) return Boolean is
         --  Behind space
      begin
         Skip_Space;
         return Next <= Text'Last and then Text (Next) = C;
      end Is_Next;

      procedure Take (C : Character) is
      begin
         if not Is_Next (C) then
            Fail ("no '" & C & "'");
         end if;
         Next := Next + 1;
      end Take;

      procedure Skip_Digits is
         First : constant Positive := Next;
      begin
         while Next <= Text'Last and then Text (Next) in '0' .. '9' loop
            Next := Next + 1;
         end loop;
         if Next = First then
            Fail ("no digit");
         end if;
      end Skip_Digits;

      procedure Skip_String (First : out Positive; Last : out Natural) is
         --  What is between its quotes
      begin
         Take ('"');
         First := Next;
         loop
            if Next > Text'Last then
               Fail ("a text does not end");
            elsif Text (Next) < ' ' then
               Fail ("a control character in a text");
            elsif Text (Next) = '\' then
               if Next < Text'Last
                 and then Text (Next + 1) in
                   '"' | '\' | '/' | 'b' | 'f' | 'n' | 'r' | 't'
               then
                  Next := Next + 2;
               elsif Next + 5 <= Text'Last
                 and then Text (Next + 1) = 'u'
                 and then (for all C of Text (Next + 2 .. Next + 5) =>
                             C in '0' .. '9' | 'a' .. 'f' | 'A' .. 'F')
               then
                  Next := Next + 6;
               else
                  Fail ("no escape sequence of JSON");
               end if;
            else
               exit when Text (Next) = '"';
               Next := Next + 1;
            end if;
         end loop;
         Last := Next - 1;
         Next := Next + 1;
      end Skip_String;

      procedure Skip_Number is
      begin
         Skip_Space;
         if Is_Next ('-') then
            Next := Next + 1;
         end if;
         if Next <= Text'Last and then Text (Next) = '0' then
            Next := Next + 1;
         else
            Skip_Digits;
         end if;
         if Next <= Text'Last and then Text (Next) = '.' then
            Next := Next + 1;
            Skip_Digits;
         end if;
         if Next <= Text'Last and then Text (Next) in 'e' | 'E' then
            Next := Next + 1;
            if Next <= Text'Last and then Text (Next) in '+' | '-' then
               Next := Next + 1;
            end if;
            Skip_Digits;
         end if;
      end Skip_Number;

      procedure Skip_Word (Word : String) is
      begin
         if Text'Last - Next + 1 < Word'Length
           or else Text (Next .. Next + Word'Length - 1) /= Word
         then
            Fail ("no value of JSON");
         end if;
         Next := Next + Word'Length;
      end Skip_Word;

      procedure Parse_Object is
         First : Positive;
         Last  : Natural;
      begin
         Take ('{');
         if not Is_Next ('}') then
            loop
               Skip_String (First, Last);
               Take (':');
               Member (Text (First .. Last));
               exit when not Is_Next (',');
               Next := Next + 1;
            end loop;
         end if;
         Take ('}');
      end Parse_Object;

      procedure Parse_Array is
      begin
         Take ('[');
         if not Is_Next (']') then
            loop
               Element;
               exit when not Is_Next (',');
               Next := Next + 1;
            end loop;
         end if;
         Take (']');
      end Parse_Array;

      procedure Skip_Value is
         First : Positive;
         Last  : Natural;

         procedure Skip_List (Named : Boolean; Closing : Character) is
            --  The members of an object or the elements of an array
         begin
            Next := Next + 1;
            if not Is_Next (Closing) then
               loop
                  if Named then
                     Skip_String (First, Last);
                     Take (':');
                  end if;
                  Skip_Value;
                  exit when not Is_Next (',');
                  Next := Next + 1;
               end loop;
            end if;
            Take (Closing);
         end Skip_List;

      begin
         Skip_Space;
         if Next > Text'Last then
            Fail ("no value");
         end if;
         case Text (Next) is
            when '"' => Skip_String (First, Last);
            when '{' => Skip_List (True, '}');
            when '[' => Skip_List (False, ']');
            when 't' => Skip_Word ("true");
            when 'f' => Skip_Word ("false");
            when 'n' => Skip_Word ("null");
            when others => Skip_Number;
         end case;
      end Skip_Value;

      function String_Value return String is
         First : Positive;
         Last  : Natural;
      begin
         Skip_String (First, Last);
         return Text (First .. Last);
      end String_Value;

      function Natural_Value return Natural is
         First : Positive;
      begin
         Skip_Space;
         First := Next;
         Skip_Number;
         return Natural'Value (Text (First .. Next - 1));
      exception
         when Constraint_Error =>
            Fail ("no natural number");
      end Natural_Value;

      function Time_Value return Nanoseconds is
         --  Of microseconds with up to three decimals
         First  : Positive;
         Result : Nanoseconds := 0;
         Places : Natural := 0;
         Point  : Boolean := False;
      begin
         Skip_Space;
         First := Next;
         Skip_Number;
         for C of Text (First .. Next - 1) loop
            if C = '.' then
               Point := True;
            elsif C in '0' .. '9' and then Places < 3 then
               Result := 10 * Result
                 + (Character'Pos (C) - Character'Pos ('0'));
               Places := Places + (if Point then 1 else 0);
            else
               Fail ("no time");
            end if;
         end loop;
         return Result * 10 ** (3 - Places);
      end Time_Value;

      procedure Parse_Event is
         Item  : Event;
         Named : Unbounded_String;
         Order : Natural := 0;
         Timed : Boolean := False;

         procedure Argument (Name : String) is
         begin
            if Name = "command" then
               Item.Command := Natural_Value;
            elsif Name = "name" then
               Named := To_Unbounded_String (String_Value);
            elsif Name = "sort_index" then
               Order := Natural_Value;
            else
               Skip_Value;
            end if;
         end Argument;

         procedure Parse_Arguments is new Parse_Object (Argument);

         procedure Member (Name : String) is
         begin
            if Name = "name" then
               declare
                  Value : constant String := String_Value;
               begin
                  if Value'Length not in Name_Length then
                     Fail ("a longer name than any");
                  end if;
                  Item.Length := Value'Length;
                  Item.Text (1 .. Value'Length) := Value;
               end;
            elsif Name = "ph" then
               declare
                  Value : constant String := String_Value;
               begin
                  if Value'Length /= 1 then
                     Fail ("a phase is one letter");
                  end if;
                  Item.Phase := Value (Value'First);
               end;
            elsif Name = "tid" then
               Item.Thread := Natural_Value;
            elsif Name = "ts" then
               Item.Time := Time_Value;
               Timed := True;
            elsif Name = "args" then
               Parse_Arguments;
            else
               Skip_Value;
            end if;
         end Member;

         procedure Parse_Members is new Parse_Object (Member);

      begin
         Parse_Members;
         case Item.Phase is
            when 'M' =>
               if Name (Item) = "thread_name" then
                  Result.Threads (Item.Thread).Name := Named;
               elsif Name (Item) = "thread_sort_index" then
                  Result.Threads (Item.Thread).Order := Order;
               end if;
            when 'B' | 'E' | 'i' =>
               if not Timed then
                  Fail ("an event without a time");
               end if;
               Result.Events.Append (Item);
            when others =>
               Fail ("an event of no known phase");
         end case;
      end Parse_Event;

      procedure Parse_Events is new Parse_Array (Parse_Event);

      procedure Data_Member (Name : String) is
      begin
         if Name = "recorded" then
            Result.Recorded := Natural_Value;
         elsif Name = "kept" then
            Result.Kept := Natural_Value;
         else
            Skip_Value;
         end if;
      end Data_Member;

      procedure Parse_Data is new Parse_Object (Data_Member);

      Any : Boolean := False;

      procedure Member (Name : String) is
      begin
         if Name = "traceEvents" then
            Any := True;
            Parse_Events;
         elsif Name = "otherData" then
            Parse_Data;
         else
            Skip_Value;
         end if;
      end Member;

      procedure Parse_Whole is new Parse_Object (Member);

   begin
      Parse_Whole;
      Skip_Space;
      if Next <= Text'Last then
         Fail ("something behind the end");
      elsif not Any then
         Fail ("no traceEvents");
      end if;
   end Parse;

   procedure Read (Path : String; Result : out Trace) is
      use Ada.Streams.Stream_IO;
      File : File_Type;
      Text : Text_Access :=
        new String (1 .. Natural (Ada.Directories.Size (Path)));
   begin
      Result.Events.Clear;
      Result.Threads := (others => <>);
      Result.Recorded := 0;
      Result.Kept := 0;
      Open (File, In_File, Path);
      String'Read (Stream (File), Text.all);
      Close (File);
      Parse (Text.all, Result);
      Free (Text);
   exception
      when others =>
         Free (Text);
         raise;
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
