--  SPDX-License-Identifier: GPL-3.0-or-later

with Command_Lines; use Command_Lines;
with Console;
with Process;
with Settings;
with Texts;
pragma Elaborate_All (Console, Process, Settings);

package body Early_Answers with SPARK_Mode => Off is
   --  Off: an elaboration with an effect outside

   Line    : Reading renames Settings.Command_Line;
   Written : Boolean;

begin
   if Line.Request = Wrong then
      Console.Put_Log ("destijl: " & Texts.Image (Line.Reason));
      Console.Put_Log (Usage);
      Process.Leave (Process.Bad_Usage);
   elsif Line.Request in Settled_Kind then
      Console.Put
        ((if Line.Request = Show_Help then Usage else Version), Written);
      if Written then
         Process.Leave (Process.Success);
      end if;
      Console.Cannot_Start ("standard output does not take it");
   end if;
end Early_Answers;
