--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces;    use Interfaces;
with Interfaces.C;  use Interfaces.C;
with Linux;         use Linux;
with System;

package body Robot.Serial_Line.Calls with SPARK_Mode => Off is
   --  Off: addresses are passed to C

   --  Requests of ioctl
   Set_Now       : constant := 16#5402#;  --  TCSETS
   Exclusive     : constant := 16#540C#;  --  TIOCEXCL
   Not_Exclusive : constant := 16#540D#;  --  TIOCNXCL
   Output_Queue  : constant := 16#5411#;  --  TIOCOUTQ

   function Ask (Fd : int; Request : unsigned_long; Answer : System.Address)
     return int
   with Import, Convention => C_Variadic_2, External_Name => "ioctl";

   procedure Open (Path : String; Result : out Outcome) is
      function Advise (Fd, Operation : int) return int
      with Import, Convention => C, External_Name => "flock";

      To_Write    : constant := 2;  --  O_RDWR
      Lock_Now    : constant := 6;  --  LOCK_EX, LOCK_NB
      --  The kernel's struct termios: of its four words of flags CREAD,
      --  CLOCAL, CS8 and B9600 alone are set; then VMIN is 1
      Raw_At_9600 : constant array (1 .. 9) of Unsigned_32 :=
        (3 => 8#4275#, 6 => 2 ** 24, others => 0);
      Fd          : constant int :=
        Open_File (To_C (Path), To_Read_Only + To_Write);
   begin
      if Fd < 0 then
         Result := Outcome_Of (-1);
      elsif Advise (Fd, Lock_Now) < 0
        or else Ask (Fd, Set_Now, Raw_At_9600'Address) < 0
      then
         Result := Outcome_Of (-1);
         Linux.Close (Fd);
      else
         Result := Outcome (Fd);
         Control (Fd, Exclusive);
      end if;
   end Open;

   procedure Close (Descriptor : Outcome) is
   begin
      Control (int (Descriptor), Not_Exclusive);
      Linux.Close (int (Descriptor));
   end Close;

   procedure Discard (Descriptor : Outcome; What : Queue) is
      procedure Tc_Flush (Fd, Queue : int)
      with Import, Convention => C, External_Name => "tcflush";
      --  Queue: TCIFLUSH, TCOFLUSH
   begin
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

   procedure Read
     (Descriptor : Outcome;
      Limit      : Time_Span;
      Data       : in out Bytes.Byte_Array;
      Result     : out Outcome)
   is
      --  32 bits hold 2.1 seconds of nanoseconds
      Part    : constant Time_Span :=
        (if Limit < Milliseconds (900) then Limit else Milliseconds (900));
      Wait    : constant Time_Spec := (0, long (Part / Nanoseconds (1)));
      Entries : Poll_Entry := (int (Descriptor), Poll_In, 0);
      Ready   : Ssize := 1;
   begin
      if Limit > Time_Span_Zero then
         Ready := Ssize (Precise_Poll
           (Entries'Address, 1, Wait'Address, System.Null_Address));
      end if;
      if Ready > 0 then
         Result := Outcome_Of
           (Ssize'Min
              (Linux.Read (int (Descriptor), Data'Address, Data'Length),
               Data'Length));
      else
         Result := (if Ready = 0 then No_Data else Outcome_Of (Ready));
      end if;
   end Read;

end Robot.Serial_Line.Calls;
