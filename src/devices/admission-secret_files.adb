--  SPDX-License-Identifier: GPL-3.0-or-later

with Admission.Secret_Files.Calls;
with Error_Texts;

package body Admission.Secret_Files with
  SPARK_Mode,
  Refined_State => (Files => Calls.System_Files)
is

   procedure Read
     (Path    : Texts.Text;
      Data    : out String;
      Length  : out Natural;
      Mode    : out Admission.Authentication.File_Mode;
      Owner   : out Admission.Authentication.User_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   is
      File   : Calls.Outcome;
      Result : Calls.Outcome;
   begin
      Data := (others => ' ');
      Length := 0;
      Mode := 0;
      Owner := 0;
      Texts.Set (Reason, "");
      Calls.Open (Texts.Image (Path), File);
      Result := File;
      if File >= 0 then
         --  of the file that is open: the path may lead to another by now
         Calls.Get_Status (File, Mode, Owner, Result);
         if Result >= 0 then
            Calls.Read (File, Data, Result);
         end if;
         Calls.Close (File);
      end if;
      Success := Result >= 0;
      if Success then
         Length := Result;
      else
         Error_Texts.Describe (-Result, Reason);
      end if;
   end Read;

end Admission.Secret_Files;
