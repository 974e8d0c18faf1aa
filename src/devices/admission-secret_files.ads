--  SPDX-License-Identifier: GPL-3.0-or-later
--  Files that hold a secret: their first characters and permissions.

with Admission.Authentication;
with Texts;

package Admission.Secret_Files with
  SPARK_Mode,
  Abstract_State =>
    (Files with Synchronous, External => (Async_Readers, Async_Writers)),
  Initializes => Files
is

   procedure Read
     (Path    : Texts.Text;
      Data    : out String;
      Length  : out Natural;
      Mode    : out Admission.Authentication.File_Mode;
      Owner   : out Admission.Authentication.User_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   with
     Global => (In_Out => Files),
     Post   => Length <= Data'Length;
   --  The first characters of the file, as many as exist and fit into Data,
   --  and its mode and owner at that time. Never waits. Reason explains a
   --  failure

end Admission.Secret_Files;
