--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Users with SPARK_Mode is

   procedure Signal (Who : Task_Name; Number : Orders.Ticket := 0) is
   begin
      case Who is
         when Th_Open_Com_Robot => Open_Com.Signal (Number);
         when Th_Start_Robot    => Start.Signal (Number);
         when Th_Start_Robot_WD => Start_WD.Signal (Number);
         when Th_Reset_Robot    => Reset.Signal (Number);
         when Th_Move           => Move.Signal (Number);
         when Th_Battery_Level  => Battery.Signal (Number);
         when Th_Mission        => Mission.Signal (Number);
         when Th_Com_Mon_Perdue => Monitor_Lost.Signal (Number);
         when others            => null;
      end case;
   end Signal;

end Robot.Users;
