--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the robot: the steps of every request, step by step.

with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

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

   function Mark (S : State; Next : Step) return String is
     (case Next.Kind is
         when Open_Device  => "O",
         when Close_Device => "C",
         when Send         => "!" & Mark (Next.Command),
         when Exchange     =>
           (if Robot.Health.In_Step (S.Health) then "" else "~")
           & Mark (Next.Command),
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
               ((if C.Kind = Wire.Battery then Wire.Level
                 else Wire.Moving_State),
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

   S      : State;
   Before : Mode_Kind;

   procedure Carry_Out (Script, Request : String) is
      --  "REQUEST:ANSWERS:TRACE:OUTCOME", with a digit or a note after it: its
      --  exchanges and openings are answered so, or else accepted; it makes
      --  the steps of the trace and has that outcome
      Part    : constant Line_Vectors.Vector := Split (Request, ':');
      Answers : constant String := Part (2);
      More    : constant String :=
        (if Part.Last_Index = 5 then Part (5) else "0");
      Kind    : constant Request_Kind := Request_Kind'Value (Part (1));
      Wanted  : constant Outcome_Kind := Outcome_Kind'Value (Part (4));
      Made    : Unbounded_String;
      Used    : Natural := 0;
      P       : Progress;
      Next    : Step;

      procedure Get (How : out Character) is
         --  The next of the answers
      begin
         Used := Used + 1;
         How := (if Used <= Answers'Length
                 then Answers (Answers'First + Used - 1) else '+');
      end Get;

      How : Character;
   begin
      Start_Request (S, (Kind, Driving), P);
      loop
         Next := Next_Step (S, P);
         exit when Next.Kind = Finish;
         Append (Made, Mark (S, Next));
         case Next.Kind is
            when Send | Close_Device | Finish =>
               Continue_Request (S, P, (Ok => False, others => <>));
            when Open_Device =>
               Get (How);
               Continue_Request (S, P, (How = '+', others => <>));
            when Exchange =>
               Get (How);
               Continue_Request (S, P, Answer (Next.Command, How));
         end case;
      end loop;
      Assert (Made = Part (3) and then Used >= Answers'Length
              and then P.Result.Kind = Wanted
              and then P.Result.Note =
                (if More in "0" | "1" | "2" then Nothing
                 else Note_Kind'Value (More))
              and then
                (if Kind in Get_Battery | Get_Moving and then Wanted = Done
                 then P.Result.Text.Data (1 .. 1) = More)
              and then Is_Consistent (S),
              Request & " in " & Script & " from " & Before'Image & ": "
              & To_String (Made) & " " & P.Result.Kind'Image
              & P.Result.Text.Data (1) & " " & P.Result.Note'Image);
   end Carry_Out;

   procedure Play (Script : String) is
      --  Requests one after the other, from each state that "@WORD" names:
      --  a mode of an open line in step; "running", the two that are started;
      --  "any" of the three; "unsure", started with one answer missing;
      --  "closed", the initial state. After it: "=MODE", or "=" for that
      --  before, of the open line; "new", an open line in step in the mode
      --  before; "idle", the robot is known not to run; "closed";
      --  "failures:N"

      procedure Begin_In (Name : String) is
      begin
         S := (if Name = "closed" then (others => <>) else Opened (Before));
         if Name = "unsure" then
            S.Health := Robot.Health.After_Failure (S.Health, Wire.Ping);
         end if;
      end Begin_In;

      procedure Obey (Word : String) is

         procedure Check (Is_So : Boolean) is
         begin
            Assert (Is_So, Word & " in " & Script & " from " & Before'Image
                    & ": " & S.Mode'Image & " " & S.Line_Open'Image);
         end Check;

      begin
         if Word = "closed" then
            Check (S = State'(others => <>));
         elsif Word = "new" then
            Check (S = Opened (Before));
         elsif Word = "idle" then
            Check (S.Idle);
            S.Idle := False;
         elsif Head (Word, 9) = "failures:" then
            Check (S.Health.Failures'Image (2 .. 2) = Tail (Word, 1));
         elsif Head (Word, 1) = "=" then
            Check (S.Line_Open
                   and then S.Mode =
                     (if Word = "=" then Before
                      else Mode_Kind'Value (Tail (Word, Word'Length - 1))));
         elsif Word /= "" then
            Carry_Out (Script, Word);
         end if;
      end Obey;

      function Is_Meant (Name : String; Mode : Mode_Kind) return Boolean is
        (if Name = "any" then True
         elsif Name = "running" then Mode /= Not_Started
         elsif Name = "unsure" then Mode = Started
         elsif Name = "closed" then Mode = Not_Started
         else Mode_Kind'Value (Name) = Mode);

   begin
      for Part of Split (Tail (Script, Script'Length - 1), '@') loop
         for Mode in Mode_Kind loop
            if Is_Meant (Split (Part, ' ') (1), Mode) then
               Before := Mode;
               Begin_In (Split (Part, ' ') (1));
               for K in 2 .. Split (Part, ' ').Last_Index loop
                  Obey (Split (Part, ' ') (K));
               end loop;
            end if;
         end loop;
      end loop;
   end Play;

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
            Follow (Answer (Next.Command, '-'));
            Follow (Answer (Next.Command, '+'));
            if Robot.Health.In_Step (S.Health) then
               Follow (Answer (Next.Command, 'E'));
               if Next.Command.Kind in Wire.Battery | Wire.Busy then
                  Follow (Answer (Next.Command, '1'));
               end if;
            end if;
         when Finish =>
            null;
      end case;
   end Explore;

   procedure Test_Closed is
   begin
      for Kind in Request_Kind range Close_Line .. Keep_Alive loop
         Play ("@closed " & Kind'Image & ":::"
               & (if Kind = Close_Line then "Done" else "Not_Open")
               & " closed");
      end loop;
   end Test_Closed;

   procedure Test_Everything is

      procedure Explore_From (S : State; R : Request) is
         --  All that can come of R.
         P : Progress;
      begin
         Start_Request (S, R, P);
         Explore ((Before => S, Request => R, others => <>), S, P);
      end Explore_From;

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

begin
   Run_Test ("a closed line", Test_Closed'Access);
   Run_Scripts
     (Play'Access,
      --  Its robot may be off: the line is open all the same. One that
      --  answers late has been reset
      "open, then reset: @closed Open_Line:-:O:Not_Opened closed"
      & "@closed Open_Line:+++:O!r~Vr:Done idle new"
      & "@closed Open_Line:++E:O!r~Vr:Done new"
      & "@closed Open_Line:+-:O!r~V:Done =Not_Started failures:1"
      & "@closed Open_Line:++-:O!r~Vr:Done =Not_Started failures:1"
      & "@any Open_Line:::Done ="

      & "|close, though the stop is refused: @Not_Started Close_Line::C:Done "
      & "closed@running Close_Line:+:.C:Done closed"
      & "@running Close_Line:E:.C:Done closed"

      & "|start: @any Start:+:u:Done =Started"
      & "@any Start_Watchdog:+:W:Done =Started_With_Watchdog"
      & "@any Start:E:u:Refused = Start_Watchdog:E:W:Refused ="
      & "@any Start:-:u:Timed_Out =@any Start_Watchdog:-:W:Timed_Out ="

      & "|movements only while started: @Not_Started Drive:::Refused ="
      & "@running Drive:+:T:Done = Drive:E+:T.:Refused ="
      & "@running Drive:EE:T.:Refused:Not_Running =Not_Started"
      & "@running Drive:E-:T.:Timed_Out =@running Drive:-:T:Timed_Out ="

      --  The first may have been damaged on its way; a robot may have heard
      --  the start that was not answered
      & "|a stop goes out, but to a robot that is known not to run: "
      & "@any Stop:+:.:Done =@any Stop:-:.:Timed_Out ="
      & "@Not_Started Stop:E:.:Refused =@running Stop:E+:..:Done ="
      & "@running Stop:EE:..:Refused:Not_Running =Not_Started"
      & "@running Stop:E-:..:Timed_Out ="
      & "@Started Reset:++:.r:Done Stop:::Refused Start:-:u:Timed_Out "
      & "Stop:+:!.~V.:Done"

      & "|queries: @any Ping:+:p:Done = Get_Battery:0:v:Done:0 = "
      & "Get_Battery:1:v:Done:1 = Get_Battery:2:v:Done:2 = "
      & "Get_Battery:E:v:Refused = Get_Version:+:V:Done = "
      & "Get_Moving:0:b:Done = Get_Moving:1:b:Done:1 = Ping:-:p:Timed_Out ="

      --  Is the answer of a power off cut off: does the robot still answer?
      & "|a stop on every way out: @Not_Started Reset:+:r:Done ="
      & "@Not_Started Power_Off:+:z:Done ="
      & "@running Reset:++:.r:Done =Not_Started"
      & "@running Reset:E+:.r:Done =Not_Started"
      & "@running Reset:+E:.r:Refused =Not_Started"
      & "@running Reset:+-:.r:Timed_Out ="
      & "@running Power_Off:++:.z:Done =Not_Started"
      & "@running Power_Off:+E:.z:Refused ="
      & "@running Power_Off:+--:.z~V:Done =Not_Started"
      & "@running Power_Off:+-++:.z~Vz:Done =Not_Started"
      & "@running Power_Off:+-+-:.z~Vz:Timed_Out ="

      --  The probes are answered, the stops never; or nothing is answered:
      --  the robot is lost on the way out
      & "|an unanswered stop on the way out: "
      & "@running Reset:-+++:.!.~V.r:Done =Not_Started"
      & "@running Power_Off:--++:.!.~V~v.z:Done =Not_Started"
      & "@running Reset:-+-+-+-:.!.~V.~V.~V.~Vr:Done =Not_Started"
      & "@running Close_Line:----:.!.~V~v~?!.C:Timed_Out:Robot_Lost closed"
      & "@running Reset:----:.!.~V~v~?!.C:Timed_Out:Robot_Lost closed"
      & "@running Power_Off:----:.!.~V~v~?!.C:Timed_Out:Robot_Lost closed"

      --  By hand the robot answers, unless the periodic one does the work
      & "|reload: @Not_Started Reload:::Done =@Started Reload:::Done ="
      & "@Started_With_Watchdog Reload:+:w:Done = Reload:-:w:Timed_Out ="
      & "@Started_With_Watchdog Reload_By_Hand:::Done ="
      & "@Started Reload_By_Hand:+:w:Done = Reload_By_Hand:E:w:Refused ="
      & "@Not_Started Reload_By_Hand:E:w:Refused ="

      & "|a refused reload, window missed, or not running: "
      & "@Started_With_Watchdog Reload:E1:wb:Refused:Missed_Window ="
      & "@Started_With_Watchdog Reload:E0+:wb.:Refused:Missed_Window ="
      & "@Started_With_Watchdog Reload:E0E:wb.:Refused:Not_Running "
      & "=Not_Started"
      & "@Started_With_Watchdog Reload:EEE:wb.:Refused:Not_Running "
      & "=Not_Started"
      & "@Started_With_Watchdog Reload:E-:wb:Timed_Out:Missed_Window ="
      & "@Started_With_Watchdog Reload:E0-:wb.:Timed_Out:Missed_Window ="

      & "|keep alive: @any Keep_Alive:+:p:Done = Keep_Alive:-:p:Timed_Out ="

      --  With a success in between the count begins again
      & "|F8, lost at the fourth failure, not the third: "
      & "@any Ping:-:p:Timed_Out Ping:-:~V:Timed_Out Ping:-:~v:Timed_Out = "
      & "Ping:-:~?!.C:Timed_Out:Robot_Lost closed Ping:::Not_Open "
      & "Open_Line::O!r~Vr:Done@any "
      & 3 * ("Ping:-:p:Timed_Out Ping:-:~V:Timed_Out Ping:-:~v:Timed_Out "
             & "Ping:++:~?p:Done new ")

      & "|out of step, a probe, and a stop before it: "
      & "@unsure Drive:++:~VT:Done new"
      & "@unsure Drive:-:~V:Timed_Out failures:2"
      & "@unsure Drive:+-:~VT:Timed_Out failures:1"
      & "@unsure Stop:++:!.~V.:Done@unsure Stop:-:!.~V:Timed_Out"
      & "@unsure Stop:+-:!.~V.:Timed_Out"
      & "@unsure Close_Line:++:!.~V.C:Done@unsure Reset:+++:!.~V.r:Done");
   Run_Test ("every answer to every request", Test_Everything'Access);
end Robot_Session_Tests;
