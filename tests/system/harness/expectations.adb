--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects.

with Ada.Exceptions; use Ada.Exceptions;
with Ada.Text_IO;    use Ada.Text_IO;

with Host_Time;
with Instants;

package body Expectations is

   procedure Check (Condition : Boolean; Message : String) is
   begin
      if not Condition then
         raise Failed with Message;
      end if;
   end Check;

   Is_Timing : Boolean := False;
   --  What has failed last is a matter of time

   procedure Check_Timing (Condition : Boolean; Message : String) is
   begin
      Is_Timing := not Condition;
      Check (Condition, Message);
   end Check_Timing;

   procedure Check_Within
     (Taken : Duration; Limit : Duration; What : String)
   is
   begin
      Check_Timing
        (Taken <= Limit,
         What & " took " & Instants.Milliseconds (Taken)
         & ", allowed are " & Instants.Milliseconds (Limit));
   end Check_Within;

   procedure Measure_Calmly (Measure : not null access procedure) is
      Attempts      : constant := 3;
      Most_Attempts : constant := 6;
      Host_Grant    : constant Duration := 0.1;
      Taken         : Duration;
   begin
      for Attempt in 1 .. Most_Attempts loop
         Taken := Host_Time.Taken;
         Is_Timing := False;
         begin
            Measure.all;
            return;
         exception
            when Occurrence : Failed =>
               Taken := Host_Time.Taken - Taken;
               if Attempt >= Attempts and then Taken < Host_Grant then
                  raise;
               elsif Attempt = Most_Attempts then
                  if not Is_Timing then
                     raise;
                  end if;
                  Note
                    ("not judged: " & Exception_Message (Occurrence)
                     & ", but the host had the processors for "
                     & Instants.Milliseconds (Taken));
                  return;
               end if;
               Note ("measured again: " & Exception_Message (Occurrence));
         end;
      end loop;
   end Measure_Calmly;

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
