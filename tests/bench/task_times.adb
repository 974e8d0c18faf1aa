--  SPDX-License-Identifier: GPL-3.0-or-later
--  The processor time that the supervisor's tasks use, from the kernel, and
--  beside it what the response-time analysis allows them.

with Ada.Containers.Indefinite_Ordered_Maps;
with Ada.Containers.Vectors;
with Ada.Directories;         use Ada.Directories;
with Ada.Strings;             use Ada.Strings;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Strings.Unbounded;   use Ada.Strings.Unbounded;
with Ada.Text_IO;             use Ada.Text_IO;
with Interfaces.C;            use Interfaces.C;

with Budgets;                 use Budgets;
with Instants;                use Instants;
with Libc;
with Own_Process;
with Reports;
with Response_Times;          use type Response_Times.Microseconds;
with Samples;
with Schedule;
with Supervisor_Model;

package body Task_Times is

   Pause : constant Duration := 0.002;
   --  that ends a run
   Between_Looks : constant Duration := 0.000_4;

   type Thread is record
      Name    : Unbounded_String;
      File    : int      := -1;
      Used    : Duration := 0.0;   --  in all, at the last look
      Run     : Duration := 0.0;   --  in the run under way
      Changed : Instant  := Never; --  when it was last seen to have run
   end record;

   package Thread_Vectors is new Ada.Containers.Vectors (Positive, Thread);

   Threads : Thread_Vectors.Vector;
   Gone    : Boolean := False;  --  one of them: their process is ending

   package Run_Maps is new Ada.Containers.Indefinite_Ordered_Maps
     (String, Samples.Set, "=" => Samples."=");

   Runs : Run_Maps.Map;  --  of the threads by their names

   package Duration_Vectors is new Ada.Containers.Vectors (Positive, Duration);

   Exchange : Duration_Vectors.Vector;
   --  in this one, the runs of the tasks that use the line
   Requests : Samples.Set;
   Answers  : Samples.Set;

   Kept : constant := 15;  --  characters, of a longer name

   function Uses_Line (Name : String) return Boolean is
     (for some Who in
        Schedule.Th_Start_Robot_WD .. Schedule.Th_Battery_Level =>
        Head (Schedule.Name_Of (Who), Kept) = Head (Name, Kept));

   function Budget_Of (Name : Activity_Name) return Duration is
     (Duration (Processor_Time (Name)) / 1_000_000);
   --  The longest of a task's activities. Name: as the kernel keeps it

   task type Watch_Task is
      entry Begin_Exchange;
      entry End_Exchange;
      entry Stop;
   end Watch_Task;

   type Watch_Access is access Watch_Task;

   Watch : Watch_Access;

   function Budget_Of (Name : String) return Duration is
      Most : Response_Times.Span :=
        (if Uses_Line (Name)
         then Processor_Time (Line_Answer) + Processor_Time (Line_Outcome)
         else 0);
   begin
      for A in Activity_Name loop
         if Head (Supervisor_Model.Task_Name (A), Kept) = Head (Name, Kept)
         then
            Most := Response_Times.Span'Max (Most, Processor_Time (A));
         end if;
      end loop;
      return Duration (Most) / 1_000_000;
   end Budget_Of;

   procedure End_Run (Item : in out Thread) is
   begin
      if not Gone then
         --  otherwise it may have been the process's end, not the task's job
         Runs (To_String (Item.Name)).Add (Item.Run);
      end if;
      if Uses_Line (To_String (Item.Name)) then
         Exchange.Append (Item.Run);
      end if;
      Item.Run := 0.0;
   end End_Run;

   procedure Look (Item : in out Thread) is
      Text : String (1 .. 80);
      Got  : constant long :=
        Libc.Pread (Item.File, Text'Address, Text'Length, 0);
      Last : Natural;
      Used : Duration;
      Time : constant Instant := Now;
   begin
      if Got <= 0 then
         Gone := True;
         return;
      end if;
      --  nanoseconds on a processor, waiting for one, times on one
      Last := Index (Text (1 .. Natural (Got)), " ") - 1;
      Used := Duration (Long_Long_Integer'Value (Text (1 .. Last)) / 1_000)
        / 1_000_000;
      if Item.Changed = Never then
         Item.Changed := Time;
      elsif Used > Item.Used then
         Item.Run := Item.Run + (Used - Item.Used);
         Item.Changed := Time;
      elsif Item.Run > 0.0 and then Time - Item.Changed > Pause then
         End_Run (Item);
      end if;
      Item.Used := Used;
   end Look;

   task body Watch_Task is
   begin
      --  it must see the end of each run
      Own_Process.Prefer_Real_Time (True);
      loop
         select
            accept Begin_Exchange;
            Exchange.Clear;
         or
            accept End_Exchange;
            if Exchange.Last_Index = 2 then
               Requests.Add (Exchange (1));
               Answers.Add (Exchange (2));
            end if;
         or
            accept Stop;
            exit;
         or
            delay Between_Looks;
         end select;
         for Item of Threads loop
            Look (Item);
         end loop;
      end loop;
   end Watch_Task;

   procedure Start (Process : Interfaces.C.int; Except : String := "") is
      Folder : constant String :=
        "/proc/" & Trim (int'Image (Process), Both) & "/task";

      procedure Add (Which : Directory_Entry_Type) is
         Place : constant String := Folder & "/" & Simple_Name (Which);
         File  : File_Type;
         Item  : Thread;
         None  : Samples.Set;
      begin
         if Simple_Name (Which) in "." | ".." then
            return;
         end if;
         Open (File, In_File, Place & "/comm");
         Item.Name := To_Unbounded_String (Get_Line (File));
         Close (File);
         if Item.Name = Except then
            return;
         end if;
         Item.File := Libc.Open
           (To_C (Place & "/schedstat"), Libc.O_Rdonly + Libc.O_Cloexec);
         Threads.Append (Item);
         if not Runs.Contains (To_String (Item.Name)) then
            Runs.Insert (To_String (Item.Name), None);
         end if;
      end Add;

   begin
      Threads.Clear;
      Gone := False;
      Search (Folder, "", (Directory => True, others => False), Add'Access);
      Watch := new Watch_Task;
   end Start;

   procedure Begin_Exchange is
   begin
      Watch.Begin_Exchange;
   end Begin_Exchange;

   procedure End_Exchange is
   begin
      Watch.End_Exchange;
   end End_Exchange;

   procedure Stop is
   begin
      Watch.Stop;
      for Item of Threads loop
         Libc.Close (Item.File);
      end loop;
   end Stop;

   procedure Print is

      procedure Put (Name : String; Set : Samples.Set; Budget : Duration) is
      begin
         if Budget > 0.0 then
            Reports.Put (Name, Set, More => Reports.Member ("budget", Budget));
         end if;
      end Put;

   begin
      for Place in Runs.Iterate loop
         Put (Run_Maps.Key (Place), Run_Maps.Element (Place),
              Budget_Of (Run_Maps.Key (Place)));
      end loop;
      Put ("line, request", Requests, Budget_Of (Line_Request));
      Put ("line, answer", Answers,
           Budget_Of (Line_Answer) + Budget_Of (Line_Outcome));
   end Print;

end Task_Times;
