--  SPDX-License-Identifier: GPL-3.0-or-later

with Console.Calls;

package body Console with
  SPARK_Mode,
  Refined_State => (Terminal => Calls.Streams)
is

   procedure Put_On (To : Calls.Stream; Line : String; Written : out Boolean)
   with Pre => Line'Length < Max_Line;
   --  Writes all of it, or as much as is accepted

   procedure Put (Line : String; Written : out Boolean) is
   begin
      Put_On (Calls.Standard_Output, Line, Written);
   end Put;

   procedure Put_Log (Line : String) is
      Ignored : Boolean;
   begin
      Put_On (Calls.Standard_Error, Line, Ignored);
   end Put_Log;

   procedure Put_On (To : Calls.Stream; Line : String; Written : out Boolean)
   is
      Text : String (1 .. Line'Length + 1) := (others => ASCII.LF);
      Next : Positive := 1;
      Done : Calls.Outcome;
   begin
      Text (1 .. Line'Length) := Line;
      while Next <= Text'Last loop
         Calls.Write (To, Text (Next .. Text'Last), Done);
         if Done > 0 then
            Next := Next + Done;
         else
            exit when Done /= Calls.Interrupted;
         end if;
         pragma Loop_Invariant (Next <= Text'Last + 1);
      end loop;
      Written := Next > Text'Last;
   end Put_On;

end Console;
