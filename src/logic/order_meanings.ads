--  SPDX-License-Identifier: GPL-3.0-or-later
--  The meaning of a monitor's order: the request to the robot, the place among
--  the robot's orders, and the answer to the monitor. Decided only here.

with Monitor.Protocol; use Monitor.Protocol;
with Orders;
with Robot.Protocol;
with Robot.Requests;
with Robot.Session;    use Robot.Session;

package Order_Meanings with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Order_Meanings);

   use type Orders.Ticket;

   subtype Robot_Order is Message_Kind range Open_Robot .. Get_State;

   subtype Vision_Order is Message_Kind range Open_Camera .. Stop_Position;

   subtype Arena_Order is Vision_Order range Ask_Arena .. Reject_Arena;
   --  Carried out by th_arene; the other vision orders by th_cameraControl,
   --  and those of Monitor.Protocol.Mission_Order by th_mission

   --  The task that carries it out

   function Client_Of (Kind : Robot_Order) return Robot.Requests.Client is
     (case Kind is
         when Open_Robot | Close_Robot           => Robot.Requests.Open,
         when Start_Robot                        => Robot.Requests.Start,
         when Start_Robot_Watchdog               =>
            Robot.Requests.Start_Watchdog,
         when Reset_Robot | Power_Off_Robot      => Robot.Requests.Reset,
         when Go_Forward .. Go_Right | Move_Robot | Turn_Robot =>
            Robot.Requests.Move,
         when Stop_Robot | Abort_Mission         => Robot.Requests.Stop_Order,
         when Ping_Robot | Reload_Watchdog
            | Monitor.Protocol.Get_Battery | Get_State =>
            Robot.Requests.Query);
   --  Clients of the robot's line; a stop has no task of its own

   --  The request to the robot

   function Request_Of (M : Message) return Request is
     (case M.Kind is
         when Open_Robot           => (Open_Line, others => <>),
         when Close_Robot          => (Close_Line, others => <>),
         when Start_Robot          => (Start, others => <>),
         when Start_Robot_Watchdog => (Start_Watchdog, others => <>),
         when Reset_Robot          => (Reset, others => <>),
         when Power_Off_Robot      => (Power_Off, others => <>),
         when Reload_Watchdog      => (Reload_By_Hand, others => <>),
         when Monitor.Protocol.Get_Battery =>
            (Robot.Session.Get_Battery, others => <>),
         when Get_State            => (Get_Moving, others => <>),
         when Stop_Robot | Abort_Mission => (Stop, others => <>),
         when Go_Forward           => (Drive, Robot.Protocol.Forward),
         when Go_Backward          => (Drive, Robot.Protocol.Backward),
         when Go_Left              => (Drive, Robot.Protocol.Left),
         when Go_Right             => (Drive, Robot.Protocol.Right),
         when Move_Robot           =>
            (Drive, (Robot.Protocol.Move, M.Value)),
         when Turn_Robot           =>
            (Drive, (Robot.Protocol.Turn, M.Value)),
         when others               => (Ping, others => <>));

   --  The place among the robot's orders

   function Has_Rank (Kind : Message_Kind) return Boolean is
     (Kind in Robot_Order
      and then Kind not in Stop_Robot | Abort_Mission);
   --  A stop overtakes all others

   function Changes_Session (M : Message) return Boolean is
     (M.Kind in Robot_Order
      and then Changes_Session (Request_Of (M).Kind));

   function Is_By_Hand (Kind : Message_Kind) return Boolean is
     (Kind in Robot_Order
      and then Kind not in Ping_Robot | Reload_Watchdog
        | Monitor.Protocol.Get_Battery | Get_State);
   --  It moves or stops the robot or changes its session, and so ends a
   --  mission. Questions do not

   type Ranks is record
      Last   : Orders.Ticket := 0;
      --  rank of the session's last ranked order
      Change : Orders.Ticket := 0;
      --  the same of the last that changes the robot's session
   end record;

   procedure Give_Rank (R : in out Ranks; Order : in out Orders.Order)
   with
     Post => Order.Number = Order'Old.Number
       and then Order.Message = Order'Old.Message
       and then Order.Owed = Order'Old.Owed
       and then
         (if Has_Rank (Order.Message.Kind) then
             Order.Rank = R'Old.Last + 1
             and then Order.After = R'Old.Change
             and then R.Last = Order.Rank
             and then R.Change =
               (if Changes_Session (Order.Message) then Order.Rank
                else R'Old.Change)
          else R = R'Old
            and then Order.Rank = 0
            and then Order.After =
              (if Order.Message.Kind in Mission_Order then R.Last else 0));
   --  A mission's orders to the robot follow all earlier ones

   --  The answer to the monitor

   function Answer_To (Kind : Message_Kind; Result : Outcome)
     return Answer_Kind
   is (case Result.Kind is
          when Done                  =>
            (if Kind = Monitor.Protocol.Get_Battery then
                Battery_Answer (Result.Value)
             elsif Kind = Get_State then
               (if Result.Value = 0 then Standing else Moving)
             else Acknowledged),
          when Refused               => Monitor.Protocol.Refused,
          when Timed_Out             => Monitor.Protocol.Timed_Out,
          when Not_Open | Not_Opened => Not_Done);
   --  Answer for a robot order whose request had this Result

   function Answer_To (Done : Boolean) return Answer_Kind is
     (if Done then Acknowledged else Not_Done);
   --  Answer for a vision order

end Order_Meanings;
