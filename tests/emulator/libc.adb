--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls of the C library that the emulator needs.

with Ada.Unchecked_Conversion;

with GNAT.OS_Lib;

package body Libc is

   use type Interfaces.Integer_64;

   type Time_Spec is record
      Seconds : long;
      Nanos   : long;
   end record with Convention => C;

   Billion : constant := 1_000_000_000;

   -----------
   -- Close --
   -----------

   procedure Close (Fd : in out Descriptor) is
      Ignored : int;
   begin
      if Fd /= No_Descriptor then
         Ignored := Close (Fd);
         Fd := No_Descriptor;
      end if;
   end Close;

   --------------
   -- Give_Way --
   --------------

   procedure Give_Way is
      function Set_Priority
        (Which : int; Who : unsigned; Value : int) return int
        with Import, Convention => C, External_Name => "setpriority";

      This_Thread : constant := 0;
      Nice        : constant := 5;

      Ignored : int;
   begin
      Ignored := Set_Priority (0, This_Thread, Nice);
   end Give_Way;

   -------------------------
   -- Ignore_Broken_Pipes --
   -------------------------

   procedure Ignore_Broken_Pipes is
      function Set_Signal
        (Number : int; Handler : System.Address) return System.Address
        with Import, Convention => C, External_Name => "signal";

      function To_Address is new Ada.Unchecked_Conversion
        (size_t, System.Address);

      SIGPIPE : constant := 13;
      SIG_IGN : constant := 1;

      Ignored : System.Address;
   begin
      Ignored := Set_Signal (SIGPIPE, To_Address (SIG_IGN));
   end Ignore_Broken_Pipes;

   ----------------
   -- Last_Error --
   ----------------

   function Last_Error return String is
     (GNAT.OS_Lib.Errno_Message (Default => "unknown error"));

   --------------
   -- Make_Raw --
   --------------

   procedure Make_Raw (Terminal : Descriptor; Done : out Boolean) is

      type Attributes is array (1 .. 256) of unsigned_char
        with Alignment => 8;
      --  A termios, whose size only the C library knows: well below this

      function Get (Fd : Descriptor; To : System.Address) return int
        with Import, Convention => C, External_Name => "tcgetattr";
      function Set
        (Fd : Descriptor; When_To : int; From : System.Address) return int
        with Import, Convention => C, External_Name => "tcsetattr";
      procedure Be_Raw (Value : System.Address)
        with Import, Convention => C, External_Name => "cfmakeraw";
      function Set_Speed
        (Value : System.Address; Speed : unsigned) return int
        with Import, Convention => C, External_Name => "cfsetspeed";

      B9600   : constant := 8#15#;
      TCSANOW : constant := 0;

      Value   : Attributes := (others => 0);
      Ignored : int;
   begin
      Done := Get (Terminal, Value'Address) = 0;
      if Done then
         Be_Raw (Value'Address);
         Ignored := Set_Speed (Value'Address, B9600);
         Done := Set (Terminal, TCSANOW, Value'Address) = 0;
      end if;
   end Make_Raw;

   ---------
   -- Now --
   ---------

   function Now return Nanoseconds is
      function Get_Time (Clock : int; To : System.Address) return int
        with Import, Convention => C, External_Name => "clock_gettime";

      CLOCK_MONOTONIC : constant := 1;

      Time    : Time_Spec := (0, 0);
      Ignored : int;
   begin
      Ignored := Get_Time (CLOCK_MONOTONIC, Time'Address);
      return Nanoseconds (Time.Seconds) * Billion + Nanoseconds (Time.Nanos);
   end Now;

   ----------
   -- Poll --
   ----------

   procedure Poll (Set : in out Poll_Array; Wait : Nanoseconds) is
      function Precise_Poll
        (Set    : System.Address;
         Number : unsigned_long;
         Wait   : System.Address;
         Mask   : System.Address) return int
        with Import, Convention => C, External_Name => "ppoll";

      Time : constant Time_Spec :=
        (if Wait <= 0 then (0, 0)
         else (Seconds => long (Wait / Billion),
               Nanos   => long (Wait mod Billion)));
   begin
      for E of Set loop
         E.Revents := 0;
      end loop;
      if Precise_Poll
           (Set'Address, Set'Length, Time'Address, System.Null_Address) <= 0
      then
         for E of Set loop
            E.Revents := 0;
         end loop;
      end if;
   end Poll;

   -----------------
   -- Lock_Memory --
   -----------------

   procedure Lock_Memory is
      function Effective_User return unsigned
        with Import, Convention => C, External_Name => "geteuid";
      function Lock_All (Flags : int) return int
        with Import, Convention => C, External_Name => "mlockall";

      Once_Used : constant := 7;
      --  MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT

      Ignored : int;
   begin
      --  anybody else may lock a little, and could not get more memory then
      if Effective_User = 0 then
         Ignored := Lock_All (Once_Used);
      end if;
   end Lock_Memory;

   ----------------------
   -- Prefer_Real_Time --
   ----------------------

   procedure Prefer_Real_Time is
      function Set_Scheduler
        (Who : int; Policy : int; Parameter : System.Address) return int
        with Import, Convention => C, External_Name => "sched_setscheduler";
      function Control
        (Option : int; Value, Third, Fourth, Fifth : unsigned_long)
         return int
        with Import, Convention => C_Variadic_1, External_Name => "prctl";

      This_Thread      : constant := 0;
      SCHED_FIFO       : constant := 1;
      PR_SET_TIMERSLACK : constant := 29;

      Priority : constant int := 50;
      --  Above every task of a supervisor on the same machine, as the
      --  robot's own processor would be

      Ignored : int;
   begin
      Ignored := Control (PR_SET_TIMERSLACK, 1, 0, 0, 0);
      Ignored := Set_Scheduler (This_Thread, SCHED_FIFO, Priority'Address);
   end Prefer_Real_Time;

end Libc;
