--  SPDX-License-Identifier: GPL-3.0-or-later
--  The table of results.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;

with Faults;                use Faults;
with Plain_Numbers;         use Plain_Numbers;

package body Fault_Tables is

   type Tally is record
      Alone, In_Pairs, Violations, Impossible : Natural := 0;
   end record;

   Most : constant := 200;

   Rows  : array (1 .. Most) of Tally;
   --  by fault
   Pairs : array (Group_Kind, Group_Kind) of Tally;
   --  the earlier group first

   All_Injections, All_Violations : Natural := 0;

   function Group_Name (Group : Group_Kind) return String is
     (case Group is
         when Network => "network",
         when Robot   => "robot",
         when Camera  => "camera",
         when Machine => "machine");

   procedure Groups_Of
     (First, Second : Positive; Earlier, Later : out Group_Kind)
   is
      A : constant Group_Kind := Element (First).Group;
      B : constant Group_Kind := Element (Second).Group;
   begin
      Earlier := Group_Kind'Min (A, B);
      Later := Group_Kind'Max (A, B);
   end Groups_Of;

   procedure Count (First : Positive; Second : Natural; Violated : Boolean)
   is
      Earlier, Later : Group_Kind;
      Bad            : constant Natural := (if Violated then 1 else 0);
   begin
      All_Injections := All_Injections + 1;
      All_Violations := All_Violations + Bad;
      if Second = 0 then
         Rows (First).Alone := Rows (First).Alone + 1;
         Rows (First).Violations := Rows (First).Violations + Bad;
      else
         Groups_Of (First, Second, Earlier, Later);
         Rows (First).In_Pairs := Rows (First).In_Pairs + 1;
         Rows (Second).In_Pairs := Rows (Second).In_Pairs + 1;
         Rows (First).Violations := Rows (First).Violations + Bad;
         Rows (Second).Violations := Rows (Second).Violations + Bad;
         Pairs (Earlier, Later).In_Pairs :=
           Pairs (Earlier, Later).In_Pairs + 1;
         Pairs (Earlier, Later).Violations :=
           Pairs (Earlier, Later).Violations + Bad;
      end if;
   end Count;

   procedure Count_Impossible (First : Positive; Second : Natural) is
   begin
      if Second = 0 then
         Rows (First).Impossible := Rows (First).Impossible + 1;
      end if;
   end Count_Impossible;

   function Injections return Natural is (All_Injections);
   function Violations return Natural is (All_Violations);

   procedure Print (Path : String := "") is
      File : File_Type;

      procedure Put_Row (Row : Tally; Group, Name : String) is
      begin
         Put_Line
           ("| " & Group & " | " & Name
            & " | "
            & (if Row.Impossible > 0 and then Row.Alone = 0
               then "not possible here" else Image (Row.Alone))
            & " | " & Image (Row.In_Pairs)
            & " | " & Image (Row.Violations) & " |");
      end Put_Row;

   begin
      if Path /= "" then
         Create (File, Out_File, Path);
         Set_Output (File);
      end if;
      Put_Line ("| group | fault | alone | in pairs | violations |");
      Put_Line ("|---|---|---|---|---|");
      for Number in 1 .. Faults.Count loop
         if Rows (Number) /= (others => 0) then
            Put_Row
              (Rows (Number), Group_Name (Element (Number).Group),
               To_String (Element (Number).Name));
         end if;
      end loop;
      for Earlier in Group_Kind loop
         for Later in Earlier .. Group_Kind'Last loop
            if Pairs (Earlier, Later).In_Pairs > 0 then
               Put_Row
                 (Pairs (Earlier, Later),
                  Group_Name (Earlier) & ", " & Group_Name (Later),
                  "pairs");
            end if;
         end loop;
      end loop;
      Set_Output (Standard_Output);
      if Path /= "" then
         Close (File);
      end if;
   end Print;

end Fault_Tables;
