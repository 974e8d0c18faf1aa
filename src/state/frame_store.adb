--  SPDX-License-Identifier: GPL-3.0-or-later
--  Which task may use which frame slot: the camera's owner fills one after
--  the other, the newest is for whoever takes it first.

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Schedule;

package body Frame_Store with SPARK_Mode is

   type Use_Kind is (Free, Claimed, Newest);
   type Use_Array is array (Vision.Slot) of Use_Kind;

   Changed : Suspension_Object;  --  an image has come, or none will

   protected Store with Priority => Schedule.Vision_Ceiling is
      procedure Begin_Delivery (At_Time : Time);
      procedure End_Delivery;
      procedure Claim_Empty (Slot : out Vision.Slot);
      procedure Publish (Slot : Vision.Slot; At_Time : Time);
      procedure Release (Slot : Vision.Slot);
      procedure Claim_Newest (Slot : out Vision.Slot; Found : out Boolean);
      procedure Get_Delivering (Now : out Boolean);
      procedure Get_Newest_Time (At_Time : out Time);
   private
      Uses        : Use_Array := (others => Free);
      Delivering  : Boolean := False;
      Newest_Time : Time := Time_First;
   end Store;

   protected body Store is

      procedure Drop_Newest is
      begin
         for U of Uses loop
            if U = Newest then
               U := Free;
            end if;
         end loop;
      end Drop_Newest;

      procedure Begin_Delivery (At_Time : Time) is
      begin
         Drop_Newest;
         Delivering := True;
         Newest_Time := At_Time;
      end Begin_Delivery;

      procedure End_Delivery is
      begin
         Drop_Newest;
         Delivering := False;
      end End_Delivery;

      procedure Claim_Empty (Slot : out Vision.Slot) is
      begin
         --  six slots: one with the owner, one newest, one with each of the
         --  two readers, so one is always free
         Slot := Vision.Slot'First;
         for S in Vision.Slot loop
            if Uses (S) = Free then
               Slot := S;
               exit;
            end if;
         end loop;
         Uses (Slot) := Claimed;
      end Claim_Empty;

      procedure Publish (Slot : Vision.Slot; At_Time : Time) is
      begin
         if Delivering then
            Drop_Newest;
            Uses (Slot) := Newest;
            Newest_Time := At_Time;
         else
            Uses (Slot) := Free;
         end if;
      end Publish;

      procedure Release (Slot : Vision.Slot) is
      begin
         Uses (Slot) := Free;
      end Release;

      procedure Claim_Newest (Slot : out Vision.Slot; Found : out Boolean) is
      begin
         Slot := Vision.Slot'First;
         Found := False;
         for S in Vision.Slot loop
            if Uses (S) = Newest then
               Slot := S;
               Found := True;
               Uses (S) := Claimed;
               exit;
            end if;
         end loop;
      end Claim_Newest;

      procedure Get_Delivering (Now : out Boolean) is
      begin
         Now := Delivering;
      end Get_Delivering;

      procedure Get_Newest_Time (At_Time : out Time) is
      begin
         At_Time := Newest_Time;
      end Get_Newest_Time;

   end Store;

   --------------------
   -- Begin_Delivery --
   --------------------

   procedure Begin_Delivery (At_Time : Ada.Real_Time.Time) is
   begin
      Store.Begin_Delivery (At_Time);
   end Begin_Delivery;

   ------------------
   -- End_Delivery --
   ------------------

   procedure End_Delivery is
   begin
      Store.End_Delivery;
      Set_True (Changed);
   end End_Delivery;

   -----------------
   -- Claim_Empty --
   -----------------

   procedure Claim_Empty (Slot : out Vision.Slot) is
   begin
      Store.Claim_Empty (Slot);
   end Claim_Empty;

   -------------
   -- Publish --
   -------------

   procedure Publish (Slot : Vision.Slot; At_Time : Ada.Real_Time.Time) is
   begin
      Store.Publish (Slot, At_Time);
      Set_True (Changed);
   end Publish;

   -------------
   -- Release --
   -------------

   procedure Release (Slot : Vision.Slot) is
   begin
      Store.Release (Slot);
   end Release;

   ------------------
   -- Claim_Newest --
   ------------------

   procedure Claim_Newest (Slot : out Vision.Slot; Found : out Boolean) is
   begin
      Store.Claim_Newest (Slot, Found);
   end Claim_Newest;

   -----------------
   -- Wait_Newest --
   -----------------

   procedure Wait_Newest (Slot : out Vision.Slot; Found : out Boolean) is
      Delivering : Boolean;
   begin
      loop
         Store.Get_Delivering (Delivering);
         Store.Claim_Newest (Slot, Found);
         exit when Found or else not Delivering;
         Suspend_Until_True (Changed);
      end loop;
   end Wait_Newest;

   ---------------------
   -- Get_Newest_Time --
   ---------------------

   procedure Get_Newest_Time (At_Time : out Ada.Real_Time.Time) is
   begin
      Store.Get_Newest_Time (At_Time);
   end Get_Newest_Time;

end Frame_Store;
