--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C;        use Interfaces.C;
with Linux;               use Linux;
pragma Warnings (Off, "*is an internal GNAT unit");
with System.OS_Constants; use System.OS_Constants;
pragma Warnings (On, "*is an internal GNAT unit");

package body Process.Files with SPARK_Mode => Off is
   --  Off: addresses are passed to C

   --  Where a result is of no use, a function of C is a procedure here

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
               when None     => 0,
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
      Result := Outcome_Of
        (Linux.Write (int (File), Data'Address, Data'Length));
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
end Process.Files;
