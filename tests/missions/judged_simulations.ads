--  SPDX-License-Identifier: GPL-3.0-or-later
--  Missions in simulated time, judged as the real ones.

with Mission_Judges; use Mission_Judges;
with Mission_Plans;  use Mission_Plans;

package Judged_Simulations is

   procedure Run (P : Plan; V : out Verdict; Traced : Boolean := False)
     with Pre => P.Count > 0;
   --  Traced: prints what happens

end Judged_Simulations;
