--  SPDX-License-Identifier: GPL-3.0-or-later
--  The file that holds the token (--token).

with Texts;

package Admission.Secret_Files with SPARK_Mode is

   procedure Read_Token
     (Path   : Texts.Text;
      Token  : out Admission.Token;
      Reason : out Texts.Text)
   with Post => (if Path.Length = 0 then Token.Length = 0);
   --  The token in the file Path. Never waits. Length 0: Path is empty, or,
   --  for the Reason, there is none or others could read it

end Admission.Secret_Files;
