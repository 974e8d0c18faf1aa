--  SPDX-License-Identifier: GPL-3.0-or-later

with Bounded_Queues;
with Event;
with Schedule; use Schedule;
with Trace;

package body Vision.Turns with SPARK_Mode is

   use type Commands.Ticket;

   package Control_Turn is new Event (Th_Camera_Control);
   package Arena_Turn is new Event (Th_Arene);

   function User_Of (Order : Commands.Order) return Task_Name is
     (Commands.Table (Order.Command.Name).By);

   package Order_Queues is new Bounded_Queues
     (Commands.Order, Commands.Capacity);

   protected Line with Priority => Schedule.Turn_Ceiling is
      procedure Put (Order : Commands.Order; Next : out Commands.Order);
      procedure Take (Who : Task_Name; Order : in out Commands.Order);
      procedure Finish (Next : out Commands.Order);
      procedure Clear;
   private
      Waiting : Order_Queues.Queue;
      In_Use  : Boolean := False;
      --  an order is being carried out
   end Line;

   function Next_Of
     (Waiting : Order_Queues.Queue; In_Use : Boolean) return Commands.Order
   is (if In_Use or else Order_Queues.Length (Waiting) = 0 then (others => <>)
       else Order_Queues.Element_At (Waiting, 1));
   --  Whose turn it is; its number is 0 if it is none's turn

   protected body Line is

      procedure Put (Order : Commands.Order; Next : out Commands.Order) is
      begin
         Order_Queues.Put (Waiting, Order);
         Next := Next_Of (Waiting, In_Use);
      end Put;

      procedure Take (Who : Task_Name; Order : in out Commands.Order) is
         Next : constant Commands.Order := Next_Of (Waiting, In_Use);
      begin
         if Next.Number > 0 and then User_Of (Next) = Who then
            Order := Next;
            Order.Owed := True;
            Order_Queues.Remove_First (Waiting);
            In_Use := True;
         end if;
      end Take;

      procedure Finish (Next : out Commands.Order) is
      begin
         In_Use := False;
         Next := Next_Of (Waiting, In_Use);
      end Finish;

      procedure Clear is
      begin
         Order_Queues.Clear (Waiting);
      end Clear;

   end Line;

   procedure Wake (Next : Commands.Order) is
   begin
      if Next.Number > 0 then
         if User_Of (Next) = Th_Arene then
            Arena_Turn.Set (Next.Number);
         else
            Control_Turn.Set (Next.Number);
         end if;
      end if;
   end Wake;

   procedure Take (Who : Task_Name; Order : in out Commands.Order) is
   begin
      Line.Take (Who, Order);
      if Order.Owed then
         Trace.Put (Trace.Take, Who, Order.Number);
      end if;
   end Take;

   procedure Put (Order : in out Commands.Order) is
      Next : Commands.Order;
   begin
      Order.Owed := False;
      Line.Put (Order, Next);
      Wake (Next);
   end Put;

   procedure Wait_Camera_Control (Order : in out Commands.Order) is
   begin
      loop
         pragma Loop_Invariant (not Order.Owed);
         Control_Turn.Wait;
         Take (Th_Camera_Control, Order);
         exit when Order.Owed;
      end loop;
   end Wait_Camera_Control;

   procedure Wait_Arena (Order : in out Commands.Order) is
   begin
      loop
         pragma Loop_Invariant (not Order.Owed);
         Arena_Turn.Wait;
         Take (Th_Arene, Order);
         exit when Order.Owed;
      end loop;
   end Wait_Arena;

   procedure Finish is
      Next : Commands.Order;
   begin
      Line.Finish (Next);
      Wake (Next);
   end Finish;

   procedure Clear is
   begin
      Line.Clear;
   end Clear;

end Vision.Turns;
