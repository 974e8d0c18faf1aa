--  SPDX-License-Identifier: GPL-3.0-or-later

with GNAT.Directory_Operations;
with GNAT.Serial_Communications; use GNAT.Serial_Communications;
with Interfaces;                 use Interfaces;
with Interfaces.C;               use Interfaces.C;
with Linux;                      use Linux;
with System;

package body Robot.Serial_Line.Calls with
  SPARK_Mode    => Off,
  Refined_State => (Port => null)
is
   --  Off: addresses are passed to C, GNAT.Serial_Communications raises

   function Fcntl (Fd, Command, Argument : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "fcntl";

   function Is_Terminal (Fd : int) return int
   with Import, Convention => C, External_Name => "isatty";

   Exclusive     : constant := 16#540C#;  --  TIOCEXCL
   Not_Exclusive : constant := 16#540D#;  --  TIOCNXCL

   function Advise (Fd, Operation : int) return int
   with Import, Convention => C, External_Name => "flock";

   procedure Tc_Flush (Fd, Queue : int)
   with Import, Convention => C, External_Name => "tcflush";

   function Ask (Fd : int; Request : unsigned_long; Answer : System.Address)
     return int
   with Import, Convention => C_Variadic_2, External_Name => "ioctl";

   Output_Queue : constant := 16#5411#;  --  TIOCOUTQ

   procedure Open (Path : String; Result : out Outcome) is
      Port : Serial_Port;
      Fd   : int := -1;
   begin
      Open (Port, Port_Name (Path));
      Fd := int (To_C (Port));
      Control (Fd, Close_On_Exec);
      if Is_Terminal (Fd) = 0 then
         Result := No_Terminal;
         Linux.Close (Fd);
      elsif Advise (Fd, 6) < 0 then  --  LOCK_EX, LOCK_NB
         Result := Outcome_Of (-1);
         Linux.Close (Fd);
      else
         Control (Fd, Exclusive);
         --  Blocking: with a time-out GNAT 12 turns the echo on
         Set (Port, B9600, CS8, One, None,
              Block => True, Local => True, Flow => None, Timeout => 0.0);
         --  F_SETFL, O_NONBLOCK
         Result := Outcome_Of (Ssize (Fcntl (Fd, 4, 8#4000#)));
         if Result < 0 then
            Close (Outcome (Fd));
         else
            Result := Outcome (Fd);
         end if;
      end if;
   exception
      when others =>
         Result := Outcome_Of (-1);
         if Fd >= 0 then
            Close (Outcome (Fd));
         end if;
   end Open;

   procedure Get_Start
     (Path : String; Data : in out String; Last : out Natural)
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

   procedure Get_Numbers (Path : String; File : out File_Numbers) is
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

   procedure Get_Processes (Data : in out String; Last : out Natural) is
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

   procedure Close (Descriptor : Outcome) is
   begin
      Control (int (Descriptor), Not_Exclusive);
      Linux.Close (int (Descriptor));
   end Close;

   procedure Discard (Descriptor : Outcome; What : Queue) is
   begin
      --  TCIFLUSH, TCOFLUSH
      Tc_Flush (int (Descriptor), Queue'Pos (What));
   end Discard;

   procedure Get_Unsent (Descriptor : Outcome; Result : out Outcome) is
      Count : int := 0;
   begin
      Result := Outcome_Of
        (Ssize (Ask (int (Descriptor), Output_Queue, Count'Address)));
      if Result = 0 then
         Result := Outcome (Count);
      end if;
   end Get_Unsent;

   procedure Write
     (Descriptor : Outcome;
      Data       : Bytes.Byte_Array;
      Length     : Natural;
      Result     : out Outcome) is
   begin
      Result := Outcome_Of
        (Linux.Write (int (Descriptor), Data'Address, size_t (Length)));
   end Write;

   procedure Wait_Input
     (Descriptor : Outcome; Limit : Nanoseconds; Result : out Outcome)
   is
      Entries : Poll_Entry := (int (Descriptor), Poll_In, 0);
      Wait    : Time_Spec := (0, long (Limit));
   begin
      Result := Outcome_Of
        (Ssize (Precise_Poll
           (Entries'Address, 1, Wait'Address, System.Null_Address)));
   end Wait_Input;

   procedure Read
     (Descriptor : Outcome;
      Data       : in out Bytes.Byte_Array;
      Result     : out Outcome) is
   begin
      Result := Outcome_Of
        (Ssize'Min
           (Linux.Read (int (Descriptor), Data'Address, Data'Length),
            Data'Length));
   end Read;

end Robot.Serial_Line.Calls;
