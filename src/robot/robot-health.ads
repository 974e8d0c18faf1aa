--  SPDX-License-Identifier: GPL-3.0-or-later
--  Supervision of the robot's line: when it is lost, and how it is
--  synchronised again after a missing answer.

with Robot.Protocol; use Robot.Protocol;

package Robot.Health with SPARK_Mode is

   --  An answer may be late, and the same letter answers many commands. So
   --  after a failed exchange the line is out of step: an answer of the
   --  missing answer's class may still arrive (it is owed). Before the next
   --  command, a probe is sent: a harmless command whose answer has a class
   --  that is not owed. All that arrives before that answer is discarded
   --  (Robot.Protocol.Is_Answer), also a refusal, as any command damaged on
   --  the line is refused. The robot answers in order, so after the probe's
   --  answer nothing is owed any more. A newly opened line is also out of
   --  step: the answer to a last stop, sent on a lost line or by the
   --  supervisor's previous run, may still arrive.

   Max_Failures : constant := 4;
   --  Failures in a row at which the line is lost: more than 3 (F8).

   subtype Failure_Count is Natural range 0 .. Max_Failures;

   type Class_Set is array (Answer_Class) of Boolean;

   function Count (Owed : Class_Set) return Natural is
     (Boolean'Pos (Owed (Acknowledge)) + Boolean'Pos (Owed (Digit))
      + Boolean'Pos (Owed (Text)) + Boolean'Pos (Owed (Unknown)));

   type State is record
      Failures : Failure_Count := 0;
      --  Exchanges in a row that have failed
      Owed     : Class_Set     := (others => False);
      --  A late answer of these classes may still arrive
      Untried  : Boolean       := False;
      --  Since it was opened
   end record
   with Dynamic_Predicate => Count (State.Owed) <= State.Failures;
   --  A failure adds at most one class: while the line is not lost, one of the
   --  four classes is free for a probe.

   Initial : constant State := (others => <>);
   --  In step, no failure, nothing owed: also after an answer to a command
   --  sent in step, or to a probe

   Opened  : constant State := (Untried => True, others => <>);
   --  The state of a newly opened line: the same, but out of step

   function Lost (H : State) return Boolean is (H.Failures = Max_Failures);
   --  No further exchange: the line must be closed.

   function In_Step (H : State) return Boolean is
     (H.Failures = 0 and then not H.Untried);
   --  The next frame to arrive is the answer to the next command.

   function Probe (H : State) return Command_Kind is
     (if not H.Owed (Text) then Version
      elsif not H.Owed (Digit) then Battery
      elsif not H.Owed (Unknown) then Unknown_Letter
      else Ping)
   with
     Pre  => not Lost (H),
     Post => not H.Owed (Class_Of (Probe'Result));
   --  The command that synchronises the line. There always is one.

   function Is_Owed_After
     (H : State; Command : Command_Kind; Class : Answer_Class) return Boolean
   is (H.Owed (Class) or else Class_Of (Command) = Class);

   function After_Failure (H : State; Command : Command_Kind) return State is
     (Failures => H.Failures + 1,
      Owed     =>
        (Acknowledge => Is_Owed_After (H, Command, Acknowledge),
         Digit       => Is_Owed_After (H, Command, Digit),
         Text        => Is_Owed_After (H, Command, Text),
         Unknown     => Is_Owed_After (H, Command, Unknown)),
      Untried  => False)
   with Pre => not Lost (H);
   --  The exchange of Command failed: no answer in time, a wrong checksum, a
   --  wrong kind of answer or a malformed one. A probe fails only by time-out.
   --  The class of Command is owed from now on, too

end Robot.Health;
