--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line, an argument after the other.

with Ada.Command_Line;  use Ada.Command_Line;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

with Plain_Numbers;     use Plain_Numbers;

package body Option_Readers is

   Place : Natural := 0;
   --  of the option or word
   Last  : Natural := 0;
   --  of its value; Place where it is behind "=" or none was taken
   Taken : Boolean := True;
   --  the value, if one is behind "="

   function Sign return Natural is
     (if Index (Argument (Place), "--") = 1
      then Index (Argument (Place), "=") else 0);
   --  Where "=" is in an option, 0 without

   function Next return Boolean is
   begin
      if not Taken then
         raise Bad_Usage with Name & ": takes no value";
      elsif Last = Argument_Count then
         return False;
      end if;
      Place := Last + 1;
      Last := Place;
      Taken := Sign = 0;
      return True;
   end Next;

   function Name return String is
     (if Sign = 0 then Argument (Place) else Argument (Place) (1 .. Sign - 1));

   function Value return String is
      Given : constant String := Argument (Place);
   begin
      Taken := True;
      if Sign > 0 then
         return Given (Sign + 1 .. Given'Last);
      elsif Place = Argument_Count then
         raise Bad_Usage with Name & ": needs a value";
      end if;
      Last := Place + 1;
      return Argument (Last);
   end Value;

   function Number
     (Low : Integer := 1; High : Integer := Integer'Last) return Integer
   is
      Text   : constant String := Value;
      Result : Integer;
   begin
      Result := Integer'Value (Text);
      if Result in Low .. High then
         return Result;
      end if;
      raise Constraint_Error;
   exception
      when Constraint_Error =>
         raise Bad_Usage with Name & ": a number from " & Image (Low)
           & (if High = Integer'Last then " on" else " to " & Image (High))
           & " is expected, not '" & Text & "'";
   end Number;

   procedure Refuse is
   begin
      raise Bad_Usage with Name & ": unknown";
   end Refuse;

end Option_Readers;
