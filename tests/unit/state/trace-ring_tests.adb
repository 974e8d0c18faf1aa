--  SPDX-License-Identifier: GPL-3.0-or-later
--  The ring of a trace: the newest events, and none that is mixed from two.

with Ada.Directories;
with Ada.Real_Time;    use Ada.Real_Time;
with Ada.Strings.Unbounded; use type Ada.Strings.Unbounded.Unbounded_String;
with Interfaces;       use Interfaces;

with Programs;
with Schedule;         use Schedule;
with Texts;
with Trace.Ring;       use Trace.Ring;
with Trace_Files;
with Unit_Runs;        use Unit_Runs;

procedure Trace.Ring_Tests is

   use type Commands.Ticket;

   function Marked (Value : Commands.Ticket) return Event is
     (At_Time => Time_Of (Seconds_Count (Value mod 2 ** 32), Time_Span_Zero),
      Number  => Value,
      Who     => Task_Name'Val (Value mod 17),
      Kind    => Event_Kind'Val (Value mod 10),
      Label   => (others => Character'Val (Value mod 251)));
   --  All of it depends on Value

   procedure Test_File is
      Path    : constant String := Programs.Temporary_Folder & "/trace.txt";
      More    : constant := 6_001;
      Success : Boolean;
      Reason  : Texts.Text;
      Result  : Trace_Files.Trace;
      Starts  : Natural;
   begin
      Trace.Open (Texts.To_Text (Path), Success, Reason);
      Assert (Success, Texts.Image (Reason));
      Trace.Put (Trace.Release, Th_Move, 5);
      for I in 4 .. Capacity + More - 1 loop
         --  what lasts past the first events that are kept, begins in those
         --  that are not
         if I mod 3 = 0 then
            Trace.Put (Trace.Start, Th_Move);
         elsif I mod 3 = 1 then
            Trace.Put (Trace.Wait, Th_Move, Label => Trace.Line);
         else
            Trace.Put (Trace.Done, Th_Move);
         end if;
      end loop;
      Trace.Put_Due (Th_Move, Time_First);
      Trace.Put (Trace.Resume, Th_Move);
      Trace.Put (Trace.Sent, Th_Send_To_Mon, Label => "AACK  ");
      Trace.Finish (Reason);
      --  with contracts on and other load it may be too slow
      Success := Reason.Length = 0;
      Assert (Success or else Texts.Image (Reason) = "it takes too long",
              Texts.Image (Reason));
      Result := Trace_Files.Trace_Of (Path);
      Assert (Result.Recorded = Capacity + More, "recorded");
      for Item of Result.Events loop
         Assert (Item.What /= "release", "the oldest is kept");
         Assert (Item.Time < 1_000.0, "a time of long ago");
      end loop;
      Starts := Trace_Files.Count_Of (Result, "th_move", "start");
      Assert (Starts <= Capacity / 3 + 1
              and then (Starts >= Capacity / 3 - 1 or else not Success),
              Starts'Image & " jobs");
      Assert (Trace_Files.Count_Of (Result, "th_sendToMon", "out AACK")
              = (if Success then 1 else 0), "the newest is missing");
      Programs.Remove_Temporary_Folder;
      --  it is over
      Trace.Put (Trace.Start, Th_Move);
      Trace.Finish (Reason);
      Assert
        (Reason.Length = 0 and then not Ada.Directories.Exists (Path),
         "again");
   end Test_File;

   procedure Test_Round is
      Past  : constant := 5;
      Item  : Event;
      Found : Boolean;
      Count : Event_Number;
   begin
      Ring.Reset;
      Get (0, Item, Found);
      Assert (not Found, "an event in an empty ring");
      for Number in Event_Number range 0 .. Capacity + Past - 1 loop
         Ring.Put (Marked (100 + Commands.Ticket (Number)));
         Get_Count (Count);
         Assert (Count = Number + 1, "count" & Count'Image);
         Get (Number, Item, Found);
         Assert (Found and then Item = Marked (100 + Commands.Ticket (Number)),
                 "the newest");
         Get (Number + 1, Item, Found);
         Assert (not Found, "one that has not come");
      end loop;
      for Number in Event_Number range 0 .. Capacity + Past - 1 loop
         Get (Number, Item, Found);
         Assert (Found = (Number >= Past)
                 and then (not Found or else
                             Item = Marked (100 + Commands.Ticket (Number))),
                 "event" & Number'Image);
      end loop;
   end Test_Round;

   procedure Test_Together is
      Writers : constant := 4;
      Each    : constant := Capacity / 8;
      --  Half of the ring in a round: a writer that stands still meanwhile is
      --  not overtaken by a whole one, as it would mix its event with another
      First   : Event_Number := 0;
      Count   : Event_Number;
      Seen    : Natural := 0;

      procedure Look (Number : Event_Number) is
         Item  : Event;
         Found : Boolean;
      begin
         Get (Number, Item, Found);
         if Found then
            Seen := Seen + 1;
            Assert (Item = Marked (Item.Number), "mixed");
         end if;
      end Look;

   begin
      Ring.Reset;
      for Round in 1 .. 40 loop
         declare
            task type Writer (Number : Integer);

            task body Writer is
            begin
               for I in Unsigned_64 range 1 .. Each loop
                  Ring.Put
                    (Marked (Commands.Ticket (Number) * 2 ** 32
                             + Commands.Ticket (I)));
               end loop;
            end Writer;

            One   : Writer (1);
            Two   : Writer (2);
            Three : Writer (3);
            Four  : Writer (4);
            pragma Unreferenced (One, Two, Three, Four);
         begin
            loop
               Get_Count (Count);
               exit when Count = First + Writers * Each;
               for Back in Event_Number range 1 .. 4 loop
                  Look (if Count > Back then Count - Back else 0);
                  --  and the oldest, which are overwritten next
                  Look ((if Count > Capacity then Count - Capacity else 0)
                        + Back);
               end loop;
            end loop;
         end;
         Seen := 0;
         First := Count;
         for Back in 1 .. Event_Number'Min (Count, Capacity) loop
            Look (Count - Back);
         end loop;
         Assert (Unsigned_64 (Seen) = Event_Number'Min (Count, Capacity),
                 Seen'Image & " are there");
      end loop;
   end Test_Together;

begin
   Run_Test ("the newest are kept", Test_Round'Access);
   Run_Test ("many writers, and a reader at once", Test_Together'Access);
   Run_Test ("more than is kept, in the file", Test_File'Access);
end Trace.Ring_Tests;
