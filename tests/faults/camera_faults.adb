--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults of a camera.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Demands;               use Demands;
with Expectations;          use Expectations;
with Faults;                use Faults;
with Instants;              use Instants;
with Plain_Numbers;         use Plain_Numbers;
with Random_Numbers;        use Random_Numbers;
with Tolerances;            use Tolerances;
with Worlds;                use Worlds;

package body Camera_Faults is

   --  The images asked for (Worlds), which every image is made to fit

   Asked_Width  : constant := 320;
   Asked_Height : constant := 240;

   Open_Limit : constant Duration := 5.0;
   --  For a source on the network to be given up

   type Camera_Fault is abstract new Fault with null record;

   overriding procedure Lift (F : in out Camera_Fault; W : in out World);

   --  It opens after some time

   type Opens_Late is new Camera_Fault with record
      After : Positive := 10_000;
      --  milliseconds
      Opens : Boolean := False;
      --  and is waited for so long
   end record;

   overriding procedure Inject (F : in out Opens_Late; W : in out World);

   --  Images of another size, one or many

   type Other_Size is new Camera_Fault with record
      Width, Height : Natural := 0;
      --  0: many at random
      Fit_Width     : Positive := Asked_Width;
      Fit_Height    : Positive := Asked_Height;
      --  what becomes of it
   end record;

   overriding procedure Inject (F : in out Other_Size; W : in out World);

   --  Images at another rate

   type Other_Rate is new Camera_Fault with record
      Rate : Positive := 1;
   end record;

   overriding procedure Inject (F : in out Other_Rate; W : in out World);

   procedure Expect_Robot_Answers (W : in out World) is
      --  In the usual time, during the fault of the camera
   begin
      Expect
        (W, "RPIN", (if W.Robot = Line_Closed then "ANAK" else "AACK"));
   end Expect_Robot_Answers;

   procedure Expect_Fitting (W : in out World) is
      --  The last image fills the size asked for, in one direction at least
      Width, Height : Natural;
   begin
      Get_Image_Size (W, Width, Height);
      Check
        (Width in 1 .. Asked_Width and then Height in 1 .. Asked_Height
         and then (Width = Asked_Width or else Height = Asked_Height),
         "an image of" & Width'Image & " x" & Height'Image);
   end Expect_Fitting;

   procedure Mend (W : in out World) is
      --  The camera works again
   begin
      W.Emulator.Tell ("camera mend");
   end Mend;

   overriding procedure Lift (F : in out Camera_Fault; W : in out World) is
      pragma Unreferenced (F);
   begin
      Mend (W);
   end Lift;

   procedure Prepare_No_Device (P : in out Plan) is
   begin
      P.Camera := To_Unbounded_String ("/dev/no_such_camera");
   end Prepare_No_Device;

   procedure Switch_Off (W : in out World) is
      B : Before;
   begin
      if not W.Alone then
         W.Emulator.Tell ("camera off");
         return;
      end if;
      B := Situation (W);
      W.Emulator.Tell ("camera off");
      if W.Camera > Camera_Closed then
         Expect_Closed (W, B);
      end if;
      for Attempt in 1 .. Whole (W.Source, 1, 5) loop
         Expect (W, "COPN", "ANAK");
         Expect_Robot_Answers (W);
      end loop;
      Expect (W, "CPCO", "ANAK");
      Mend (W);
      Recover_Camera (W);
   end Switch_Off;

   procedure Open_No_Device (W : in out World) is
   begin
      if W.Alone then
         for Attempt in 1 .. Whole (W.Source, 1, 5) loop
            Expect (W, "COPN", "ANAK");
            Expect_Robot_Answers (W);
            Expect (W, "CASA", "ANAK");
         end loop;
      else
         W.Say ("COPN");
      end if;
   end Open_No_Device;

   overriding procedure Inject (F : in out Opens_Late; W : in out World) is
      Opening : constant String := "camera opening " & Image (F.After);
      Seen    : Natural;
      Start   : Instant;
      Number  : Natural;
      Took    : Duration;

      procedure Expect_On_Wire (Command, Text : String) is
         Said : constant Instant := Now;
      begin
         W.Say (Command);
         Check_Within
           (W.Emulator.Await_On_Wire (Text).First
            - Said,
            Prompt + Noise, Command & " on the wire");
      end Expect_On_Wire;

   begin
      if not W.Alone then
         W.Emulator.Tell (Opening);
         W.Say ("CCLS");
         W.Say ("COPN");
         return;
      end if;

      Expect (W, "CCLS", "AACK");
      if not Is_Started (W) then
         Quieten (W);
         Expect (W, "RSOW", "AACK");
      end if;
      W.Expect_Answers;
      W.Emulator.Tell (Opening);
      W.Emulator.Clear_Journal;
      Seen := W.Monitor.Count_Of ("RBLV");
      Number := W.Monitor.Count;
      Start := Now;
      W.Say ("COPN");

      --  Its answer comes first, but neither the robot nor unsolicited
      --  messages wait for it

      delay Span (W.Source, 0.0, 0.3);
      Expect_On_Wire ("RTRN:7", "T=7");
      Expect_On_Wire ("RSTP", "M=0");
      W.Expect_Status ("moving", "0", Within => Noise);
      while Now < Start + 1.0 + Noise
        and then W.Monitor.Count_Of ("RBLV") = Seen
      loop
         delay 0.005;
      end loop;
      Check
        (W.Monitor.Count_Of ("RBLV") > Seen,
         "the battery's level waits for the camera");

      if Chance (W.Source, 3) then
         --  nor does the end of the session, or the next one
         W.Say ("RGFW");
         W.Lose (if Chance (W.Source, 2) then Orderly else Abortive);
         W.Join (Return_Limit + Noise);
         Expect (W, "RPIN", "ANAK");
         Expect (W, "ROPN", "AACK");
         Expect (W, "RSOW", "AACK");
         return;
      end if;

      W.Expect_Answers;
      loop
         Number := Number + 1;
         exit when W.Monitor.Element (Number).Label in "AACK" | "ANAK";
      end loop;
      Took := W.Monitor.Element (Number).Time - Start;
      Check_Within (Took, Open_Limit + Noise, "the answer to COPN");
      if F.Opens then
         Check
           (W.Monitor.Element (Number).Label = "AACK",
            "a camera that opens slowly is given up after "
            & Milliseconds (Took));
         Expect_Images (W, 2);
      end if;
      Expect_Robot_Answers (W);
   end Inject;

   procedure Stall (W : in out World) is
      B : Before;
   begin
      if not W.Alone then
         W.Emulator.Tell ("camera stall");
         return;
      end if;
      B := Situation (W);
      W.Emulator.Tell ("camera stall");
      for Number in 1 .. 3 loop
         Expect_Robot_Answers (W);
         delay Span (W.Source, 0.0, 0.2);
      end loop;
      Expect_Closed (W, B);
      if Chance (W.Source, 4) then
         W.Say ("COPN");
         W.Expect_Answers (Within => Open_Limit + Noise);
         Expect (W, "CPCO", "ANAK");
      end if;
      Mend (W);
      Recover_Camera (W);
   end Stall;

   procedure Deliver_Garbage (W : in out World) is
   begin
      W.Emulator.Tell ("camera garbage");
      if W.Alone then
         for Number in 1 .. 4 loop
            delay Span (W.Source, 0.1, 0.5);
            Expect_Robot_Answers (W);
         end loop;
         Check (W.Monitor.Broken_Images = 0, "a broken image was sent");
         Mend (W);
         Recover_Camera (W);
      end if;
   end Deliver_Garbage;

   overriding procedure Inject (F : in out Other_Size; W : in out World) is
      Widest  : constant := 1_600;
      Highest : constant := 1_200;
      B       : Before;
      Width   : Natural;
      Height  : Natural;

      procedure Ask_For (Width, Height : Positive) is
      begin
         W.Emulator.Tell
           ("camera size " & Image (Width) & "x" & Image (Height));
      end Ask_For;

   begin
      if W.Alone then
         B := Situation (W);
      end if;
      if F.Width > 0 then
         Ask_For (F.Width, F.Height);
         if W.Alone then
            --  in mid-stream the images are made to fit, one way or another
            Expect_Images (W, 3);
            Expect_Fitting (W);
            Expect_Robot_Answers (W);
            Expect_Open (W, B);

            --  from the beginning their proportions are kept
            Expect (W, "CCLS", "AACK");
            W.Order ("COPN", "AACK");
            Expect_Images (W, 1);
            Get_Image_Size (W, Width, Height);
            Check
              (Width = F.Fit_Width and then Height = F.Fit_Height,
               "images of" & Width'Image & " x" & Height'Image
               & " instead of" & F.Fit_Width'Image & " x"
               & F.Fit_Height'Image);
            Mend (W);
            Expect_Images (W, 3);
            Expect_Fitting (W);
         end if;
      else
         for Number in 1 .. Whole (W.Source, 4, 10) loop
            Ask_For
              (Whole (W.Source, 1, Widest), Whole (W.Source, 1, Highest));
            delay Span (W.Source, 0.02, 0.25);
         end loop;
         if W.Alone then
            Expect_Images (W, 2);
            Expect_Fitting (W);
            Expect_Robot_Answers (W);
            Mend (W);
            Expect_Images (W, 3);
            Expect_Fitting (W);
            Expect_Open (W, B);
         end if;
      end if;
   end Inject;

   overriding procedure Inject (F : in out Other_Rate; W : in out World) is
      Sent     : constant Positive := 10;
      --  images a second, at most
      Watched  : constant Duration := 1.0;
      Slow_For : constant Duration := 2.5;
      B        : Before;
      Seen     : Natural;
   begin
      if W.Alone then
         B := Situation (W);
      end if;
      W.Emulator.Tell ("camera fps " & Image (F.Rate));
      if not W.Alone then
         return;
      end if;
      if F.Rate < Sent then
         --  fewer, but it is no failure
         delay Slow_For;
         Expect_Images (W, 1);
      else
         Expect_Images (W, 1);
         Seen := W.Monitor.Count_Of ("CIMG");
         delay Watched;
         Seen := W.Monitor.Count_Of ("CIMG") - Seen;
         Check
           (Seen in 2 .. Sent + 2,
            Seen'Image & " images a second");
      end if;
      Expect_Robot_Answers (W);
      Expect_Open (W, B);
      Mend (W);
      Expect_Images (W, 2);
   end Inject;

   procedure Register is
   begin
      Add (Faults.Camera, "camera cannot be opened",
           Switch_Off'Access, Mend'Access);
      Add (Faults.Camera, "no such camera",
           Open_No_Device'Access, Mend'Access, Prepare_No_Device'Access,
           Camera => No_Camera);
      Add (Faults.Camera, "camera stops delivering",
           Stall'Access, Mend'Access, Cost => 4.0, Camera => Camera_Streaming);
      Add (Faults.Camera, "camera delivers garbage",
           Deliver_Garbage'Access, Mend'Access,
           Cost => 2.5, Camera => Camera_Streaming);
      Add (Faults.Camera, "images change their size", new Other_Size,
           Cost => 2.5, Camera => Camera_Streaming);
      Add (Faults.Camera, "images of 1x1",
           new Other_Size'(Width      => 1,
                           Height     => 1,
                           Fit_Width  => Asked_Height,
                           Fit_Height => Asked_Height,
                           others     => <>),
           Camera => Camera_Streaming);
      Add (Faults.Camera, "images of 3840x2160",
           new Other_Size'(Width      => 3_840,
                           Height     => 2_160,
                           Fit_Width  => Asked_Width,
                           Fit_Height => 180,
                           others     => <>),
           Cost => 3.0, Camera => Camera_Streaming, Heavy => True);
      Add (Faults.Camera, "camera slower than asked",
           new Other_Rate'(Rate => 1, others => <>), Cost => 3.5,
           Camera => Camera_Streaming);
      Add (Faults.Camera, "camera faster than asked",
           new Other_Rate'(Rate => 100, others => <>), Cost => 2.0,
           Camera => Camera_Streaming);
      Add (Faults.Camera, "camera opens only after 10 s",
           new Opens_Late, Cost => 4.0, Ends => Session_May_End);
      Add (Faults.Camera, "camera opens only after 2 s",
           new Opens_Late'(After => 2_000, Opens => True, others => <>),
           Cost => 3.0, Ends => Session_May_End);
   end Register;

end Camera_Faults;
