--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults of the robot and its line.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Demands;               use Demands;
with Faults;                use Faults;
with Plain_Numbers;         use Plain_Numbers;
with Random_Numbers;        use Random_Numbers;
with Tolerances;            use Tolerances;
with Worlds;                use Worlds;

package body Robot_Faults is

   Enough_To_Lose : constant := 4;
   --  F8: failures in a row

   Start_Up : constant Duration := 0.25;
   --  Of a robot that needs 100 ms (Emulators), by a tick of 100 ms

   --  Questions to a robot that is idle, and their answers. RLDW is one
   --  that it refuses then.

   subtype Question is Positive range 1 .. 4;

   subtype Word is String (1 .. 4);

   Questions : constant array (Question) of Word :=
     ("RPIN", "RGBT", "RGST", "RLDW");

   function Right_Answer (Q : Question) return String is
     (case Q is
         when 1 => "AACK",
         when 2 => "RBLV:2",
         when 3 => "RCST:0",
         when 4 => "ACRJ");

   function Any_Question (W : in out World) return Question is
     (Whole (W.Source, Question'First, Question'Last));

   procedure Expect_Right (W : in out World) is
      --  One of them is answered correctly
      Q : constant Question := Any_Question (W);
   begin
      Expect (W, Questions (Q), Right_Answer (Q));
   end Expect_Right;

   procedure Expect_Nothing (W : in out World; Q : Question) is
      --  It has no valid answer
   begin
      Expect (W, Questions (Q), "ATIM");
   end Expect_Nothing;

   type Robot_Fault is abstract new Fault with null record;

   overriding procedure Lift (F : in out Robot_Fault; W : in out World);
   --  The robot answers correctly again

   --  A socket cannot be hung up, and takes no noise while it is closed

   type Terminal_Fault is abstract new Robot_Fault with null record;

   overriding procedure Prepare (F : Terminal_Fault; P : in out Plan);

   --  Corrupted answers, a few or many

   type Spoiling is (Dropped, Flipped, Cut, Wrong_Kind, Garbage);

   type Spoilt_Answers is new Robot_Fault with record
      How : Spoiling := Dropped;
   end record;

   overriding procedure Inject
     (F : in out Spoilt_Answers; W : in out World);

   --  All answers late, or none, or one without end

   type No_Answers is new Robot_Fault with record
      Command : Unbounded_String;
      --  to the emulator
      Mended  : Unbounded_String;
      --  and what ends it
      Late_By : Duration := 0.0;
   end record;

   overriding procedure Inject (F : in out No_Answers; W : in out World);

   --  Answers held back, and sent together

   type Pile is new Robot_Fault with null record;

   overriding procedure Inject (F : in out Pile; W : in out World);

   --  Unsolicited answers

   type Unasked is new Terminal_Fault with null record;

   overriding procedure Inject (F : in out Unasked; W : in out World);

   --  The adapter is pulled out and put back

   type Unplugged is new Terminal_Fault with record
      Away : Boolean := False;
   end record;

   overriding procedure Inject (F : in out Unplugged; W : in out World);
   overriding procedure Lift (F : in out Unplugged; W : in out World);

   --  The line is a pair of radios

   type By_Radio is new Robot_Fault with record
      Command : Unbounded_String;
      --  to the emulator
      Loses   : Boolean := False;
      --  packets, which may be those of a stop
   end record;

   overriding procedure Prepare (F : By_Radio; P : in out Plan);
   overriding procedure Inject (F : in out By_Radio; W : in out World);

   --  The robot is stopped and accepts nothing any more

   type Reason is (Disabled, Switched_Off_And_On, Empty, Charging);

   type Robot_Stops is new Robot_Fault with record
      Why : Reason := Disabled;
   end record;

   overriding procedure Inject (F : in out Robot_Stops; W : in out World);
   overriding procedure Lift (F : in out Robot_Stops; W : in out World);

   overriding procedure Lift (F : in out Robot_Fault; W : in out World) is
      pragma Unreferenced (F);
   begin
      W.Emulator.Tell ("mend");
   end Lift;

   procedure Spoil
     (F : Spoilt_Answers'Class; W : in out World; Count : Positive)
   is
      --  The next Count answers
      Bits : constant := 40;
      --  Of the longest answer, the version
      Keep : constant := 4;
   begin
      W.Emulator.Tell
        ((case F.How is
             when Dropped    => "drop " & Image (Count),
             when Garbage    => "garbage " & Image (Count),
             when Wrong_Kind => "wrong " & Image (Count),
             when Flipped    =>
               "flip " & Image (Count) & " "
               & Image (Whole (W.Source, 0, Bits - 1)),
             when Cut        =>
               "truncate " & Image (Count) & " "
               & Image (Whole (W.Source, 0, Keep))));
   end Spoil;

   procedure In_Quiet (F : Spoilt_Answers'Class; W : in out World) is
      --  Every answer reported is a possible answer to the command
      Few   : constant := Enough_To_Lose - 1;
      Bits  : constant := 24;
      Kinds : constant := 3;
      Q     : Question;
      Count : Positive;
   begin
      Quieten (W);

      if F.How = Flipped then
         --  every bit of the answer to one question
         Q := Any_Question (W);
         for Bit in 0 .. Bits - 1 loop
            W.Emulator.Tell ("flip 1 " & Image (Bit));
            Expect_Nothing (W, Q);
            Expect_Right (W);
         end loop;
      end if;

      if F.How = Wrong_Kind then
         --  every other kind for each: some answers to a battery request
         --  cannot be distinguished from a level of 0
         for Any of Questions loop
            for Kind in 1 .. Kinds loop
               W.Emulator.Tell ("wrong 1");
               Expect
                 (W, Any, (if Any = "RGBT" then "ATIM RBLV:0" else "ATIM"));
               Expect_Right (W);
            end loop;
         end loop;
      end if;

      --  the answers to the probes that follow, too

      for Round in 1 .. 4 loop
         Count := Whole (W.Source, 1, Few);
         Spoil (F, W, Count);
         for Number in 1 .. Count loop
            Q := Any_Question (W);
            if F.How = Wrong_Kind then
               --  a false level of 0 cannot be detected, and with it the line
               --  seems to be synchronised
               Expect
                 (W, Questions (Q),
                  "ATIM " & (if Q = 2 then "RBLV:0 " else "")
                  & (if Number > 1 then Right_Answer (Q) else ""));
            else
               Expect_Nothing (W, Q);
            end if;
         end loop;
         W.Emulator.Tell ("mend");
         Expect_Right (W);
         Expect_Right (W);
      end loop;

      if F.How /= Wrong_Kind and then Chance (W.Source, 2) then
         declare
            B : constant Before := Situation (W);
         begin
            Spoil (F, W, Enough_To_Lose);
            for Number in 1 .. Enough_To_Lose - 1 loop
               Expect_Nothing (W, Any_Question (W));
            end loop;
            Expect_No_Loss (W, B);
            Expect_Nothing (W, Any_Question (W));
            W.Expect_Log
              ("robot lost", Within => Noise, After => B.Log);
            Await_Unasked (W);
            Expect (W, "RPIN", "ANAK");
            W.Emulator.Tell ("mend");
            Expect_Return (W);
         end;
      end if;
   end In_Quiet;

   procedure In_Motion (F : Spoilt_Answers'Class; W : in out World) is
      Few : constant Positive := Whole (W.Source, 1, Enough_To_Lose - 1);
      B   : Before := Situation (W);
   begin
      Spoil (F, W, Few);
      W.Talk (Span (W.Source, 0.4, 0.8), Calm => True);
      W.Expect_Answers;
      Expect_No_Loss (W, B);
      W.Emulator.Tell ("mend");
      Expect_Truth (W);

      if F.How /= Wrong_Kind and then Chance (W.Source, 2) then
         B := Situation (W);
         Spoil (F, W, 2 * Enough_To_Lose);
         Expect_Loss (W, B);
         W.Emulator.Tell ("mend");
         Expect_Return (W);
      end if;
   end In_Motion;

   overriding procedure Inject
     (F : in out Spoilt_Answers; W : in out World) is
   begin
      if not W.Alone then
         Spoil (F, W, Whole (W.Source, 1, 2 * Enough_To_Lose));
      elsif Is_Started (W) and then not Chance (W.Source, 3) then
         In_Motion (F, W);
      else
         In_Quiet (F, W);
      end if;
   end Inject;

   overriding procedure Inject (F : in out No_Answers; W : in out World) is
      Command : constant String := To_String (F.Command);
      Mended  : constant String := To_String (F.Mended);
      B       : Before;
      Q       : Question;
   begin
      if not W.Alone then
         W.Emulator.Tell (Command);
      elsif Is_Started (W) and then not Chance (W.Source, 3) then
         B := Situation (W);
         W.Emulator.Tell (Command);
         Expect_Loss (W, B);
         W.Emulator.Tell (Mended);
         Expect (W, "ROPN", "AACK");

         --  late answers may disturb the first exchanges

         delay F.Late_By;
         Expect_Return (W);
         Expect_Truth (W);
      else
         Quieten (W);
         for Round in 1 .. 3 loop
            B := Situation (W);
            W.Emulator.Tell (Command);
            for Number in 1 .. Whole
              (W.Source, 1,
               (if F.Late_By = 0.0 then Enough_To_Lose - 1 else 2))
            loop
               Expect_Nothing (W, Any_Question (W));
            end loop;
            W.Emulator.Tell (Mended);

            --  Late answers arrive while others are awaited, and delay these.
            --  They are never taken for them.

            if F.Late_By > 0.0 then
               delay Span (W.Source, 0.0, F.Late_By);
               for Number in 1 .. 2 loop
                  Q := Any_Question (W);
                  Expect (W, Questions (Q), Right_Answer (Q) & " ATIM");
               end loop;
            end if;
            for Number in 1 .. 3 loop
               Expect_Right (W);
            end loop;
            Expect_No_Loss (W, B);
         end loop;
      end if;
   end Inject;

   overriding procedure Inject (F : in out Pile; W : in out World) is
      pragma Unreferenced (F);
      Highest : constant := 8;
      Count   : Positive := Whole (W.Source, 2, Highest);
      B       : Before;
   begin
      if not W.Alone then
         W.Emulator.Tell ("pile " & Image (Count));
      elsif Is_Started (W) and then not Chance (W.Source, 3) then
         B := Situation (W);
         W.Emulator.Tell ("pile " & Image (Count));
         if Count > Enough_To_Lose then
            Expect_Loss (W, B);
            W.Emulator.Tell ("mend");
            Expect_Return (W);
         else
            W.Talk (Span (W.Source, 0.5, 0.8), Calm => True);
            W.Expect_Answers;
            Expect_No_Loss (W, B);
            Expect_Truth (W);
         end if;
      else
         Quieten (W);
         for Round in 1 .. 3 loop
            B := Situation (W);
            Count := Whole (W.Source, 2, Enough_To_Lose);
            W.Emulator.Tell ("pile " & Image (Count));
            for Number in 1 .. Count - 1 loop
               Expect_Nothing (W, Any_Question (W));
            end loop;

            --  with the next one all of them come

            for Number in 1 .. 3 loop
               Expect_Right (W);
            end loop;
            Expect_No_Loss (W, B);
         end loop;
      end if;
   end Inject;

   overriding procedure Prepare (F : Terminal_Fault; P : in out Plan) is
      pragma Unreferenced (F);
   begin
      P.Terminal := True;
   end Prepare;

   overriding procedure Inject (F : in out Unasked; W : in out World) is
      pragma Unreferenced (F);

      Frames : constant Arguments := Words
        ("OO\r EE\r CC\r 00\r 11\r 22\r 3.5(\r \r \r\r\r OO O\r OO\rOO\r"
         & " OX\r \x00\x00\x00 \xFF\xFF\r M=0\x41\r w\x77\r");

      Longest : constant := 60;

      function Noise_Text return String is
         --  Bytes at random
         Digit  : constant String := "0123456789ABCDEF";
         Result : Unbounded_String;
      begin
         for Number in 1 .. Whole (W.Source, 1, Longest) loop
            Append (Result, "\x"
                    & Digit (Whole (W.Source, 1, 16))
                    & Digit (Whole (W.Source, 1, 16)));
         end loop;
         return To_String (Result);
      end Noise_Text;

   begin
      for Number in 1 .. Whole (W.Source, 5, 30) loop
         --  through an adapter that is not there nothing comes
         exit when not W.Line_Works;
         W.Emulator.Tell
           ("unasked "
            & (if Chance (W.Source, 4) then Noise_Text
               else Frames.Element
                 (Whole (W.Source, 1, Natural (Frames.Length)))));
         W.Talk (Span (W.Source, 0.0, 0.06), Calm => True);
      end loop;
      if W.Alone then
         --  a stop among them must be effective, whatever the answers
         W.Expect_Answers;
         W.Say ("RSTP");
         W.Expect_Answers;
         W.Expect_Status
           ("moving", "0", Within => Prompt + Stop_Limit + Noise);

         --  and after them the line must work again
         delay 0.1;
         Expect (W, "RCLS", "AACK");
         Expect_Return (W);
         Expect_Truth (W);
      end if;
   end Inject;

   overriding procedure Inject (F : in out Unplugged; W : in out World) is
      procedure Put_Back is
      begin
         W.Emulator.Tell ("return");
         F.Away := False;
      end Put_Back;

      Soon : constant Boolean := Chance (W.Source, 3);
      B    : Before;
   begin
      if W.Alone then
         B := Situation (W);
      end if;
      W.Line_Works := False;
      W.Emulator.Tell ("hangup");
      F.Away := True;
      if not W.Alone then
         return;
      end if;

      if Soon then
         --  back before it is detected
         delay Span (W.Source, 0.0, 0.06);
         Put_Back;
      end if;
      if Is_Started (W) then
         Expect_Loss (W, B);
      elsif W.Robot = Line_Open then
         for Number in 1 .. Enough_To_Lose loop
            Expect (W, "RPIN", "ATIM");
         end loop;
         Expect (W, "RPIN", "ANAK");
         W.Expect_Log
           ("robot lost", Within => Noise, After => B.Log);
      end if;
      if not Soon then
         Expect (W, "ROPN", "ANAK");
         delay Span (W.Source, 0.0, 0.5);
         Expect (W, "RPIN", "ANAK");
         Put_Back;
      end if;
      Expect_Return (W);
      W.Line_Works := True;
      Expect_Truth (W);
   end Inject;

   overriding procedure Prepare (F : By_Radio; P : in out Plan) is
      pragma Unreferenced (F);
   begin
      P.Emulator_Options := To_Unbounded_String ("--radio");
      P.Options := To_Unbounded_String ("--answer-timeout 150");
   end Prepare;

   overriding procedure Inject (F : in out By_Radio; W : in out World) is
      Last_Failure : constant Duration := 0.5;
      --  With its probe
   begin
      W.Emulator.Tell (To_String (F.Command));
      if W.Alone then
         W.Talk (Span (W.Source, 1.0, 3.0), Calm => True);
         W.Expect_Answers;
         W.Emulator.Tell ("mend");
         delay Last_Failure;
         W.Listen;
         Expect (W, "ROPN", "AACK");
         Expect_Truth (W);
      else
         W.Line_Works := W.Line_Works and then not F.Loses;
      end if;
   end Inject;

   overriding procedure Inject (F : in out Robot_Stops; W : in out World) is
      B        : Before;
      Watchdog : Boolean;
   begin
      if not W.Alone then
         W.Emulator.Tell
           ((case F.Why is
                when Disabled            => "starve",
                when Switched_Off_And_On => "reset-robot",
                when Empty               => "battery critical",
                when Charging            => "charge on"));
         if F.Why = Switched_Off_And_On then
            delay Start_Up;
         end if;
         W.Robot_Ready := W.Robot_Ready and then F.Why /= Empty;
         return;
      end if;

      if F.Why in Disabled | Empty or else Chance (W.Source, 2) then
         Start_With_Watchdog (W);
      end if;
      Watchdog := W.Robot in Started_With_Watchdog | Moving_With_Watchdog;
      B := Situation (W);
      case F.Why is
         when Disabled =>
            W.Emulator.Tell ("starve");
            W.Expect_Status
              ("state", "watchdog_disabled", Within => Noise);
         when Switched_Off_And_On =>
            W.Emulator.Tell ("reset-robot");
            W.Emulator.Await_Status ("state", "idle");
         when Empty =>
            W.Emulator.Tell ("battery 0");
            Expect (W, "RGBT", "RBLV:0");
            W.Robot_Ready := False;
            B := Situation (W);
            W.Emulator.Tell ("battery critical");
            Expect_Loss (W, B);
            W.Expect_Log
              ("its battery was empty", Within => Noise, After => B.Log);
            W.Robot := Line_Closed;
            if Chance (W.Source, 4) then
               --  at last it switches itself off
               W.Expect_Status ("state", "off", Within => 6.0);
            end if;
            return;
         when Charging =>
            W.Emulator.Tell ("charge on");
            W.Expect_Status
              ("state", "in_charge", Within => Noise);
      end case;

      if Watchdog then
         Expect_Not_Running (W, B);
      elsif W.Robot = Line_Closed then
         Expect (W, "ROPN", "AACK");
         W.Robot := Line_Open;
      end if;
      Expect_Truth (W);
      Expect (W, "RGFW", "ACRJ");

      if F.Why = Charging then
         Expect (W, "RRST", "ACRJ AACK");
         Expect (W, "RSOW", "ACRJ");
      else
         Expect (W, "RRST", "AACK");
         Expect (W, "RSWW", "AACK");
         Expect (W, "RGFW", "AACK");
         W.Expect_Status ("moving", "1", Within => Noise);
      end if;
   end Inject;

   overriding procedure Lift (F : in out Unplugged; W : in out World) is
   begin
      if F.Away then
         F.Away := False;
         W.Emulator.Tell ("return");
      end if;
   end Lift;

   overriding procedure Lift (F : in out Robot_Stops; W : in out World) is
   begin
      case F.Why is
         when Disabled | Switched_Off_And_On =>
            null;
         when Empty =>
            W.Emulator.Tell ("battery 2");
         when Charging =>
            W.Emulator.Tell ("charge off");
      end case;
   end Lift;

   procedure Register is

      procedure Add_Radio (Name, Command : String; Loses : Boolean := False)
      is
      begin
         Add (Robot, "by radio" & Name,
              new By_Radio'(Command => To_Unbounded_String (Command),
                            Loses   => Loses,
                            others  => <>),
              Cost => 3.0);
      end Add_Radio;

      procedure Add_Spoilt (Name : String; How : Spoiling; Cost : Duration)
      is
      begin
         Add (Robot, Name, new Spoilt_Answers'(How => How, others => <>),
              Cost);
      end Add_Spoilt;

      procedure Add_Silence
        (Name, Command, Mended : String; Late_By : Duration := 0.0) is
      begin
         Add (Robot, Name,
              new No_Answers'(Command => To_Unbounded_String (Command),
                              Mended  => To_Unbounded_String (Mended),
                              Late_By => Late_By,
                              others  => <>));
      end Add_Silence;

      procedure Add_Stop (Name : String; Why : Reason; Cost : Duration) is
      begin
         Add (Robot, Name, new Robot_Stops'(Why => Why, others => <>), Cost);
      end Add_Stop;

   begin
      Add_Silence ("robot silent", "silent on", "silent off");
      Add_Silence ("answers 90 ms late", "delay 90", "delay 0", 0.1);
      Add_Silence ("answers 200 ms late", "delay 200", "delay 0", 0.25);
      Add (Robot, "answers come together", new Pile);
      Add_Spoilt ("answers lost", Dropped, 2.0);
      Add_Spoilt ("each bit of an answer flipped", Flipped, 3.0);
      Add_Spoilt ("answers cut short", Cut, 2.0);
      Add_Spoilt ("random bytes for answers", Garbage, 1.5);
      Add_Silence ("answer without an end", "endless on", "endless off");
      Add (Robot, "answers nobody asked for", new Unasked, Cost => 2.0);
      Add_Spoilt ("answers of another kind", Wrong_Kind, 2.0);
      Add (Robot, "device pulled and put back", new Unplugged, Cost => 1.5);
      Add_Stop ("robot disabled by its watchdog", Disabled, 2.0);
      Add_Stop
        ("robot reset by its watchdog", Switched_Off_And_On, 2.0);
      Add_Stop ("robot's battery empty", Empty, 2.5);
      Add_Stop ("robot charging", Charging, 2.0);
      Add_Radio ("", "mend");
      Add_Radio (", retries in bursts", "radio-bursts 5");
      Add_Radio (", packets lost", "radio-losses 5", Loses => True);
   end Register;

end Robot_Faults;
