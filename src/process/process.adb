--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Command_Line;
with GNAT.OS_Lib;
with Interfaces.C;        use Interfaces.C;
with Linux;               use Linux;
pragma Warnings (Off, "*is an internal GNAT unit");
with System.OS_Constants; use System.OS_Constants;
pragma Warnings (On, "*is an internal GNAT unit");

package body Process with
  SPARK_Mode    => Off,
  Refined_State => (System_State => null)
is
   --  Off: addresses are passed to C

   --  Where a result is of no use, a function of C is a procedure here

   function Argument_Count return Natural is
     (Ada.Command_Line.Argument_Count);

   function Argument (Index : Positive) return String is
     (if Index <= Argument_Count then Ada.Command_Line.Argument (Index)
      else "");

   function Program return Texts.Text is
     (Texts.To_Text (Ada.Command_Line.Command_Name));

   procedure Exit_At_Once (Status : int)
   with Import, Convention => C, External_Name => "_exit", No_Return;

   procedure Leave (Status : Exit_Status) is
   begin
      Exit_At_Once (int (Status));
   end Leave;

   procedure Give_Up_Priority is
      Lowest  : constant int := 0;
      Ignored : int;
   begin
      Ignored := Set_Scheduler (0, Time_Shared, Lowest'Address);
   end Give_Up_Priority;

   procedure Describe (Error : Integer; Text : out Texts.Text) is
   begin
      Texts.Set (Text, GNAT.OS_Lib.Errno_Message (Error));
   end Describe;

   --  The machine

   subtype Field is char_array (1 .. 65);

   type Names is record
      System, Node, Release, Version, Processor, Domain : Field :=
        (others => nul);
   end record with Convention => C;
   --  The kernel's struct utsname

   procedure Get_Names (To : in out Names)
   with Import, Convention => C, External_Name => "uname";

   function Setting (Name : int) return long
   with Import, Convention => C, External_Name => "sysconf";

   Page_Size  : constant int := 30;  --  _SC_PAGESIZE
   Page_Count : constant int := 85;  --  _SC_PHYS_PAGES

   procedure Get_Kernel (Name, Version : out Texts.Text) is
      All_Names : Names;
   begin
      Get_Names (All_Names);
      Texts.Set (Name, To_Ada (All_Names.Release));
      Texts.Set (Version, To_Ada (All_Names.Version));
   end Get_Kernel;

   procedure Get_Memory (Megabytes : out Natural) is
   begin
      Megabytes := Natural
        (Setting (Page_Count) / 1_024 * Setting (Page_Size) / 1_024);
   end Get_Memory;

   --  Files

   function Seek (File : int; Place : long; From : int) return long
   with Import, Convention => C, External_Name => "lseek";

   procedure Unlink (Path : char_array)
   with Import, Convention => C, External_Name => "unlink";

   procedure Truncate (File : int; Length : long)
   with Import, Convention => C, External_Name => "ftruncate";

   procedure Open
     (Path : Texts.Text; Created : Creation; Result : out Outcome)
   is
      No_Follow : constant int :=
        (if Target_Name < "b" then 8#100000# else 8#400000#);
      --  O_NOFOLLOW, of ARM and of all others: the link may be anybody's
      File      : constant int := Open_File
        (To_C (Texts.Image (Path)),
         8#2004402#  --  O_RDWR, O_CLOEXEC, O_NONBLOCK, O_NOCTTY
         + (case Created is
               when Never    => 0,
               when New_Only => 8#300#,   --  O_CREAT, O_EXCL
               when New_Also => 8#100#)   --  O_CREAT
         + No_Follow,
         Mode => 8#600#);
   begin
      Result := Outcome_Of (Ssize (File));
      if Result >= 0 and then Seek (File, 0, From => 0) < 0 then  --  SEEK_SET
         Result := Outcome_Of (-1);
         Linux.Close (File);
      end if;
   end Open;

   procedure Close (File : Descriptor) is
   begin
      Linux.Close (int (File));
   end Close;

   procedure Remove (Path : Texts.Text) is
   begin
      Unlink (To_C (Texts.Image (Path)));
   end Remove;

   procedure Empty (File : Descriptor) is
   begin
      Truncate (int (File), 0);
   end Empty;

   procedure Write (File : Descriptor; Data : String; Result : out Outcome) is
   begin
      loop
         Result := Outcome_Of
           (Linux.Write (int (File), Data'Address, Data'Length));
         exit when Result /= -EINTR;
      end loop;
   end Write;

   Found : int;

begin
   loop
      Found := Open_File (To_C ("/dev/null"), 2);  --  O_RDWR
      exit when Found not in 0 .. 2;
   end loop;
   if Found > 2 then
      Linux.Close (Found);
   end if;
end Process;
