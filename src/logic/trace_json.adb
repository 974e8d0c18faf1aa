--  SPDX-License-Identifier: GPL-3.0-or-later

with System;

package body Trace_Json with SPARK_Mode is

   subtype Digit_Value is Unsigned_64 range 0 .. 9;

   function Digit (Value : Digit_Value) return Character is
     (Character'Val (Character'Pos ('0') + Integer (Value)));

   function Number_Of (Who : Schedule.Task_Name) return Positive is
     (Schedule.Task_Name'Pos (Who) + 1);

   Separator : constant String := "," & ASCII.LF;
   --  before each object but the first

   procedure Append (Line : in out Texts.Text; Value : Unsigned_64);
   --  In decimal

   procedure Append_Label (Line : in out Texts.Text; Label : Label_Text);
   --  Up to its first blank; it contains no quote, so cannot end a JSON string

   procedure Append_Place
     (Line : in out Texts.Text; First : Unsigned_64; Item : Event);
   --  The members of an object that give its time and task

   procedure Append_End
     (Line : in out Texts.Text; First : Unsigned_64; Item : Event);
   --  Ends the last open slice of Item's task

   procedure Append_Other
     (Line : in out Texts.Text; First : Unsigned_64; Item : Event);
   --  The text of all events except ends of slices

   subtype Job_Start is Event_Kind range Start .. Start_Due;

   procedure Append (Line : in out Texts.Text; Value : Unsigned_64) is
      subtype Digit_Place is Integer range 1 .. 20;
      Digit_Text : String (Digit_Place) := (others => '0');
      First      : Digit_Place;
      Rest       : Unsigned_64 := Value;
   begin
      for Place in reverse Digit_Place loop
         Digit_Text (Place) := Digit (Rest mod 10);
         First := Place;
         Rest := Rest / 10;
         exit when Rest = 0;
      end loop;
      Texts.Append (Line, Digit_Text (First .. Digit_Place'Last));
   end Append;

   procedure Append_End
     (Line : in out Texts.Text; First : Unsigned_64; Item : Event) is
   begin
      Texts.Append (Line, Separator);
      Texts.Append (Line, "{""ph"":""E""");
      Append_Place (Line, First, Item);
      Texts.Append (Line, "}");
   end Append_End;

   procedure Append_Label (Line : in out Texts.Text; Label : Label_Text) is
   begin
      for C of Label loop
         exit when C = ' ';
         Texts.Append
           (Line,
            (1 => (if C in 'A' .. 'Z' | 'a' .. 'z' | '0' .. '9' then C
                   else '?')));
      end loop;
   end Append_Label;

   procedure Append_Other
     (Line : in out Texts.Text; First : Unsigned_64; Item : Event) is
   begin
      Texts.Append (Line, Separator);
      Texts.Append (Line, "{""name"":""");
      Texts.Append
        (Line,
         (case Item.Kind is
             when Release  => "release",
             when Due      => "due",
             when Start    => "job",
             when Wait     => "wait for ",
             when Received => "in ",
             when Sent     => "out ",
             when Ordered  => "robot ",
             when others   => "idle"));
      Append_Label (Line, Item.Label);
      Texts.Append
        (Line,
         (if Item.Kind in Start | Wait then """,""ph"":""B"""
          else """,""ph"":""i"",""s"":""t"""));
      Append_Place (Line, First, Item);
      if Item.Number > 0 then
         Texts.Append (Line, ",""args"":{""command"":");
         Append (Line, Item.Number);
         Texts.Append (Line, "}");
      end if;
      Texts.Append (Line, "}");
   end Append_Other;

   procedure Append_Place
     (Line : in out Texts.Text; First : Unsigned_64; Item : Event)
   is
      Since : constant Unsigned_64 :=
        (if Item.At_Time > First then Item.At_Time - First else 0);
   begin
      Texts.Append (Line, ",""pid"":1,""tid"":");
      Texts.Append (Line, Number_Of (Item.Who));
      Texts.Append (Line, ",""ts"":");
      Append (Line, Since / 1_000);
      Texts.Append
        (Line,
         (1 => '.',
          2 => Digit (Since / 100 mod 10),
          3 => Digit (Since / 10 mod 10),
          4 => Digit (Since mod 10)));
   end Append_Place;

   procedure Begin_Text
     (First    : Unsigned_64;
      Recorded : Unsigned_64;
      Kept     : Unsigned_64;
      Line     : out Texts.Text) is
   begin
      Texts.Set
        (Line,
         "{""displayTimeUnit"":""ns"",""otherData"":"
         & "{""clock"":""CLOCK_MONOTONIC"",""first_ns"":""");
      Append (Line, First);
      Texts.Append (Line, """,""recorded"":");
      Append (Line, Recorded);
      Texts.Append (Line, ",""kept"":");
      Append (Line, Kept);
      Texts.Append (Line, "},""traceEvents"":[" & ASCII.LF);
      Texts.Append
        (Line,
         "{""name"":""process_name"",""ph"":""M"",""pid"":1,"
         & """args"":{""name"":""destijl""}}");
   end Begin_Text;

   procedure Name_Task (Who : Schedule.Task_Name; Line : out Texts.Text) is
      Below_All : constant := System.Any_Priority'Last + 1;
   begin
      Texts.Set (Line, Separator);
      Texts.Append
        (Line, "{""name"":""thread_name"",""ph"":""M"",""pid"":1,""tid"":");
      Texts.Append (Line, Number_Of (Who));
      Texts.Append (Line, ",""args"":{""name"":""");
      Texts.Append (Line, Schedule.Name_Of (Who));
      Texts.Append (Line, """}}");
      Texts.Append (Line, Separator);
      Texts.Append
        (Line,
         "{""name"":""thread_sort_index"",""ph"":""M"",""pid"":1,""tid"":");
      Texts.Append (Line, Number_Of (Who));
      Texts.Append (Line, ",""args"":{""sort_index"":");
      --  the viewer shows the lowest index on top
      Texts.Append
        (Line,
         100 * (Below_All - Schedule.Table (Who).Priority) + Number_Of (Who));
      Texts.Append (Line, "}}");
   end Name_Task;

   procedure Put
     (Open  : in out Slices;
      First : Unsigned_64;
      Item  : Event;
      Line  : out Texts.Text) is
   begin
      Line := (others => <>);
      if Item.Kind in Job_Start | Done | Wait | Resume
        and then Open (Item.Who) = Job_And_Wait
      then
         Append_End (Line, First, Item);
         Open (Item.Who) := Job;
      end if;
      if Item.Kind in Job_Start | Done and then Open (Item.Who) = Job then
         Append_End (Line, First, Item);
         Open (Item.Who) := None;
      end if;
      case Item.Kind is
         when Job_Start =>
            if Item.Kind = Take_Up then
               Append_Other
                 (Line, First,
                  (At_Time => Item.At_Time,
                   Who     => Item.Who,
                   Kind    => Release,
                   others  => <>));
            elsif Item.Kind = Start_Due then
               Append_Other
                 (Line, First,
                  (At_Time => Item.Number,
                   Who     => Item.Who,
                   Kind    => Due,
                   others  => <>));
            end if;
            Append_Other
              (Line, First,
               (At_Time => Item.At_Time,
                Number  => (if Item.Kind = Start then Item.Number else 0),
                Who     => Item.Who,
                Kind    => Start,
                others  => <>));
            Open (Item.Who) := Job;
         when Wait =>
            if Open (Item.Who) = Job then
               Append_Other (Line, First, Item);
               Open (Item.Who) := Job_And_Wait;
            end if;
         when Done | Resume =>
            null;
         when others =>
            Append_Other (Line, First, Item);
      end case;
   end Put;

end Trace_Json;
