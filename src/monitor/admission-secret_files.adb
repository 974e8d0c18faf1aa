--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;
with Process;

package body Admission.Secret_Files with SPARK_Mode is

   Credentials : constant String := "/run/credentials/";

   procedure Read
     (Path   : String;
      Data   : in out String;
      Mode   : out File_Mode;
      Owner  : out User_Number;
      Result : out Integer)
   with
     Global => (In_Out => Process.System_State),
     Post   => Result in -Integer'Last .. Data'Length;
   --  Into the first characters of Data, without waiting. Mode and Owner: of
   --  the file that was read. Result: the number of characters, or, if a call
   --  fails, its error (errno), negative

   procedure Read
     (Path   : String;
      Data   : in out String;
      Mode   : out File_Mode;
      Owner  : out User_Number;
      Result : out Integer)
   with SPARK_Mode => Off
   is
      --  Off: addresses are passed to C
      Status : File_Status := (others => 0);
      File   : constant int := Open_File (To_C (Path), To_Read_Only);
   begin
      Result := Outcome_Of (Ssize (File));
      if File >= 0 then
         --  AT_EMPTY_PATH; STATX_TYPE, STATX_MODE, STATX_UID
         Result := Outcome_Of
           (Ssize (Status_Of
              (File, To_C (""), 16#1000#, 16#000B#, Status'Address)));
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
      Read (Texts.Image (Path), Data, Mode, Owner, Result);
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
