--  SPDX-License-Identifier: GPL-3.0-or-later
--  Matches answers to commands, and waits for answers and for messages of one
--  kind.

with Ada.Real_Time;           use Ada.Real_Time;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;
with Commands;
with Words;

package Exchanges is

   type Command is record
      Text    : Unbounded_String;               --  as it was sent
      Name    : Commands.Command_Name;
      Sent_At : Time;
      Overdue : Boolean := False;               --  reported as unanswered
   end record;

   Capacity : constant := 256;
   --  Commands that may wait for their answers; the supervisor's limit is the
   --  same.

   type Count is range 0 .. Capacity;

   type Command_Array is array (Count range 1 .. Capacity) of Command;

   type Seen_Flags is array (Words.Message_Class) of Boolean;

   protected Exchange is

      procedure Note_Sent (Given : Command; OK : out Boolean);
      --  Given waits for its answer from now on. If too many wait, OK is False
      --  and nothing is changed.

      procedure Match
        (Line     : String;
         Begun_At : Time;
         Found    : out Boolean;
         Given    : out Command);
      --  Line was received, its first byte at Begun_At. Found: it answers
      --  Given. The answers come in the order of the commands. Then Published
      --  must be called.

      procedure Give_Up
        (Before : Time; Found : out Boolean; Given : out Command);
      --  Found: Given was sent before that time and has no answer; it now
      --  counts as unanswered. Then Published must be called.

      procedure Published;
      --  The user has been informed: Settled may open

      entry Settled;
      --  Open when no waiting command can still be answered in time

      function Last_Answer return Unbounded_String;
      --  The last command's answer; its label if it is long; empty if none

      function Unanswered return Natural;
      --  Commands not answered in time, including those waiting now

      function Answered return Natural;
      --  Commands with an answer in time

      procedure Watch (Class : Words.Message_Class);
      --  Messages received before are ignored

      procedure See (Class : Words.Message_Class);

      entry Seen (Words.Message_Class);
      --  Open when such a message has been received since Watch

      procedure See_End (Text : String);
      --  A mission has ended: its text

      function Last_End return Unbounded_String;
      --  That of the last mission; empty if none

      procedure Claim_End (First : out Boolean);
      --  First is True for one caller only: the one that ends the program

      function Is_Ending return Boolean;

      procedure End_Reading;
      --  The supervisor sends nothing more

      entry Reading_Ended;

   private
      Pending : Command_Array;
      Waiting : Count            := 0;
      Due     : Natural          := 0;  --  of these, not overdue
      Untold  : Natural          := 0;  --  found, not yet published
      Missed  : Natural          := 0;
      Served  : Natural          := 0;
      Answer  : Unbounded_String;
      Ended   : Unbounded_String;
      Flags   : Seen_Flags       := (others => False);
      Ending  : Boolean          := False;
      Silent  : Boolean          := False;
   end Exchange;

end Exchanges;
