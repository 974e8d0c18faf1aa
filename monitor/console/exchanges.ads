--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which answer belongs to which command, and waiting for answers and for
--  messages of one kind.

with Ada.Real_Time;           use Ada.Real_Time;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;
with Monitor.Protocol;
with Words;

package Exchanges is

   type Command is record
      Text    : Unbounded_String;               --  as it was sent
      Kind    : Monitor.Protocol.Message_Kind;
      Sent_At : Time;
      Overdue : Boolean := False;               --  reported as unanswered
   end record;

   Capacity : constant := 256;
   --  Commands that may wait for their answers; the supervisor reads no
   --  more either.

   type Count is range 0 .. Capacity;

   type Commands is array (Count range 1 .. Capacity) of Command;

   type Seen_Flags is array (Words.Message_Class) of Boolean;

   protected Exchange is

      procedure Note_Sent (Given : Command; OK : out Boolean);
      --  Given waits for its answer from now on. OK is False, and nothing
      --  noted, when too many do already.

      procedure Match
        (Line     : String;
         Begun_At : Time;
         Found    : out Boolean;
         Given    : out Command);
      --  Line has come, its first byte at Begun_At. Found: it answers
      --  Given. The answers come in the order of the commands. Published
      --  is to be called then.

      procedure Give_Up
        (Before : Time; Found : out Boolean; Given : out Command);
      --  Found: Given was sent before that and has no answer; it is
      --  unanswered, whatever comes later. Published is to be called then.

      procedure Published;
      --  The user has been told: Settled may open

      entry Settled;
      --  Open when no command waits that could still be answered in time

      function Last_Answer return Unbounded_String;
      --  The last command's, only its label if it is long; empty if none

      function Unanswered return Natural;
      --  Commands without an answer in time, those waiting now among them

      function Answered return Natural;
      --  Commands with an answer in time

      procedure Watch (Class : Words.Message_Class);
      --  What was seen before this does not count

      procedure See (Class : Words.Message_Class);

      entry Seen (Words.Message_Class);
      --  Open when such a message has come since Watch

      procedure Claim_End (First : out Boolean);
      --  First for one caller only: the one that ends the program

      function Is_Ending return Boolean;

      procedure End_Reading;
      --  Nothing comes from the supervisor any more

      entry Reading_Ended;

   private
      Pending : Commands;
      Waiting : Count            := 0;
      Due     : Natural          := 0;  --  of these, not overdue
      Untold  : Natural          := 0;  --  found, not yet published
      Missed  : Natural          := 0;
      Served  : Natural          := 0;
      Answer  : Unbounded_String;
      Flags   : Seen_Flags       := (others => False);
      Ending  : Boolean          := False;
      Silent  : Boolean          := False;
   end Exchange;

end Exchanges;
