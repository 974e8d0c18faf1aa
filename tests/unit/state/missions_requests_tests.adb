--  SPDX-License-Identifier: GPL-3.0-or-later

with Commands; use Commands;
with Missions;         use Missions;
with Missions.Requests;
with Unit_Runs; use Unit_Runs;

procedure Missions_Requests_Tests is

   procedure Put (Number : Ticket; Points : Point_Count; Taken : Boolean) is
      --  Asks for a mission, which is Taken or stays with the caller
      Order : Commands.Order :=
        (Number  => Number,
         Command => (Commands.Follow_Pixels, 0),
         Owed    => True,
         others  => <>);
   begin
      Missions.Requests.Put (Order, (Count => Points, others => <>));
      Assert (Order.Owed /= Taken, "taken:" & Number'Image);
   end Put;

   procedure Test_One is
      Order : Commands.Order;
      What  : Path;
   begin
      Put (3, 5, Taken => True);
      Put (4, 1, Taken => False);
      Missions.Requests.Wait (Order, What);
      Assert (Order.Owed and then Order.Number = 3, "another order");
      Assert (What.Count = 5, "another path");
      Put (5, 1, Taken => False);
      Missions.Requests.Place.Release;
      Put (6, 2, Taken => True);
      Order.Owed := False;
      Missions.Requests.Wait (Order, What);
      Assert (Order.Number = 6 and then What.Count = 2, "the second mission");
      Missions.Requests.Place.Release;
   end Test_One;

   procedure Test_Wait is
      Order : Commands.Order;
      What  : Path;

      task Monitor_Side;

      task body Monitor_Side is
      begin
         delay 0.02;
         Put (9, 64, Taken => True);
      end Monitor_Side;

   begin
      Missions.Requests.Wait (Order, What);
      Assert (Order.Number = 9 and then What.Count = 64, "not that mission");
      Missions.Requests.Place.Release;
   end Test_Wait;

begin
   Run_Test ("none beside one that waits or is under way", Test_One'Access);
   Run_Test ("a mission wakes its task", Test_Wait'Access);
end Missions_Requests_Tests;
