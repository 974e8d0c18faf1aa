--  SPDX-License-Identifier: GPL-3.0-or-later

package body Vision.Mode with SPARK_Mode is

   procedure Begin_Session (S : out State; Number : Ticket) is
   begin
      S := (First => Number, others => <>);
   end Begin_Session;

   procedure Ask_Open
     (S       : in out State;
      Number  : Ticket;
      Needed  : out Boolean;
      Is_Open : out Boolean) is
   begin
      Needed := Counts (S, Number) and then S.Stage = Closed;
      Is_Open := Counts (S, Number) and then Vision.Mode.Is_Open (S);
      if Needed then
         S.Stage := Opening;
      end if;
   end Ask_Open;

   procedure Opened
     (S       : in out State;
      Number  : Ticket;
      Success : Boolean;
      Is_Open : out Boolean) is
   begin
      Is_Open := False;
      if Counts (S, Number) and then S.Stage = Opening then
         S.Stage := (if Success then Streaming else Closed);
         Is_Open := Success;
      end if;
   end Opened;

   procedure Close (S : in out State; Was_Open : out Boolean) is
   begin
      Was_Open := Is_Open (S);
      Begin_Session (S, S.First);
   end Close;

   procedure Close_By_Order
     (S : in out State; Number : Ticket; Done : out Boolean) is
   begin
      Done := Counts (S, Number);
      if Done then
         Begin_Session (S, S.First);
      end if;
   end Close_By_Order;

   procedure Ask_Arena
     (S : in out State; Number : Ticket; Accepted : out Boolean) is
   begin
      Accepted := Counts (S, Number) and then Is_Open (S);
      if Accepted then
         S.Stage := Searching;
      end if;
   end Ask_Arena;

   procedure Searched
     (S      : in out State;
      Number : Ticket;
      Found  : Boolean;
      Arena  : Arena_Corners;
      Valid  : out Boolean) is
   begin
      Valid := Counts (S, Number) and then S.Stage = Searching;
      if Valid then
         S.Stage := (if Found then Deciding else Streaming);
         S.Candidate := Arena;
      end if;
   end Searched;

   procedure Decide
     (S       : in out State;
      Number  : Ticket;
      Confirm : Boolean;
      Valid   : out Boolean) is
   begin
      Valid := Counts (S, Number) and then S.Stage = Deciding;
      if Valid then
         S.Stage := Streaming;
         S.Confirmed := Confirm;
         S.Arena := (if Confirm then S.Candidate else No_Arena);
      end if;
   end Decide;

   procedure Ask_Position
     (S        : in out State;
      Number   : Ticket;
      On       : Boolean;
      Accepted : out Boolean) is
   begin
      Accepted := Counts (S, Number) and then (Is_Open (S) or else not On);
      if Accepted then
         S.Position_On := On;
      end if;
   end Ask_Position;

end Vision.Mode;
