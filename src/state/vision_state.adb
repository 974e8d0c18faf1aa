--  SPDX-License-Identifier: GPL-3.0-or-later
--  The mode of the vision and the arena, shared by the vision's tasks. What
--  an ended session still asks for is refused.

with Schedule;

package body Vision_State with SPARK_Mode is

   use type Orders.Ticket;
   use type Vision_Mode.Stage_Kind;

   protected Store with Priority => Schedule.Vision_Ceiling is
      procedure Begin_Session (Number : Orders.Ticket);
      procedure Get (Value : out View);
      procedure Ask_Open
        (Number  : Orders.Ticket;
         Needed  : out Boolean;
         Is_Open : out Boolean);
      procedure Opened
        (Number : Orders.Ticket; Success : Boolean; Is_Open : out Boolean);
      procedure Close (Was_Open : out Boolean);
      procedure Close_By_Order (Number : Orders.Ticket; Done : out Boolean);
      procedure Ask_Arena (Number : Orders.Ticket; Accepted : out Boolean);
      procedure Searched
        (Number : Orders.Ticket;
         Found  : Boolean;
         Arena  : Shapes.Arena_Corners;
         Valid  : out Boolean);
      procedure Decide
        (Number : Orders.Ticket; Confirm : Boolean; Valid : out Boolean);
      procedure Ask_Position
        (Number : Orders.Ticket; On : Boolean; Accepted : out Boolean);
   private
      First     : Orders.Ticket := 0;
      Current   : View;
      Candidate : Shapes.Arena_Corners := Shapes.No_Arena;
   end Store;

   protected body Store is

      procedure Begin_Session (Number : Orders.Ticket) is
      begin
         First := Number;
         Current := (others => <>);
      end Begin_Session;

      procedure Get (Value : out View) is
      begin
         Value := Current;
      end Get;

      procedure Ask_Open
        (Number  : Orders.Ticket;
         Needed  : out Boolean;
         Is_Open : out Boolean) is
      begin
         Needed := False;
         Is_Open := False;
         if Number >= First
           and then Current.Mode.Stage /= Vision_Mode.Opening
         then
            Vision_Mode.Ask_Open (Current.Mode, Needed);
            Is_Open := not Needed;
         end if;
      end Ask_Open;

      procedure Opened
        (Number : Orders.Ticket; Success : Boolean; Is_Open : out Boolean) is
      begin
         Is_Open := False;
         if Number >= First then
            Vision_Mode.Opened (Current.Mode, Success);
            Is_Open := Vision_Mode.Is_Open (Current.Mode);
         end if;
      end Opened;

      procedure Close (Was_Open : out Boolean) is
      begin
         Was_Open := Vision_Mode.Is_Open (Current.Mode);
         Vision_Mode.Close (Current.Mode);
      end Close;

      procedure Close_By_Order (Number : Orders.Ticket; Done : out Boolean) is
      begin
         Done := Number >= First;
         if Done then
            Vision_Mode.Close (Current.Mode);
         end if;
      end Close_By_Order;

      procedure Ask_Arena (Number : Orders.Ticket; Accepted : out Boolean) is
      begin
         Accepted := False;
         if Number >= First then
            Vision_Mode.Ask_Arena (Current.Mode, Accepted);
         end if;
      end Ask_Arena;

      procedure Searched
        (Number : Orders.Ticket;
         Found  : Boolean;
         Arena  : Shapes.Arena_Corners;
         Valid  : out Boolean) is
      begin
         Valid := Number >= First
           and then Current.Mode.Stage = Vision_Mode.Searching;
         if Valid then
            Vision_Mode.Searched (Current.Mode, Found);
            Candidate := Arena;
         end if;
      end Searched;

      procedure Decide
        (Number : Orders.Ticket; Confirm : Boolean; Valid : out Boolean) is
      begin
         Valid := False;
         if Number >= First then
            Vision_Mode.Decide (Current.Mode, Confirm, Valid);
            if Valid then
               Current.Arena :=
                 (if Confirm then Candidate else Shapes.No_Arena);
            end if;
         end if;
      end Decide;

      procedure Ask_Position
        (Number : Orders.Ticket; On : Boolean; Accepted : out Boolean) is
      begin
         Accepted := False;
         if Number >= First then
            Vision_Mode.Ask_Position (Current.Mode, On, Accepted);
         end if;
      end Ask_Position;

   end Store;

   -------------------
   -- Begin_Session --
   -------------------

   procedure Begin_Session (First : Orders.Ticket) is
   begin
      Store.Begin_Session (First);
   end Begin_Session;

   ---------
   -- Get --
   ---------

   procedure Get (Current : out View) is
   begin
      Store.Get (Current);
   end Get;

   --------------
   -- Ask_Open --
   --------------

   procedure Ask_Open
     (Number : Orders.Ticket; Needed : out Boolean; Is_Open : out Boolean) is
   begin
      Store.Ask_Open (Number, Needed, Is_Open);
   end Ask_Open;

   ------------
   -- Opened --
   ------------

   procedure Opened
     (Number : Orders.Ticket; Success : Boolean; Is_Open : out Boolean) is
   begin
      Store.Opened (Number, Success, Is_Open);
   end Opened;

   -----------
   -- Close --
   -----------

   procedure Close (Was_Open : out Boolean) is
   begin
      Store.Close (Was_Open);
   end Close;

   --------------------
   -- Close_By_Order --
   --------------------

   procedure Close_By_Order (Number : Orders.Ticket; Done : out Boolean) is
   begin
      Store.Close_By_Order (Number, Done);
   end Close_By_Order;

   ---------------
   -- Ask_Arena --
   ---------------

   procedure Ask_Arena (Number : Orders.Ticket; Accepted : out Boolean) is
   begin
      Store.Ask_Arena (Number, Accepted);
   end Ask_Arena;

   --------------
   -- Searched --
   --------------

   procedure Searched
     (Number : Orders.Ticket;
      Found  : Boolean;
      Arena  : Shapes.Arena_Corners;
      Valid  : out Boolean) is
   begin
      Store.Searched (Number, Found, Arena, Valid);
   end Searched;

   ------------
   -- Decide --
   ------------

   procedure Decide
     (Number : Orders.Ticket; Confirm : Boolean; Valid : out Boolean) is
   begin
      Store.Decide (Number, Confirm, Valid);
   end Decide;

   ------------------
   -- Ask_Position --
   ------------------

   procedure Ask_Position
     (Number : Orders.Ticket; On : Boolean; Accepted : out Boolean) is
   begin
      Store.Ask_Position (Number, On, Accepted);
   end Ask_Position;

end Vision_State;
