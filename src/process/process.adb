--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Command_Line;
with GNAT.OS_Lib;
with Interfaces.C; use Interfaces.C;
with Linux;

package body Process with
  SPARK_Mode    => Off,
  Refined_State => (System_State => null)
is

   function Value (Index : Positive) return String is
     (if Index <= Argument_Count then Ada.Command_Line.Argument (Index)
      else "");

   function Argument (Index : Positive) return Texts.Text is
     (Texts.To_Text (Value (Index)));

   function Argument_Count return Natural is
     (Ada.Command_Line.Argument_Count);

   function Is_Whole (Index : Positive) return Boolean is
     (Value (Index)'Length <= Texts.Max_Length);

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
      Ignored := Linux.Set_Scheduler (0, Linux.Time_Shared, Lowest'Address);
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

end Process;
