--  SPDX-License-Identifier: GPL-3.0-or-later
--  Requirements that a fault checks during the session, in addition to the
--  invariants. Each raises Failed if it is not met.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Worlds;                use Worlds;

package Demands is

   type Reply is record
      Label : Message_Label := "    ";
      Data  : Unbounded_String;
      --  the text after the colon
      Took  : Duration := 0.0;
   end record;

   function Asked (W : in out World; Command : String) return Reply;
   --  Sends Command, when all before it is answered, and takes the answer

   function Image (R : Reply) return String;
   --  Such as RBLV:2

   Prompt : constant Duration := 0.3;
   --  The longest time of an order to the robot, a stop on a failing line:
   --  three exchanges of 80 ms, and their bytes

   procedure Expect (W : in out World; Command, Answers : String);
   --  The answer is one of Answers, such as "AACK" or "RBLV:2 ATIM", in time

   --  The robot

   procedure Quieten (W : in out World);
   --  Line open, robot not started: only requested exchanges are on the line,
   --  and all messages are answers

   function Is_Started (W : World) return Boolean is
     (W.Robot >= Started);
   --  It was, when the fault came

   procedure Start_With_Watchdog (W : in out World);
   --  Where it was not

   procedure Expect_Truth (W : in out World);
   --  The monitor's messages on battery and movement are true

   type Before is record
      Log   : Natural := 0;
      Atims : Natural := 0;
      Time  : Instant := Never;
   end record;

   function Situation (W : in out World) return Before;
   --  With every command answered

   procedure Expect_Loss (W : in out World; B : Before);
   --  Within a second after B a started robot counts as lost: a last stop on
   --  the wire, one message, and from then on ANAK

   procedure Expect_No_Loss (W : in out World; B : Before);

   procedure Await_Unasked (W : in out World);
   --  Waits for the unsolicited ATIM of a lost robot, which a monitor could
   --  take for the next answer

   procedure Expect_Return (W : in out World);
   --  The line can be opened again, and works

   procedure Expect_Not_Running (W : in out World; B : Before);
   --  A started robot with watchdog is found not to run at the next reload: a
   --  message, and the session is not started

   --  The camera

   procedure Expect_Images (W : in out World; Count : Positive);
   --  So many images, soon

   procedure Expect_Closed (W : in out World; B : Before);
   --  The monitor is informed that the camera has failed

   procedure Expect_Open (W : in out World; B : Before);
   --  It has not been closed since

   procedure Get_Image_Size
     (W : in out World; Width, Height : out Natural);
   --  Of the last image; 0 if it is none

   procedure Recover_Camera (W : in out World);
   --  Open or not: it can be opened, and delivers images

end Demands;
