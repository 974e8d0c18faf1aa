--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as the analysis sees it: complete, and sensitive.

with AUnit.Assertions; use AUnit.Assertions;

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings;             use Ada.Strings;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Text_IO;             use Ada.Text_IO;

with Budgets;          use Budgets;
with Response_Times;   use Response_Times;
with Schedule;
with Supervisor_Model; use Supervisor_Model;
with Unit_Runs; use Unit_Runs;

package body Supervisor_Model_Tests is

   Usual : constant Load := (others => <>);

   function Reduced (Name : String) return String is
      --  In lower case, without underlines
      Result : String (Name'Range);
      Last   : Natural := Name'First - 1;
   begin
      for C of Name loop
         if C /= '_' then
            Last := Last + 1;
            Result (Last) := To_Lower (C);
         end if;
      end loop;
      return Result (Name'First .. Last);
   end Reduced;

   function Is_Analysed (Name : String) return Boolean is
     (for some A in Activity_Name =>
        Reduced (Task_Name (A)) = Reduced (Name));

   procedure Check_Tasks (File_Name : String; Found : in out Natural) is
      --  The tasks that it declares are analysed
      Head : constant String := "task ";
      File : File_Type;
   begin
      Open (File, In_File, "src/tasks/" & File_Name);
      while not End_Of_File (File) loop
         declare
            Line : constant String := Trim (Get_Line (File), Both);
            Last : Natural;
         begin
            if Index (Line, Head) = 1 then
               Last := Index (Line & " ", " ", Head'Length + 1) - 1;
               Assert
                 (Is_Analysed (Line (Head'Length + 1 .. Last)),
                  Line & " is not analysed");
               Found := Found + 1;
            end if;
         end;
      end loop;
      Close (File);
   end Check_Tasks;

   procedure Test_Complete is
      Found : Natural := 0;
   begin
      Check_Tasks ("mission_tasks.ads", Found);
      Check_Tasks ("monitor-tasks.ads", Found);
      Check_Tasks ("robot-tasks.ads", Found);
      Check_Tasks ("vision-tasks.ads", Found);
      Check_Tasks ("support_tasks.ads", Found);
      Assert
        (Found = Schedule.Table'Length, "tasks declared:" & Found'Image);
      for Who in Schedule.Task_Name'First
        .. Schedule.Task_Name'Pred (Schedule.Task_Name'Last)
      loop
         Assert
           (Schedule.Table (Who).Priority
            >= Schedule.Table (Schedule.Task_Name'Succ (Who)).Priority,
            Schedule.Name_Of (Who) & " is not in order of priority");
      end loop;
   end Test_Complete;

   procedure Test_Ceilings is
   begin
      Assert (Ceilings_Hold (Of_The_Table), "table");
      Assert (Ceilings_Hold (Of_The_Report), "report");
   end Test_Ceilings;

   procedure Test_Here is
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>), Usual, Result);
      Assert (Result.Settled, "not settled");
      Assert (All_Met (Result), "a deadline is missed");
   end Test_Here;

   procedure Test_Cortex is
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart,
         (Percent => 100 * Cortex_A53_Factor, Second | Many => True), Usual,
         Result);
      Assert (Deadlines_Met (Result), "a deadline is missed");
   end Test_Cortex;

   procedure Test_Flood is
      On    : constant Machine :=
        (Percent => 100 * Cortex_A53_Factor, Second | Many => True);
      Under : Load := Usual;
      Quiet : Analysis;
      Amid  : Analysis;
   begin
      Analyse (Of_The_Table, Real_Time_Apart, On, Under, Quiet);
      Under.Flood := True;
      Analyse (Of_The_Table, Real_Time_Apart, On, Under, Amid);
      Assert (Promises_Kept (Amid), "a promise is broken");
      Assert
        (Amid.Requirements (F12_At_Robot).Bound
           > Quiet.Requirements (F12_At_Robot).Bound,
         "orders do not feel it");
      Assert
        (Amid.Requirements (F2_Admitted).Bound
           > 2 * Amid.Bounds (Newcomer).Finish,
         "newcomers do not wait");
   end Test_Flood;

   procedure Test_Missions is
      Beside  : constant Load := (Mission => True, others => <>);
      Without : Analysis;
      Result  : Analysis;

      procedure Check_Longer (Name : Requirement_Name) is
         --  It waits for what a mission has in progress
      begin
         Assert
           (Result.Requirements (Name).Bound
            > Without.Requirements (Name).Bound,
            Name'Image & " does not feel a mission");
      end Check_Longer;

   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>), Usual, Without);
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>), Beside, Result);
      Assert (All_Met (Result), "a deadline is missed");
      Assert
        (Result.Requirements (Mission_Order).Limit = 100_000,
         "an image and its order have another deadline");
      Assert
        (Without.Requirements (Mission_Order).Limit = 0,
         "orders of missions without missions");
      Check_Longer (F12_At_Robot);
      Check_Longer (F11_Reload);
      Check_Longer (F13_Level);

      Analyse
        (Of_The_Table, Real_Time_Apart,
         (Percent => 100 * Cortex_A53_Factor, Second | Many => True), Beside,
         Result);
      Assert (Deadlines_Met (Result), "a deadline is missed on the A53");
      Assert
        (not Met (Result.Requirements (Mission_Order)),
         "the order is in time on the A53: claim it");
   end Test_Missions;

   procedure Test_Late_Mission is
      Limit  : constant := 50_000;
      --  Schedule.Mission_Order_Limit
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>),
         (Mission => True, others => <>), Result);
      Assert
        (Result.Line (Mission).Start in 20_000 .. Limit - 1,
         "the quiet zone before a reload is not waited for");
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>),
         (Mission => True, Turnaround => 40_000, others => <>), Result);
      Assert
        (Result.Line (Mission).Start = Limit,
         "an order that is sent has waited"
         & Result.Line (Mission).Start'Image);
      Assert
        (not Met (Result.Requirements (Mission_Order)),
         "a slow robot is not seen");
   end Test_Late_Mission;

   procedure Test_Orders is

      procedure Check (Name : Activity_Name; Result : Analysis) is
         --  It waits for an order and for a task that is done, but for less
         --  than those of all tasks at once

         Left_Out : constant array (1 .. 4) of Row_Index :=
           (Row (Stop), Row (Newcomer), Orders_Row, Done_Row);
         Each_One : Activity_Set := Result.Set;
         --  Without these

         function Wait_With_Queries return Span is
            --  If there were no other orders
            Set   : Activity_Set := Each_One;
            Value : Bound;
         begin
            for A in Activity_Name loop
               if A = Line_Outcome
                 or else
                   (A in Move_Order | Move_Done | Open_Order .. Query_Done
                    and then A not in Name | Query_Order | Query_Done)
               then
                  --  an outcome is counted in one of two ways
                  Set (Row (A)).Budget := 0;
               end if;
            end loop;
            Pre_Emptive_Bound (Set, Row (Name), Value);
            return Value.Local;
         end Wait_With_Queries;

         Local : constant Span := Result.Bounds (Name).Local;
         All_Of_Them : Bound;
      begin
         for Other of Left_Out loop
            Each_One (Other).Budget := 0;
         end loop;
         Pre_Emptive_Bound (Each_One, Row (Name), All_Of_Them);
         Assert
           (Local < All_Of_Them.Local,
            Name'Image & " waits for the orders of all tasks");
         Assert
           (Local >= Wait_With_Queries,
            Name'Image & " waits for less than th_query");
      end Check;

      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>), Usual, Result);
      Check (Ping_Due, Result);
      Check (Camera_Order, Result);
      Check (Reset_Order, Result);
   end Test_Orders;

   procedure Test_Report is
      Result : Analysis;
   begin
      Analyse
        (Of_The_Report, One_Processor, (others => <>), Usual, Result);
      Assert (not Met (Result.Requirements (F11_Reload)), "F11");
      Assert (not Met (Result.Requirements (F12_First_Byte)), "F12");
      Assert (Met (Result.Requirements (F2_Admitted)), "F2");
   end Test_Report;

   procedure Test_No_Bound is
      Result : Analysis;
   begin
      Analyse
        (Of_The_Report, One_Processor,
         (Percent => 100 * Cortex_A53_Factor, Second | Many => True), Usual,
         Result);
      Assert
        (not Result.Bounds (Capture).Exists, "images leave time for more");
      Assert
        (not Result.Bounds (Send_Image).Exists,
         "an image is sent in time that is not made in time");
   end Test_No_Bound;

   procedure Test_Slow_Robot is
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>),
         (Turnaround => 40_000, others => <>),
         Result);
      Assert (not Met (Result.Requirements (F11_Reload)), "F11");
      Assert (Met (Result.Requirements (F12_First_Byte)),
              "the processor's part does not depend on the robot");
   end Test_Slow_Robot;

   procedure Test_Slow_Kernel is
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>),
         (Latency => 2_000, others => <>), Result);
      Assert (not Met (Result.Requirements (F12_First_Byte)), "F12");
   end Test_Slow_Kernel;

   procedure Test_Slow_Processor is
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart,
         (Percent => 3_000, Second | Many => True), Usual, Result);
      Assert (not Deadlines_Met (Result), "nothing is missed");
   end Test_Slow_Processor;

   procedure Add_Tests is
   begin
      Add_Test ("every task of src/tasks is analysed", Test_Complete'Access);
      Add_Test ("no ceiling below a caller", Test_Ceilings'Access);
      Add_Test ("every deadline is met", Test_Here'Access);
      Add_Test ("on a Cortex-A53 too", Test_Cortex'Access);
      Add_Test ("a flood of newcomers is borne", Test_Flood'Access);
      Add_Test ("an order follows its image in time", Test_Missions'Access);
      Add_Test ("an order that is late is not sent", Test_Late_Mission'Access);
      Add_Test ("the monitor's orders come one at a time", Test_Orders'Access);
      Add_Test ("the report's priorities miss F11 and F12",
                Test_Report'Access);
      Add_Test ("what is late makes others late", Test_No_Bound'Access);
      Add_Test ("a slow robot is seen", Test_Slow_Robot'Access);
      Add_Test ("a slow kernel is seen", Test_Slow_Kernel'Access);
      Add_Test ("a slow processor is seen", Test_Slow_Processor'Access);
   end Add_Tests;

end Supervisor_Model_Tests;
