--  SPDX-License-Identifier: GPL-3.0-or-later
--  Results of missions as JSON, one object a line.

with Mission_Judges; use Mission_Judges;
with Mission_Plans;  use Mission_Plans;

package Mission_Lines is

   function Line
     (Kind : String; P : Plan; V : Verdict; Repeated : Natural := 0)
      return String;

   function Line (Kind : String; P : Plan; Failure : String) return String;
   --  One that could not be judged

end Mission_Lines;
