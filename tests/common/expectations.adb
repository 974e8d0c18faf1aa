--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a test expects.

with Ada.Text_IO; use Ada.Text_IO;

with Instants;    use Instants;

package body Expectations is

   procedure Check (Condition : Boolean; Message : String) is
   begin
      if not Condition then
         raise Failed with Message;
      end if;
   end Check;

   procedure Check_In_Time (Condition : Boolean; Message : String) is
   begin
      if not Condition and then not Ignore_Times then
         raise Too_Late with Message;
      end if;
   end Check_In_Time;

   procedure Check_Within
     (Taken : Duration; Limit : Duration; What : String)
   is
      Seen : constant String := What & " took " & Milliseconds (Taken);
   begin
      if Ignore_Times then
         Note (Seen);
      end if;
      Check_In_Time (Taken <= Limit + Own_Time,
                     Seen & ", allowed are " & Milliseconds (Limit) & " and "
                     & Milliseconds (Own_Time) & " of the machine");
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
