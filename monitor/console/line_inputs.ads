--  SPDX-License-Identifier: GPL-3.0-or-later
--  Lines of a script or of the keyboard, byte for byte: Ada.Text_IO would
--  translate what is not ASCII.

with Ada.Strings.Unbounded;
with GNAT.OS_Lib;

package Line_Inputs is

   type Source is limited private;

   procedure Open_Standard_Input (S : out Source);

   procedure Open (S : out Source; Name : String; OK : out Boolean);

   procedure Get_Line
     (S     : in out Source;
      Line  : out Ada.Strings.Unbounded.Unbounded_String;
      Ended : out Boolean);
   --  The next line, without its end. Ended: there is none any more. What
   --  follows the last line feed counts as a line if there is anything.

   procedure Close (S : in out Source);

private

   type Source is limited record
      File   : GNAT.OS_Lib.File_Descriptor := GNAT.OS_Lib.Invalid_FD;
      Buffer : String (1 .. 4096)          := (others => ' ');
      Next   : Positive                    := 1;
      Last   : Natural                     := 0;
      --  Buffer (Next .. Last) is still to be read
   end record;

end Line_Inputs;
