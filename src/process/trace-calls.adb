--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C;            use Interfaces.C;
with Linux;                   use Linux;
with System;                  use System;
pragma Warnings (Off, "*is an internal GNAT unit");
with System.OS_Constants;     use System.OS_Constants;
pragma Warnings (On, "*is an internal GNAT unit");
with System.Storage_Elements; use System.Storage_Elements;

package body Trace.Calls with
  SPARK_Mode    => Off,
  Refined_State => (System_State => null)
is
   --  Off: addresses are passed to C

   Monotonic      : constant int := 1;      --  CLOCK_MONOTONIC
   Time_Shared    : constant int := 0;      --  SCHED_OTHER
   Start          : constant int := 0;      --  SEEK_SET
   File_Too_Large : constant int := 25;     --  SIGXFSZ
   Ignore         : constant Address := To_Address (1);  --  SIG_IGN

   --  Where a result is of no use, a function of C is a procedure here

   procedure Set_Action (Signal : int; Action : Address)
   with Import, Convention => C, External_Name => "signal";

   procedure Set_Scheduler (Thread, Policy : int; Priority : Address)
   with Import, Convention => C, External_Name => "sched_setscheduler";

   procedure Get_Time (Clock : int; Now : Address)
   with Import, Convention => C, External_Name => "clock_gettime";

   function Open (Path : char_array; Flags : int; Mode : unsigned) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   function Seek (File : int; Place : long; From : int) return long
   with Import, Convention => C, External_Name => "lseek";

   procedure Unlink (Path : char_array)
   with Import, Convention => C, External_Name => "unlink";

   procedure Truncate (File : int; Length : long)
   with Import, Convention => C, External_Name => "ftruncate";

   procedure Close (File : Descriptor) is
   begin
      Linux.Close (int (File));
   end Close;

   procedure Empty (File : Descriptor) is
   begin
      Truncate (int (File), 0);
   end Empty;

   procedure Get_Time (Nanoseconds : out Unsigned_64) is
      Now : Time_Spec := (0, 0);
   begin
      Get_Time (Monotonic, Now'Address);
      Nanoseconds := Unsigned_64 (Now.Seconds) * 1_000_000_000
        + Unsigned_64 (Now.Nanoseconds);
   end Get_Time;

   procedure Give_Up_Priority is
      Lowest : constant int := 0;
   begin
      Set_Scheduler (0, Time_Shared, Lowest'Address);
   end Give_Up_Priority;

   procedure Ignore_Size_Signal is
   begin
      Set_Action (File_Too_Large, Ignore);
   end Ignore_Size_Signal;

   procedure Open
     (Path : Texts.Text; Flags : Open_Flags; Result : out Outcome)
   is
      Mode      : constant unsigned := 8#600#;
      No_Follow : constant int :=
        (if Target_Name < "b" then 8#100000# else 8#400000#);
      --  O_NOFOLLOW, of ARM and of all others: the link may be anybody's
   begin
      Result := Outcome_Of
        (Ssize (Open (To_C (Texts.Image (Path)), int (Flags) + No_Follow,
                      Mode)));
   end Open;

   procedure Remove (Path : Texts.Text) is
   begin
      Unlink (To_C (Texts.Image (Path)));
   end Remove;

   procedure Seek_Start (File : Descriptor; Result : out Outcome) is
   begin
      Result := Outcome_Of (Ssize (Seek (int (File), 0, Start)));
   end Seek_Start;

   procedure Write
     (File : Descriptor; Data : String; Result : out Outcome) is
   begin
      Result := Outcome_Of
        (Linux.Write (int (File), Data'Address, Data'Length));
   end Write;

end Trace.Calls;
