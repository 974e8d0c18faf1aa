--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mode of the vision and the arena, shared by the vision's tasks. The
--  object only locks; Vision.Mode decides.

with Orders;
with Schedule;
with Vision.Mode;
with Vision.Shapes;

package Vision.State with SPARK_Mode is

   protected Store with Priority => Schedule.Vision_Ceiling is

      procedure Begin_Session (First : Orders.Ticket);
      --  Sets the initial state; orders with a lower number are refused

      procedure Get (Current : out Vision.Mode.State);

      procedure Ask_Open
        (Number : Orders.Ticket; Needed : out Boolean; Is_Open : out Boolean);
      --  Needed: the camera must be opened now. Is_Open: it is already open.
      --  Neither: the session has ended

      procedure Opened
        (Number : Orders.Ticket; Success : Boolean; Is_Open : out Boolean);
      --  The outcome of the opening. Is_Open is also false if the session has
      --  ended or the camera has failed meanwhile

      procedure Close (Was_Open : out Boolean);
      --  The camera has failed, or the session has ended

      procedure Close_By_Order (Number : Orders.Ticket; Done : out Boolean);
      --  The same, by order of the monitor

      procedure Ask_Arena (Number : Orders.Ticket; Accepted : out Boolean);

      procedure Searched
        (Number : Orders.Ticket;
         Found  : Boolean;
         Arena  : Vision.Shapes.Arena_Corners;
         Valid  : out Boolean);
      --  Valid is false if the search has been cancelled meanwhile

      procedure Decide
        (Number : Orders.Ticket; Confirm : Boolean; Valid : out Boolean);

      procedure Ask_Position
        (Number : Orders.Ticket; On : Boolean; Accepted : out Boolean);

   private
      State : Vision.Mode.State;
   end Store;

end Vision.State;
