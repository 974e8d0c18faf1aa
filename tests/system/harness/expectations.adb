--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects.

with Ada.Exceptions; use Ada.Exceptions;
with Ada.Text_IO;    use Ada.Text_IO;

with Instants;

package body Expectations is

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
         What & " took " & Instants.Milliseconds (Taken)
         & ", allowed are " & Instants.Milliseconds (Limit));
   end Check_Within;

   procedure Measure_Calmly (Measure : not null access procedure) is
      Attempts : constant := 3;
   begin
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
