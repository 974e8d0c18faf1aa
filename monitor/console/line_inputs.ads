--  SPDX-License-Identifier: GPL-3.0-or-later
--  Lines of a script or of the keyboard, byte by byte: Ada.Text_IO would
--  convert non-ASCII characters.

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
   --  The next line, without its end. Ended: there are no more. Characters
   --  after the last line feed count as a line.

   procedure Close (S : in out Source);

private

   type Source is limited record
      File   : GNAT.OS_Lib.File_Descriptor := GNAT.OS_Lib.Invalid_FD;
      Buffer : String (1 .. 4096)          := (others => ' ');
      Next   : Positive                    := 1;
      Last   : Natural                     := 0;
      --  Buffer (Next .. Last) has not been read yet
   end record;

end Line_Inputs;
