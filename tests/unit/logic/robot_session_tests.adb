--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: the steps of every request, step by step.

with Commands;         use Commands;
with Robot.Health;
with Robot.Protocol;
with Robot.Session;    use Robot.Session;
with Unit_Runs; use Unit_Runs;

procedure Robot_Session_Tests is

   package Wire renames Robot.Protocol;

   use type Wire.Command;
   use type Wire.Command_Kind;

   Driving : constant Movement := (Turn, 90);

   function Opened (Mode : Mode_Kind) return State is
     ((Line_Open => True, Mode => Mode, Health => Robot.Health.Initial,
       others => <>));

   function Mark (C : Wire.Command) return Character is
     (if C = Wire.Stop then '.' else Wire.Letter (C.Kind));

   function Mark (Next : Step) return String is
     (case Next.Kind is
         when Open_Device  => "O",
         when Close_Device => "C",
         when Send         => "!" & Mark (Next.Command),
         when Exchange     => (1 => Mark (Next.Command)),
         when Synchronise  => "~" & Mark (Next.Command),
         when Finish       => "");
   --  A step in a trace: a command's letter, a full stop for a stop.

   type History is record
      Before  : State;
      Request : Commands.Request;
      Stopped : Boolean := False;  --  a stop has been sent
      Closed  : Boolean := False;
   end record;

   Visited : Natural := 0;

   function Answer (C : Wire.Command; How : Character) return Step_Result is
     ((Ok    => How /= '-',
       Reply =>
         (case How is
             when '-'        => (others => <>),
             when 'E'        => (Wire.Refused, 0),
             when '0' .. '2' =>
               (Wire.Digit_Kind (C.Kind),
                Character'Pos (How) - Character'Pos ('0')),
             when others     =>
               (case C.Kind is
                   when Wire.Battery        => (Wire.Level, 0),
                   when Wire.Busy           => (Wire.Moving_State, 0),
                   when Wire.Version        => (Wire.Version_Text, 0),
                   when Wire.Unknown_Letter => (Wire.Unknown_Command, 0),
                   when others              => (Wire.Done, 0))),
       Text  =>
         (Length => 1,
          Data   => (1 => How, 2 .. Answer_Length'Last => ' '))));
   --  How the robot answers C: '-' not at all, 'E' it refuses, '+' it
   --  accepts, or a digit.

   type Ending is record
      Kind  : Outcome_Kind;
      Value : Natural;  --  the digit in the outcome's text
      Note  : Note_Kind;
   end record;

   Success : constant Ending := (Done, 0, Nothing);
   Refusal : constant Ending := (Refused, 0, Nothing);
   Silence : constant Ending := (Timed_Out, 0, Nothing);

   procedure Carry_Out
     (S       : in out State;
      Kind    : Request_Kind;
      Answers : String;
      Trace   : String;
      Kept    : Ending)
   is
      --  A request, whose exchanges and openings are answered so, or else
      --  accepted: it makes the steps of Trace and ends as Kept says.
      Label : constant String := Kind'Image & " " & Answers & ": ";
      Made  : String (1 .. 100) := (others => ' ');
      Last  : Natural := 0;
      Used  : Natural := 0;
      P     : Progress;
      Next  : Step;

      procedure Get (How : out Character) is
         --  The next of the answers.
      begin
         Used := Used + 1;
         How := (if Used <= Answers'Length
                 then Answers (Answers'First + Used - 1) else '+');
      end Get;

      How   : Character;
   begin
      Start_Request (S, (Kind, Driving), P);
      loop
         Next := Next_Step (S, P);
         exit when Next.Kind = Finish;
         declare
            M : constant String := Mark (Next);
         begin
            Made (Last + 1 .. Last + M'Length) := M;
            Last := Last + M'Length;
         end;
         case Next.Kind is
            when Send | Close_Device | Finish =>
               Continue_Request (S, P, (Ok => False, others => <>));
            when Open_Device =>
               Get (How);
               Continue_Request (S, P, (How = '+', others => <>));
            when Exchange | Synchronise =>
               Get (How);
               Continue_Request (S, P, Answer (Next.Command, How));
         end case;
      end loop;
      Assert (Made (1 .. Last) = Trace,
              Label & "steps " & Made (1 .. Last) & ", not " & Trace);
      Assert (Used >= Answers'Length, Label & "all answers were wanted");
      Assert (P.Result.Kind = Kept.Kind
              and then P.Result.Note = Kept.Note
              and then
                (if Kind in Get_Battery | Get_Moving and then Kept.Kind = Done
                 then P.Result.Text.Data (1 .. 1)
                   = Kept.Value'Image (2 .. 2)),
              Label & "outcome " & P.Result.Kind'Image
              & P.Result.Text.Data (1) & " " & P.Result.Note'Image);
      Assert (Is_Consistent (S), Label & "consistent");
   end Carry_Out;

   procedure Check
     (Mode    : Mode_Kind;
      Kind    : Request_Kind;
      Answers : String;
      Trace   : String;
      Kept    : Ending;
      After   : Mode_Kind)
   is
      --  The same, from an open line in step, and the line stays open.
      S : State := Opened (Mode);
   begin
      Carry_Out (S, Kind, Answers, Trace, Kept);
      Assert (S.Line_Open, Kind'Image & ": the line stays open");
      Assert (S.Mode = After,
              Kind'Image & ": " & Mode'Image & " to " & S.Mode'Image);
   end Check;

   procedure Explore (H : History; S : State; P : Progress) is
      --  Every answer to the next step, and to all that follows: what the
      --  contracts leave open
      Next : constant Step := Next_Step (S, P);
      Now  : History := H;

      procedure Follow (Last : Step_Result) is
         --  Next has given Last.
         S_Now : State    := S;
         P_Now : Progress := P;
      begin
         Continue_Request (S_Now, P_Now, Last);
         Explore (Now, S_Now, P_Now);
      end Follow;

   begin
      Visited := Visited + 1;
      if Next.Kind = Finish then
         Assert ((if P.Result.Note = Robot_Lost
                  then H.Stopped and then H.Closed),
                 "lost: stopped and closed");
         Assert (S.Line_Open =
                   (not H.Closed
                    and then (H.Before.Line_Open
                              or else (H.Request.Kind = Open_Line
                                       and then P.Result.Kind = Done))),
                 "the line is closed by a close only");
         return;
      end if;

      Now.Stopped := H.Stopped or else Sends_Stop (Next);
      case Next.Kind is
         when Open_Device =>
            Follow ((True, others => <>));
            Follow ((False, others => <>));
         when Close_Device =>
            Assert (Now.Stopped or else H.Before.Mode = Not_Started,
                    "stopped before the device is closed");
            Now.Closed := True;
            Follow ((True, others => <>));
         when Send =>
            Follow ((True, others => <>));
         when Exchange =>
            for How of String'("-E+") loop
               Follow (Answer (Next.Command, How));
            end loop;
            if Next.Command.Kind in Wire.Battery | Wire.Busy then
               Follow (Answer (Next.Command, '1'));
            end if;
         when Synchronise =>
            for How of String'("-+") loop
               Follow (Answer (Next.Command, How));
            end loop;
         when Finish =>
            null;
      end case;
   end Explore;

   procedure Test_Close is
      S : State := Opened (Not_Started);
   begin
      Carry_Out (S, Close_Line, "", "C", Success);
      Assert (not S.Line_Open, "closed");
      for Mode in Started .. Started_With_Watchdog loop
         S := Opened (Mode);
         Carry_Out (S, Close_Line, "+", ".C", Success);
         Assert (not S.Line_Open and then S.Mode = Not_Started, "closed");
         S := Opened (Mode);
         Carry_Out (S, Close_Line, "E", ".C", Success);
         Assert (not S.Line_Open and then S.Mode = Not_Started,
                 "closed, though the stop was refused");
      end loop;
   end Test_Close;

   procedure Test_Closed is
      S : State;
   begin
      for Kind in Request_Kind range Close_Line .. Keep_Alive loop
         Carry_Out (S, Kind, "", "",
                    ((if Kind = Close_Line then Done else Not_Open),
                     0, Nothing));
         Assert (not S.Line_Open, "stays closed");
      end loop;
   end Test_Closed;

   procedure Test_Drive is
   begin
      Check (Not_Started, Drive, "", "", Refusal, Not_Started);
      for Mode in Started .. Started_With_Watchdog loop
         Check (Mode, Drive, "+", "T", Success, Mode);
         Check (Mode, Drive, "E+", "T.", Refusal, Mode);
         Check (Mode, Drive, "EE", "T.", (Refused, 0, Not_Running),
                Not_Started);
         Check (Mode, Drive, "E-", "T.", Silence, Mode);
         Check (Mode, Drive, "-", "T", Silence, Mode);
      end loop;
   end Test_Drive;

   procedure Test_Everything is

      procedure Explore_From (S : State; R : Request) is
         --  All that can come of R.
         P : Progress;
      begin
         Start_Request (S, R, P);
         Explore ((Before => S, Request => R, others => <>), S, P);
      end Explore_From;

      S : State;
   begin
      Visited := 0;
      for Kind in Request_Kind loop
         Explore_From ((others => <>), (Kind, Driving));
         for Mode in Mode_Kind loop
            S := Opened (Mode);
            Explore_From (S, (Kind, Driving));
            Explore_From (S, (Kind, Forward));
            for First in Wire.Command_Kind loop
               S := Opened (Mode);
               S.Health := Robot.Health.After_Failure (S.Health, First);
               Explore_From (S, (Kind, Driving));
               for Probes in 1 .. 2 loop
                  S.Health := Robot.Health.After_Failure
                    (S.Health, Robot.Health.Probe (S.Health));
                  Explore_From (S, (Kind, Driving));
               end loop;
            end loop;
         end loop;
      end loop;
      Assert (Visited > 5_000, "steps visited:" & Visited'Image);
   end Test_Everything;

   procedure Test_Keep_Alive is
   begin
      for Mode in Mode_Kind loop
         Check (Mode, Keep_Alive, "+", "p", Success, Mode);
         Check (Mode, Keep_Alive, "-", "p", Silence, Mode);
      end loop;
   end Test_Keep_Alive;

   procedure Test_Leaving is
   begin
      Check (Not_Started, Reset, "+", "r", Success, Not_Started);
      Check (Not_Started, Power_Off, "+", "z", Success, Not_Started);
      for Mode in Started .. Started_With_Watchdog loop
         Check (Mode, Reset, "++", ".r", Success, Not_Started);
         Check (Mode, Reset, "E+", ".r", Success, Not_Started);
         Check (Mode, Reset, "+E", ".r", Refusal, Not_Started);
         Check (Mode, Reset, "+-", ".r", Silence, Mode);
         Check (Mode, Power_Off, "++", ".z", Success, Not_Started);
         Check (Mode, Power_Off, "+E", ".z", Refusal, Mode);

         --  Its answer is cut off: does the robot still answer?

         Check (Mode, Power_Off, "+--", ".z~V", Success, Not_Started);
         Check (Mode, Power_Off, "+-++", ".z~Vz", Success, Not_Started);
         Check (Mode, Power_Off, "+-+-", ".z~Vz", Silence, Mode);
      end loop;
   end Test_Leaving;

   procedure Test_Leaving_Unanswered is
      S : State;
   begin
      for Mode in Started .. Started_With_Watchdog loop
         Check (Mode, Reset, "-+++", ".!.~V.r", Success, Not_Started);
         Check (Mode, Power_Off, "--++", ".!.~V~v.z", Success, Not_Started);

         --  The probes are answered, the stops never

         Check (Mode, Reset, "-+-+-+-", ".!.~V.~V.~V.~Vr",
                Success, Not_Started);

         --  Nothing is answered: the robot is lost on the way out

         for Kind in Request_Kind loop
            if Kind in Close_Line | Reset | Power_Off then
               S := Opened (Mode);
               Carry_Out (S, Kind, "----", ".!.~V~v~?!.C",
                          (Timed_Out, 0, Robot_Lost));
               Assert (S = State'(others => <>), "closed");
            end if;
         end loop;
      end loop;
   end Test_Leaving_Unanswered;

   procedure Test_Lost is
      S : State;
   begin
      for Mode in Mode_Kind loop
         S := Opened (Mode);
         Carry_Out (S, Ping, "-", "p", Silence);
         Carry_Out (S, Ping, "-", "~V", Silence);
         Carry_Out (S, Ping, "-", "~v", Silence);
         Assert (S.Line_Open and then S.Mode = Mode, "not at the third");
         Carry_Out (S, Ping, "-", "~?!.C", (Timed_Out, 0, Robot_Lost));
         Assert (S = State'(others => <>), "at the fourth");
         Carry_Out (S, Ping, "", "", (Not_Open, 0, Nothing));
         Carry_Out (S, Open_Line, "", "O!r~Vr", Success);

         --  A success in between, and the count begins again

         S := Opened (Mode);
         for Round in 1 .. 3 loop
            Carry_Out (S, Ping, "-", "p", Silence);
            Carry_Out (S, Ping, "-", "~V", Silence);
            Carry_Out (S, Ping, "-", "~v", Silence);
            Carry_Out (S, Ping, "++", "~?p", Success);
            Assert (S = Opened (Mode), "as good as new");
         end loop;
      end loop;
   end Test_Lost;

   procedure Test_Open is
      S : State;
   begin
      Carry_Out (S, Open_Line, "-", "O", (Not_Opened, 0, Nothing));
      Assert (not S.Line_Open, "not opened");
      Carry_Out (S, Open_Line, "+++", "O!r~Vr", Success);
      Assert (S.Idle, "it has acknowledged the reset");
      S.Idle := False;
      Assert (S = Opened (Not_Started), "open, in step");
      S := (others => <>);
      Carry_Out (S, Open_Line, "++E", "O!r~Vr", Success);
      Assert (S = Opened (Not_Started), "the robot did not run");

      --  Its robot may be off: the line is open all the same. One that
      --  answers late has been reset

      S := (others => <>);
      Carry_Out (S, Open_Line, "+-", "O!r~V", Success);
      Assert (S.Line_Open and then S.Mode = Not_Started
              and then S.Health.Failures = 1,
              "open, one failure");
      S := (others => <>);
      Carry_Out (S, Open_Line, "++-", "O!r~Vr", Success);
      Assert (S.Line_Open and then S.Mode = Not_Started
              and then S.Health.Failures = 1,
              "open, one failure");
      for Mode in Mode_Kind loop
         Check (Mode, Open_Line, "", "", Success, Mode);
      end loop;
   end Test_Open;

   procedure Test_Probe is

      function Unsure return State is
         --  Started, one answer missing.
         Result : State := Opened (Started);
      begin
         Result.Health := Robot.Health.After_Failure
           (Result.Health, Wire.Ping);
         return Result;
      end Unsure;

      procedure Check_Unsure
        (Kind : Request_Kind; Answers, Trace : String; Kept : Ending)
      is
         S : State := Unsure;
      begin
         Carry_Out (S, Kind, Answers, Trace, Kept);
      end Check_Unsure;

      S : State := Unsure;
   begin
      Carry_Out (S, Drive, "++", "~VT", Success);
      Assert (S = Opened (Started), "in step");
      S := Unsure;
      Carry_Out (S, Drive, "-", "~V", Silence);
      Assert (S.Health.Failures = 2, "two failures");
      S := Unsure;
      Carry_Out (S, Drive, "+-", "~VT", Silence);
      Assert (S.Health.Failures = 1, "one failure");

      Check_Unsure (Stop, "++", "!.~V.", Success);
      Check_Unsure (Stop, "-", "!.~V", Silence);
      Check_Unsure (Stop, "+-", "!.~V.", Silence);
      Check_Unsure (Close_Line, "++", "!.~V.C", Success);
      Check_Unsure (Reset, "+++", "!.~V.r", Success);
   end Test_Probe;

   procedure Test_Queries is
   begin
      for Mode in Mode_Kind loop
         Check (Mode, Ping, "+", "p", Success, Mode);
         Check (Mode, Ping, "-", "p", Silence, Mode);
         for Level in 0 .. 2 loop
            Check (Mode, Get_Battery,
                   (1 => Character'Val (Character'Pos ('0') + Level)), "v",
                   (Done, Level, Nothing), Mode);
         end loop;
         Check (Mode, Get_Battery, "E", "v", Refusal, Mode);
         Check (Mode, Get_Version, "+", "V", Success, Mode);
         Check (Mode, Get_Moving, "0", "b", Success, Mode);
         Check (Mode, Get_Moving, "1", "b", (Done, 1, Nothing), Mode);
      end loop;
   end Test_Queries;

   procedure Test_Reload is
      With_Watchdog : constant Mode_Kind := Started_With_Watchdog;
   begin
      Check (Not_Started, Reload, "", "", Success, Not_Started);
      Check (Started, Reload, "", "", Success, Started);
      Check (With_Watchdog, Reload, "+", "w", Success, With_Watchdog);
      Check (With_Watchdog, Reload, "-", "w", Silence, With_Watchdog);

      --  By hand: the robot answers, unless the periodic one does the work

      Check (With_Watchdog, Reload_By_Hand, "", "", Success, With_Watchdog);
      Check (Started, Reload_By_Hand, "+", "w", Success, Started);
      Check (Started, Reload_By_Hand, "E", "w", Refusal, Started);
      Check (Not_Started, Reload_By_Hand, "E", "w", Refusal, Not_Started);
   end Test_Reload;

   procedure Test_Reload_Refused is
      Mode : constant Mode_Kind := Started_With_Watchdog;
   begin
      Check (Mode, Reload, "E1", "wb", (Refused, 0, Missed_Window), Mode);
      Check (Mode, Reload, "E0+", "wb.", (Refused, 0, Missed_Window), Mode);
      Check (Mode, Reload, "E0E", "wb.", (Refused, 0, Not_Running),
             Not_Started);
      Check (Mode, Reload, "EEE", "wb.", (Refused, 0, Not_Running),
             Not_Started);
      Check (Mode, Reload, "E-", "wb", (Timed_Out, 0, Missed_Window), Mode);
      Check (Mode, Reload, "E0-", "wb.", (Timed_Out, 0, Missed_Window), Mode);
   end Test_Reload_Refused;

   procedure Test_Start is
   begin
      for Mode in Mode_Kind loop
         Check (Mode, Start, "+", "u", Success, Started);
         Check (Mode, Start_Watchdog, "+", "W", Success,
                Started_With_Watchdog);
         Check (Mode, Start, "E", "u", Refusal, Mode);
         Check (Mode, Start_Watchdog, "E", "W", Refusal, Mode);
         Check (Mode, Start, "-", "u", Silence, Mode);
         Check (Mode, Start_Watchdog, "-", "W", Silence, Mode);
      end loop;
   end Test_Start;

   procedure Test_Stop is
      S : State := Opened (Started);
   begin
      for Mode in Mode_Kind loop
         Check (Mode, Stop, "+", ".", Success, Mode);
         Check (Mode, Stop, "-", ".", Silence, Mode);
      end loop;
      Check (Not_Started, Stop, "E", ".", Refusal, Not_Started);
      for Mode in Started .. Started_With_Watchdog loop
         --  the first may have been damaged on its way
         Check (Mode, Stop, "E+", "..", Success, Mode);
         Check (Mode, Stop, "EE", "..", (Refused, 0, Not_Running),
                Not_Started);
         Check (Mode, Stop, "E-", "..", Silence, Mode);
      end loop;
      Carry_Out (S, Reset, "++", ".r", Success);
      Carry_Out (S, Stop, "", "", Refusal);
      --  it may have heard the start
      Carry_Out (S, Start, "-", "u", Silence);
      Carry_Out (S, Stop, "+", "!.~V.", Success);
   end Test_Stop;

begin
   Run_Test ("a closed line", Test_Closed'Access);
   Run_Test ("open, then reset", Test_Open'Access);
   Run_Test ("close", Test_Close'Access);
   Run_Test ("start", Test_Start'Access);
   Run_Test ("movements only while started", Test_Drive'Access);
   Run_Test ("a stop goes out, but to a robot that is known not to run",
             Test_Stop'Access);
   Run_Test ("queries", Test_Queries'Access);
   Run_Test ("a stop on every way out", Test_Leaving'Access);
   Run_Test ("an unanswered stop on the way out",
             Test_Leaving_Unanswered'Access);
   Run_Test ("reload", Test_Reload'Access);
   Run_Test ("a refused reload: window missed, or not running",
             Test_Reload_Refused'Access);
   Run_Test ("keep alive", Test_Keep_Alive'Access);
   Run_Test ("F8: lost at the fourth failure, not the third",
             Test_Lost'Access);
   Run_Test ("out of step: a probe, and a stop before it", Test_Probe'Access);
   Run_Test ("every answer to every request", Test_Everything'Access);
end Robot_Session_Tests;
