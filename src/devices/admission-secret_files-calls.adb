--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;
with System;

package body Admission.Secret_Files.Calls with
  SPARK_Mode    => Off,
  Refined_State => (System_Files => null)
is
   --  Off: addresses are passed to C

   Read_Only    : constant int := 8#2004400#;
   --  O_RDONLY, O_CLOEXEC, O_NONBLOCK, O_NOCTTY
   Of_The_File  : constant int := 16#1000#;         --  AT_EMPTY_PATH
   Wanted       : constant unsigned := 16#000B#;
   --  STATX_TYPE, STATX_MODE, STATX_UID

   --  The kernel's struct statx (linux/stat.h), the same on all platforms
   type File_Status is array (1 .. 64) of Unsigned_32 with Convention => C;
   --  Words 6: the owner, 8: the mode, in the lower half (little-endian)

   function Open_File (Path : char_array; Flags : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   function Status_Of
     (Folder : int; Path : char_array; Flags : int; Mask : unsigned;
      Status : System.Address) return int
   with Import, Convention => C, External_Name => "statx";

   procedure Open (Path : String; Result : out Outcome) is
   begin
      Result := Outcome_Of (Ssize (Open_File (To_C (Path), Read_Only)));
   end Open;

   procedure Get_Status
     (File   : Outcome;
      Mode   : out Admission.Authentication.File_Mode;
      Owner  : out Admission.Authentication.User_Number;
      Result : out Outcome)
   is
      Status : File_Status := (others => 0);
   begin
      Result := Outcome_Of
        (Ssize (Status_Of
           (int (File), To_C (""), Of_The_File, Wanted, Status'Address)));
      Mode := Admission.Authentication.File_Mode'Mod (Status (8));
      Owner := Status (6);
   end Get_Status;

   procedure Read
     (File : Outcome; Data : in out String; Result : out Outcome) is
   begin
      Result := Outcome_Of
        (Ssize'Min
           (Linux.Read (int (File), Data'Address, Data'Length), Data'Length));
   end Read;

   procedure Close (File : Outcome) is
   begin
      Linux.Close (int (File));
   end Close;

end Admission.Secret_Files.Calls;
