--  SPDX-License-Identifier: GPL-3.0-or-later
--  The outbox: order of the answers, the newest image, the hold.

with Ada.Real_Time;    use Ada.Real_Time;

with AUnit.Assertions; use AUnit.Assertions;

with Monitor_Protocol; use Monitor_Protocol;
with Orders;           use Orders;
with Outbox;
with Schedule;
with Send_Order;
with Texts;

package body Outbox_Tests is

   use type Outbox.Message_Kind;

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   Data : Outbox.Message_Buffer := (others => ' ');

   Gap : constant := 20;

   procedure Check
     (Kind : Outbox.Message_Kind;
      Text : String;
      Kept : Send_Order.Milliseconds := Gap);
   --  What is taken next, without its line feed, Kept after the one before.

   procedure Begin_Anew;
   --  A session with nothing in it.

   function Place return Ticket;
   --  Of the next command.

   procedure Put_Picture (Text : String);
   --  A periodic image.

   procedure Put_Place (Text : String);
   --  A position.

   procedure Test_Order (T : in out Any_Test);
   procedure Test_Newest (T : in out Any_Test);
   procedure Test_Hold (T : in out Any_Test);
   procedure Test_Hold_Of_Each (T : in out Any_Test);
   procedure Test_Hold_Of_All (T : in out Any_Test);
   procedure Test_Gap (T : in out Any_Test);
   procedure Test_Stale (T : in out Any_Test);
   procedure Test_Full (T : in out Any_Test);

   ----------------
   -- Begin_Anew --
   ----------------

   procedure Begin_Anew is
      Next : Ticket;
   begin
      Outbox.Close_Session (Next);
      Assert (Next > 0, "numbers begin at 1");
      Outbox.Open_Session;
   end Begin_Anew;

   -----------
   -- Check --
   -----------

   procedure Check
     (Kind : Outbox.Message_Kind;
      Text : String;
      Kept : Send_Order.Milliseconds := Gap)
   is
      Taken  : Outbox.Message_Kind;
      Length : Outbox.Message_Length;
   begin
      Outbox.Take (Gap, Kept, Taken, Data, Length);
      Assert (Taken = Kind, Text & ": " & Taken'Image);
      Assert (Data (1 .. Natural'Max (Length - 1, 0)) = Text,
              "text of " & Text);
      Outbox.Sent;
   end Check;

   ----------
   -- Name --
   ----------

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Outbox"));

   -----------
   -- Place --
   -----------

   function Place return Ticket is
      Number : Ticket;
      Open   : Boolean;
   begin
      Outbox.Reserve (Number, Open);
      Assert (Open, "reserved");
      return Number;
   end Place;

   -----------------
   -- Put_Picture --
   -----------------

   procedure Put_Picture (Text : String) is
      Made : Outbox.Generation;
   begin
      Outbox.Get_Generation (Made);
      Data (1 .. Text'Length) := Text;
      Data (Text'Length + 1) := ASCII.LF;
      Outbox.Put_Image (Data, Text'Length + 1, Made);
   end Put_Picture;

   ---------------
   -- Put_Place --
   ---------------

   procedure Put_Place (Text : String) is
      Made : Outbox.Generation;
   begin
      Outbox.Get_Generation (Made);
      Outbox.Put_Position (Text & ASCII.LF, Made);
   end Put_Place;

   --------------------
   -- Register_Tests --
   --------------------

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Order'Access, "answers in order");
      Register_Routine (T, Test_Newest'Access, "the newest image wins");
      Register_Routine (T, Test_Hold'Access, "rule 7: the hold");
      Register_Routine
        (T, Test_Hold_Of_Each'Access, "each command has its hold");
      Register_Routine
        (T, Test_Hold_Of_All'Access, "commands without end hold no longer");
      Register_Routine (T, Test_Gap'Access, "the gap and the turns");
      Register_Routine (T, Test_Stale'Access, "numbers out of date");
      Register_Routine (T, Test_Full'Access, "room for 256");
   end Register_Tests;

   ---------------
   -- Test_Full --
   ---------------

   procedure Test_Full (T : in out Any_Test) is
      pragma Unreferenced (T);
      First, Last : Ticket;
      Count       : Order_Count;
   begin
      Begin_Anew;
      First := Place;
      for I in 2 .. Capacity loop
         Last := Place;
         Assert (Last = First + Ticket (I) - 1, "numbers in a row");
      end loop;
      Outbox.Get_Waiting (Count);
      Assert (Count = Capacity, "full");
      Outbox.Answer (First, Acknowledged);
      Check (Outbox.Answer, "AACK");
      Assert (Place = First + Capacity, "room again");
   end Test_Full;

   ---------------
   -- Test_Hold --
   ---------------

   procedure Test_Hold (T : in out Any_Test) is
      pragma Unreferenced (T);
      First, Second : Ticket;
   begin
      Begin_Anew;
      First := Place;
      Second := Place;
      Outbox.Put_Battery (Battery_Full);
      Put_Picture ("MIMG:one");
      Outbox.End_Hold;
      Check (Outbox.Nothing, "");
      delay until Clock + Schedule.Hold_Limit;
      Outbox.End_Hold;
      Outbox.Answer (First, Acknowledged);
      Outbox.Answer (Second, Refused);
      Check (Outbox.Answer, "AACK");
      Check (Outbox.Unasked, "RBLV:2");
      Check (Outbox.Answer, "ACRJ");
      Check (Outbox.Unasked, "MIMG:one");
   end Test_Hold;

   ----------------------
   -- Test_Hold_Of_All --
   ----------------------

   procedure Test_Hold_Of_All (T : in out Any_Test) is
      pragma Unreferenced (T);
      --  A command each 10 ms, answered at once, leaves no gap of 20 ms
      Any      : Boolean;
      At_Time  : Time;
      First_End : Time := Time_Last - Schedule.Hold_Limit;
      Number   : Ticket;
      Taken    : Outbox.Message_Kind := Outbox.Answer;
      Length   : Outbox.Message_Length;
      Answered : Natural := 0;
   begin
      Begin_Anew;
      Outbox.Answer (Place, Acknowledged);
      Check (Outbox.Answer, "AACK");
      Outbox.Put_Battery (Battery_Full);
      Outbox.Get_Hold_End (Any, At_Time);
      Assert (not Any, "no command waits");
      for Turn in 1 .. 1_000 loop
         Number := Place;
         Outbox.Get_Hold_End (Any, At_Time);
         Assert (Any, "there is a hold");
         First_End := (if Turn = 1 then At_Time else First_End);
         Assert
           (At_Time <= First_End + Schedule.Hold_Limit, "held too long");
         Outbox.Answer (Number, Acknowledged);
         Check (Outbox.Answer, "AACK");
         Answered := Answered + 1;
         delay until Clock + Milliseconds (10);
         if Clock >= At_Time then
            Outbox.End_Hold;
         end if;
         Outbox.Take (Gap, 10, Taken, Data, Length);
         Outbox.Sent;
         exit when Taken = Outbox.Unasked;
      end loop;
      Assert (Taken = Outbox.Unasked, "held back for ever");
      Assert (Clock >= At_Time, "not held back");
      Assert (Answered > 1, "too few commands");
   end Test_Hold_Of_All;

   -----------------------
   -- Test_Hold_Of_Each --
   -----------------------

   procedure Test_Hold_Of_Each (T : in out Any_Test) is
      pragma Unreferenced (T);
      --  However long unasked ones have waited for a slow monitor
      Number  : Ticket;
      Any     : Boolean;
      First   : Time;
      Second  : Time;
      Now     : Time;
   begin
      Begin_Anew;
      Number := Place;
      Outbox.Put_Battery (Battery_Full);
      Put_Picture ("MIMG:one");
      Outbox.Get_Hold_End (Any, First);
      Assert (Any, "there is a hold");
      Outbox.Answer (Number, Acknowledged);
      Check (Outbox.Answer, "AACK");
      Check (Outbox.Unasked, "RBLV:2");
      Now := Clock;
      Number := Place;
      Outbox.Get_Hold_End (Any, Second);
      Assert (Any and then Second >= Now + Schedule.Hold_Limit,
              "not the hold of the second command");
      delay until First;
      Outbox.End_Hold;
      if Clock < Second then
         Check (Outbox.Nothing, "");
      end if;
      delay until Second;
      Outbox.End_Hold;
      Check (Outbox.Unasked, "MIMG:one");
      Outbox.Answer (Number, Acknowledged);
      Check (Outbox.Answer, "AACK");
   end Test_Hold_Of_Each;

   --------------
   -- Test_Gap --
   --------------

   procedure Test_Gap (T : in out Any_Test) is
      pragma Unreferenced (T);

      procedure Check_Gap (Expected : Send_Order.Milliseconds);

      procedure Check_Gap (Expected : Send_Order.Milliseconds) is
         Value : Send_Order.Milliseconds;
      begin
         Outbox.Get_Gap (Gap, Value);
         Assert (Value = Expected, "the gap is" & Value'Image);
      end Check_Gap;

   begin
      Begin_Anew;
      Put_Place ("CPOS:one");
      Put_Picture ("MIMG:one");
      Check_Gap (0);
      Check (Outbox.Unasked, "MIMG:one", Kept => 0);
      Check_Gap (20);
      Put_Picture ("MIMG:two");
      Put_Place ("CPOS:two");
      Check (Outbox.Nothing, "", Kept => 19);
      Check (Outbox.Unasked, "CPOS:two");
      Outbox.Answer (Place, Acknowledged);
      Check_Gap (4);
      Check (Outbox.Answer, "AACK", Kept => 4);
      Check_Gap (20);
      Check (Outbox.Nothing, "", Kept => 4);
      Check (Outbox.Unasked, "MIMG:two");
      Check_Gap (0);
      Check (Outbox.Nothing, "");
   end Test_Gap;

   -----------------
   -- Test_Newest --
   -----------------

   procedure Test_Newest (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Begin_Anew;
      Put_Picture ("MIMG:one");
      Put_Picture ("MIMG:second");
      Outbox.Put_Text (Texts.To_Text ("hello"));
      Outbox.Put_Robot_Lost;
      Check (Outbox.Unasked, "ATIM");
      Check (Outbox.Unasked, "MSSG:hello");
      Check (Outbox.Unasked, "MIMG:second");
      Check (Outbox.Nothing, "");
      Put_Picture ("MIMG:third");
      Outbox.Stop_Images;
      Check (Outbox.Nothing, "");
   end Test_Newest;

   ----------------
   -- Test_Order --
   ----------------

   procedure Test_Order (T : in out Any_Test) is
      pragma Unreferenced (T);
      First, Second, Third : Ticket;
   begin
      Begin_Anew;
      First := Place;
      Second := Place;
      Third := Place;
      Put_Picture ("MIMG:one");
      Outbox.Answer (Third, Refused);
      Check (Outbox.Nothing, "");
      Outbox.Answer_Nothing (Second);
      Outbox.Answer (First, Acknowledged);
      Outbox.Answer (First, Timed_Out);
      Check (Outbox.Answer, "AACK");
      Check (Outbox.Answer, "ACRJ");
      Check (Outbox.Unasked, "MIMG:one");
   end Test_Order;

   ----------------
   -- Test_Stale --
   ----------------

   procedure Test_Stale (T : in out Any_Test) is
      pragma Unreferenced (T);
      Old, Now : Ticket;
   begin
      Begin_Anew;
      Old := Place;
      Begin_Anew;
      Now := Place;
      Assert (Now > Old, "no number twice");
      Outbox.Answer (Old, Refused);
      Outbox.Answer (Now + 1, Refused);
      Check (Outbox.Nothing, "");
      Outbox.Answer (Now, Acknowledged);
      Check (Outbox.Answer, "AACK");
   end Test_Stale;

end Outbox_Tests;
