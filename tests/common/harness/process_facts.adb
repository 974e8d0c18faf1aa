--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel says about a process.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings;             use Ada.Strings;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Strings.Maps;        use Ada.Strings.Maps;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;
with Ada.Text_IO;             use Ada.Text_IO;
with GNAT.Directory_Operations;

with Libc;

package body Process_Facts is

   function Folder (Process : int) return String is
     ("/proc/" & Trim (Process'Image, Both));

   function Field (Path : String; Key : String) return String is
      --  What stands after "Key:" in the file, "" where there is none
      File   : File_Type;
      Result : Unbounded_String;
   begin
      Open (File, In_File, Path);
      while not End_Of_File (File) loop
         declare
            Line : constant String := Get_Line (File);
         begin
            if Index (Line, Key & ":") = Line'First then
               Result := To_Unbounded_String
                 (Trim (Line (Line'First + Key'Length + 1 .. Line'Last),
                        To_Set (" " & ASCII.HT), To_Set (" ")));
            end if;
         end;
      end loop;
      Close (File);
      return To_String (Result);
   exception
      when Name_Error | Use_Error =>
         return "";
   end Field;

   function Status_Number (Process : int; Key : String) return Natural is
      --  The first number after Key in the process's status
      Text : constant String := Field (Folder (Process) & "/status", Key);
      Last : Natural := Text'First - 1;
   begin
      while Last < Text'Last and then Is_Digit (Text (Last + 1)) loop
         Last := Last + 1;
      end loop;
      return
        (if Last < Text'First then 0
         else Natural'Value (Text (Text'First .. Last)));
   end Status_Number;

   function File_Line (Path : String; Key : String := "") return String is
      File : File_Type;
   begin
      Open (File, In_File, Path);
      while not End_Of_File (File) loop
         declare
            Line : constant String := Get_Line (File);
         begin
            if Key = "" or else Index (Line, Key) > 0 then
               Close (File);
               return Line;
            end if;
         end;
      end loop;
      Close (File);
      return "";
   exception
      when Name_Error | Use_Error | End_Error | Device_Error =>
         if Is_Open (File) then
            Close (File);
         end if;
         return "";
   end File_Line;

   procedure For_Each_Entry
     (Path : String; Action : not null access procedure (Name : String))
   is
      --  Of a folder whose entries may vanish meanwhile
      use GNAT.Directory_Operations;
      --  Ada.Directories leaves out what it cannot find, such as sockets
      Folder : Dir_Type;
      Name   : String (1 .. 255);
      Last   : Natural;
   begin
      Open (Folder, Path);
      loop
         Read (Folder, Name, Last);
         exit when Last = 0;
         if Name (1 .. Last) not in "." | ".." then
            Action (Name (1 .. Last));
         end if;
      end loop;
      Close (Folder);
   exception
      when Directory_Error =>
         null;
   end For_Each_Entry;

   function State (Process : int) return String is
     (File_Line (Folder (Process) & "/stat") & " "
      & File_Line (Folder (Process) & "/wchan"));

   function Resident_Kilobytes (Process : int) return Natural is
     (Status_Number (Process, "VmRSS"));

   function Locked_Kilobytes (Process : int) return Natural is
     (Status_Number (Process, "VmLck"));

   function Threads (Process : int) return Natural is
     (Status_Number (Process, "Threads"));

   function Descriptors (Process : int) return Natural is
      Result : Natural := 0;

      procedure Count (Name : String) is
      begin
         if Name /= "" then
            Result := Result + 1;
         end if;
      end Count;
   begin
      For_Each_Entry (Folder (Process) & "/fd", Count'Access);
      return Result;
   end Descriptors;

   function Open_File (Process : int; Descriptor : Natural) return String is
      Target : String (1 .. 4_096);
      Size   : constant long := Libc.Readlink
        (To_C (Folder (Process) & "/fd/" & Trim (Descriptor'Image, Both)),
         Target'Address, Target'Length);
   begin
      return Target (1 .. Natural (long'Max (0, Size)));
   end Open_File;

   function Inherited (Process : int) return String is
      Result : Unbounded_String;

      procedure Judge (Name : String) is
         Close_On_Exec : constant := 8#2000000#;
         Flags : constant String :=
           Field (Folder (Process) & "/fdinfo/" & Name, "flags");
      begin
         if Natural'Value (Name) > 2 and then Flags /= ""
           and then Natural'Value ("8#" & Flags & "#") / Close_On_Exec mod 2
                    = 0
         then
            Append
              (Result,
               " " & Name & ":" & Open_File (Process, Natural'Value (Name)));
         end if;
      end Judge;
   begin
      For_Each_Entry (Folder (Process) & "/fd", Judge'Access);
      return To_String (Result);
   end Inherited;

   function Has_Mapped (Process : int; Path : String) return Boolean is
      File  : File_Type;
      Found : Boolean := False;
   begin
      Open (File, In_File, Folder (Process) & "/maps");
      while not Found and then not End_Of_File (File) loop
         Found := Index (Get_Line (File), Path) > 0;
      end loop;
      Close (File);
      return Found;
   exception
      when Name_Error | Use_Error =>
         return False;
   end Has_Mapped;

   function Thread_Named (Process : int; Name : String) return int is
      Wanted : constant String :=
        To_Lower (Name (Name'First
                  .. Natural'Min (Name'Last, Name'First + 14)));
      Result : int := 0;

      procedure Compare (Thread : String) is
      begin
         if To_Lower
           (File_Line (Folder (Process) & "/task/" & Thread & "/comm"))
           = Wanted
         then
            Result := int'Value (Thread);
         end if;
      end Compare;
   begin
      For_Each_Entry (Folder (Process) & "/task", Compare'Access);
      return Result;
   end Thread_Named;

   function Real_Time_Threads (Process : int) return Natural is
      Result : Natural := 0;

      procedure Count (Thread : String) is
      begin
         if Libc.Sched_Getscheduler (int'Value (Thread)) = Libc.Sched_Fifo then
            Result := Result + 1;
         end if;
      end Count;
   begin
      For_Each_Entry (Folder (Process) & "/task", Count'Access);
      return Result;
   end Real_Time_Threads;

   function Thread_Names (Process : int) return String is
      Result : Unbounded_String;

      procedure Add (Thread : String) is
      begin
         Append (Result,
                 " " & File_Line
                   (Folder (Process) & "/task/" & Thread & "/comm"));
      end Add;
   begin
      For_Each_Entry (Folder (Process) & "/task", Add'Access);
      return To_String (Result);
   end Thread_Names;

   function Processors (Process : int; Thread : int) return String is
     (Field
        (Folder (Process) & "/task/" & Trim (Thread'Image, Both) & "/status",
         "Cpus_allowed_list"));

end Process_Facts;
