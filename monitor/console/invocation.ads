--  SPDX-License-Identifier: GPL-3.0-or-later
--  The arguments of the console monitor.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package Invocation is

   type Options is record
      Host    : Unbounded_String := To_Unbounded_String ("127.0.0.1");
      Port    : Positive         := 5_544;
      Script  : Unbounded_String;         --  empty: the keyboard; "-" too
      Token   : Unbounded_String;         --  a file; empty: no token
      Images  : Unbounded_String;         --  empty: not saved automatically
      Timeout : Duration         := 5.0;  --  s, for an answer
      Quiet   : Boolean          := False;
      Verbose : Boolean          := False;
   end record;

   type Outcome is (Run, Say_Version, Say_Usage, Refuse);

   procedure Read
     (Values : out Options;
      What   : out Outcome;
      Reason : out Unbounded_String);
   --  From the command line. Reason: why it is rejected.

   procedure Put_Usage (Put_Line : not null access procedure (Line : String));

end Invocation;
