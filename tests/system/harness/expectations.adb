--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects.

with Ada.Text_IO; use Ada.Text_IO;

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
