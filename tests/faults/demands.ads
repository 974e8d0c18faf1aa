--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a fault may demand of the session while it goes on, beside the
--  invariants. Where it is not met Failed is raised.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;
with Worlds;                use Worlds;

package Demands is

   type Reply is record
      Label : Message_Label := "    ";
      Data  : Unbounded_String;
      --  what follows the colon
      Took  : Duration := 0.0;
   end record;

   function Asked (W : in out World; Command : String) return Reply;
   --  Says Command, when all before it is answered, and takes the answer

   function Image (R : Reply) return String;
   --  Such as RBLV:2

   Prompt : constant Duration := 0.3;
   --  The longest that an order to the robot takes, a stop on a failing
   --  line: three exchanges of 80 ms, and their bytes

   procedure Expect (W : in out World; Command, Answers : String);
   --  One of Answers, such as "AACK" or "RBLV:2 ATIM", and promptly

   --  The robot

   procedure Quieten (W : in out World);
   --  Its line open, itself not started: nothing but what is asked then
   --  goes over the line, and what is told is an answer

   function Is_Started (W : World) return Boolean is
     (W.Robot >= Started);
   --  It was, when the fault came

   procedure Start_With_Watchdog (W : in out World);
   --  Where it was not

   procedure Expect_Truth (W : in out World);
   --  What the monitor hears of battery and movement is so

   type Before is record
      Log   : Natural := 0;
      Atims : Natural := 0;
      Time  : Instant := Never;
   end record;

   function Situation (W : in out World) return Before;
   --  With every command answered

   procedure Expect_Loss (W : in out World; B : Before);
   --  Within a second of B a started robot is given up: a last stop on the
   --  wire, told once, and from then on ANAK

   procedure Expect_No_Loss (W : in out World; B : Before);

   procedure Await_Unasked (W : in out World);
   --  Lets the unasked ATIM of a lost robot come in, which a monitor could
   --  take for the answer to what it asks next

   procedure Expect_Return (W : in out World);
   --  The line can be opened again, and works

   procedure Expect_Not_Running (W : in out World; B : Before);
   --  A robot started with its watchdog is found not to run any more, at
   --  the next reload: told, and the session not started

   --  The camera

   procedure Expect_Images (W : in out World; Count : Positive);
   --  So many, soon

   procedure Expect_Closed (W : in out World; B : Before);
   --  The monitor is told that the camera delivers no more

   procedure Expect_Open (W : in out World; B : Before);
   --  It has not been closed since

   procedure Get_Image_Size
     (W : in out World; Width, Height : out Natural);
   --  Of the last image; 0 where it is none

   procedure Recover_Camera (W : in out World);
   --  Open or not: it can be opened, and gives images

end Demands;
