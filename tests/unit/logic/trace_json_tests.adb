--  SPDX-License-Identifier: GPL-3.0-or-later
--  The text of a trace: each event, and that what begins there ends there.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Interfaces;        use Interfaces;

with AUnit.Assertions;  use AUnit.Assertions;

with Schedule;          use Schedule;
with Texts;
with Trace_Json;        use Trace_Json;
with Unit_Runs; use Unit_Runs;

package body Trace_Json_Tests is

   LF : constant Character := ASCII.LF;

   procedure Expect
     (Open : in out Slices; Item : Event; Text : String)
   is
      --  What Item adds, counted from 1 us
      Line : Texts.Text;
   begin
      Put (Open, 1_000, Item, Line);
      Assert (Texts.Image (Line) = Text, Texts.Image (Line));
   end Expect;

   procedure Test_Balance is
      Open  : Slices := (others => None);
      Line  : Texts.Text;
      Depth : Integer := 0;
      Bits  : Unsigned_32 := 1;

      procedure Put_One (Kind : Event_Kind; At_Time : Unsigned_64) is
      begin
         Put
           (Open, 0,
            (Kind => Kind, Who => Th_Line, At_Time => At_Time, others => <>),
            Line);
         Depth := Depth + Count (Texts.Image (Line), """ph"":""B""");
         Depth := Depth - Count (Texts.Image (Line), """ph"":""E""");
         Assert (Depth in 0 .. 2, "depth" & Depth'Image);
         Assert (Slice_Kind'Pos (Open (Th_Line)) = Depth, "what is open");
      end Put_One;

   begin
      --  any sequence: events may be missing at every place
      for I in Unsigned_64 range 1 .. 10_000 loop
         Bits := Bits * 1_664_525 + 1_013_904_223;
         Put_One (Event_Kind'Val (Shift_Right (Bits, 16) mod 12), I);
      end loop;
      Put_One (Done, 10_001);
      Assert (Depth = 0, "not ended");
      Assert (Open = (Task_Name => None), "another task's is open");
   end Test_Balance;

   procedure Test_Events is
      Open : Slices := (others => None);
   begin
      Expect
        (Open, (Kind => Release, Who => Th_Move, At_Time => 500,
                Number => 7, others => <>),
         "," & LF & "{""name"":""release"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":5,""ts"":0.000,""args"":{""command"":7}}");
      Expect
        (Open, (Kind => Start, Who => Th_Move, At_Time => 2_001,
                Number => 7, others => <>),
         "," & LF & "{""name"":""job"",""ph"":""B"",""pid"":1,"
         & """tid"":5,""ts"":1.001,""args"":{""command"":7}}");
      Expect
        (Open, (Kind => Wait, Who => Th_Move, At_Time => 1_234_567_890,
                Label => "line  ", others => <>),
         "," & LF & "{""name"":""wait for line"",""ph"":""B"",""pid"":1,"
         & """tid"":5,""ts"":1234566.890}");
      Expect
        (Open, (Kind => Done, Who => Th_Line, At_Time => 1_234_567_890,
                others => <>), "");
      Expect
        (Open, (Kind => Resume, Who => Th_Move, At_Time => 1_234_567_900,
                others => <>),
         "," & LF
         & "{""ph"":""E"",""pid"":1,""tid"":5,""ts"":1234566.900}");
      Expect
        (Open, (Kind => Done, Who => Th_Move, At_Time => 1_234_568_000,
                others => <>),
         "," & LF
         & "{""ph"":""E"",""pid"":1,""tid"":5,""ts"":1234567.000}");
      Expect
        (Open, (Kind => Received, Who => Th_Receive_From_Mon,
                At_Time => 1_000, Label => "ROPN  ", others => <>),
         "," & LF & "{""name"":""in ROPN"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":6,""ts"":0.000}");
      Expect
        (Open, (Kind => Sent, Who => Th_Send_To_Mon,
                At_Time => 1_000, Label => "AACK  ", others => <>),
         "," & LF & "{""name"":""out AACK"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":9,""ts"":0.000}");
      Expect
        (Open, (Kind => Ordered, Who => Th_Line,
                At_Time => 1_000, Label => "M     ", others => <>),
         "," & LF & "{""name"":""robot M"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":2,""ts"":0.000}");
      Expect
        (Open, (Kind => Due, Who => Th_Reload_WD, At_Time => 1_000,
                others => <>),
         "," & LF & "{""name"":""due"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":3,""ts"":0.000}");
      Expect
        (Open, (Kind => Idle, Who => Th_Console, At_Time => 1_000,
                others => <>),
         "," & LF & "{""name"":""idle"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":22,""ts"":0.000}");
      Expect
        (Open, (Kind => Take_Up, Who => Th_Stop, At_Time => 2_000,
                others => <>),
         "," & LF & "{""name"":""release"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":1,""ts"":1.000}"
         & "," & LF & "{""name"":""job"",""ph"":""B"",""pid"":1,"
         & """tid"":1,""ts"":1.000}");
      Expect
        (Open, (Kind => Start_Due, Who => Th_Stop, At_Time => 4_000,
                Number => 3_000, others => <>),
         "," & LF & "{""ph"":""E"",""pid"":1,""tid"":1,""ts"":3.000}"
         & "," & LF & "{""name"":""due"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":1,""ts"":2.000}"
         & "," & LF & "{""name"":""job"",""ph"":""B"",""pid"":1,"
         & """tid"":1,""ts"":3.000}");
   end Test_Events;

   procedure Test_Label is
      Open : Slices := (others => None);
   begin
      Expect
        (Open, (Kind => Sent, Who => Th_Stop, Label => "a""\" & LF & "b ",
                others => <>),
         "," & LF & "{""name"":""out a???b"",""ph"":""i"",""s"":""t"","
         & """pid"":1,""tid"":1,""ts"":0.000}");
   end Test_Label;

   procedure Test_Longest is
      Open : Slices := (others => Job_And_Wait);
      Line : Texts.Text;
   begin
      Put
        (Open, 0,
         (Kind    => Start_Due,
          Who     => Task_Name'Last,
          At_Time => Unsigned_64'Last,
          Number  => Unsigned_64'Last,
          Label   => "ABCDEF"),
         Line);
      Assert (Line.Length < Texts.Max_Length, "an event is cut");
      Assert (Line.Data (Line.Length) = '}', Texts.Image (Line));
      Assert
        (Count (Texts.Image (Line), "18446744073709551.615") = 4,
         Texts.Image (Line));
      Begin_Text
        (Unsigned_64'Last, Unsigned_64'Last, Unsigned_64'Last, Line);
      Assert (Line.Length < Texts.Max_Length, "the beginning is cut");
      for Who in Task_Name loop
         Name_Task (Who, Line);
         Assert (Line.Length < Texts.Max_Length, "a name is cut");
      end loop;
   end Test_Longest;

   procedure Test_Order is

      function Place (Who : Task_Name) return Integer is
         Key  : constant String := """sort_index"":";
         Line : Texts.Text;
         From : Positive;
      begin
         Name_Task (Who, Line);
         From := Index (Texts.Image (Line), Key) + Key'Length;
         return Integer'Value
           (Line.Data (From .. Index (Texts.Image (Line), "}", From) - 1));
      end Place;

   begin
      for Left in Task_Name loop
         for Right in Task_Name loop
            if Table (Left).Priority > Table (Right).Priority then
               Assert (Place (Left) < Place (Right),
                       Left'Image & " and " & Right'Image);
            end if;
         end loop;
      end loop;
   end Test_Order;

   procedure Add_Tests is
   begin
      Add_Test ("the text of each event", Test_Events'Access);
      Add_Test ("what begins ends, whatever is missing", Test_Balance'Access);
      Add_Test ("room for the longest", Test_Longest'Access);
      Add_Test ("a label ends no text", Test_Label'Access);
      Add_Test ("tasks by their priorities", Test_Order'Access);
   end Add_Tests;

end Trace_Json_Tests;
