--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.State with SPARK_Mode is

   protected body Store is

      procedure Begin_Session (First : Orders.Ticket) is
      begin
         Vision.Mode.Begin_Session (State, First);
      end Begin_Session;

      procedure Get (Current : out Vision.Mode.State) is
      begin
         Current := State;
      end Get;

      procedure Ask_Open
        (Number  : Orders.Ticket;
         Needed  : out Boolean;
         Is_Open : out Boolean) is
      begin
         Vision.Mode.Ask_Open (State, Number, Needed, Is_Open);
      end Ask_Open;

      procedure Opened
        (Number : Orders.Ticket; Success : Boolean; Is_Open : out Boolean) is
      begin
         Vision.Mode.Opened (State, Number, Success, Is_Open);
      end Opened;

      procedure Close (Was_Open : out Boolean) is
      begin
         Vision.Mode.Close (State, Was_Open);
      end Close;

      procedure Close_By_Order (Number : Orders.Ticket; Done : out Boolean) is
      begin
         Vision.Mode.Close_By_Order (State, Number, Done);
      end Close_By_Order;

      procedure Ask_Arena (Number : Orders.Ticket; Accepted : out Boolean) is
      begin
         Vision.Mode.Ask_Arena (State, Number, Accepted);
      end Ask_Arena;

      procedure Searched
        (Number : Orders.Ticket;
         Found  : Boolean;
         Arena  : Vision.Shapes.Arena_Corners;
         Valid  : out Boolean) is
      begin
         Vision.Mode.Searched (State, Number, Found, Arena, Valid);
      end Searched;

      procedure Decide
        (Number : Orders.Ticket; Confirm : Boolean; Valid : out Boolean) is
      begin
         Vision.Mode.Decide (State, Number, Confirm, Valid);
      end Decide;

      procedure Ask_Position
        (Number : Orders.Ticket; On : Boolean; Accepted : out Boolean) is
      begin
         Vision.Mode.Ask_Position (State, Number, On, Accepted);
      end Ask_Position;

   end Store;

end Vision.State;
