--  SPDX-License-Identifier: GPL-3.0-or-later
--  The messages received from the supervisor: shown as lines or in the status
--  line, counted, and summarised at the end.

with Ada.Real_Time; use Ada.Real_Time;

package Accounts is

   procedure Start
     (Connected_At : Time;
      Quiet        : Boolean;
      Each_Message : Boolean;
      Folder       : String);
   --  Each_Message: a line for every image, position and battery level.
   --  Folder: where every image is saved; empty: nowhere.

   procedure Put_Sent (Line : String);
   --  A command is sent

   procedure Put_Unanswered (Line : String; After : Duration);
   --  A command is unanswered

   procedure Take (Line : String; Begun_At : Time; Ended_At : Time)
   with Pre => Line'First = 1;
   --  A line from the supervisor, without its end

   procedure Take_Too_Long (Ended_At : Time);
   --  A line longer than any valid one

   procedure Save_Latest
     (File : String; Saved : out Boolean);
   --  Saves the latest image; empty File: image_NNNN.jpg, NNNN its number. The
   --  result is reported to the user.

   procedure Put_Summary;
   --  To be called after the last Take

end Accounts;
