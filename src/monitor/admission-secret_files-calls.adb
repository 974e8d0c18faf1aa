--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;

package body Admission.Secret_Files.Calls with
  SPARK_Mode    => Off,
  Refined_State => (System_Files => null)
is
   --  Off: addresses are passed to C

   Of_The_File : constant int := 16#1000#;       --  AT_EMPTY_PATH
   Wanted      : constant unsigned := 16#000B#;
   --  STATX_TYPE, STATX_MODE, STATX_UID

   procedure Read
     (Path   : String;
      Data   : in out String;
      Mode   : out File_Mode;
      Owner  : out User_Number;
      Result : out Integer)
   is
      Status : File_Status := (others => 0);
      File   : constant int := Open_File (To_C (Path), To_Read_Only);
   begin
      Result := Outcome_Of (Ssize (File));
      if File >= 0 then
         Result := Outcome_Of
           (Ssize (Status_Of
              (File, To_C (""), Of_The_File, Wanted, Status'Address)));
         if Result >= 0 then
            Result := Outcome_Of
              (Ssize'Min (Linux.Read (File, Data'Address, Data'Length),
                          Data'Length));
         end if;
         Linux.Close (File);
      end if;
      Mode := File_Mode'Mod (Status (8));
      Owner := Status (6);
   end Read;

end Admission.Secret_Files.Calls;
