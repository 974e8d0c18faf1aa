--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects.

with Ada.Text_IO; use Ada.Text_IO;

with Instants;    use Instants;

package body Expectations is

   Times_Ignored : Boolean  := False;
   Floor         : Duration := 0.0;

   procedure Check (Condition : Boolean; Message : String) is
   begin
      if not Condition then
         raise Failed with Message;
      end if;
   end Check;

   procedure Check_In_Time (Condition : Boolean; Message : String) is
   begin
      if Condition or else Times_Ignored then
         return;
      end if;
      raise Too_Late with Message;
   end Check_In_Time;

   procedure Check_Within
     (Taken : Duration; Limit : Duration; What : String)
   is
      Seen : constant String := What & " took " & Milliseconds (Taken);
   begin
      if Times_Ignored then
         Note (Seen);
      end if;
      Check_In_Time (Taken <= Limit + Floor,
                     Seen & ", allowed are " & Milliseconds (Limit) & " and "
                     & Milliseconds (Floor) & " of the machine");
   end Check_Within;

   procedure Set_Floor (Value : Duration) is
   begin
      Floor := Value;
   end Set_Floor;

   procedure Ignore_Times is
   begin
      Times_Ignored := True;
   end Ignore_Times;

   procedure Skip (Reason : String) is
   begin
      raise Skipped with Reason;
   end Skip;

   procedure Note (Text : String) is
   begin
      Put_Line ("      " & Text);
      Flush;
   end Note;

end Expectations;
