--  SPDX-License-Identifier: GPL-3.0-or-later
--  The test environment of a fault: one supervisor, one emulated robot with
--  its arena camera, one monitor that records its commands and the answers.

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
      --  of the supervisor, besides those that connect the three
      Emulator_Options : Unbounded_String;
      Camera           : Unbounded_String;
      --  instead of the emulated one's
      Terminal         : Boolean := False;
      --  the robot's line is a pseudo-terminal, not a socket
      Through_Link     : Boolean := False;
      --  the monitor is at the far end of a cable (Network_Links)
      Fresh            : Boolean := False;
      --  a new supervisor for every injection
      Receive_Buffer   : Natural := 0;
      --  of the monitor's socket, bytes; 0 leaves the system's
      Log_Is_Read      : Boolean := True;
      --  False if the launcher removes its standard error: the checks do not
      --  use the log
   end record;

   --  Its current state

   type Robot_Situation is
     (Line_Closed, Line_Open, Started, Started_With_Watchdog, Moving,
      Moving_With_Watchdog);

   type Camera_Situation is
     (Camera_Closed, Streaming, With_Position, Arena_Asked, Arena_Kept);

   type Invariant is
     (Supervisor_Lives, Answered_Once, Robot_Stands, Session_Works,
      Nothing_Leaks);

   type Explanation is (A_Late_Line, A_Stopped_Machine, Nothing_Else);
   --  Possible causes of a violation other than the supervisor: a processor
   --  or a pseudo-terminal that stood still (Standstills), or processor time
   --  stolen by the host (Host_Time); neither for violations such as two
   --  answers to one command

   --  Additional figures

   type Figure_Set is record
      Repeated     : Natural := 0;
      --  sessions repeated, see Tolerances.Line_Attempts
      Interrupted  : Natural := 0;
      --  injections repeated, see Tolerances.Host_Grant
      Stops        : Natural := 0;
      --  of a moving robot, after a close or a reset
      Late_Stops   : Natural := 0;
      --  of these, those that needed the margin
      Slowest_Stop : Duration := 0.0;
      --  from the close to the stop order on the wire
      Growth       : Natural := 0;
      --  kilobytes, of the supervisor's memory since its first session
   end record;

   function Worst (Left, Right : Figure_Set) return Figure_Set;
   --  Adds the counts; of the others takes the maximum

   type World is tagged limited record
      Emulator   : Emulators.Emulator;
      Supervisor : Supervisors.Supervisor;
      Monitor    : Monitor_Clients.Client;
      --  Commands must be sent by Say, to be counted
      Source     : Random_Numbers.Generator;
      --  of this injection: the source of all random values
      The_Plan   : Plan;
      Robot      : Robot_Situation := Line_Closed;
      Camera     : Camera_Situation := Camera_Closed;
      --  state of the session before the fault

      Alone      : Boolean := True;
      --  no other fault is active: the session exists, and a fault may check
      --  requirements that only it can violate

      --  Set by a fault for the checks; reset before the next injection

      Line_Works : Boolean := True;
      --  False if a stop could not reach the robot: it is not checked
      Robot_Ready : Boolean := True;
      --  False if the robot must be power-cycled before it can be started
      --  again
      Reachable  : Boolean := True;
      --  False while no new monitor can be admitted: between Inject and Lift

      --  Maintained by the operations below

      Present        : Boolean := False;
      --  the monitor is connected
      Ledger         : Answer_Ledgers.Ledger;
      Read           : Natural := 0;
      --  messages recorded in the ledger
      Session_Log    : Natural := 0;
      --  lines of the log before this session
      Nobody_Since   : Instant := Never;
      Nobody_Limit   : Duration := 0.0;
      Stop_Counted   : Boolean := False;
      Found_By       : Instant := Never;
      --  latest time for the detection of the monitor's loss
      Port           : Natural := 0;
      Expected_End   : Boolean := False;
      Expected_Status : Integer := 0;
      Base_Threads, Base_Descriptors, Base_Memory : Natural := 0;
      Figures        : Figure_Set;
      Violations     : Natural := 0;
      Explained_By   : Explanation := A_Late_Line;
      --  the one with the fewest possible causes
      Account        : Unbounded_String;
      --  what was violated, line by line
      Remarks        : Unbounded_String;
      --  the same for stops that needed the margin
   end record;

   --  Building

   procedure Build (W : in out World; P : Plan);
   --  Starts emulator and supervisor; a first session with all features; then
   --  records threads, descriptors and memory. Raises Failed.

   procedure Start_Supervisor (W : in out World);
   --  A new supervisor with the same emulator, and its first session

   function Is_Built (W : World) return Boolean;

   procedure Destroy (W : in out World);

   function Address (W : World) return String;
   --  Its port

   function Pid (W : World) return Interfaces.C.int;
   --  Of the supervisor

   --  The session

   procedure Begin_Session
     (W : in out World; Robot : Robot_Situation; Camera : Camera_Situation);
   --  Connects a monitor and brings robot and camera into that state by
   --  commands. Raises Failed on failure.

   procedure Bring_To (W : in out World; Robot : Robot_Situation);
   --  By commands, from a closed line. Raises Failed.

   procedure Join (W : in out World; Within : Duration);
   --  Connects a monitor; retries while it is rejected. Raises Failed if it is
   --  not admitted.

   procedure Try_To_Join (W : in out World);
   --  The same during a fault: gives up soon if it is not admitted

   procedure Order (W : in out World; Command, Answer : String);
   --  Says Command and waits. Raises Failed unless it is answered with one
   --  of the labels in Answer

   procedure Say (W : in out World; Command : String);
   --  Sends a well-formed command and does not wait. No effect if no monitor
   --  is connected; if the connection turns out to be closed, the monitor is
   --  no longer present.

   procedure Say (W : in out World; Line : String; Answer : Answer_Kind);
   --  Any line, with its expected answer

   procedure Say_Bytes (W : in out World; Bytes : String);
   --  Sent unchanged and not counted: such as part of a line. Must be followed
   --  by Say with the line's end.

   procedure Expect_Answers
     (W : in out World; Within : Duration := Tolerances.Answer_Limit);
   --  Waits until all commands are answered. Raises Failed if one is not.

   procedure Talk
     (W : in out World; For_Time : Duration; Calm : Boolean := False);
   --  Random commands at random times, without waiting. Calm: only those that
   --  do not change robot and camera.

   procedure Listen (W : in out World);
   --  Records received messages in the ledger

   --  The end of the session

   type Manner is (Orderly, Abortive, Silently);
   --  The connection stays open, but no longer belongs to the session (a cable
   --  was cut)

   procedure Lose
     (W         : in out World;
      How       : Manner;
      Detection : Duration := Tolerances.Loss_Limit);
   --  The monitor is gone from now on: closed, or reset. Detection: the time
   --  for the supervisor to detect it.

   procedure Nobody_In_Command
     (W         : in out World;
      Since     : Instant := Now;
      Within    : Duration := Tolerances.Stop_Limit);
   --  The robot must be stopped Within after Since, plus a margin: checked
   --  after the fault. Implied by Lose, and by a close of the connection by
   --  the supervisor.

   procedure Supervisor_Ends (W : in out World; Status : Integer);
   --  This fault ends the supervisor, with this status, perhaps later

   procedure End_Session (W : in out World);
   --  Closes in order, if there is a session

   procedure Await_Standing (W : in out World);
   --  The third invariant, when nobody is in command. May be repeated: it also
   --  detects a later movement

   --  Demands

   procedure Expect_Status
     (W : in out World; Key, Value : String; Within : Duration);
   --  The emulator's status becomes Value in that time

   procedure Expect_Log
     (W      : in out World;
      Text   : String;
      Within : Duration;
      After  : Natural := 0);
   --  The supervisor says so in that time

   --  Findings

   function Line_Was_Late (W : World) return Boolean;
   --  Or what serves it; since Standstills.Forget

   procedure Violate (W : in out World; Which : Invariant; Text : String);

   procedure Violate
     (W : in out World; Text : String; By : Explanation := A_Late_Line);
   --  Requirements of the fault itself, besides the five

   function Wire_Tail (W : in out World) return String;
   --  The last commands received by the robot, with their times: lines

   procedure Expect_No_Leaks (W : in out World);
   --  The fifth invariant, between two sessions

   The_Link : Network_Links.Link;
   --  all worlds of this process, one after the other

end Worlds;
