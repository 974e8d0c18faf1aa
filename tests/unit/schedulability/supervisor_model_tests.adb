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

package body Supervisor_Model_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   Usual : constant Load := (others => <>);

   function Reduced (Name : String) return String;
   --  In lower case, without underlines

   function Is_Analysed (Name : String) return Boolean is
     (for some A in Activity_Name =>
        Reduced (Task_Name (A)) = Reduced (Name));

   procedure Check_Tasks (File_Name : String; Found : in out Natural);
   --  The tasks that it declares are analysed

   procedure Test_Complete (T : in out Any_Test);
   procedure Test_Ceilings (T : in out Any_Test);
   procedure Test_Here (T : in out Any_Test);
   procedure Test_Cortex (T : in out Any_Test);
   procedure Test_Flood (T : in out Any_Test);
   procedure Test_Missions (T : in out Any_Test);
   procedure Test_Late_Mission (T : in out Any_Test);
   procedure Test_Orders (T : in out Any_Test);
   procedure Test_Report (T : in out Any_Test);
   procedure Test_No_Bound (T : in out Any_Test);
   procedure Test_Slow_Robot (T : in out Any_Test);
   procedure Test_Slow_Kernel (T : in out Any_Test);
   procedure Test_Slow_Processor (T : in out Any_Test);

   function Reduced (Name : String) return String is
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

   procedure Check_Tasks (File_Name : String; Found : in out Natural) is
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

   procedure Test_Complete (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Ceilings (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Assert (Ceilings_Hold (Of_The_Table), "table");
      Assert (Ceilings_Hold (Of_The_Report), "report");
   end Test_Ceilings;

   procedure Test_Here (T : in out Any_Test) is
      pragma Unreferenced (T);
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>), Usual, Result);
      Assert (Result.Settled, "not settled");
      Assert (All_Met (Result), "a deadline is missed");
   end Test_Here;

   procedure Test_Cortex (T : in out Any_Test) is
      pragma Unreferenced (T);
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart,
         (Percent => 100 * Cortex_A53_Factor, Second | Many => True), Usual,
         Result);
      Assert (Deadlines_Met (Result), "a deadline is missed");
   end Test_Cortex;

   procedure Test_Flood (T : in out Any_Test) is
      pragma Unreferenced (T);
      On    : constant Machine :=
        (Percent => 100 * Cortex_A53_Factor, Second | Many => True);
      Under : Load := Usual;
      Quiet : Analysis;
      Amid  : Analysis;
   begin
      Analyse (Of_The_Table, Real_Time_Apart, On, Under, Quiet);
      Under.Flood := True;
      Analyse (Of_The_Table, Real_Time_Apart, On, Under, Amid);
      for R in Requirement_Name loop
         Assert
           (not Always (R) or else R = F13_Level
            or else Met (Amid.Requirements (R)),
            R'Image & " is broken");
      end loop;
      --  F13's level is not kept at this factor
      Assert (not Promises_Kept (Amid), "F13 is kept: claim it");
      Assert
        (Amid.Requirements (F12_At_Robot).Bound
           > Quiet.Requirements (F12_At_Robot).Bound,
         "orders do not feel it");
      Assert
        (Amid.Requirements (F2_Admitted).Bound
           > 2 * Amid.Bounds (Newcomer).Finish,
         "newcomers do not wait");
   end Test_Flood;

   procedure Test_Missions (T : in out Any_Test) is
      pragma Unreferenced (T);
      Beside  : constant Load := (Mission => True, others => <>);
      Without : Analysis;
      Result  : Analysis;

      procedure Check_Longer (Name : Requirement_Name);
      --  It waits for what a mission has in progress

      procedure Check_Longer (Name : Requirement_Name) is
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

   procedure Test_Late_Mission (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Orders (T : in out Any_Test) is
      pragma Unreferenced (T);

      procedure Check (Name : Activity_Name; Result : Analysis);
      --  It waits for an order and for a task that is done, but for less than
      --  those of all tasks at once

      procedure Check (Name : Activity_Name; Result : Analysis) is

         Left_Out : constant array (1 .. 4) of Row_Index :=
           (Row (Stop), Row (Newcomer), Orders_Row, Done_Row);
         Each_One : Activity_Set := Result.Set;
         --  Without these

         function Wait_With_Queries return Span;
         --  If there were no other orders

         function Wait_With_Queries return Span is
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

   procedure Test_Report (T : in out Any_Test) is
      pragma Unreferenced (T);
      Result : Analysis;
   begin
      Analyse
        (Of_The_Report, One_Processor, (others => <>), Usual, Result);
      Assert (not Met (Result.Requirements (F11_Reload)), "F11");
      Assert (not Met (Result.Requirements (F12_First_Byte)), "F12");
      Assert (Met (Result.Requirements (F2_Admitted)), "F2");
   end Test_Report;

   procedure Test_No_Bound (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Slow_Robot (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Slow_Kernel (T : in out Any_Test) is
      pragma Unreferenced (T);
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart, (others => <>),
         (Latency => 2_000, others => <>), Result);
      Assert (not Met (Result.Requirements (F12_First_Byte)), "F12");
   end Test_Slow_Kernel;

   procedure Test_Slow_Processor (T : in out Any_Test) is
      pragma Unreferenced (T);
      Result : Analysis;
   begin
      Analyse
        (Of_The_Table, Real_Time_Apart,
         (Percent => 3_000, Second | Many => True), Usual, Result);
      Assert (not Deadlines_Met (Result), "nothing is missed");
   end Test_Slow_Processor;

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine
        (T, Test_Complete'Access, "every task of src/tasks is analysed");
      Register_Routine
        (T, Test_Ceilings'Access, "no ceiling below a caller");
      Register_Routine (T, Test_Here'Access, "every deadline is met");
      Register_Routine (T, Test_Cortex'Access, "on a Cortex-A53 too");
      Register_Routine
        (T, Test_Flood'Access, "a flood of newcomers is borne");
      Register_Routine
        (T, Test_Missions'Access, "an order follows its image in time");
      Register_Routine
        (T, Test_Late_Mission'Access, "an order that is late is not sent");
      Register_Routine
        (T, Test_Orders'Access, "the monitor's orders come one at a time");
      Register_Routine
        (T, Test_Report'Access, "the report's priorities miss F11 and F12");
      Register_Routine
        (T, Test_No_Bound'Access, "what is late makes others late");
      Register_Routine (T, Test_Slow_Robot'Access, "a slow robot is seen");
      Register_Routine (T, Test_Slow_Kernel'Access, "a slow kernel is seen");
      Register_Routine
        (T, Test_Slow_Processor'Access, "a slow processor is seen");
   end Register_Tests;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Supervisor_Model"));

end Supervisor_Model_Tests;
