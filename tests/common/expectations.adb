--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects.

with Ada.Exceptions; use Ada.Exceptions;
with Ada.Text_IO;    use Ada.Text_IO;

with Instants;     use Instants;

package body Expectations is

   Time_Limit : Duration := Duration'Last;
   Begun      : Instant  := Now;
   --  of the limit; one task sets both and looks at them

   Measurements_Left_Out : Boolean := False;

   procedure Check (Condition : Boolean; Message : String) is
   begin
      if not Condition then
         raise Failed with Message;
      end if;
   end Check;

   procedure Check_Within
     (Taken : Duration; Limit : Duration; What : String)
   is
   begin
      Check
        (Taken <= Limit,
         What & " took " & Milliseconds (Taken)
         & ", allowed are " & Milliseconds (Limit));
   end Check_Within;

   procedure Leave_Out_Measurements is
   begin
      Measurements_Left_Out := True;
   end Leave_Out_Measurements;

   procedure Measures_Time is
   begin
      if Measurements_Left_Out then
         Skip ("it measures time");
      end if;
   end Measures_Time;

   procedure Measure_Calmly (Measure : not null access procedure) is
      Attempts : constant := 3;
   begin
      Measures_Time;
      for Attempt in 1 .. Attempts loop
         begin
            Measure.all;
            return;
         exception
            when Occurrence : Failed =>
               if Attempt = Attempts then
                  raise;
               end if;
               Note ("measured again: " & Exception_Message (Occurrence));
         end;
      end loop;
   end Measure_Calmly;

   procedure Limit_Time (Span : Duration) is
   begin
      Begun := Now;
      Time_Limit := Span;
   end Limit_Time;

   procedure Check_Time is
   begin
      Check
        (Now - Begun < Time_Limit,
         "it goes on for more than " & Milliseconds (Time_Limit));
   end Check_Time;

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
