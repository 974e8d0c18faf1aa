--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Process.Threads;
with Robot.Line;
with Robot.Requests;
with Robot.Service;

package body Robot.Tasks with SPARK_Mode is

   task body Th_Open_Com_Robot is
      Next    : Time := Time_Last;
      Was_Set : Boolean;
   begin
      Process.Threads.Name_Task (Schedule.Th_Open_Com_Robot);
      loop
         Robot.Line.Open_Com.Wait_Until (Next, Was_Set);
         if Was_Set then
            Robot.Service.Serve (Schedule.Th_Open_Com_Robot);
         end if;
         Robot.Line.Look (Robot.Requests.Keep_Alive, Next);
      end loop;
   end Th_Open_Com_Robot;

   task body Th_Start_Robot is
   begin
      Process.Threads.Name_Task (Schedule.Th_Start_Robot);
      loop
         Robot.Line.Start.Wait;
         Robot.Service.Serve (Schedule.Th_Start_Robot);
      end loop;
   end Th_Start_Robot;

   task body Th_Start_Robot_WD is
      Next    : Time := Time_Last;
      Was_Set : Boolean;
   begin
      Process.Threads.Name_Task (Schedule.Th_Start_Robot_WD);
      loop
         Robot.Line.Start_WD.Wait_Until (Next, Was_Set);
         if Was_Set then
            Robot.Service.Serve (Schedule.Th_Start_Robot_WD);
         end if;
         Robot.Line.Look (Robot.Requests.Reload, Next);
      end loop;
   end Th_Start_Robot_WD;

   task body Th_Reset_Robot is
   begin
      Process.Threads.Name_Task (Schedule.Th_Reset_Robot);
      loop
         Robot.Line.Reset.Wait;
         Robot.Service.Serve (Schedule.Th_Reset_Robot);
      end loop;
   end Th_Reset_Robot;

   task body Th_Move is
   begin
      Process.Threads.Name_Task (Schedule.Th_Move);
      loop
         Robot.Line.Move.Wait;
         Robot.Service.Serve (Schedule.Th_Move);
      end loop;
   end Th_Move;

   task body Th_Battery_Level is
      Next    : Time := Time_Last;
      Was_Set : Boolean;
   begin
      Process.Threads.Name_Task (Schedule.Th_Battery_Level);
      loop
         Robot.Line.Battery.Wait_Until (Next, Was_Set);
         if Was_Set then
            Robot.Service.Serve (Schedule.Th_Battery_Level);
         end if;
         Robot.Line.Look (Robot.Requests.Battery, Next);
      end loop;
   end Th_Battery_Level;

end Robot.Tasks;
