--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Users with SPARK_Mode is

   procedure Set (Who : Task_Name; Number : Commands.Ticket) is
   begin
      case Who is
         when Th_Open_Com_Robot => Open_Com.Set (Number);
         when Th_Start_Robot    => Start.Set (Number);
         when Th_Start_Robot_WD => Start_WD.Set (Number);
         when Th_Reset_Robot    => Reset.Set (Number);
         when Th_Move           => Move.Set (Number);
         when Th_Battery_Level  => Battery.Set (Number);
         when Th_Mission        => Mission.Set (Number);
         when Th_Com_Mon_Perdue => Monitor_Lost.Set (Number);
         when others            => null;
      end case;
   end Set;

end Robot.Users;
