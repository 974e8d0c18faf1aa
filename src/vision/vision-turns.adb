--  SPDX-License-Identifier: GPL-3.0-or-later

with Bounded_Queues;
with Event;
with Schedule; use Schedule;
with Trace;

package body Vision.Turns with SPARK_Mode is

   use type Orders.Ticket;

   package Control_Turn is new Event;
   package Arena_Turn is new Event;

   function User_Of (Order : Orders.Order) return Task_Name is
     (Commands.Table (Order.Command.Name).By);

   package Order_Queues is new Bounded_Queues (Orders.Order, Orders.Capacity);

   protected Line with Priority => Schedule.Turn_Ceiling is
      procedure Put (Order : Orders.Order; Next : out Orders.Order);
      procedure Take
        (Who : Task_Name; Order : in out Orders.Order; Found : out Boolean);
      procedure Finish (Next : out Orders.Order);
      procedure Clear;
   private
      Waiting : Order_Queues.Queue;
      In_Use  : Boolean := False;
      --  an order is being carried out
   end Line;

   protected body Line is

      procedure Put (Order : Orders.Order; Next : out Orders.Order) is
      begin
         Order_Queues.Put (Waiting, Order);
         Next :=
           (if In_Use or else Order_Queues.Length (Waiting) = 0
            then (others => <>) else Order_Queues.Element_At (Waiting, 1));
      end Put;

      procedure Take
        (Who : Task_Name; Order : in out Orders.Order; Found : out Boolean) is
      begin
         Found := not In_Use
           and then Order_Queues.Length (Waiting) > 0
           and then User_Of (Order_Queues.Element_At (Waiting, 1)) = Who;
         if Found then
            Order := Order_Queues.Element_At (Waiting, 1);
            Order_Queues.Remove_First (Waiting);
            In_Use := True;
         end if;
      end Take;

      procedure Finish (Next : out Orders.Order) is
      begin
         In_Use := False;
         Next :=
           (if Order_Queues.Length (Waiting) = 0 then (others => <>)
            else Order_Queues.Element_At (Waiting, 1));
      end Finish;

      procedure Clear is
      begin
         Order_Queues.Clear (Waiting);
      end Clear;

   end Line;

   procedure Wake (Next : Orders.Order)
   with Annotate => (GNATprove, Terminating)
   is
      --  The task of Next; its number is 0 if it is none's turn
   begin
      if Next.Number > 0 then
         Trace.Release (User_Of (Next), Next.Number);
         if User_Of (Next) = Th_Arene then
            Arena_Turn.Set;
         else
            Control_Turn.Set;
         end if;
      end if;
   end Wake;

   procedure Take
     (Who : Task_Name; Order : in out Orders.Order; Found : out Boolean)
   with
     Pre  => not Order.Owed,
     Post => Order.Owed = Found
   is
   begin
      Line.Take (Who, Order, Found);
      Order.Owed := Found;
      if Found then
         Trace.Start (Who, Order.Number);
      else
         Trace.Idle (Who);
      end if;
   end Take;

   procedure Put (Order : in out Orders.Order) is
      Next : Orders.Order;
   begin
      Order.Owed := False;
      Line.Put (Order, Next);
      Wake (Next);
   end Put;

   procedure Wait_Camera_Control (Order : in out Orders.Order) is
      Found : Boolean;
   begin
      Trace.Done (Th_Camera_Control);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Control_Turn.Wait;
         Take (Th_Camera_Control, Order, Found);
         exit when Found;
      end loop;
   end Wait_Camera_Control;

   procedure Wait_Arena (Order : in out Orders.Order) is
      Found : Boolean;
   begin
      Trace.Done (Th_Arene);
      loop
         pragma Loop_Invariant (not Order.Owed);
         Arena_Turn.Wait;
         Take (Th_Arene, Order, Found);
         exit when Found;
      end loop;
   end Wait_Arena;

   procedure Finish is
      Next : Orders.Order;
   begin
      Line.Finish (Next);
      Wake (Next);
   end Finish;

   procedure Clear is
   begin
      Line.Clear;
   end Clear;

end Vision.Turns;
