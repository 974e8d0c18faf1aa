--  SPDX-License-Identifier: GPL-3.0-or-later

package body Robot.Clients with SPARK_Mode is

   procedure Signal (Who : Robot.Requests.Client) is
   begin
      case Who is
         when Robot.Requests.Safe_State     => Safe_State.Signal;
         when Robot.Requests.Stop_Order     => null;
         when Robot.Requests.Reload         => Reload.Signal;
         when Robot.Requests.Move           => Move.Signal;
         when Robot.Requests.Mission        => Mission.Signal;
         when Robot.Requests.Battery        => Battery.Signal;
         when Robot.Requests.Open           => Open.Signal;
         when Robot.Requests.Start          => Start.Signal;
         when Robot.Requests.Start_Watchdog => Start_Watchdog.Signal;
         when Robot.Requests.Reset          => Reset.Signal;
         when Robot.Requests.Query          => Query.Signal;
         when Robot.Requests.Keep_Alive     => Keep_Alive.Signal;
      end case;
   end Signal;

end Robot.Clients;
