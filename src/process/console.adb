--  SPDX-License-Identifier: GPL-3.0-or-later

with Process.Files;

package body Console with SPARK_Mode is

   procedure Put_On
     (To : Process.Files.Descriptor; Line : String; Written : out Boolean)
   with Pre => Line'Length < Max_Line
   is
      --  Writes all of it, or as much as is accepted
      Text : String (1 .. Line'Length + 1) := (others => ASCII.LF);
      Next : Positive := 1;
      Done : Process.Files.Outcome;
   begin
      Text (1 .. Line'Length) := Line;
      while Next <= Text'Last loop
         Process.Files.Write (To, Text (Next .. Text'Last), Done);
         if Done > 0 then
            Next := Next + Done;
         else
            exit when Done /= -Process.Files.Interrupted;
         end if;
         pragma Loop_Invariant (Next <= Text'Last + 1);
      end loop;
      Written := Next > Text'Last;
   end Put_On;

   procedure Put (Line : String; Written : out Boolean) is
   begin
      Put_On (Process.Files.Standard_Output, Line, Written);
   end Put;

   procedure Put_Log (Line : String) is
      Ignored : Boolean;
   begin
      Put_On (Process.Files.Standard_Error, Line, Ignored);
   end Put_Log;

   procedure Cannot_Start (Why : String) is
   begin
      Put_Log ("destijl: " & Why);
      Process.Leave (Process.Cannot_Start);
   end Cannot_Start;

end Console;
