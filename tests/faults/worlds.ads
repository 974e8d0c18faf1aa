--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where a fault is injected: one supervisor, one emulated robot with its
--  arena camera, one monitor that counts what it asks and what it is told.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Interfaces.C;

with Answer_Ledgers;        use Answer_Ledgers;
with Emulators;
with Instants;              use Instants;
with Monitor_Clients;
with Network_Links;
with Random_Numbers;
with Supervisors;
with Tolerances;

package Worlds is

   --  How its programs are started

   type Plan is record
      Launcher         : Unbounded_String;
      --  of the supervisor, such as "setpriv --reuid 65534"
      Program          : Unbounded_String;
      --  another copy of the supervisor
      Options          : Unbounded_String;
      --  of the supervisor, beside those that connect the three
      Emulator_Options : Unbounded_String;
      Camera           : Unbounded_String;
      --  instead of the emulated one's
      Through_Link     : Boolean := False;
      --  the monitor sits at the far end of a cable (Network_Links)
      Fresh            : Boolean := False;
      --  a new supervisor for every injection
      Receive_Buffer   : Natural := 0;
      --  of the monitor's socket, bytes; 0 leaves the system's
      Log_Is_Read      : Boolean := True;
      --  False where the launcher takes its standard error away: the checks
      --  do without its log
   end record;

   --  What is going on in it

   type Robot_Situation is
     (Line_Closed, Line_Open, Started, Started_With_Watchdog, Moving,
      Moving_With_Watchdog);

   type Camera_Situation is
     (Camera_Closed, Streaming, With_Position, Arena_Asked, Arena_Kept);

   type Invariant is
     (Supervisor_Lives, Answered_Once, Robot_Stands, Session_Works,
      Nothing_Leaks);

   type Explanation is (A_Late_Line, A_Stopped_Machine, Nothing_Else);
   --  What a violation may come from, other than the supervisor: a
   --  pseudo-terminal that was late (Line_Watch), or the machine's host,
   --  which took the processors (Host_Time); or from neither, such as two
   --  answers to one command

   --  Worth knowing, beside whether all held

   type Figure_Set is record
      Repeated     : Natural := 0;
      --  sessions begun again, see Tolerances.Line_Attempts
      Interrupted  : Natural := 0;
      --  injections made again, see Tolerances.Host_Grant
      Stops        : Natural := 0;
      --  of a moving robot, after a close or a reset
      Late_Stops   : Natural := 0;
      --  of these, within the margin for noise only
      Slowest_Stop : Duration := 0.0;
      --  from the close to the stop order on the wire
      Growth       : Natural := 0;
      --  kilobytes, of the supervisor's memory since its first session
   end record;

   function Worst (Left, Right : Figure_Set) return Figure_Set;
   --  Counts are added; of the others the maximum

   type World is tagged limited record
      Emulator   : Emulators.Emulator;
      Supervisor : Supervisors.Supervisor;
      Monitor    : Monitor_Clients.Client;
      --  Commands go through Say, so that they are counted
      Source     : Random_Numbers.Generator;
      --  of this injection: everything random comes from here
      The_Plan   : Plan;
      Robot      : Robot_Situation := Line_Closed;
      Camera     : Camera_Situation := Camera_Closed;
      --  as the session was brought to, before the fault

      Alone      : Boolean := True;
      --  no other fault is under way: the session is there, and a fault may
      --  demand what only it can spoil

      --  What a fault tells the checks; reset before the next injection

      Line_Works : Boolean := True;
      --  False where a stop could not reach the robot: it is not looked at
      Robot_Ready : Boolean := True;
      --  False where the robot has to be switched off and on before it can
      --  be started again
      Reachable  : Boolean := True;
      --  False while no new monitor can be admitted: between Inject and Lift

      --  Kept by the operations below

      Present        : Boolean := False;
      --  the monitor is connected
      Ledger         : Answer_Ledgers.Ledger;
      Read           : Natural := 0;
      --  messages that the ledger has
      Session_Log    : Natural := 0;
      --  lines of the log before this session
      Nobody_Since   : Instant := Never;
      Nobody_Limit   : Duration := 0.0;
      Stop_Counted   : Boolean := False;
      Found_By       : Instant := Never;
      --  when a loss of the monitor is to have been found, at the latest
      Port           : Natural := 0;
      Expected_End   : Boolean := False;
      Expected_Status : Integer := 0;
      Base_Threads, Base_Descriptors, Base_Memory : Natural := 0;
      Figures        : Figure_Set;
      Violations     : Natural := 0;
      Explained_By   : Explanation := A_Late_Line;
      --  the one among them that the least can explain
      Account        : Unbounded_String;
      --  what was violated, line by line
      Remarks        : Unbounded_String;
      --  the same of stops that were late, but within the margin for noise
   end record;

   --  Building

   procedure Build (W : in out World; P : Plan);
   --  Emulator and supervisor, new; a first session with everything; then
   --  threads, descriptors and memory are noted. Raises Failed.

   procedure Start_Supervisor (W : in out World);
   --  A new one beside the emulator that there is, with its first session

   function Is_Built (W : World) return Boolean;

   procedure Destroy (W : in out World);

   function Address (W : World) return String;
   --  Where the supervisor listens

   function Pid (W : World) return Interfaces.C.int;
   --  Of the supervisor

   --  The session

   procedure Begin_Session
     (W : in out World; Robot : Robot_Situation; Camera : Camera_Situation);
   --  A monitor connects and brings robot and camera there by commands.
   --  Raises Failed where that does not succeed.

   procedure Bring_To (W : in out World; Robot : Robot_Situation);
   --  By commands, from a closed line. Raises Failed.

   procedure Join (W : in out World; Within : Duration);
   --  A monitor connects and is admitted; tried again while it is refused.
   --  Raises Failed when it is not admitted.

   procedure Try_To_Join (W : in out World);
   --  The same amid a fault: where it is not admitted soon, then not

   procedure Order (W : in out World; Command, Answer : String);
   --  Says Command and waits. Raises Failed unless it is answered with one
   --  of the labels in Answer

   procedure Say (W : in out World; Command : String);
   --  Sends a well-formed command and does not wait. Nothing happens where
   --  no monitor is connected; where the connection turns out to be closed
   --  the monitor is no longer present.

   procedure Say (W : in out World; Line : String; Answer : Answer_Kind);
   --  Any line, with the answer that it must have

   procedure Say_Bytes (W : in out World; Bytes : String);
   --  As they are and uncounted: part of a line, say. Followed by Say of
   --  the line's end.

   procedure Expect_Answers
     (W : in out World; Within : Duration := Tolerances.Answer_Limit);
   --  Until all commands are answered. Raises Failed when one is not.

   procedure Talk
     (W : in out World; For_Time : Duration; Calm : Boolean := False);
   --  Random commands at random moments, not waited for. Calm: such as
   --  leave robot and camera as they are.

   procedure Listen (W : in out World);
   --  What was received goes to the ledger

   --  The end of the session

   type Manner is (Orderly, Abortive, Silently);
   --  Silently: the connection stays as it is, but no longer belongs to the
   --  session (a cable was cut)

   procedure Lose
     (W         : in out World;
      How       : Manner;
      Detection : Duration := Tolerances.Loss_Limit);
   --  The monitor is gone from now on: closed, or reset. Detection is what
   --  the supervisor may take to find it.

   procedure Nobody_In_Command
     (W         : in out World;
      Since     : Instant := Now;
      Within    : Duration := Tolerances.Stop_Limit);
   --  From Since the robot must stand Within, and a margin: checked after
   --  the fault. Lose says so itself, and where the supervisor closes the
   --  connection it holds from then on.

   procedure Supervisor_Ends (W : in out World; Status : Integer);
   --  This fault ends it, with this status; it need not have ended yet

   procedure End_Session (W : in out World);
   --  An orderly close, if there is a session

   procedure Await_Standing (W : in out World);
   --  The third invariant, where nobody is in command. May be repeated: a
   --  movement afterwards is found as well

   --  Findings

   procedure Violate (W : in out World; Which : Invariant; Text : String);

   procedure Violate
     (W : in out World; Text : String; By : Explanation := A_Late_Line);
   --  What the fault itself demands beyond the five

   function Wire_Tail (W : in out World) return String;
   --  The last commands that the robot has heard, and when: lines

   procedure Expect_No_Leaks (W : in out World);
   --  The fifth invariant, between two sessions

   The_Link : Network_Links.Link;
   --  of all worlds of this process, one after the other

end Worlds;
