--  SPDX-License-Identifier: GPL-3.0-or-later
--  The system's words for the number of an error (errno).

with Texts;

package Error_Texts with SPARK_Mode is

   procedure Describe (Error : Integer; Text : out Texts.Text)
   with Global => null, Annotate => (GNATprove, Terminating);
   --  Such as "No such file or directory"

end Error_Texts;
