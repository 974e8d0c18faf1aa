--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mission that the monitor has asked for, from th_receiveFromMon to
--  th_mission. There is one at a time.

with Commands;
with Schedule;

package Missions.Requests with SPARK_Mode is

   protected Place with Priority => Schedule.Mission_Ceiling is

      procedure Put (Item : Commands.Order; What : Path; Taken : out Boolean);

      procedure Take (Item : in out Commands.Order; What : out Path);
      --  Item is Owed if a mission waits

      procedure Release;
      --  No mission is under way any more. For th_mission only

   private
      Waits   : Boolean := False;
      --  Wanted has not been taken
      Used    : Boolean := False;
      --  a mission waits or is under way
      Wanted  : Commands.Order;
      Points  : Path;
   end Place;

   procedure Put (Order : in out Commands.Order; What : Path)
   with
     Pre => Order.Owed,
     Annotate => (GNATprove, Terminating);
   --  A mission for th_mission, which answers Order then. Order stays Owed if
   --  another mission waits or is under way. For th_receiveFromMon

   procedure Wait (Order : in out Commands.Order; What : out Path)
   with
     Pre  => not Order.Owed,
     Post => Order.Owed;
   --  The next mission; waits for it. It is under way until Release. For
   --  th_mission only: its job lasts until the next call

end Missions.Requests;
