--  SPDX-License-Identifier: GPL-3.0-or-later
--  A monitor for the console: sends commands to the supervisor, from the
--  keyboard or a script, and shows its messages.

with Accounts;
with Ada.Directories;
with Ada.Exceptions;
with Ada.Real_Time;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;
with Admission;
with Connections;
with GNAT.OS_Lib;           use GNAT.OS_Lib;
with Interruptions;
with Invocation;
with Line_Inputs;
with Numerals;
with Project_Version;
with Terminals;
with Words;

procedure Destijl_Monitor is

   use type Words.Message_Class;

   Retry : constant Duration := 0.2;
   --  Between the attempts of "try"

   Values   : Invocation.Options;
   Scripted : Boolean;
   --  The input is a script: one command at a time, the first failure ends it

   Input : Line_Inputs.Source;

   function First_Line (Token_File : String) return String is
      --  The line that shows the token; empty if Token_File is empty. Ends the
      --  program if the file contains no token
      File  : Ada.Text_IO.File_Type;
      Text  : String (1 .. 256);
      Last  : Natural;
      Token : Admission.Token;
   begin
      if Token_File = "" then
         return "";
      end if;
      Ada.Text_IO.Open (File, Ada.Text_IO.In_File, Token_File);
      Ada.Text_IO.Get_Line (File, Text, Last);
      Ada.Text_IO.Close (File);
      Admission.Read_Token (Text (1 .. Last), Token);
      if Token.Length = 0 then
         Terminals.Put_Error (Token_File & " has no token in its first line");
         OS_Exit (2);
      end if;
      return Admission.Label & Token.Data (1 .. Token.Length);
   exception
      when Error : Ada.Text_IO.Name_Error | Ada.Text_IO.Use_Error
         | Ada.Text_IO.End_Error =>
         Terminals.Put_Error
           ("cannot read the token: "
            & Ada.Exceptions.Exception_Message (Error));
         OS_Exit (2);
   end First_Line;

   procedure Send (Given : Words.Action) is
   begin
      for Attempt in 1 .. Given.Attempts loop
         Connections.Send (To_String (Given.Text));
         if Scripted or else Given.Attempts > 1 then
            Connections.Await_Answers;
         end if;
         exit when Words.Is_Acknowledged (Connections.Last_Answer);
         if Attempt < Given.Attempts then
            delay Retry;
         end if;
      end loop;
   end Send;

   procedure Fail (Text : String; Status : Positive := 1) is
      --  Reports the mistake, and ends a script
   begin
      Terminals.Put_Error (Text);
      if Scripted then
         Connections.Finish (Status);
      end if;
   end Fail;

   procedure Carry_Out (Given : Words.Action; Where : String) is
      Text : constant String := To_String (Given.Text);
      Done : Boolean;

      function Last return String is
        (if Connections.Last_Answer = "" then "missing"
         else Connections.Last_Answer);
   begin
      case Given.Kind is
         when Words.Nothing =>
            null;

         when Words.Send =>
            Send (Given);

         when Words.Pause =>
            delay Given.Seconds;

         when Words.Wait_Message =>
            --  what was refused brings no message
            if Scripted and then Last /= "missing"
              and then not Words.Is_Acknowledged (Last)
            then
               Fail
                 (Where & "no " & Words.Name (Given.Awaited)
                  & ": the last answer is " & Last);
            end if;
            Connections.Await (Given.Awaited, Done);
            if not Done then
               Fail
                 (Where & "no "
                  & Words.Name (Given.Awaited) & " within "
                  & (if Given.Awaited = Words.Mission then "10 min"
                     else Numerals.Seconds (Values.Timeout) & " s"));
            elsif Given.Awaited = Words.Mission
              and then Connections.Last_End /= "done"
            then
               Fail (Where & "mission " & Connections.Last_End);
            end if;

         when Words.Expect =>
            Connections.Await_Answers;
            if not Words.Is_As_Expected (Connections.Last_Answer, Text) then
               Fail
                 (Where & "expected " & Text & ", the last answer is "
                  & Last);
            end if;

         when Words.Save =>
            Accounts.Save_Latest (Text, Done);
            if not Done and then Scripted then
               Connections.Finish (1);
            end if;

         when Words.Help =>
            Words.List (Terminals.Put_Line'Access);

         when Words.Quit =>
            Connections.Await_Answers;
            Connections.Finish (0);

         when Words.Mistake =>
            Fail (Where & Text, Status => 2);
      end case;
   end Carry_Out;

   procedure Check_Script is
      --  Ends the program if a line of the script is invalid: before the robot
      --  moves, not in between
      Line   : Unbounded_String;
      Ended  : Boolean;
      OK     : Boolean;
      Number : Natural := 0;
      Wrong  : Natural := 0;
      Given  : Words.Action;
      use type Words.Action_Kind;
   begin
      Line_Inputs.Open (Input, To_String (Values.Script), OK);
      if not OK then
         Terminals.Put_Error ("cannot read " & To_String (Values.Script));
         OS_Exit (2);
      end if;

      loop
         Line_Inputs.Get_Line (Input, Line, Ended);
         exit when Ended;
         Number := Number + 1;
         Given := Words.Translate (To_String (Line));
         if Given.Kind = Words.Mistake then
            Wrong := Wrong + 1;
            Terminals.Put_Error
              (To_String (Values.Script) & ":" & Numerals.Image (Number)
               & ": " & To_String (Given.Text));
         end if;
      end loop;
      Line_Inputs.Close (Input);

      if Wrong > 0 then
         OS_Exit (2);
      end if;
      Line_Inputs.Open (Input, To_String (Values.Script), OK);
   end Check_Script;

   procedure Connect is
      Failed : Boolean;
   begin
      Connections.Open
        (To_String (Values.Host), Values.Port,
         First_Line (To_String (Values.Token)), Failed);
      if Failed then
         OS_Exit (1);
      end if;

      if not Values.Quiet then
         Terminals.Put_Line
           ("connected to " & To_String (Values.Host) & " port "
            & Numerals.Image (Values.Port)
            & (if Scripted then "" else "; help lists the commands"));
         Terminals.Start (Interactive => not Scripted);
      end if;
      Accounts.Start
        (Ada.Real_Time.Clock,
         Quiet        => Values.Quiet,
         Each_Message => Values.Verbose,
         Folder       => To_String (Values.Images));
      Connections.Start (Values.Timeout);
   end Connect;

   procedure Make_Folder is
   begin
      if Values.Images /= "" then
         Ada.Directories.Create_Path (To_String (Values.Images));
      end if;
   exception
      when others =>
         Terminals.Put_Error
           ("cannot make the folder " & To_String (Values.Images));
         OS_Exit (1);
   end Make_Folder;

   procedure Put_Error_Line (Line : String) is
      --  Without the program's name
      Text    : constant String  := Line & ASCII.LF;
      Ignored : constant Integer :=
        Write (Standerr, Text'Address, Text'Length);
   begin
      null;
   end Put_Error_Line;

   procedure Read_Command_Line is
      --  Ends the program if there is nothing more to do
      What   : Invocation.Outcome;
      Reason : Unbounded_String;
   begin
      Invocation.Read (Values, What, Reason);
      case What is
         when Invocation.Run =>
            null;
         when Invocation.Say_Version =>
            Terminals.Put_Line ("destijl_monitor " & Project_Version.Number);
            OS_Exit (if Terminals.Is_Heard then 0 else 1);
         when Invocation.Say_Usage =>
            Invocation.Put_Usage (Terminals.Put_Line'Access);
            OS_Exit (if Terminals.Is_Heard then 0 else 1);
         when Invocation.Refuse =>
            Terminals.Put_Error (To_String (Reason));
            Invocation.Put_Usage (Put_Error_Line'Access);
            OS_Exit (2);
      end case;
   end Read_Command_Line;

   procedure Run is
      --  Processes the input, to its end
      Line   : Unbounded_String;
      Ended  : Boolean;
      Number : Natural := 0;
   begin
      loop
         Line_Inputs.Get_Line (Input, Line, Ended);
         exit when Ended;
         Number := Number + 1;
         if not Scripted then
            Terminals.Line_Typed;
         end if;
         Carry_Out
           (Words.Translate (To_String (Line)),
            Where =>
              (if Scripted then "line " & Numerals.Image (Number) & ": "
               else ""));
      end loop;
      Connections.Await_Answers;
      Connections.Finish (0);
   end Run;

   task Interrupter is
      entry Start;
   end Interrupter;
   --  Ends the program on a signal

   task body Interrupter is
   begin
      accept Start;
      Interruptions.Await;
      Connections.Finish (if Scripted then 1 else 0);
   end Interrupter;

begin
   Read_Command_Line;
   Scripted := Values.Script /= "" or else not Terminals.Input_Is_Terminal;
   if To_String (Values.Script) in "" | "-" then
      Line_Inputs.Open_Standard_Input (Input);
   else
      Check_Script;
   end if;
   Make_Folder;
   Connect;
   Interrupter.Start;
   Run;
exception
   when Error : others =>
      Terminals.Put_Error (Ada.Exceptions.Exception_Information (Error));
      OS_Exit (1);
end Destijl_Monitor;
