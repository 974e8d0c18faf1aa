--  SPDX-License-Identifier: GPL-3.0-or-later

with GNAT.OS_Lib;
with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;
with System;

package body Admission.Secret_Files with
  SPARK_Mode    => Off,
  Refined_State => (Files => null)
is

   Read_Only    : constant int := 8#2004400#;
   --  O_RDONLY, O_CLOEXEC, O_NONBLOCK, O_NOCTTY
   Of_The_File  : constant int := 16#1000#;         --  AT_EMPTY_PATH
   Wanted       : constant unsigned := 16#000B#;
   --  STATX_TYPE, STATX_MODE, STATX_UID

   --  The kernel's struct statx (linux/stat.h), the same on all platforms
   type Filler is array (Positive range <>) of Unsigned_32
     with Convention => C;

   type File_Status is record
      Before : Filler (1 .. 5);
      Owner  : Unsigned_32;
      Group  : Unsigned_32;
      Mode   : Unsigned_16;
      Spare  : Unsigned_16;
      Behind : Filler (1 .. 56);
   end record with Convention => C, Size => 256 * 8;

   function Open (Path : char_array; Flags : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   function Status_Of
     (Folder : int;
      Path   : char_array;
      Flags  : int;
      Mask   : unsigned;
      Status : System.Address) return int
   with Import, Convention => C, External_Name => "statx";

   procedure Read
     (Path    : Texts.Text;
      Data    : out String;
      Length  : out Natural;
      Mode    : out Admission.Authentication.File_Mode;
      Owner   : out Admission.Authentication.User_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   is
      File   : constant int := Open (To_C (Texts.Image (Path)), Read_Only);
      Status : File_Status;
      Got    : Ssize := -1;
   begin
      Data := (others => ' ');
      Length := 0;
      Mode := 0;
      Owner := 0;
      Texts.Set (Reason, "");
      if File >= 0
        and then Status_Of
          (File, To_C (""), Of_The_File, Wanted, Status'Address) = 0
      then
         Mode := Admission.Authentication.File_Mode (Status.Mode);
         Owner := Status.Owner;
         Got := Linux.Read (File, Data'Address, Data'Length);
      end if;
      Success := Got >= 0;
      if Success then
         Length := Natural (Got);
      else
         Texts.Set (Reason, GNAT.OS_Lib.Errno_Message);
      end if;
      if File >= 0 then
         Linux.Close (File);
      end if;
   end Read;

end Admission.Secret_Files;
