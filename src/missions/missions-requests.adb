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

      procedure Take
        (Item : in out Commands.Order; What : out Path; Found : out Boolean) is
      begin
         Found := Waits;
         What := Points;
         if Found then
            Waits := False;
            Item := Wanted;
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
      Found : Boolean;
   begin
      loop
         Arrived.Wait;
         Place.Take (Order, What, Found);
         exit when Found;
      end loop;
      Trace.Put (Trace.Take, Schedule.Th_Mission, Order.Number);
      Order.Owed := True;
   end Wait;

end Missions.Requests;
