--  SPDX-License-Identifier: GPL-3.0-or-later

with Event;
with Trace;

package body Missions.Requests with SPARK_Mode is

   package Arrived is new Event (Schedule.Th_Mission);

   protected body Place is

      procedure Put
        (Item : Commands.Order; What : Path; Taken : out Boolean) is
      begin
         Taken := not Used;
         if Taken then
            Used := True;
            Waits := True;
            Wanted := Item;
            Points := What;
         end if;
      end Put;

      procedure Take (Item : in out Commands.Order; What : out Path) is
      begin
         What := Points;
         if Waits then
            Waits := False;
            Item := Wanted;
            Item.Owed := True;
         end if;
      end Take;

      procedure Release is
      begin
         Used := False;
      end Release;

   end Place;

   procedure Put (Order : in out Commands.Order; What : Path) is
      Taken : Boolean;
   begin
      Place.Put (Order, What, Taken);
      if Taken then
         Order.Owed := False;
         Arrived.Set (Order.Number);
      end if;
   end Put;

   procedure Wait (Order : in out Commands.Order; What : out Path) is
   begin
      loop
         Arrived.Wait;
         Place.Take (Order, What);
         exit when Order.Owed;
      end loop;
      Trace.Put (Trace.Take, Schedule.Th_Mission, Order.Number);
   end Wait;

end Missions.Requests;
