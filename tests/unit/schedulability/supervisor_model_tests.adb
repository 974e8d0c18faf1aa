--  SPDX-License-Identifier: GPL-3.0-or-later
--  The supervisor as the analysis sees it: complete, and sensitive.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings;             use Ada.Strings;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Text_IO;             use Ada.Text_IO;

with Budgets;          use Budgets;
with Response_Times;   use Response_Times;
with Schedule;
with Supervisor_Model; use Supervisor_Model;
with Unit_Runs; use Unit_Runs;

procedure Supervisor_Model_Tests is

   Cortex : constant Machine :=
     (Percent => 100 * Cortex_A53_Factor, Second | Many => True);

   function Analysed
     (On    : Machine  := (others => <>);
      Under : Load     := (others => <>)) return Analysis is
   begin
      return Result : Analysis do
         Analyse (Of_The_Table, Real_Time_Apart, On, Under, Result);
      end return;
   end Analysed;

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
     ((for some A in Activity_Name =>
         Reduced (Task_Name (A)) = Reduced (Name))
      or else
        (for some Who in Schedule.Task_Name =>
           Reduced (Who'Image) = Reduced (Name)
           and then Schedule.Table (Who).Priority = Schedule.Open_Priority));
   --  What uses the line is analysed as one

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
               Assert (Is_Analysed (Line (Head'Length + 1 .. Last)),
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
      Assert (Found = Schedule.Table'Length, "tasks declared:" & Found'Image);
      for Who in Schedule.Task_Name'First
        .. Schedule.Task_Name'Pred (Schedule.Task_Name'Last)
      loop
         Assert (Schedule.Table (Who).Priority
                 >= Schedule.Table (Schedule.Task_Name'Succ (Who)).Priority,
                 Schedule.Name_Of (Who) & " is not in order of priority");
      end loop;
   end Test_Complete;

   procedure Test_Deadlines is
      Result : constant Analysis := Analysed;
   begin
      Assert (Ceilings_Hold (Of_The_Table), "a ceiling of the table");
      Assert (Ceilings_Hold (Of_The_Report), "a ceiling of the report");
      Assert (Result.Settled, "not settled");
      Assert (All_Met (Result), "a deadline is missed");
      Assert (Deadlines_Met (Analysed (Cortex)), "a deadline on the A53");
   end Test_Deadlines;

   procedure Test_Late_Mission is
      Limit  : constant := 50_000;
      --  Schedule.Mission_Order_Limit
      Result : Analysis := Analysed (Under => (Mission => True, others => <>));
   begin
      Assert (Result.Line (Mission).Start in 20_000 .. Limit - 1,
              "the quiet zone before a reload is not waited for");
      Result := Analysed
        (Under => (Mission => True, Turnaround => 40_000, others => <>));
      Assert (Result.Line (Mission).Start = Limit,
              "an order that is sent has waited"
              & Result.Line (Mission).Start'Image);
      Assert (not Met (Result.Requirements (Mission_At_Robot)),
              "a slow robot is not seen");
   end Test_Late_Mission;

   procedure Test_Slow is
      Robot : constant Analysis :=
        Analysed (Under => (Turnaround => 40_000, others => <>));
   begin
      Assert (not Met (Robot.Requirements (F11_Reload)), "F11");
      Assert (Met (Robot.Requirements (F12_First_Byte)),
              "the processor's part does not depend on the robot");
      Assert
        (not Met
           (Analysed (Under => (Latency => 2_000, others => <>)).Requirements
              (F12_First_Byte)), "a slow kernel is not seen");
      Assert
        (not Deadlines_Met
           (Analysed ((Percent => 3_000, Second | Many => True))),
         "a slow processor is not seen");
   end Test_Slow;

begin
   Run_Test ("every task of src/tasks is analysed", Test_Complete'Access);
   Run_Test ("every deadline is met, on a Cortex-A53 too, and no ceiling is"
             & " below a caller", Test_Deadlines'Access);
   Run_Test ("an order that is late is not sent", Test_Late_Mission'Access);
   Run_Test ("a slow robot, kernel or processor is seen", Test_Slow'Access);
end Supervisor_Model_Tests;
