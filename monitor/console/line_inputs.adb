--  SPDX-License-Identifier: GPL-3.0-or-later
--  Lines of a script or of the keyboard, byte by byte.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with GNAT.OS_Lib;           use GNAT.OS_Lib;

package body Line_Inputs is

   procedure Close (S : in out Source) is
   begin
      if S.File not in Invalid_FD | Standin then
         Close (S.File);
      end if;
      S.File := Invalid_FD;
   end Close;

   procedure Get_Line
     (S     : in out Source;
      Line  : out Unbounded_String;
      Ended : out Boolean)
   is
      C : Character;
   begin
      Line := Null_Unbounded_String;
      Ended := False;
      loop
         if S.Next > S.Last then
            S.Next := 1;
            S.Last := Integer'Max
              (0, Read (S.File, S.Buffer'Address, S.Buffer'Length));
            if S.Last = 0 then
               Ended := Length (Line) = 0;
               return;
            end if;
         end if;

         C := S.Buffer (S.Next);
         S.Next := S.Next + 1;
         exit when C = ASCII.LF;
         Append (Line, C);
      end loop;
   end Get_Line;

   procedure Open (S : out Source; Name : String; OK : out Boolean) is
   begin
      S.File := Open_Read (Name, Binary);
      OK := S.File /= Invalid_FD and then not Is_Directory (Name);
   end Open;

   procedure Open_Standard_Input (S : out Source) is
   begin
      S.File := Standin;
   end Open_Standard_Input;

end Line_Inputs;
