--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with GNAT.Directory_Operations;
with Interfaces;        use Interfaces;
with Interfaces.C;      use Interfaces.C;
with Linux;             use Linux;

package body Process.Devices with SPARK_Mode is

   type Device_Number is record
      Major : Natural range 0 .. 2 ** 12 - 1 := 0;
      Minor : Natural range 0 .. 2 ** 19 - 1 := 0;
   end record;
   --  The kernel's number for a device. A minor has one bit more, which no
   --  terminal needs

   type File_Numbers is record
      Itself : Device_Number;  --  if it is a device
      Place  : Device_Number;  --  where it is
      Inode  : Natural := 0;
   end record;

   procedure Get_Numbers (Path : String; File : out File_Numbers)
   with Global => (In_Out => System_State);
   --  Of the file at Path

   procedure Get_Numbers (Path : String; File : out File_Numbers)
   with SPARK_Mode => Off
   is
      --  Off, as the next two: addresses are passed to C, GNAT's library
      --  raises
      Current_Folder : constant int      := -100;    --  AT_FDCWD
      Wanted         : constant unsigned := 16#100#; --  STATX_INO
      Status         : File_Status := (others => 0);
      Ignored        : int;

      function Device_At (Word : Positive) return Device_Number is
        (Natural (Status (Word) mod 2 ** 12),
         Natural (Status (Word + 1) mod 2 ** 19));
   begin
      Ignored := Status_Of
        (Current_Folder, To_C (Path), 0, Wanted, Status'Address);
      File := (Itself => Device_At (33),
               Place  => Device_At (35),
               Inode  => Natural (Status (9) mod 2 ** 31));
   end Get_Numbers;

   procedure Get_Start
     (Path : String; Data : in out String; Last : out Natural)
   with
     Global => (In_Out => System_State),
     Pre    => Data'First = 1,
     Post   => Last <= Data'Last;
   --  What the file at Path begins with: Data (1 .. Last)

   procedure Get_Start
     (Path : String; Data : in out String; Last : out Natural)
   with SPARK_Mode => Off
   is
      File : constant int := Open_File (To_C (Path), To_Read_Only);
      Got  : Ssize;
   begin
      Last := 0;
      while Last < Data'Last loop
         Got := Linux.Read
           (File, Data (Last + 1)'Address, size_t (Data'Last - Last));
         exit when Got <= 0;
         Last := Last + Natural (Got);
      end loop;
      Linux.Close (File);
   end Get_Start;

   procedure Get_Processes (Data : in out String; Last : out Natural)
   with
     Global => (In_Out => System_State),
     Pre    => Data'First = 1,
     Post   => Last <= Data'Last;
   --  The numbers of all processes, as many as fit, each followed by a blank:
   --  Data (1 .. Last)

   procedure Get_Processes (Data : in out String; Last : out Natural)
   with SPARK_Mode => Off
   is
      use GNAT.Directory_Operations;
      Folder : Dir_Type;
      Name   : String (1 .. 32);
      Length : Natural;
   begin
      Last := 0;
      Open (Folder, "/proc");
      loop
         Read (Folder, Name, Length);
         exit when Length not in 1 .. Data'Last - Last - 1;
         if Name (1) in '0' .. '9' then
            Data (Last + 1 .. Last + Length + 1) := Name (1 .. Length) & ' ';
            Last := Last + Length + 1;
         end if;
      end loop;
      Close (Folder);
   exception
      when Directory_Error =>
         null;
   end Get_Processes;

   procedure Append_Hexadecimal (To : in out Texts.Text; Number : Natural) is
      --  Two digits or more
      All_Digits : constant String (1 .. 16) := "0123456789abcdef";
      Digit      : constant Positive := Number mod 16 + 1;
   begin
      if Number >= 16#100# then
         Append_Hexadecimal (To, Number / 16);
      else
         Texts.Append (To, (1 => All_Digits (Number / 16 + 1)));
      end if;
      Texts.Append (To, (1 => All_Digits (Digit)));
   end Append_Hexadecimal;

   procedure Append_Process (To : in out Texts.Text; Number : String)
   with Pre => Number'Length <= 65_536
   is
      --  Its name, and its number
      Name : String (1 .. 16) := (others => ' ');
      Last : Natural;
   begin
      Get_Start ("/proc/" & Number & "/comm", Name, Last);
      --  without the line feed behind it
      Texts.Append
        (To, Name (1 .. Integer'Max (0, Last - 1)) & " (process " & Number
         & ")");
   end Append_Process;

   procedure Get_Owner (Path : Texts.Text; Owner : out Texts.Text) is
      --  /proc/locks has a line for each lock, with its process and the file's
      --  place and inode: "1: FLOCK  ADVISORY  WRITE 1234 00:1a:3 0 EOF"
      Table  : String (1 .. 8_192) := (others => ' ');
      Last   : Natural;
      File   : File_Numbers;
      Wanted : Texts.Text := Texts.To_Text (" ");
      Place  : Natural;
      Start  : Natural;
   begin
      Get_Numbers (Texts.Image (Path), File);
      Append_Hexadecimal (Wanted, File.Place.Major);
      Texts.Append (Wanted, ":");
      Append_Hexadecimal (Wanted, File.Place.Minor);
      Texts.Append (Wanted, ":");
      Texts.Append (Wanted, File.Inode);
      Texts.Append (Wanted, " ");
      Get_Start ("/proc/locks", Table, Last);
      Place := Index (Table (1 .. Last), Texts.Image (Wanted));
      Start := Place;
      while Start > 1 and then Table (Start - 1) in '0' .. '9' loop
         pragma Loop_Invariant (Start <= Place);
         Start := Start - 1;
      end loop;
      Texts.Set (Owner, "");
      if Start < Place then
         Append_Process (Owner, Table (Start .. Place - 1));
      else
         Texts.Set (Owner, "another program");
      end if;
   end Get_Owner;

   function Is_Of_Session
     (Stat : String; Number : Device_Number) return Boolean
   with Pre => Stat'First = 1 and then Stat'Last < Integer'Last
   is
      --  The device, which is no pseudo-terminal (containers have the same
      --  numbers), is the terminal of a process' session, such as a login's.
      --  Stat: its /proc/PID/stat, "512 (agetty) S 1 512 512 1088 512 ..."
      Wanted : Texts.Text := Texts.To_Text (" ");
      Place  : Natural := Index (Stat, ")", Ada.Strings.Backward);
   begin
      Texts.Append
        (Wanted,
         Number.Minor mod 2 ** 8 + 2 ** 8 * Number.Major
         + 2 ** 20 * (Number.Minor / 2 ** 8));
      Texts.Append (Wanted, " ");
      --  before the fifth word after the name, which may have a parenthesis,
      --  too: the last one counts
      for Word in 1 .. 5 loop
         if Place > 0 then
            Place := Index (Stat (Place + 1 .. Stat'Last), " ");
         end if;
      end loop;
      return Place > 0
        and then Number.Major not in 0 | 136 .. 143  --  0: none
        and then Index (Stat (Place .. Stat'Last), Texts.Image (Wanted))
          = Place;
   end Is_Of_Session;

   procedure Get_Use (Path : Texts.Text; Used : out Texts.Text) is
      File    : File_Numbers;
      Wanted  : Texts.Text := Texts.To_Text (" ");
      Table   : String (1 .. 2_048) := (others => ' ');
      Last    : Natural;
      Numbers : String (1 .. 65_536) := (others => ' ');
      Count   : Natural;
      Start   : Positive := 1;
   begin
      Texts.Set (Used, "");
      Get_Numbers (Texts.Image (Path), File);
      --  /proc/consoles has a line for each device to which the kernel writes
      --  its messages, such as "ttyS0   -W- (EC p a)    4:64"
      Get_Start ("/proc/consoles", Table, Last);
      Texts.Append (Wanted, File.Itself.Major);
      Texts.Append (Wanted, ":");
      Texts.Append (Wanted, File.Itself.Minor);
      Texts.Append (Wanted, (1 => ASCII.LF));
      if Index (Table (1 .. Last), Texts.Image (Wanted)) > 0 then
         Texts.Set (Used, "it is a console of the kernel");
         return;
      end if;
      Get_Processes (Numbers, Count);
      for I in 1 .. Count loop
         pragma Loop_Invariant (Start <= I);
         if Numbers (I) = ' ' then
            Get_Start
              ("/proc/" & Numbers (Start .. I - 1) & "/stat", Table, Last);
            if Is_Of_Session (Table (1 .. Last), File.Itself) then
               Append_Process (Used, Numbers (Start .. I - 1));
               Texts.Append (Used, " has it as its terminal");
               return;
            end if;
            Start := I + 1;
         end if;
      end loop;
   end Get_Use;

end Process.Devices;
