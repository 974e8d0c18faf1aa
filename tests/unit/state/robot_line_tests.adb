--  SPDX-License-Identifier: GPL-3.0-or-later
--  The line's requests: urgency, void movements, places kept.

with AUnit.Assertions; use AUnit.Assertions;

with Ada.Real_Time;
with Line_Requests;    use Line_Requests;
with Orders;           use Orders;
with Robot_Line;
with Robot_Session;

package body Robot_Line_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   function Numbered (Number, Rank, After : Ticket) return Order is
     ((Number => Number, Rank => Rank, After => After, others => <>));

   procedure Ask
     (From  : Client;
      Kind  : Robot_Session.Request_Kind;
      Order : Orders.Order := (others => <>));
   --  A request of From.

   procedure Check
     (From : Client; Verdict : Verdict_Kind := Carry_Out);
   --  The next job is From's, and is done.

   procedure Test_Urgency (T : in out Any_Test);
   procedure Test_Overtaken (T : in out Any_Test);
   procedure Test_Places (T : in out Any_Test);
   procedure Test_Out_Of_Date (T : in out Any_Test);
   procedure Test_Many_Stops (T : in out Any_Test);

   ---------
   -- Ask --
   ---------

   procedure Ask
     (From  : Client;
      Kind  : Robot_Session.Request_Kind;
      Order : Orders.Order := (others => <>)) is
   begin
      Robot_Line.Put (From, (Kind => Kind, others => <>), Order);
   end Ask;

   -----------
   -- Check --
   -----------

   procedure Check
     (From : Client; Verdict : Verdict_Kind := Carry_Out)
   is
      Next  : Job;
      Found : Boolean;
   begin
      Robot_Line.Take (Next, Found);
      Assert (Found and then Next.From = From,
              From'Image & " expected, not " & Next.From'Image);
      Assert (Next.Verdict = Verdict, From'Image & Next.Verdict'Image);
      Robot_Line.Finish
        (Next, (Line_Open => True, others => <>), (others => <>),
         Ada.Real_Time.Clock);
   end Check;

   ----------
   -- Name --
   ----------

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Robot_Line"));

   --------------------
   -- Register_Tests --
   --------------------

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Urgency'Access, "the most urgent first");
      Register_Routine (T, Test_Overtaken'Access,
                        "a movement older than a stop is void");
      Register_Routine (T, Test_Places'Access,
                        "orders that change the session keep their place");
      Register_Routine (T, Test_Out_Of_Date'Access,
                        "orders of a session that has ended");
      Register_Routine (T, Test_Many_Stops'Access,
                        "stops without end do not starve the reload");
   end Register_Tests;

   ---------------------
   -- Test_Many_Stops --
   ---------------------

   procedure Test_Many_Stops (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Robot_Line.Begin_Session (400);
      Ask (Reload, Robot_Session.Reload, (others => <>));
      Ask (Move, Robot_Session.Drive, Numbered (399, 0, 0));
      for Number in Orders.Ticket range 400 .. 402 loop
         Robot_Line.Put_Stop (Numbered (Number, 0, 0));
      end loop;
      Check (Stop_Order);
      Check (Reload);
      Check (Stop_Order);
      --  nothing else goes before a stop
      Check (Stop_Order);
      Check (Move, Out_Of_Date);
   end Test_Many_Stops;

   ----------------------
   -- Test_Out_Of_Date --
   ----------------------

   procedure Test_Out_Of_Date (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Robot_Line.Begin_Session (300);
      Ask (Reset, Robot_Session.Reset, Numbered (301, 7, 5));
      Robot_Line.Put_Stop (Numbered (302, 0, 0));
      Robot_Line.Begin_Session (310);
      Check (Reset, Out_Of_Date);

      --  and does not count among the orders of the new one

      Ask (Open, Robot_Session.Open_Line, Numbered (310, 1, 0));
      Check (Open);
   end Test_Out_Of_Date;

   --------------------
   -- Test_Overtaken --
   --------------------

   procedure Test_Overtaken (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Robot_Line.Begin_Session (200);
      Ask (Move, Robot_Session.Drive, Numbered (200, 1, 0));
      Robot_Line.Put_Stop (Numbered (201, 0, 0));
      Check (Stop_Order);
      Check (Move, Overtaken);
      Ask (Move, Robot_Session.Drive, Numbered (202, 2, 0));
      Check (Move);
   end Test_Overtaken;

   -----------------
   -- Test_Places --
   -----------------

   procedure Test_Places (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Robot_Line.Begin_Session (100);
      Ask (Move, Robot_Session.Drive, Numbered (103, 4, 3));
      Ask (Reset, Robot_Session.Reset, Numbered (102, 3, 1));
      Ask (Query, Robot_Session.Ping, Numbered (101, 2, 1));
      Ask (Open, Robot_Session.Open_Line, Numbered (100, 1, 0));
      Robot_Line.Put_Stop (Numbered (104, 0, 3));
      Check (Stop_Order);
      Check (Open);
      Check (Query);
      Check (Reset);
      Check (Move, Overtaken);
   end Test_Places;

   ------------------
   -- Test_Urgency --
   ------------------

   procedure Test_Urgency (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Robot_Line.Begin_Session (10);
      Ask (Keep_Alive, Robot_Session.Keep_Alive);
      Ask (Query, Robot_Session.Ping, Numbered (11, 2, 0));
      Ask (Battery, Robot_Session.Get_Battery);
      Ask (Move, Robot_Session.Drive, Numbered (13, 3, 0));
      Ask (Reload, Robot_Session.Reload);
      Robot_Line.Put_Stop (Numbered (12, 0, 0));
      Ask (Safe_State, Robot_Session.Close_Line);
      Check (Safe_State);
      Check (Stop_Order);
      Check (Reload);
      Check (Move);
      Check (Battery);
      Check (Query);
      Check (Keep_Alive);
   end Test_Urgency;

end Robot_Line_Tests;
