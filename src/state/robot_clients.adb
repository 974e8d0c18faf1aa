--  SPDX-License-Identifier: GPL-3.0-or-later
--  The clients of the robot's line, one for each task that asks.

package body Robot_Clients with SPARK_Mode is

   ------------
   -- Signal --
   ------------

   procedure Signal (Who : Line_Requests.Client) is
   begin
      case Who is
         when Line_Requests.Safe_State     => Safe_State.Signal;
         when Line_Requests.Stop_Order     => null;
         when Line_Requests.Reload         => Reload.Signal;
         when Line_Requests.Move           => Move.Signal;
         when Line_Requests.Battery        => Battery.Signal;
         when Line_Requests.Open           => Open.Signal;
         when Line_Requests.Start          => Start.Signal;
         when Line_Requests.Start_Watchdog => Start_Watchdog.Signal;
         when Line_Requests.Reset          => Reset.Signal;
         when Line_Requests.Query          => Query.Signal;
         when Line_Requests.Keep_Alive     => Keep_Alive.Signal;
      end case;
   end Signal;

end Robot_Clients;
