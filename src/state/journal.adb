--  SPDX-License-Identifier: GPL-3.0-or-later
--  The log on its way to the console: a bounded buffer, so that no task ever
--  waits for the console.

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Bounded_Queues;
with Schedule;
with Trace;

package body Journal with SPARK_Mode is

   use type Options.Level;

   package Line_Queues is new Bounded_Queues (Line, Capacity);

   Arrived : Suspension_Object;

   Start : constant Time := Clock;

   Least : Options.Level := Options.Info
     with Atomic, Async_Readers, Async_Writers;
   --  Of what is kept. Not in the buffer: a line that is not kept costs next
   --  to nothing, neither a lock nor the time of day

   procedure Get_Now (Now : out Instant)
   with Global => (Input => (Start, Clock_Time));

   protected Buffer with Priority => Schedule.Journal_Ceiling is
      procedure Put (Item : Line);
      procedure Take (Item : out Line; Found : out Boolean);
      procedure Written;
      procedure Get_Waiting (Waiting : out Natural);
   private
      Kept     : Line_Queues.Queue;
      Not_Kept : Natural := 0;
      Writing  : Boolean := False;
   end Buffer;

   protected body Buffer is

      procedure Put (Item : Line) is
      begin
         if Line_Queues.Is_Full (Kept) then
            if Not_Kept < Natural'Last then
               Not_Kept := Not_Kept + 1;
            end if;
         else
            Line_Queues.Put (Kept, Item);
         end if;
      end Put;

      procedure Take (Item : out Line; Found : out Boolean) is
      begin
         if Line_Queues.Length (Kept) > 0 and then Not_Kept > 0 then
            Found := True;
            Item := (Level => Options.Warning,
                     Time  => Line_Queues.Element_At (Kept, 1).Time,
                     Text  => <>);
            Texts.Append (Item.Text, Not_Kept);
            Texts.Append
              (Item.Text, " lines were not kept: the console is too slow");
            Not_Kept := 0;
         else
            Line_Queues.Take (Kept, Item, Found);
         end if;
         Writing := Found;
      end Take;

      procedure Written is
      begin
         Writing := False;
      end Written;

      procedure Get_Waiting (Waiting : out Natural) is
      begin
         Waiting := Line_Queues.Length (Kept) + (if Writing then 1 else 0);
      end Get_Waiting;

   end Buffer;

   -------------
   -- Get_Now --
   -------------

   procedure Get_Now (Now : out Instant) is
      Read  : constant Time := Clock;
      Whole : Seconds_Count;
      Rest  : Time_Span;
   begin
      --  not by a division of the time as a whole: its result, an Integer,
      --  would be too small after 24 days
      Split (Time_Of (0, Read - Start), Whole, Rest);
      Now :=
        (Seconds     => Natural
           (Seconds_Count'Max
              (0, Seconds_Count'Min (Whole, Seconds_Count (Natural'Last)))),
         Thousandths =>
           Integer'Max (0, Integer'Min (Rest / Milliseconds (1), 999)));
   end Get_Now;

   ---------------
   -- Set_Level --
   ---------------

   procedure Set_Level (Least : Options.Level) is
   begin
      Journal.Least := Least;
   end Set_Level;

   --------------
   -- Get_Kept --
   --------------

   procedure Get_Kept (Level : Options.Level; Kept : out Boolean) is
      Last_Kept : constant Options.Level := Least;
   begin
      Kept := Level <= Last_Kept;
   end Get_Kept;

   ---------
   -- Put --
   ---------

   procedure Put (Level : Options.Level; Text : String) is
      Kept : Boolean;
      Now  : Instant;
      Item : Line;
   begin
      Get_Kept (Level, Kept);
      if Kept then
         Get_Now (Now);
         Item := (Level => Level, Time => Now, Text => <>);
         Texts.Set (Item.Text, Text);
         for C of Item.Text.Data loop
            if C not in ' ' .. '~' then
               C := '?';
            end if;
         end loop;
         Buffer.Put (Item);
         Trace.Release (Schedule.Th_Console);
         Set_True (Arrived);
      end if;
   end Put;

   procedure Put (Level : Options.Level; Text : Texts.Text) is
   begin
      Put (Level, Text.Data (1 .. Text.Length));
   end Put;

   ----------
   -- Take --
   ----------

   procedure Take (Item : out Line) is
      Found : Boolean;
   begin
      Trace.Done (Schedule.Th_Console);
      loop
         Buffer.Take (Item, Found);
         exit when Found;
         Trace.Idle (Schedule.Th_Console);
         Suspend_Until_True (Arrived);
      end loop;
      Trace.Start (Schedule.Th_Console);
   end Take;

   -------------
   -- Written --
   -------------

   procedure Written is
   begin
      Buffer.Written;
   end Written;

   -----------------
   -- Get_Waiting --
   -----------------

   procedure Get_Waiting (Count : out Natural) is
   begin
      Buffer.Get_Waiting (Count);
   end Get_Waiting;

end Journal;
