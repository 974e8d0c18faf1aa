--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Mode_Changes with SPARK_Mode is

   procedure Begin_Session (S : in out State; Number : Orders.Ticket) is
   begin
      S.First := Number;
      S.Seen := (others => <>);
   end Begin_Session;

   procedure Ask_Open
     (S       : in out State;
      Number  : Orders.Ticket;
      Needed  : out Boolean;
      Is_Open : out Boolean) is
   begin
      Needed := False;
      Is_Open := False;
      if Counts (S, Number) and then S.Seen.Mode.Stage /= Vision.Mode.Opening
      then
         Vision.Mode.Ask_Open (S.Seen.Mode, Needed);
         Is_Open := not Needed;
      end if;
   end Ask_Open;

   procedure Opened
     (S       : in out State;
      Number  : Orders.Ticket;
      Success : Boolean;
      Is_Open : out Boolean) is
   begin
      Is_Open := False;
      if Counts (S, Number) then
         Vision.Mode.Opened (S.Seen.Mode, Success);
         Is_Open := Vision.Mode_Changes.Is_Open (S);
      end if;
   end Opened;

   procedure Close (S : in out State; Was_Open : out Boolean) is
   begin
      Was_Open := Is_Open (S);
      Vision.Mode.Close (S.Seen.Mode);
   end Close;

   procedure Close_By_Order
     (S : in out State; Number : Orders.Ticket; Done : out Boolean) is
   begin
      Done := Counts (S, Number);
      if Done then
         Vision.Mode.Close (S.Seen.Mode);
      end if;
   end Close_By_Order;

   procedure Ask_Arena
     (S : in out State; Number : Orders.Ticket; Accepted : out Boolean) is
   begin
      Accepted := False;
      if Counts (S, Number) then
         Vision.Mode.Ask_Arena (S.Seen.Mode, Accepted);
      end if;
   end Ask_Arena;

   procedure Searched
     (S      : in out State;
      Number : Orders.Ticket;
      Found  : Boolean;
      Arena  : Vision.Shapes.Arena_Corners;
      Valid  : out Boolean) is
   begin
      Valid := Counts (S, Number)
        and then S.Seen.Mode.Stage = Vision.Mode.Searching;
      if Valid then
         Vision.Mode.Searched (S.Seen.Mode, Found);
         S.Candidate := Arena;
      end if;
   end Searched;

   procedure Decide
     (S       : in out State;
      Number  : Orders.Ticket;
      Confirm : Boolean;
      Valid   : out Boolean) is
   begin
      Valid := False;
      if Counts (S, Number) then
         Vision.Mode.Decide (S.Seen.Mode, Confirm, Valid);
         if Valid then
            S.Seen.Arena :=
              (if Confirm then S.Candidate else Vision.Shapes.No_Arena);
         end if;
      end if;
   end Decide;

   procedure Ask_Position
     (S        : in out State;
      Number   : Orders.Ticket;
      On       : Boolean;
      Accepted : out Boolean) is
   begin
      Accepted := False;
      if Counts (S, Number) then
         Vision.Mode.Ask_Position (S.Seen.Mode, On, Accepted);
      end if;
   end Ask_Position;

end Vision.Mode_Changes;
