--  SPDX-License-Identifier: GPL-3.0-or-later
--  The emulated robot and its arena camera, as a separate process: commands on
--  its standard input, and its record of the wire.

with Ada.Containers.Vectors;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Child_Processes;       use Child_Processes;
with Instants;              use Instants;

package Emulators is

   type Emulator is new Child with private;
   --  Killed at the end of its scope

   procedure Start
     (Object   : in out Emulator;
      Camera   : Boolean;
      Options  : String  := "";
      Terminal : Boolean := True);
   --  With a robot that is ready at once, unless Options say otherwise; its
   --  line is a socket, or where it is to be opened as others do, hung up or
   --  full of noise, a pseudo-terminal (Pseudo_Terminals)

   function Device (Object : Emulator) return String;
   --  Of the robot's line: a link that stays the same when the line returns

   function Camera_Url (Object : Emulator) return String;

   procedure Tell (Object : in out Emulator; Command : String);
   --  Raises Failed unless the answer is ok

   function Status (Object : in out Emulator; Key : String) return String;
   --  A value in the status line, such as "run" of "state"

   function Status_Number
     (Object : in out Emulator; Key : String) return Integer;

   procedure Await_Status (Object : in out Emulator; Key, Value : String);
   --  Raises Failed if it does not become Value

   --  The wire

   type Note is record
      First, Last : Instant := Never;
      --  of the command's bytes
      Command     : Unbounded_String;
      Answer      : Unbounded_String;
      Interval    : Duration := 0.0;
      --  of a reload: since the previous one
   end record;

   package Note_Vectors is new Ada.Containers.Vectors (Positive, Note);
   subtype Notes is Note_Vectors.Vector;

   function Note_Of (Line : String) return Note;
   --  A line of the journal

   procedure Clear_Journal (Object : in out Emulator);

   function Journal (Object : in out Emulator) return Notes;
   --  Since the last clear

   function Wire_Text
     (Object : in out Emulator; Prefixes : String := "MT") return String;
   --  The commands that begin with a character of Prefixes, in their order,
   --  each followed by a blank

   function Count_Of
     (Object : in out Emulator; Command : String) return Natural;

   function Await_On_Wire
     (Object : in out Emulator; Command : String) return Note;
   --  The first such command since the last clear; raises Failed if there is
   --  none

   --  The true pose

   type Truth is record
      X, Y, Heading : Float := 0.0;
      --  cm, cm, degrees
      Cx, Cy        : Float := 0.0;
      Dx, Dy        : Float := 0.0;
      --  pixels
      Angle         : Float := 0.0;
      --  degrees, as the supervisor reports it
   end record;

   function Pose (Object : Emulator) return Truth;
   --  The current pose, from the camera

   procedure Save_Snapshot (Object : Emulator; Path : String);
   --  Saves an image of the camera to a file

private

   type Emulator is new Child with record
      Seen : Natural := 0;
      --  output lines that have been taken
      Link : Unbounded_String;
      Url  : Unbounded_String;
   end record;

end Emulators;
