--  SPDX-License-Identifier: GPL-3.0-or-later

with Console;
with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;
with System;

package body Event_Counters with SPARK_Mode => Off is
   --  Off: addresses are passed to C

   procedure Add (To : Counter) is
      One     : constant Unsigned_64 := 1;
      Ignored : Ssize;
      pragma Unreferenced (Ignored);
   begin
      Ignored := Linux.Write (int (To), One'Address, 8);
   end Add;

   function New_Counter return Counter is
      Made : constant Counter := Counter (Event_Counter (0, Event_Blocking));
   begin
      if Made < 0 then
         Console.Cannot_Start ("no file descriptor is left for an event");
      end if;
      return Made;
   end New_Counter;

   procedure Take
     (From   : Counter;
      Number : out Natural;
      Limit  : Time_Span := Time_Span_Last)
   is
      Left    : constant Time_Span :=
        (if Limit <= Time_Span_Zero then Time_Span_Zero
         elsif Limit < Seconds (3_600) then Limit else Seconds (3_600));
      Whole   : constant Integer := Left / Seconds (1);
      Rest    : constant Time_Span := Left - Seconds (Whole);
      Wait    : constant Time_Spec :=
        (long (Whole), long (Rest / Nanoseconds (1)));
      Entries : Poll_Entry := (int (From), Poll_In, 0);
      Value   : Unsigned_64 := 0;
   begin
      Number :=
        (if (Limit = Time_Span_Last
             or else Precise_Poll
               (Entries'Address, 1, Wait'Address, System.Null_Address) = 1)
           and then Linux.Read (int (From), Value'Address, 8) = 8
         then Natural (Unsigned_64'Min (Value, Unsigned_64 (Natural'Last)))
         else 0);
   end Take;

end Event_Counters;
