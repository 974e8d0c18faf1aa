--  SPDX-License-Identifier: GPL-3.0-or-later
--  The words of the console and of scripts: what each asks for, and the
--  command that it sends to the supervisor.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package Words is

   type Message_Class is (Image, Position, Robot, Battery);
   --  What can be waited for. Robot: a position with a robot in it.

   type Action_Kind is
     (Nothing,       --  an empty line, a comment
      Send,          --  Text: the line to send; Attempts: at most so often
      Pause,         --  Seconds
      Wait_Message,  --  Awaited
      Expect,        --  Text: how the last answer is to begin
      Save,          --  Text: the file, empty where it was left out
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
   --  What Line asks for. Words may be in capitals or small letters; a
   --  line that begins with four capitals, alone or before a colon, is
   --  sent as it stands.

   function Name (Class : Message_Class) return String;
   --  The word for it

   function Is_Acknowledged (Answer : String) return Boolean;
   --  It is what was asked for: AACK, a value or an image

   function Is_As_Expected (Answer : String; Wanted : String) return Boolean;
   --  Wanted is its label, or all of it

   procedure List (Put_Line : not null access procedure (Line : String));
   --  The words, explained

end Words;
