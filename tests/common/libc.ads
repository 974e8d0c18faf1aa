--  SPDX-License-Identifier: GPL-3.0-or-later
--  The C library functions that tests, benchmarks and emulator need. The
--  constants are those of Linux on all architectures of Debian.

with GNAT.OS_Lib;
with Interfaces.C;         use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;
with System.Storage_Elements;

package Libc is

   function Last_Error return String is
     (GNAT.OS_Lib.Errno_Message (Default => "unknown error"));
   --  The error message of this task's last call

   --  Clock

   type Timespec is record
      Seconds     : long;
      Nanoseconds : long;
   end record with Convention => C;

   Clock_Monotonic : constant int := 1;

   function Clock_Gettime
     (Clock : int; Time : access Timespec) return int
   with Import, Convention => C;

   --  Files

   type Pipe_Ends is array (0 .. 1) of int with Convention => C;
   --  0: the read end, 1: the write end

   O_Rdonly  : constant int := 8#0#;
   O_Rdwr    : constant int := 8#2#;
   O_Noctty  : constant int := 8#400#;
   O_Nonblock : constant int := 8#4000#;
   O_Cloexec : constant int := 8#2000000#;

   function Pipe2 (Ends : out Pipe_Ends; Flags : int) return int
   with Import, Convention => C;

   function Open (Path : char_array; Flags : int) return int
   with Import, Convention => C_Variadic_2;

   function Read
     (File : int; Buffer : System.Address; Size : size_t) return long
   with Import, Convention => C;

   function Pread
     (File : int; Buffer : System.Address; Size : size_t; Offset : long)
      return long
   with Import, Convention => C;

   function Write
     (File : int; Buffer : System.Address; Size : size_t) return long
   with Import, Convention => C;

   procedure Close (File : int) with Import, Convention => C;

   function Chmod (Path : char_array; Mode : unsigned) return int
   with Import, Convention => C;

   function Chown (Path : char_array; User, Group : unsigned) return int
   with Import, Convention => C;

   function Readlink
     (Path : char_array; Buffer : System.Address; Size : size_t) return long
   with Import, Convention => C;
   --  Its length, without a NUL; negative if there is none

   procedure Dup2 (File, Onto : int) with Import, Convention => C;

   function Symlink (Target, Path : char_array) return int
   with Import, Convention => C;

   procedure Unlink (Path : char_array) with Import, Convention => C;

   function Rename (From, To : char_array) return int
   with Import, Convention => C;

   --  Waiting: see Polls

   type Poll_Descriptor is record
      File     : int := -1;
      --  -1: none
      Events   : short := 0;
      Returned : short := 0;
   end record with Convention => C;

   Poll_In      : constant short := 16#0001#;
   Poll_Out     : constant short := 16#0004#;
   Poll_Hang_Up : constant short := 16#2000#;
   --  POLLRDHUP: the peer sends no more

   type Poll_Array is array (Positive range <>) of Poll_Descriptor
   with Convention => C;

   function Ppoll
     (Files : System.Address;
      Count : unsigned_long;
      Wait  : access constant Timespec;
      Mask  : System.Address) return int
   with Import, Convention => C;

   function Eventfd (Initial : unsigned; Flags : int) return int
   with Import, Convention => C;

   --  Terminals: see Pseudo_Terminals

   function Posix_Openpt (Flags : int) return int with Import, Convention => C;

   function Grantpt (Master : int) return int with Import, Convention => C;

   function Unlockpt (Master : int) return int with Import, Convention => C;

   function Ptsname_R
     (Master : int; Name : System.Address; Size : size_t) return int
   with Import, Convention => C;

   function Ioctl (File : int; Request : unsigned_long;
                   Value : System.Address) return int
   with Import, Convention => C_Variadic_2;

   Tiocnxcl  : constant unsigned_long := 16#540D#;
   Tiocgexcl : constant unsigned_long := 16#8004_5440#;

   Lock_Ex : constant int := 2;
   Lock_Nb : constant int := 4;
   Lock_Un : constant int := 8;

   function Flock (File, Operation : int) return int
   with Import, Convention => C;

   type Terminal_Attributes is array (1 .. 256) of unsigned_char
   with Alignment => 8;
   --  A termios, whose size only the C library knows: smaller than this

   B9600   : constant unsigned := 8#15#;
   Tcsanow : constant int := 0;

   function Tcgetattr (File : int; Value : System.Address) return int
   with Import, Convention => C;

   function Tcsetattr
     (File : int; Action : int; Value : System.Address) return int
   with Import, Convention => C;

   procedure Cfmakeraw (Value : System.Address) with Import, Convention => C;

   procedure Cfsetspeed (Value : System.Address; Speed : unsigned)
   with Import, Convention => C;

   --  Processes

   function Fork return int with Import, Convention => C;

   type Argument_Vector is array (Natural range <>) of aliased chars_ptr
   with Convention => C;

   procedure Execv (Path : chars_ptr; Arguments : Argument_Vector)
   with Import, Convention => C, External_Name => "execvp";
   --  Searches PATH if Path has no slash; returns only on failure

   procedure Exit_Now (Status : int)
   with Import, Convention => C, External_Name => "_exit";

   No_Hang : constant int := 1;

   function Waitpid
     (Process : int; Status : access int; Options : int) return int
   with Import, Convention => C;

   function Kill (Process, Signal : int) return int
   with Import, Convention => C;

   function Tgkill (Process, Thread, Signal : int) return int
   with Import, Convention => C;

   Pr_Set_Pdeathsig  : constant int := 1;
   Pr_Set_Timerslack : constant int := 29;

   procedure Prctl (Option : int; Value : unsigned_long)
   with Import, Convention => C_Variadic_1;

   function Geteuid return unsigned with Import, Convention => C;

   function Getpid return int with Import, Convention => C;

   --  Signals

   Sighup  : constant int := 1;
   Sigint  : constant int := 2;
   Sigkill : constant int := 9;
   Sigsegv : constant int := 11;
   Sigpipe : constant int := 13;
   Sigterm : constant int := 15;
   Sigcont : constant int := 18;
   Sigstop : constant int := 19;

   type Signal_Set is array (1 .. 128) of aliased char with Convention => C;
   --  sigset_t of the GNU C library

   Set_Mask : constant int := 2;

   procedure Sigemptyset (Set : access Signal_Set)
   with Import, Convention => C;

   procedure Sigprocmask
     (How : int; Set, Old : access Signal_Set)
   with Import, Convention => C;

   Default_Action : constant System.Address := System.Null_Address;

   Ignored : constant System.Address := System.Storage_Elements.To_Address (1);

   function Signal
     (Number : int; Action : System.Address) return System.Address
   with Import, Convention => C;

   --  Scheduling

   Sched_Other : constant int := 0;
   Sched_Fifo  : constant int := 1;

   Above_Supervisor : constant int := 60;
   --  A priority above all of the supervisor's: for the time stamps of a
   --  simulated remote machine

   type Sched_Param is record
      Priority : int;
   end record with Convention => C;

   function Sched_Getscheduler (Thread : int) return int
   with Import, Convention => C;

   function Sched_Setscheduler
     (Thread : int; Policy : int; Param : access Sched_Param) return int
   with Import, Convention => C;
   --  Thread 0 is the caller

   procedure Nice (Increment : int) with Import, Convention => C;
   --  Of the calling thread

   procedure Mlockall (Flags : int) with Import, Convention => C;

   --  Network namespaces

   Clone_Newnet : constant int := 16#4000_0000#;

   function Setns (File : int; Kind : int) return int
   with Import, Convention => C;

end Libc;
