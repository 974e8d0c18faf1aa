--  SPDX-License-Identifier: GPL-3.0-or-later

with Admission.Secret_Files.Calls;
with Process;

package body Admission.Secret_Files with
  SPARK_Mode,
  Refined_State => (Files => Calls.System_Files)
is

   Credentials : constant String := "/run/credentials/";

   procedure Read_Token
     (Path   : Texts.Text;
      Token  : out Admission.Token;
      Reason : out Texts.Text)
   is
      Data   : String (1 .. 256) := (others => ' ');
      Mode   : File_Mode;
      Owner  : User_Number;
      Result : Integer;
   begin
      Token := (others => <>);
      Texts.Set (Reason, "");
      if Path.Length = 0 then
         return;
      end if;
      Calls.Read (Texts.Image (Path), Data, Mode, Owner, Result);
      if Result < 0 then
         Process.Describe (-Result, Reason);
      elsif not Is_Kept_Secret (Mode, Owner) then
         Texts.Set
           (Reason,
            "others than its owner can read or write it (chmod go= it)");
      else
         Read_Token (Data (1 .. Result), Token);
         Texts.Set
           (Reason,
            (if Token.Length > 0 then ""
             else "its first line is no token: 16 .. 128 printable ASCII "
               & "characters without a blank"));
      end if;
      if Reason.Length > 0 and then Path.Length > Credentials'Length
        and then Path.Data (Credentials'Range) = Credentials
      then
         Texts.Append
           (Reason,
            ". It is systemd's copy of the file to mend, "
            & "/etc/destijl/token unless LoadCredential= names another");
      end if;
   end Read_Token;

end Admission.Secret_Files;
