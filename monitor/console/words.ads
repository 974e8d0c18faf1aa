--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command language of the console and of scripts: actions, and the
--  commands sent to the supervisor.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package Words is

   type Message_Class is (Image, Position, Robot, Battery, Mission);
   --  Messages that can be awaited. Robot: a position with a robot in it.
   --  Mission: the end of the mission that was asked for last.

   type Action_Kind is
     (Nothing,       --  an empty line, a comment
      Send,          --  Text: the line to send, up to Attempts times
      Pause,         --  Seconds
      Wait_Message,  --  Awaited
      Expect,        --  Text: expected beginning of the last answer
      Save,          --  Text: the file, empty if omitted
      Help,
      Quit,
      Mistake);      --  Text: what is wrong

   type Action is record
      Kind     : Action_Kind      := Nothing;
      Text     : Unbounded_String := Null_Unbounded_String;
      Attempts : Positive         := 1;
      Seconds  : Duration         := 0.0;
      Awaited  : Message_Class    := Image;
   end record;

   function Translate (Line : String) return Action;
   --  The action of Line, in upper or lower case. A line that begins with four
   --  capitals, alone or before a colon, is sent unchanged.

   function Name (Class : Message_Class) return String;
   --  Its name

   function Is_Acknowledged (Answer : String) return Boolean;
   --  A positive answer: AACK, a value or an image

   function Is_As_Expected (Answer : String; Wanted : String) return Boolean;
   --  Wanted is its label, or all of it

   procedure List (Put_Line : not null access procedure (Line : String));
   --  The help text

end Words;
