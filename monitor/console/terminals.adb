--  SPDX-License-Identifier: GPL-3.0-or-later
--  Standard output and standard error, shared by the tasks.

with Ada.Environment_Variables;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;           use GNAT.OS_Lib;
with Interfaces.C;
with Mutexes;

package body Terminals is

   --  Control sequences (ECMA-48, otherwise DEC's)

   Escape         : constant String := (1 => ASCII.ESC);
   Erase_Line     : constant String := ASCII.CR & Escape & "[K";
   Save_Cursor    : constant String := Escape & "7";
   Restore_Cursor : constant String := Escape & "8";
   Index_Line     : constant String := Escape & "D";
   --  One line down in the same column; scrolls at the bottom
   Up             : constant String := Escape & "[A";
   Down           : constant String := Escape & "[B";
   Insert_Line    : constant String := Escape & "[L";
   Delete_Line    : constant String := Escape & "[M";
   No_Wrap        : constant String := Escape & "[?7l";
   Wrap           : constant String := Escape & "[?7h";

   Prompt         : constant String := "> ";

   type Mode is (Plain, Status, Status_And_Input);
   --  The lines kept at the bottom

   Kept : Mode := Plain;
   Text : Unbounded_String;
   --  Of the status line

   Heard : Boolean := True;

   Mutex : Mutexes.Mutex;

   function Is_Terminal (File : File_Descriptor) return Boolean is
      use type Interfaces.C.int;

      function C_Isatty (File : Interfaces.C.int) return Interfaces.C.int
      with Import, Convention => C, External_Name => "isatty";
   begin
      return C_Isatty (Interfaces.C.int (File)) = 1;
   end Is_Terminal;

   function Shown (Line : String) return String is
      --  Line without control characters
      Result : String := Line;
   begin
      for C of Result loop
         if C < ' ' or else C = ASCII.DEL then
            C := '?';
         end if;
      end loop;
      return Result;
   end Shown;

   procedure Write_Out (File : File_Descriptor; Data : String) is
      --  Writes all of it, if possible in one call
      First   : Positive := Data'First;
      Written : Integer;
   begin
      while First <= Data'Last loop
         Written := Write (File, Data (First)'Address, Data'Last - First + 1);
         exit when Written <= 0;
         First := First + Written;
      end loop;
      if File = Standout and then First <= Data'Last then
         Heard := False;
      end if;
   end Write_Out;

   procedure Finish is
   begin
      Mutex.Seize;
      case Kept is
         when Plain            => null;
         when Status           => Write_Out (Standout, Erase_Line);
         when Status_And_Input =>
            --  Removes both lines; the next output begins in their place
            Write_Out (Standout, Erase_Line & Up & Delete_Line & ASCII.CR);
      end case;
      Kept := Plain;
      Mutex.Release;
   end Finish;

   function Input_Is_Terminal return Boolean is (Is_Terminal (Standin));

   function Is_Heard return Boolean is (Heard);

   procedure Line_Typed is
   begin
      Mutex.Seize;
      if Kept = Status_And_Input then
         --  Removes the stale status line above the typed line; a new status
         --  line and prompt follow below
         Write_Out
           (Standout,
            Up & Up & Delete_Line & Down & Erase_Line & No_Wrap
            & To_String (Text) & Wrap & ASCII.CR & ASCII.LF & Prompt);
      end if;
      Mutex.Release;
   end Line_Typed;

   function Output_Is_Terminal return Boolean is
     (Is_Terminal (Standout)
      and then Ada.Environment_Variables.Value ("TERM", "dumb") /= "dumb");

   procedure Put (File : File_Descriptor; Line : String) is
      --  A permanent line
   begin
      Mutex.Seize;
      if Kept = Plain or else not Is_Terminal (File) then
         Write_Out (File, Shown (Line) & ASCII.LF);
      elsif Kept = Status then
         Write_Out
           (File,
            Erase_Line & Shown (Line) & ASCII.LF & No_Wrap
            & To_String (Text) & Wrap);
      else
         --  Inserted above the status line. The typed text moves down with the
         --  cursor.
         Write_Out
           (File,
            Index_Line & Save_Cursor & Up & Up & ASCII.CR & Insert_Line
            & No_Wrap & Shown (Line) & Wrap & Restore_Cursor);
      end if;
      Mutex.Release;
   end Put;

   procedure Put_Error (Line : String) is
   begin
      Put (Standerr, "destijl_monitor: " & Line);
   end Put_Error;

   procedure Put_Line (Line : String) is
   begin
      Put (Standout, Line);
   end Put_Line;

   procedure Set_Status (Line : String) is
   begin
      Mutex.Seize;
      Text := To_Unbounded_String (Shown (Line));
      case Kept is
         when Plain =>
            null;
         when Status =>
            Write_Out
              (Standout,
               Erase_Line & No_Wrap & To_String (Text) & Wrap);
         when Status_And_Input =>
            Write_Out
              (Standout,
               Save_Cursor & Up & Erase_Line & No_Wrap & To_String (Text)
               & Wrap & Restore_Cursor);
      end case;
      Mutex.Release;
   end Set_Status;

   procedure Start (Interactive : Boolean) is
   begin
      Kept :=
        (if not Output_Is_Terminal then Plain
         elsif Interactive then Status_And_Input
         else Status);
      if Kept = Status_And_Input then
         Write_Out (Standout, ASCII.LF & Prompt);
      end if;
   end Start;

end Terminals;
