--  SPDX-License-Identifier: GPL-3.0-or-later
--  The clients of the robot's line, one for each task that asks.

package body Robot_Clients with SPARK_Mode is

   ------------
   -- Signal --
   ------------

   procedure Signal (Who : Robot_Line.Client) is
   begin
      case Who is
         when Robot_Line.Safe_State     => Safe_State.Signal;
         when Robot_Line.Stop_Order     => null;
         when Robot_Line.Reload         => Reload.Signal;
         when Robot_Line.Move           => Move.Signal;
         when Robot_Line.Battery        => Battery.Signal;
         when Robot_Line.Open           => Open.Signal;
         when Robot_Line.Start          => Start.Signal;
         when Robot_Line.Start_Watchdog => Start_Watchdog.Signal;
         when Robot_Line.Reset          => Reset.Signal;
         when Robot_Line.Query          => Query.Signal;
         when Robot_Line.Keep_Alive     => Keep_Alive.Signal;
      end case;
   end Signal;

end Robot_Clients;
