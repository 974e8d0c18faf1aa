--  SPDX-License-Identifier: GPL-3.0-or-later
--  Checks that every command of a session is answered exactly once, in order,
--  although some answers look like unsolicited messages.

with Ada.Containers.Vectors;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Instants;              use Instants;
with Monitor_Clients;       use Monitor_Clients;

package Answer_Ledgers is

   type Answer_Kind is
     (Usual,      --  AACK, ANAK, ACRJ, ATIM or ACER
      Battery,    --  the same, or RBLV, which is also sent unsolicited
      State,      --  the same, or RCST
      Arena,      --  the same, or CIMG, which is also sent unsolicited
      Refused,    --  ACER
      Perhaps,    --  ACER or nothing
      Silent);    --  nothing

   function Kind_Of (Command : String) return Answer_Kind;
   --  Of a well-formed command

   function Is_Answer (Kind : Answer_Kind; Label : String) return Boolean;
   --  Whether a message with this label may be such an answer

   type Ledger is private;

   procedure Clear (L : in out Ledger);
   --  A new session begins

   procedure Put_Command
     (L : in out Ledger; Text : String; Kind : Answer_Kind);
   --  It will be sent now

   procedure Put_Message (L : in out Ledger; Item : Message);
   --  It was received

   function Is_Broken (L : Ledger) return Boolean;
   --  The messages cannot be the answers to the commands, each once and in
   --  order, with unsolicited messages in between

   function Complaint (L : Ledger) return String;
   --  The line that caused it

   function Is_Complete (L : Ledger) return Boolean;
   --  No command waits for its answer

   function Unasked_Losses (L : Ledger) return Natural
     with Pre => not Is_Broken (L);
   --  Minimum number of unsolicited ATIM: one for each loss of the robot

   function Commands (L : Ledger) return Natural;
   function Waiting (L : Ledger) return Natural;
   --  Commands that certainly have no answer

   function First_Waiting (L : Ledger) return String;

private

   type Command is record
      Text : Unbounded_String;
      Kind : Answer_Kind := Usual;
      Time : Instant := Never;
   end record;

   package Command_Vectors is new Ada.Containers.Vectors
     (Positive, Command);

   Impossible : constant Natural := Natural'Last;

   package Cost_Vectors is new Ada.Containers.Vectors (Natural, Natural);
   --  By number of answered commands: the smallest number of unsolicited ATIM
   --  that is consistent with the messages so far, or Impossible

   type Ledger is record
      Sent    : Command_Vectors.Vector;
      Costs   : Cost_Vectors.Vector := Cost_Vectors.To_Vector (0, 1);
      Broken  : Boolean := False;
      Breach  : Unbounded_String;
   end record;

end Answer_Ledgers;
