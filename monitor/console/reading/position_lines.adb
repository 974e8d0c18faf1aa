--  SPDX-License-Identifier: GPL-3.0-or-later

with GNAT.Regpat; use GNAT.Regpat;

package body Position_Lines is

   Number : constant String := ";(-?[0-9]{1,8})\.([0-9]{6})";
   Form   : constant Pattern_Matcher :=
     Compile
       ("^CPOS:(-1|[0-9]{1,3})" & Number & Number & Number & Number & Number
        & "$");

   procedure Parse (Line : String; P : out Position; OK : out Boolean) is
      Found : Match_Array (0 .. 11);

      function Text (Group : Positive) return String is
        (Line (Found (Group).First .. Found (Group).Last));

      function Value (Group : Positive) return Micro is
        (Micro'Value (Text (Group) & Text (Group + 1)));

   begin
      Match (Form, Line, Found);
      OK := Found (0) = (Line'First, Line'Last);
      P := (if OK
            then (Robot_Id'Value (Text (1)), Value (2), Value (4), Value (6),
                  Value (8), Value (10))
            else Not_Found);
   exception
      when Constraint_Error =>  --  of a number beyond Micro
         OK := False;
         P := Not_Found;
   end Parse;

end Position_Lines;
