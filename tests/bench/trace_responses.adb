--  SPDX-License-Identifier: GPL-3.0-or-later
--  The response times of the tasks, out of a file of --trace, beside the
--  bounds of the response-time analysis.

with Ada.Containers.Vectors;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with System.Multiprocessors;

with Bench_Settings;
with Budgets;               use Budgets;
with Busy_Loops;
with Expectations;          use Expectations;
with Instants;              use Instants;
with Libc;
with Monitor_Clients;       use Monitor_Clients;
with Own_Process;
with Programs;
with Reports;
with Response_Times;        use Response_Times;
with Rigs;                  use Rigs;
with Service_Starts;
with Supervisor_Model;      use Supervisor_Model;
with Trace_Files;           use Trace_Files;

package body Trace_Responses is

   Never : constant Nanoseconds := -1;

   type Order is record
      Command : Natural     := 0;
      Time    : Nanoseconds := Never;
   end record;

   package Order_Vectors is new Ada.Containers.Vectors (Positive, Order);

   type Thread_State is record
      Name     : Unbounded_String;
      Waiting  : Order_Vectors.Vector;
      --  releases by other tasks that no job has answered to yet
      Due      : Nanoseconds := Never;
      --  the nominal instant that has just been passed
      Ready    : Nanoseconds := 0;
      --  when the last job ended, or the task found nothing to do
      Depth    : Natural := 0;
      Begun    : Nanoseconds := Never;
      --  the release of the activity under way, Never between activities
      Waited   : Boolean := False;
      --  the job has had a wait
      Stopped  : Nanoseconds := Never;
      --  the beginning of the wait under way
      Sending  : Activity_Name := Send_Answer;
      --  what th_sendToMon has sent in this job
   end record;

   Last_Processor : constant Natural :=
     Natural (System.Multiprocessors.Number_Of_CPUs) - 1;

   Apart : constant Boolean := Last_Processor > 0;

   Command_Pause : constant Duration := 0.05;
   --  Budgets.Command_Interval

   type State_Array is array (Thread_Number) of Thread_State;

   procedure Make (Path : String);
   --  A trace

   procedure Take_Bounds (Apart : Boolean; Result : in out Response_Array);

   procedure Begin_Job (S : in out Thread_State; Item : Event);

   procedure Resume (S : in out Thread_State; Item : Event);

   procedure Add
     (S      : in out Thread_State;
      At_End : Nanoseconds;
      Last   : Boolean;
      Result : in out Response_Array);
   --  The activity under way has ended; Last: and its job

   function Activity_Of (S : Thread_State; Last : Boolean)
     return Activity_Name;

   function Found (S : Thread_State) return Boolean is
     (S.Begun /= Never);

   function Activity_Of (S : Thread_State; Last : Boolean)
     return Activity_Name
   is
      First : Boolean := True;
   begin
      if S.Name = "th_sendToMon" then
         --  up to the gap, where there is one, nothing can be sent
         return (if Last then S.Sending else Environment);
      end if;
      if (S.Name = "th_camera" and then not S.Waited)
        or else ((S.Name = "th_stop" or else S.Name = "th_comMonPerdue")
                 and then S.Waited)
      then
         --  the camera is opened; the end of all is waited for
         return Environment;
      end if;
      --  the first of the task's activities, or its second after a wait
      for Name in Activity_Name loop
         if Task_Name (Name) = S.Name then
            if First and then S.Waited and then Last
              and then Name /= Activity_Name'Last
              and then Task_Name (Activity_Name'Succ (Name)) = S.Name
            then
               First := False;
            else
               return Name;
            end if;
         end if;
      end loop;
      return Environment;
   end Activity_Of;

   procedure Add
     (S      : in out Thread_State;
      At_End : Nanoseconds;
      Last   : Boolean;
      Result : in out Response_Array)
   is
      Name : constant Activity_Name := Activity_Of (S, Last);
      Time : constant Duration :=
        Duration ((At_End - S.Begun) / 1_000) / 1_000_000;
   begin
      if Found (S) and then Name /= Environment then
         Result (Name).Times.Add (Time);
         if Result (Name).Bound > 0.0 and then Time > Result (Name).Bound then
            Result (Name).Above := Result (Name).Above + 1;
         end if;
      end if;
      S.Begun := Never;
   end Add;

   procedure Begin_Job (S : in out Thread_State; Item : Event) is
      Place : Natural := 0;
   begin
      S.Waited := False;
      S.Sending := Send_Answer;
      if S.Due /= Never then
         S.Begun := S.Due;
         S.Due := Never;
      else
         Place := (if S.Waiting.Is_Empty then 0 else 1);
         for I in reverse 1 .. S.Waiting.Last_Index loop
            if Item.Command > 0 and then S.Waiting (I).Command = Item.Command
            then
               Place := I;
            end if;
         end loop;
         if Place > 0 then
            S.Begun := S.Waiting (Place).Time;
            S.Waiting.Delete (Place);
            if S.Name = "th_line" then
               S.Begun := Nanoseconds'Max (S.Begun, S.Ready);
            end if;
         else
            S.Begun := S.Ready;
         end if;
      end if;
      --  a job that is for no command answers to all signals so far, and
      --  one for a command to its own and to those for none
      for I in reverse 1 .. S.Waiting.Last_Index loop
         if Item.Command = 0 or else S.Waiting (I).Command = 0 then
            S.Waiting.Delete (I);
         end if;
      end loop;
   end Begin_Job;

   function Name_Of (Name : Activity_Name) return String is
     (Task_Name (Name)
      & (case Name is
            when Line_Request  => ", request",
            when Line_Answer   => ", answer",
            when Reload_Due | Battery_Due | Ping_Due    => ", due",
            when Reload_Done | Battery_Done | Ping_Done | Move_Done
               | Open_Done | Start_Done | Watchdog_Done | Reset_Done
               | Query_Done => ", done",
            when Move_Order | Open_Order | Start_Order | Watchdog_Order
               | Reset_Order | Query_Order | Camera_Order => ", order",
            when Camera_Answer | Send_Answer => ", answer",
            when Send_Battery  => ", battery",
            when Send_Position => ", position",
            when Send_Image    => ", image",
            when others        => ""));

   procedure Read
     (Path   : String;
      Apart  : Boolean;
      Result : out Response_Array)
   is
      T      : Trace;
      States : State_Array;
   begin
      Result := (others => <>);
      Take_Bounds (Apart, Result);
      Trace_Files.Read (Path, T);
      for Number in Thread_Number loop
         States (Number).Name := T.Threads (Number).Name;
      end loop;
      for Item of T.Events loop
         declare
            S : Thread_State renames States (Item.Thread);
            N : constant String := Name (Item);
         begin
            case Item.Phase is
               when 'B' =>
                  S.Depth := S.Depth + 1;
                  if S.Depth = 1 then
                     Begin_Job (S, Item);
                  else
                     --  what lies between two exchanges of one transaction
                     --  is of both activities: left out
                     if not (S.Name = "th_line" and then S.Waited) then
                        Add (S, Item.Time, False, Result);
                     end if;
                     S.Stopped := Item.Time;
                  end if;
               when 'E' =>
                  S.Depth := S.Depth - 1;
                  if S.Depth = 1 then
                     Resume (S, Item);
                  else
                     Add (S, Item.Time, True, Result);
                     S.Ready := Item.Time;
                  end if;
               when others =>
                  if N = "release" then
                     S.Waiting.Append ((Item.Command, Item.Time));
                  elsif N = "due" then
                     S.Due := Item.Time;
                  elsif N = "idle" then
                     S.Waiting.Clear;
                     S.Ready := Item.Time;
                  elsif N = "out RBLV" then
                     S.Sending := Send_Battery;
                  elsif N = "out CPOS" then
                     S.Sending := Send_Position;
                  elsif N = "out CIMG" then
                     S.Sending := Send_Image;
                  end if;
            end case;
         end;
      end loop;
   end Read;

   procedure Make (Path : String) is
      R      : Rig;
      Load   : Busy_Loops.Load;
      Start  : Instant;
      Number : Natural := 0;
      Unused : Message;
   begin
      Assemble
        (R, Camera => True,
         Supervisor_Options => "--trace " & Path & " "
           & (if Bench_Settings.As_Service then Service_Starts.Options
              elsif Apart then "--cpu" & Last_Processor'Image else ""),
         Launcher => Service_Starts.Launcher,
         Program => Service_Starts.Program);
      Service_Starts.Look_At (R.Supervisor);
      Start_Robot (R, Watchdog => True);
      Open_Camera (R, Positions => True);
      Load.Start;
      Own_Process.Prefer_Real_Time (True);
      Start := Now;
      while Now - Start < Duration (Bench_Settings.Short_Seconds) loop
         Number := Number + 1;
         Unused := R.Monitor.Ask
           ((case Number mod 4 is
                when 0 => "RMOV:-100",
                when 1 => "RTRN:90",
                when 2 => "RSTP",
                when others => "RGST"),
            Within => 5.0);
         delay Command_Pause;
      end loop;
      Own_Process.Prefer_Real_Time (False);
      Load.Stop;
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check
        (R.Supervisor.Exit_Status (Within => 10.0) = 0,
         "the supervisor did not end in good order");
      Check
        (not R.Supervisor.Says ("the trace is not complete"),
         R.Supervisor.Log_Text);
   end Make;

   procedure Report (Path : String) is
      Own    : constant String := Programs.Temporary_Folder & "/trace.json";
      Result : Response_Array;
      Number : Natural := 0;
      Above  : Natural := 0;
   begin
      Reports.Begin_Section
        ("responses", "what each task takes from its release to its end");
      if Path = "" then
         Make (Own);
      end if;
      Read ((if Path = "" then Own else Path), Apart, Result);
      for Name in Activity_Name loop
         if Result (Name).Times.Count > 0 then
            Reports.Put
              (Name_Of (Name), Result (Name).Times,
               (if Result (Name).Bound = 0.0 then Reports.No_Goals
                else (1 => (Reports.Max, 1.0E6 * Float (Result (Name).Bound),
                            False))));
         end if;
         if Result (Name).Bound > 0.0 then
            Number := Number + Result (Name).Times.Count;
            Above := Above + Result (Name).Above;
         end if;
      end loop;
      Reports.Put_Number ("responses", Float (Number), "");
      Reports.Put_Number
        ("responses above their bounds", Float (Above), "",
         Wanted => (1 => (Reports.Value, 0.0, False)));
      Reports.Put_Note
        ("the bounds are those of proofs/schedulability for this machine");
      Reports.End_Section;
   end Report;

   procedure Resume (S : in out Thread_State; Item : Event) is
   begin
      S.Waited := True;
      if S.Due /= Never then
         S.Begun := Nanoseconds'Max (S.Due, S.Stopped);
         S.Due := Never;
      elsif S.Name /= "th_line"
        and then not S.Waiting.Is_Empty
        and then S.Waiting.Last_Element.Command = 0
      then
         S.Begun := Nanoseconds'Max
           (S.Waiting.Last_Element.Time, S.Stopped);
         S.Waiting.Delete_Last;
      else
         S.Begun := Item.Time;
      end if;
   end Resume;

   procedure Take_Bounds (Apart : Boolean; Result : in out Response_Array) is
      Known : Analysis;

      procedure Take (Name : Activity_Name; From : Bound);

      procedure Take (Name : Activity_Name; From : Bound) is
      begin
         if From.Exists then
            Result (Name).Bound := Duration (From.Local) / 1_000_000;
         end if;
      end Take;

   begin
      Analyse
        (Of_The_Table, (if Apart then Real_Time_Apart else One_Processor),
         (others => <>), (others => <>), Known);
      for Name in Activity_Name loop
         Take (Name, Known.Bounds (Name));
      end loop;
      Take (Line_Request, Known.Owner.Request);
      Take (Line_Answer, Known.Owner.Outcome);
   end Take_Bounds;

end Trace_Responses;
