--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Log_Lines decides.

with Ada.Real_Time; use Ada.Real_Time;
with Event;
with Schedule;
with Trace;

package body Journal with SPARK_Mode is

   use type Options.Level;

   package Arrived is new Event;

   Start : constant Time := Clock;

   Least : Options.Level := Options.Info
     with Atomic, Async_Readers, Async_Writers;
   --  The most detailed level logged. Outside the buffer: a line that is not
   --  logged needs neither a lock nor the time of day

   procedure Put_Part
     (Level : Options.Level; Now : Instant; Text : String; After : Natural)
   with Pre => After <= Text'Length;
   --  A line of Text, without its first After characters

   protected Buffer with Priority => Schedule.Journal_Ceiling is
      procedure Put (Item : Line);
      procedure Take
        (Item : out Line; Found : out Boolean; Missing : out Natural);
      procedure Written;
      procedure Get_Waiting (Waiting : out Natural);
   private
      State : Log_Lines.State;
   end Buffer;

   protected body Buffer is

      procedure Put (Item : Line) is
      begin
         Log_Lines.Put (State, Item);
      end Put;

      procedure Take
        (Item : out Line; Found : out Boolean; Missing : out Natural) is
      begin
         Log_Lines.Take (State, Item, Found, Missing);
      end Take;

      procedure Written is
      begin
         Log_Lines.Written (State);
      end Written;

      procedure Get_Waiting (Waiting : out Natural) is
      begin
         Waiting := Log_Lines.Waiting (State);
      end Get_Waiting;

   end Buffer;

   procedure Get_Now (Now : out Instant)
   with Global => (Input => (Start, Clock_Time))
   is
      Read  : constant Time := Clock;
      Whole : Seconds_Count;
      Rest  : Time_Span;
   begin
      --  no division of the whole time: its result is an Integer, which
      --  overflows after 24 days
      Split (Time_Of (0, Read - Start), Whole, Rest);
      Now :=
        (Seconds     => Natural
           (Seconds_Count'Max
              (0, Seconds_Count'Min (Whole, Seconds_Count (Natural'Last)))),
         Thousandths =>
           Integer'Max (0, Integer'Min (Rest / Milliseconds (1), 999)));
   end Get_Now;

   procedure Set_Level (Least : Options.Level) is
   begin
      Journal.Least := Least;
   end Set_Level;

   procedure Get_Kept (Level : Options.Level; Kept : out Boolean) is
      Last_Kept : constant Options.Level := Least;
   begin
      Kept := Level <= Last_Kept;
   end Get_Kept;

   procedure Put (Level : Options.Level; Text : String) is
      Kept : Boolean;
      Now  : Instant;
      Done : Natural := 0;
   begin
      Get_Kept (Level, Kept);
      if Kept then
         Get_Now (Now);
         loop
            Put_Part (Level, Now, Text, Done);
            exit when Text'Length - Done <= Max_Text;
            Done := Done + Max_Text;
            pragma Loop_Invariant (Done <= Text'Length);
            pragma Loop_Variant (Increases => Done);
         end loop;
         Trace.Release (Schedule.Th_Console);
         Arrived.Set;
      end if;
   end Put;

   procedure Put (Level : Options.Level; Text : Texts.Text) is
   begin
      Put (Level, Text.Data (1 .. Text.Length));
   end Put;

   procedure Put_Part
     (Level : Options.Level; Now : Instant; Text : String; After : Natural)
   is
      Item : Line := (Level => Level, Time => Now, others => <>);
   begin
      Item.Length := Natural'Min (Max_Text, Text'Length - After);
      for K in 1 .. Item.Length loop
         Item.Text (K) := Text (Text'First + (After + (K - 1)));
         if Item.Text (K) not in ' ' .. '~' then
            Item.Text (K) := '?';
         end if;
      end loop;
      Buffer.Put (Item);
   end Put_Part;

   procedure Take (Item : out Line) is
      Found   : Boolean;
      Missing : Natural;
      Told    : Texts.Text;
   begin
      Trace.Done (Schedule.Th_Console);
      loop
         Buffer.Take (Item, Found, Missing);
         exit when Found;
         Trace.Idle (Schedule.Th_Console);
         Arrived.Wait;
      end loop;
      Trace.Start (Schedule.Th_Console);
      if Missing > 0 then
         Texts.Append (Told, Missing);
         Texts.Append
           (Told, " lines were not kept: the console is too slow");
         Item.Length := Told.Length;
         Item.Text (1 .. Told.Length) := Told.Data (1 .. Told.Length);
      end if;
   end Take;

   procedure Written is
   begin
      Buffer.Written;
   end Written;

   procedure Get_Waiting (Count : out Natural) is
   begin
      Buffer.Get_Waiting (Count);
   end Get_Waiting;

end Journal;
