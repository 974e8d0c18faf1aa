--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the programs under test are, and the end of them.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Command_Line;
with Ada.Directories;       use Ada.Directories;
with Ada.Exceptions;        use Ada.Exceptions;
with Ada.Streams.Stream_IO;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;
with GNAT.OS_Lib;
with Interfaces.C;          use Interfaces.C;

with Libc;
with Option_Readers;
with Plain_Numbers;         use Plain_Numbers;

package body Programs is

   type Program is (Supervisor_Path, Emulator_Path, Monitor_Path);
   --  Options are --supervisor ...

   Paths  : array (Program) of Unbounded_String;
   Folder : Unbounded_String;

   Terminals : Boolean := False;

   function Folder_Of (Process : int) return String is
     ("/tmp/destijl_tests." & Image (Integer (Libc.Geteuid)) & "."
      & Image (Integer (Process)));
   --  What a killed process of another user has left, cannot be removed

   procedure Set_Mode (Path : String; Mode : unsigned) is
   begin
      if Libc.Chmod (To_C (Path), Mode) /= 0 then
         raise Use_Error with "chmod of " & Path;
      end if;
   end Set_Mode;

   function Beside (Name : String) return String is
      Here : GNAT.OS_Lib.String_Access :=
        GNAT.OS_Lib.Locate_Exec_On_Path (Ada.Command_Line.Command_Name);
   begin
      return Found : constant String := Compose
        (Containing_Directory (Full_Name (Here.all)), Name)
      do
         GNAT.OS_Lib.Free (Here);
      end return;
   end Beside;

   function Path (Which : Program; Name : String) return String is
     (if Paths (Which) = "" then Beside (Name) else To_String (Paths (Which)));

   function Supervisor return String is (Path (Supervisor_Path, "destijl"));

   function Emulator return String is
     (Path (Emulator_Path, "destijl_emulator"));

   function Monitor return String is (Path (Monitor_Path, "destijl_monitor"));

   function Vision_Library return String is
     (Compose (Containing_Directory (Supervisor), "libdestijl_vision.so"));

   function With_Sockets return Boolean is (not Terminals);

   function New_File
     (Name, Text : String; Mode : unsigned := 8#644#) return String
   is
      use Ada.Streams.Stream_IO;
      Path : constant String := Temporary_Folder & "/" & Name;
      File : File_Type;
   begin
      if Exists (Path) then
         --  perhaps one that nobody may write
         Delete_File (Path);
      end if;
      Create (File, Out_File, Path);
      String'Write (Stream (File), Text);
      Close (File);
      Set_Mode (Path, Mode);
      return Path;
   end New_File;

   function Copied (Path : String) return String is
      To_Be_Run : constant := 8#755#;
      Copy      : constant String :=
        Compose (Temporary_Folder, Simple_Name (Path));
   begin
      if not Exists (Copy) then
         Copy_File (Path, Copy);
         Set_Mode (Copy, To_Be_Run);
      end if;
      return Copy;
   end Copied;

   function Preload (Library : String := "") return String is
     (if Terminals and then Library = "" then ""
      else "env LD_PRELOAD="
           & (if Terminals then "" else Copied (Beside ("libsocket_line.so")))
           & (if Library = "" then "" else ":" & Copied (Beside (Library))));

   function Read_Option return Boolean is
      Name : constant String := Option_Readers.Name;
   begin
      if Name = "--terminals" then
         Terminals := True;
         return True;
      end if;
      for Which in Program loop
         if Name & "_path" = "--" & To_Lower (Which'Image) then
            Paths (Which) :=
              To_Unbounded_String (Full_Name (Option_Readers.Value));
            return True;
         end if;
      end loop;
      return False;
   end Read_Option;

   procedure Read_Option (Usage : String) is
   begin
      if Option_Readers.Name = "--help" then
         Ada.Text_IO.Put_Line (Usage);
         GNAT.OS_Lib.OS_Exit (0);
      elsif not Read_Option then
         Option_Readers.Refuse;
      end if;
   end Read_Option;

   function Temporary_Folder return String is
      Open_To_All : constant := 8#777#;
   begin
      if Folder = "" then
         --  one that a killed process of the same number has left
         Remove_Left (Libc.Getpid);
         Folder := To_Unbounded_String (Folder_Of (Libc.Getpid));
         Create_Directory (To_String (Folder));
         Set_Mode (To_String (Folder), Open_To_All);
      end if;
      return To_String (Folder);
   end Temporary_Folder;

   function Copied_Supervisor return String is
      Unused : constant String :=
        (if Exists (Vision_Library) then Copied (Vision_Library) else "");
   begin
      return Copied (Supervisor);
   end Copied_Supervisor;

   procedure Remove (Path : String) is
      --  By the system's own tool: links whose emulator has gone point
      --  nowhere, and Ada.Directories does not see those.
      Unused : Integer;
   begin
      Unused := GNAT.OS_Lib.Spawn
        ("/bin/rm", (new String'("-rf"), new String'(Path)));
   end Remove;

   procedure Remove_Temporary_Folder is
   begin
      if Folder /= "" then
         Remove (To_String (Folder));
         Folder := Null_Unbounded_String;
      end if;
   end Remove_Temporary_Folder;

   procedure Remove_Left (Process : int) is
   begin
      Remove (Folder_Of (Process));
   end Remove_Left;

   procedure Give_Up (Reason : String; Status : Integer := 1) is
   begin

      Remove_Temporary_Folder;
      begin
         Ada.Text_IO.Put_Line (Ada.Text_IO.Standard_Error, Reason);
      exception
         when Ada.Text_IO.Device_Error =>
            --  nobody reads it any more
            null;
      end;
      GNAT.OS_Lib.OS_Exit (Status);
   end Give_Up;

   procedure Give_Up (Problem : Exception_Occurrence) is
      Name : constant String := Simple_Name (Ada.Command_Line.Command_Name);
   begin
      if Exception_Identity (Problem) = Option_Readers.Bad_Usage'Identity then
         Give_Up (Name & ": " & Exception_Message (Problem) & " (--help)", 2);
      else
         Give_Up (Name & ": " & Exception_Information (Problem));
      end if;
   end Give_Up;

end Programs;
