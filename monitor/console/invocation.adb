--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arguments of the console monitor.

with Ada.Command_Line;  use Ada.Command_Line;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Numerals;

package body Invocation is

   function "+" (Text : String) return Unbounded_String
     renames To_Unbounded_String;

   procedure Put_Usage (Put_Line : not null access procedure (Line : String))
   is
   begin
      Put_Line ("Usage: destijl_monitor [OPTION ...]");
      Put_Line ("A monitor for the console: sends commands to the");
      Put_Line ("supervisor and shows what comes back.");
      Put_Line ("  --host HOST      where the supervisor runs (127.0.0.1)");
      Put_Line ("  --port N         its port (5544)");
      Put_Line ("  --token FILE     begin with the token in its first line");
      Put_Line ("  --script FILE    what to do, a command a line; - reads");
      Put_Line ("                   standard input");
      Put_Line ("  --images FOLDER  save every image there");
      Put_Line ("  --timeout S      wait so long for an answer (5)");
      Put_Line ("  --verbose        a line for every image and position");
      Put_Line ("  --quiet          failures and the summary only");
      Put_Line ("  --version, --help");
      Put_Line ("Exit status: 0 all was answered and as expected, 1 not so,");
      Put_Line ("2 bad usage. Without --script, commands come from the");
      Put_Line ("keyboard (help lists them).");
   end Put_Usage;

   procedure Read
     (Values : out Options;
      What   : out Outcome;
      Reason : out Unbounded_String)
   is
      Next   : Positive := 1;
      Number : Integer;
      OK     : Boolean  := True;

      procedure Take (Name, Given : String) is
         --  An option that has a value
      begin
         if Given = "" then
            OK := False;
         elsif Name = "--host" then
            Values.Host := +Given;
         elsif Name = "--port" then
            Numerals.Read (Given, 1, 65_535, Number, OK);
            if OK then
               Values.Port := Number;
            end if;
         elsif Name = "--script" then
            Values.Script := +Given;
         elsif Name = "--token" then
            Values.Token := +Given;
         elsif Name = "--images" then
            Values.Images := +Given;
         else
            Numerals.Read (Given, Values.Timeout, OK);
            OK := OK and then Values.Timeout > 0.0;
         end if;

         if not OK then
            Reason := +("bad value of " & Name & ": """ & Given & """");
         end if;
      end Take;

   begin
      Values := (others => <>);
      What := Run;

      while OK and then What = Run and then Next <= Argument_Count loop
         declare
            Given : constant String  := Argument (Next);
            Equal : constant Natural := Index (Given, "=");
            Name  : constant String  :=
              (if Equal = 0 then Given
               else Given (Given'First .. Equal - 1));
         begin
            if Name in
              "--host" | "--port" | "--token" | "--script" | "--images"
                | "--timeout"
            then
               if Equal /= 0 then
                  Take (Name, Given (Equal + 1 .. Given'Last));
               elsif Next < Argument_Count then
                  Next := Next + 1;
                  Take (Name, Argument (Next));
               else
                  OK := False;
                  Reason := +(Name & " wants a value");
               end if;
            elsif Given = "--quiet" then
               Values.Quiet := True;
            elsif Given = "--verbose" then
               Values.Verbose := True;
            elsif Given = "--help" or else Given = "-h" then
               What := Say_Usage;
            elsif Given = "--version" then
               What := Say_Version;
            else
               OK := False;
               Reason := +("unknown argument: " & Given);
            end if;
         end;
         Next := Next + 1;
      end loop;

      if not OK then
         What := Refuse;
      end if;
   end Read;

end Invocation;
