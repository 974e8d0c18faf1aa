--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;

package body Admission.Secret_Files.Calls with
  SPARK_Mode    => Off,
  Refined_State => (System_Files => null)
is
   --  Off: addresses are passed to C

   Of_The_File  : constant int := 16#1000#;         --  AT_EMPTY_PATH
   Wanted       : constant unsigned := 16#000B#;
   --  STATX_TYPE, STATX_MODE, STATX_UID

   procedure Open (Path : String; Result : out Outcome) is
   begin
      Result := Outcome_Of (Ssize (Open_File (To_C (Path), To_Read_Only)));
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
