--  SPDX-License-Identifier: GPL-3.0-or-later
--  What has come from the supervisor: shown line by line or in the status
--  line, counted, and summed up at the end.

with Ada.Real_Time; use Ada.Real_Time;

package Accounts is

   procedure Start
     (Connected_At : Time;
      Quiet        : Boolean;
      Each_Message : Boolean;
      Folder       : String);
   --  Each_Message: a line for every image, position and battery level.
   --  Folder: where every image is saved; empty for none.

   procedure Put_Sent (Line : String);
   --  A command leaves

   procedure Put_Unanswered (Line : String; After : Duration);
   --  A command has had no answer

   procedure Take (Line : String; Begun_At : Time; Ended_At : Time)
   with Pre => Line'First = 1;
   --  A line from the supervisor, without its end

   procedure Take_Too_Long (Ended_At : Time);
   --  One that is longer than anything the supervisor has to say

   procedure Save_Latest
     (File : String; Saved : out Boolean);
   --  The latest image; empty File: image_NNNN.jpg, NNNN its number. The
   --  user is told.

   procedure Put_Summary;
   --  After the last Take

end Accounts;
