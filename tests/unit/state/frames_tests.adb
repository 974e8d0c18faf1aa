--  SPDX-License-Identifier: GPL-3.0-or-later
--  The frame slots: who holds which, and that the newest image wins.

with Ada.Real_Time;    use Ada.Real_Time;

with Schedule;
with Vision.Frames;
with Vision.Image_Grid;
with Unit_Runs; use Unit_Runs;

procedure Frames_Tests is

   use type Vision.Slot;
   use type Vision.Image_Grid.Microseconds;

   Period : constant := 100_000;

   Coming : Boolean;
   --  Newer images will come

   procedure Begin_Anew is
      --  A camera has been opened.
   begin
      for Slot in Vision.Slot loop
         Vision.Frames.Store.Release (Slot);
      end loop;
      Vision.Frames.Store.Begin_Delivery (Clock);
   end Begin_Anew;

   procedure Check_None is
      --  No image waits.
      Taken : Vision.Slot;
      Found : Boolean;
   begin
      Vision.Frames.Store.Claim_Newest (Taken, Found, Coming);
      Assert (not Found, "no image expected, not" & Taken'Image);
   end Check_None;

   procedure Claim_Due
     (Now     : Time;
      Slot    : out Vision.Slot;
      At_Time : out Time;
      Reserve : out Boolean)
   is
      --  What is sent at Now; it is released again
      Found : Boolean;
   begin
      Vision.Frames.Store.Claim_Due
        (Now, Period, Slot, At_Time, Reserve, Found, Coming);
      Assert (Found and then Coming, "an image is due");
      Vision.Frames.Store.Release (Slot);
   end Claim_Due;

   procedure Put (At_Time : Time; Slot : out Vision.Slot) is
      --  An image comes
   begin
      Vision.Frames.Store.Claim_Empty (Slot);
      Vision.Frames.Publish (Slot, At_Time);
   end Put;

   procedure Test_End is
      Slot  : Vision.Slot;
      Found : Boolean;
   begin
      Begin_Anew;
      Put (Clock, Slot);
      Vision.Frames.End_Delivery;
      Check_None;
      Vision.Frames.Wait_Newest (Slot, Found);
      Assert (not Found, "nobody waits for what does not come");

      --  an image that the owner was just taking is too late

      Put (Clock, Slot);
      Check_None;

      --  and a camera that is opened again begins with nothing

      Vision.Frames.Store.Begin_Delivery (Clock);
      Check_None;
      Put (Clock, Slot);
      Vision.Frames.Wait_Newest (Slot, Found);
      Assert (Found, "the first image of the new delivery");
      Vision.Frames.Store.Release (Slot);
   end Test_End;

   procedure Test_In_Turn is
      Held, Slot, Last : Vision.Slot;

      function Next
        (After : Vision.Slot) return Vision.Slot is
        (if After = Vision.Slot'Last
         then Vision.Slot'First
         else After + 1);
   begin
      Begin_Anew;
      Vision.Frames.Store.Claim_Empty (Held);
      Last := Held;
      for Image in 1 .. 3 * Vision.Slot'Range_Length loop
         Put (Clock, Slot);
         Last := Next (Last);
         if Last = Held then
            Last := Next (Last);
         end if;
         Assert (Slot = Last, "the next free one, not" & Slot'Image);
      end loop;
   end Test_In_Turn;

   procedure Test_Elapsed is
      Begun : constant Time := Clock;
   begin
      Assert (Vision.Image_Grid.Elapsed (Begun, Begun) = 0, "none");
      Assert (Vision.Image_Grid.Elapsed (Begun, Begun + Microseconds (1)) = 1,
                   "a microsecond");
      Assert (Vision.Image_Grid.Elapsed (Begun + Seconds (1), Begun) = 0,
              "none that is negative");
      Assert (Vision.Image_Grid.Elapsed (Begun, Begun + Seconds (5_000))
                = Vision.Image_Grid.Microseconds'Last, "more than there is");
   end Test_Elapsed;

   procedure Play (Script : String) is
      --  Its words: "N" is an image that comes N ms after the beginning; "N>M"
      --  sends at N ms that of M ms, "N>M+" keeps a newer one in reserve; "-"
      --  none is left
      Begun   : constant Time := Clock;
      In_Slot : array (Vision.Slot) of Natural := (others => 0);

      procedure Carry_Out (Word : Line_Vectors.Vector) is
         Now     : constant Natural := Natural'Value (Word (1));
         Slot    : Vision.Slot;
         At_Time : Time;
         Reserve : Boolean;
      begin
         if Word.Last_Index = 1 then
            Put (Begun + Milliseconds (Now), Slot);
            In_Slot (Slot) := Now;
         else
            Claim_Due (Begun + Milliseconds (Now), Slot, At_Time, Reserve);
            Assert (In_Slot (Slot)'Image & (if Reserve then "+" else "")
                    = " " & Word (2)
                    and then At_Time = Begun + Milliseconds (In_Slot (Slot)),
                    Now'Image & " sends" & In_Slot (Slot)'Image & " "
                    & Reserve'Image & ", not " & Word (2) & " in " & Script);
         end if;
      end Carry_Out;

   begin
      Begin_Anew;
      for Word of Split (Script, ' ') loop
         if Word = "-" then
            Check_None;
         else
            Carry_Out (Split (Word, '>'));
         end if;
      end loop;
   end Play;

   procedure Test_Wait is
      Begun   : constant Time := Clock;
      Slot    : Vision.Slot;
      At_Time : Time;
      Reserve : Boolean;
      Found   : Boolean;

      procedure Begin_Wait (Expected : Boolean) is
         --  Nothing is due; Expected: something is still to come
      begin
         Vision.Frames.Store.Claim_Due
           (Begun, Period, Slot, At_Time, Reserve, Found, Coming);
         Assert (not Found, "nothing is due");
         Assert (Coming = Expected, "coming: " & Coming'Image);
      end Begin_Wait;

   begin
      --  each Wait_Look returns, or the test does not end

      Begin_Anew;
      Vision.Frames.Store.Begin_Delivery (Begun);
      Begin_Wait (Expected => True);
      Put (Begun, Slot);
      Vision.Frames.Wait_Look;
      Claim_Due (Begun, Slot, At_Time, Reserve);

      Begin_Wait (Expected => True);
      Vision.Frames.Look_At_Silence (Begun + Milliseconds (2_000));
      Vision.Frames.Look_At_Silence (Begun + Milliseconds (2_600));
      Vision.Frames.Wait_Look;

      Begin_Wait (Expected => True);
      Vision.Frames.End_Delivery;
      Vision.Frames.Wait_Look;
      Begin_Wait (Expected => False);
   end Test_Wait;

   procedure Test_Times is
      Begun : constant Time := Clock;
      Later : constant Time := Begun + Milliseconds (40);
      Slot  : Vision.Slot;

      procedure Check (From : Time; What : String) is
         --  The time of silence counts from From
         Silent : Boolean;
      begin
         Vision.Frames.Store.Get_Silent
           (From + Schedule.Camera_Silence, Silent);
         Assert (not Silent, What & ": too early");
         Vision.Frames.Store.Get_Silent
           (From + Schedule.Camera_Silence + Milliseconds (1), Silent);
         Assert (Silent, What & ": too late");
      end Check;
   begin
      Begin_Anew;
      Vision.Frames.Store.Begin_Delivery (Begun);
      Check (Begun, "the beginning");
      Put (Later, Slot);
      Check (Later, "the image");
      Vision.Frames.End_Delivery;
      Put (Later + Milliseconds (40), Slot);
      Check (Later, "none that is too late");
   end Test_Times;

begin
   Run_Test ("a delivery that ends drops what waits", Test_End'Access);
   Run_Test ("every slot in its turn", Test_In_Turn'Access);
   Run_Test ("when the last image came", Test_Times'Access);
   Run_Scripts
     (Play'Access,
      "one that waits alone: 0 50>0 -"
      & "|what has just come is kept in reserve: 100 195 200>100+ 300>195 -"
      & "|what has been there for a while is not: 300 380 400>380 -"
      --  of three the oldest is left out in any case
      & "|the second of three: 400 448 499 500>448+ 600>499 -"
      --  the third has just come, but a fourth will come in time
      & "|of a fast source: 499 549 599 600>599 -");
   Run_Test ("who waits for an image is told of what ends it",
             Test_Wait'Access);
   Run_Test ("times between images", Test_Elapsed'Access);
end Frames_Tests;
