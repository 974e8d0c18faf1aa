--  SPDX-License-Identifier: GPL-3.0-or-later

package body Console with SPARK_Mode is

   procedure Write
     (To    : Process.Descriptor;
      Text  : String;
      Error : in out Process.Error_Number)
   is
      Done   : Natural := 0;
      Result : Process.Outcome;
   begin
      while Error = 0 and then Done < Text'Length loop
         pragma Loop_Variant (Increases => Done);
         Process.Write
           (To, Text (Text'First + Done .. Text'Last), Result);
         if Result > 0 then
            Done := Done + Result;
         else
            Error := (if Result < 0 then -Result else Process.Io_Failure);
         end if;
      end loop;
   end Write;

   procedure Put_On
     (To : Process.Descriptor; Line : String; Written : out Boolean)
   with Pre => Line'Length < Max_Line
   is
      Text  : String (1 .. Line'Length + 1) := (others => ASCII.LF);
      Error : Process.Error_Number := 0;
   begin
      Text (1 .. Line'Length) := Line;
      Write (To, Text, Error);
      Written := Error = 0;
   end Put_On;

   procedure Put (Line : String; Written : out Boolean) is
   begin
      Put_On (Process.Standard_Output, Line, Written);
   end Put;

   procedure Put_Log (Line : String) is
      Ignored : Boolean;
   begin
      Put_On (Process.Standard_Error, Line, Ignored);
   end Put_Log;

   procedure Cannot_Start (Why : String) is
   begin
      Put_Log ("destijl: " & Why);
      Process.Leave (Process.Cannot_Start);
   end Cannot_Start;

end Console;
