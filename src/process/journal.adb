--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Bounded_Queues;
with Event;
with Schedule;
with Texts;

package body Journal with SPARK_Mode is

   package Arrived is new Event (Schedule.Th_Console);

   package Queues is new Bounded_Queues (Line, Capacity);

   Start : constant Time := Clock;

   protected Buffer with Priority => Schedule.Journal_Ceiling is
      procedure Put (Item : Line);
      procedure Take
        (Item : out Line; Found : out Boolean; Missing : out Natural);
      --  The oldest line. Missing > 0: the number of lines dropped before it;
      --  then Item has only a level and a time
      procedure Get_Waiting (Waiting : out Natural);
   private
      Kept     : Queues.Queue;
      Not_Kept : Natural := 0;
      --  dropped after those, for lack of room
      Writing  : Boolean := False;
      --  the line taken last is not yet on the console
   end Buffer;

   protected body Buffer is

      procedure Put (Item : Line) is
      begin
         if not Queues.Is_Full (Kept) then
            Queues.Put (Kept, Item);
         elsif Not_Kept < Natural'Last then
            Not_Kept := Not_Kept + 1;
         end if;
      end Put;

      procedure Take
        (Item : out Line; Found : out Boolean; Missing : out Natural) is
      begin
         Found := Queues.Length (Kept) > 0;
         Missing := (if Found then Not_Kept else 0);
         if Missing > 0 then
            Item :=
              (Level   => Options.Warning,
               At_Time => Queues.Element_At (Kept, 1).At_Time,
               others  => <>);
            Not_Kept := 0;
         else
            Queues.Take (Kept, Item, Found);
         end if;
         Writing := Found;
      end Take;

      procedure Get_Waiting (Waiting : out Natural) is
      begin
         Waiting := Queues.Length (Kept) + (if Writing then 1 else 0);
      end Get_Waiting;

   end Buffer;

   procedure Put (Level : Options.Level; Text : String) is
      Now  : Time;
      Item : Line;
      Done : Natural := 0;
   begin
      if Is_Kept (Level) then
         Now := Clock;
         loop
            Item :=
              (Level   => Level,
               At_Time => To_Duration (Now - Start),
               Length  => Natural'Min (Max_Text, Text'Length - Done),
               others  => <>);
            for K in 1 .. Item.Length loop
               Item.Text (K) := Text (Text'First + (Done + (K - 1)));
               if Item.Text (K) not in ' ' .. '~' then
                  Item.Text (K) := '?';
               end if;
            end loop;
            Buffer.Put (Item);
            Done := Done + Item.Length;
            exit when Done = Text'Length;
            pragma Loop_Invariant (Done < Text'Length);
            pragma Loop_Variant (Increases => Done);
         end loop;
         Arrived.Set;
      end if;
   end Put;

   procedure Take (Item : out Line) is
      Found   : Boolean;
      Missing : Natural;
      Told    : Texts.Text;
   begin
      loop
         Buffer.Take (Item, Found, Missing);
         exit when Found;
         Arrived.Wait;
      end loop;
      if Missing > 0 then
         Texts.Append (Told, Missing);
         Texts.Append
           (Told, " lines were not kept: the console is too slow");
         Item.Length := Told.Length;
         Item.Text (1 .. Told.Length) := Told.Data (1 .. Told.Length);
      end if;
   end Take;

   procedure Get_Waiting (Count : out Natural) is
   begin
      Buffer.Get_Waiting (Count);
   end Get_Waiting;

end Journal;
