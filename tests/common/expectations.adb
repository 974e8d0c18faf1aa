--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects.

with Ada.Text_IO; use Ada.Text_IO;

with Instants;    use Instants;

package body Expectations is

   Time_Limit : Duration := Duration'Last;
   Begun      : Instant  := Now;
   --  of the limit; one task sets both and looks at them

   Measurements_Left_Out : Boolean := False;
   Last_Was_Time         : Boolean := False;

   procedure Check (Condition : Boolean; Message : String) is
   begin
      if not Condition then
         Last_Was_Time := False;
         raise Failed with Message;
      end if;
   end Check;

   procedure Check_In_Time (Condition : Boolean; Message : String) is
   begin
      if not Condition then
         Last_Was_Time := True;
         raise Failed with Message;
      end if;
   end Check_In_Time;

   procedure Check_Within
     (Taken : Duration; Limit : Duration; What : String)
   is
   begin
      Check_In_Time
        (Taken <= Limit,
         What & " took " & Milliseconds (Taken)
         & ", allowed are " & Milliseconds (Limit));
   end Check_Within;

   function Time_Ran_Out return Boolean is (Last_Was_Time);

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
