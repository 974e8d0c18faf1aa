--  SPDX-License-Identifier: GPL-3.0-or-later
--  Both the monitor's end of a connection and the robot's end of a line: the
--  time from one to the other is measured by one clock, and one task serves
--  both.

with Ada.Containers.Vectors;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants; use Instants;

package Both_Ends is

   type Place is (Ours, Traced, Floor);
   --  The program between the ends

   procedure Open_Line (Where : Place);
   --  A pseudo-terminal, with a robot that answers everything at once

   function Device (Where : Place) return String;
   --  The other end of that line

   procedure Connect (Where : Place; Port : Positive; By_Lines : Boolean);
   --  To 127.0.0.1. By_Lines: messages are the supervisor's; otherwise all
   --  that comes at once is one

   procedure Close_All;

   type Event is record
      Begun, Ended : Instant := Never;
      --  when its first byte and its last were read
      Text         : Unbounded_String;
   end record;

   package Event_Vectors is new Ada.Containers.Vectors (Positive, Event);

   function Frames (Where : Place) return Event_Vectors.Vector;
   --  Commands to the robot, without checksum and end

   function Messages (Where : Place) return Event_Vectors.Vector;
   --  To the monitor, their labels only; "gone" where the other end has closed
   --  the connection

   procedure Forget (Where : Place);
   --  Frames and messages so far

   procedure Serve (For_Time : Duration);
   --  Everything at all places

   procedure Send (Where : Place; Text : String);
   --  From the monitor

   procedure Await_Message
     (Where : Place; Label : String; Count : Positive := 1);
   --  Until so many with one of the labels have come since Forget; raises
   --  Failed after ten seconds

   procedure Set_Unanswered (Where : Place; Frame : String);
   --  The robot does not answer this command, and all others; "": none

   procedure Await_Frame (Where : Place; Text : String; Time : out Instant);
   --  Until this command's end since Forget; its first byte. Raises Failed
   --  after two seconds

   type Exchange is record
      Order  : Duration := 0.0;
      --  from the sending to the first byte at the robot
      Answer : Duration := 0.0;
      --  from the sending of the robot's answer to the monitor
      Clean  : Boolean  := False;
      --  nothing else was on the line meanwhile, and nothing failed
   end record;

   procedure Measure
     (Where   : Place;
      Command : String;
      Frame   : String;
      Result  : out Exchange);
   --  Command is sent, and Frame is what it becomes. The robot answers a
   --  millisecond later

   function Framed (Text : String) return String;
   --  With the checksum and the end

end Both_Ends;
