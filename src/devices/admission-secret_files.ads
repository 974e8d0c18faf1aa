--  SPDX-License-Identifier: GPL-3.0-or-later
--  The file that holds the token (--token).

with Admission.Authentication;
with Texts;

package Admission.Secret_Files with
  SPARK_Mode,
  Abstract_State =>
    (Files with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Files
is

   procedure Read_Token
     (Path    : Texts.Text;
      Token   : out Admission.Authentication.Token;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with
     Global => (In_Out => Files),
     Post   => (if Path.Length = 0 then Success and then Token.Length = 0
                else Success = (Token.Length > 0));
   --  The token in the file Path, none if Path is empty. Never waits. Reason
   --  explains a failure: there is no token, or others could read it

end Admission.Secret_Files;
