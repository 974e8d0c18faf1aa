--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the kernel says about a process.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Strings.Maps;        use Ada.Strings.Maps;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;
with Ada.Text_IO;             use Ada.Text_IO;
with GNAT.Directory_Operations;

with Child_Processes;         use Child_Processes;
with Expectations;            use Expectations;
with Instants;                use Instants;
with Libc;
with Plain_Numbers;           use Plain_Numbers;

package body Process_Facts is

   function Folder (Process : int) return String is
     ("/proc/" & Image (Integer (Process)));

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

   function Field (Path : String; Key : String) return String is
      --  The word after "Key:" in the file, "" where there is none
      Line  : constant String := File_Line (Path, Key & ":");
      First : Positive;
      Last  : Natural;
   begin
      if Line = "" then
         return "";
      end if;
      Find_Token (Line (Line'First + Key'Length + 1 .. Line'Last),
                  To_Set (" " & ASCII.HT), Ada.Strings.Outside, First, Last);
      return Line (First .. Last);
   end Field;

   function Status_Number (Process : int; Key : String) return Natural is
      Text : constant String := Field (Folder (Process) & "/status", Key);
   begin
      return (if Text = "" then 0 else Natural'Value (Text));
   end Status_Number;

   function Entries (Path : String) return Arguments is
      --  Of a folder; none where there is none
      use GNAT.Directory_Operations;
      --  Ada.Directories leaves out what it cannot find, such as sockets
      Folder : Dir_Type;
      Name   : String (1 .. 255);
      Last   : Natural;
      Result : Arguments;
   begin
      Open (Folder, Path);
      loop
         Read (Folder, Name, Last);
         exit when Last = 0;
         if Name (1 .. Last) not in "." | ".." then
            Result.Append (Name (1 .. Last));
         end if;
      end loop;
      Close (Folder);
      return Result;
   exception
      when Directory_Error =>
         return Result;
   end Entries;

   function Tasks (Process : int) return Arguments is
     (Entries (Folder (Process) & "/task"));

   function State (Process : int) return String is
     (File_Line (Folder (Process) & "/stat") & " "
      & File_Line (Folder (Process) & "/wchan"));

   function Resident_Kilobytes (Process : int) return Natural is
     (Status_Number (Process, "VmRSS"));

   function Locked_Kilobytes (Process : int) return Natural is
     (Status_Number (Process, "VmLck"));

   function Threads (Process : int) return Natural is
     (Status_Number (Process, "Threads"));

   function Footprint_Of (Process : int) return Footprint is
     (Resident_Kilobytes (Process), Threads (Process),
      Descriptors => Natural (Entries (Folder (Process) & "/fd").Length));

   procedure Expect_Flat
     (Process : int; Before : Footprint; Kilobytes : Natural := 1024)
   is
      Deadline : constant Instant := Now + 5.0;
      After    : Footprint;
   begin
      loop
         After := Footprint_Of (Process);
         exit when Now > Deadline
           or else (After.Kilobytes <= Before.Kilobytes + Kilobytes
                    and then After.Threads <= Before.Threads
                    and then After.Descriptors <= Before.Descriptors);
         delay 0.01;
      end loop;
      Note ("memory" & Before.Kilobytes'Image & " kB," & After.Kilobytes'Image
            & " kB; threads" & Before.Threads'Image & "," & After.Threads'Image
            & "; descriptors" & Before.Descriptors'Image & ","
            & After.Descriptors'Image);
      Check (After.Kilobytes <= Before.Kilobytes + Kilobytes
             and then After.Threads <= Before.Threads
             and then After.Descriptors <= Before.Descriptors, "it grows");
   end Expect_Flat;

   function Inherited (Process : int) return String is
      Close_On_Exec : constant := 8#2000000#;
      Result        : Unbounded_String;
      Target        : String (1 .. 4_096);
      Size          : long;
   begin
      for Name of Entries (Folder (Process) & "/fd") loop
         declare
            Flags : constant String :=
              Field (Folder (Process) & "/fdinfo/" & Name, "flags");
         begin
            if Natural'Value (Name) > 2 and then Flags /= ""
              and then Natural'Value ("8#" & Flags & "#") / Close_On_Exec mod 2
                       = 0
            then
               Size := Libc.Readlink
                 (To_C (Folder (Process) & "/fd/" & Name), Target'Address,
                  Target'Length);
               Append (Result,
                       " " & Name & ":"
                       & Target (1 .. Natural (long'Max (0, Size))));
            end if;
         end;
      end loop;
      return To_String (Result);
   end Inherited;

   function Has_Mapped (Process : int; Path : String) return Boolean is
     (File_Line (Folder (Process) & "/maps", Path) /= "");

   function Name_Of (Process : int; Thread : String) return String is
     (File_Line (Folder (Process) & "/task/" & Thread & "/comm"));

   function Thread_Named (Process : int; Name : String) return int is
      Wanted : constant String :=
        To_Lower (Head (Name, Natural'Min (Name'Length, 15)));
      Result : int := 0;
   begin
      for Thread of Tasks (Process) loop
         if To_Lower (Name_Of (Process, Thread)) = Wanted then
            Result := int'Value (Thread);
         end if;
      end loop;
      Check (Result > 0, "no thread " & Name & " among"
             & Thread_Names (Process));
      return Result;
   end Thread_Named;

   function Thread_Names (Process : int) return String is
      Result : Unbounded_String;
   begin
      for Thread of Tasks (Process) loop
         Append (Result, " " & Name_Of (Process, Thread));
      end loop;
      return To_String (Result);
   end Thread_Names;

   function Real_Time_Threads (Process : int) return Natural is
      Result : Natural := 0;
   begin
      for Thread of Tasks (Process) loop
         Result := Result + Boolean'Pos
           (Libc.Sched_Getscheduler (int'Value (Thread)) = Libc.Sched_Fifo);
      end loop;
      return Result;
   end Real_Time_Threads;

   function Processors (Process : int; Thread : String) return String is
     (Field
        (Folder (Process) & "/task/"
         & Image (Integer (Thread_Named (Process, Thread))) & "/status",
         "Cpus_allowed_list"));

end Process_Facts;
