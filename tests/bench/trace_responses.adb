--  SPDX-License-Identifier: GPL-3.0-or-later
--  The response times of the tasks, out of a file of --trace, beside the
--  bounds of the response-time analysis.

with Ada.Containers.Vectors;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with System.Multiprocessors;

with Bench_Settings;
with Budgets;               use Budgets;
with Expectations;          use Expectations;
with Libc;
with Programs;
with Reports;
with Response_Times;        use Response_Times;
with Rigs;                  use Rigs;
with Samples;
with Schedule;
with Loads;
with Supervisor_Model;      use Supervisor_Model;
with Trace_Files;           use Trace_Files;
with Vision.Image_Grid;

package body Trace_Responses is

   type Response is record
      Times : Samples.Set;
      Bound : Duration := 0.0;
      --  of this machine; 0.0: the analysis has none
      Above : Natural  := 0;
      --  how many were longer
   end record;

   type Response_Array is array (Activity_Name) of Response;

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
      Timed    : Boolean := False;
      --  the clock has begun the job
      Waited   : Boolean := False;
      --  the job has had a wait
      Asking   : Boolean := False;
      --  the wait under way is for the robot's answer
      Answered : Boolean := False;
      --  the job has had such a wait
      Stopped  : Nanoseconds := Never;
      --  the beginning of the wait under way
      Taken    : Boolean := False;
      --  the job is for a command
      Sending  : Activity_Name := Environment;
      --  what th_sendToMon has sent last
      Looking  : Activity_Name := Mission_Begin;
      --  what th_mission has begun this job with
   end record;

   type State_Array is array (Thread_Number) of Thread_State;

   type Sight is record
      Newest, Older : Nanoseconds := Never;
      --  images that came and were not taken, by their arrivals
      Taken         : Nanoseconds := Never;
      --  the image that is searched
      Seen          : Nanoseconds := Never;
      --  the one that th_mission has been woken for
   end record;
   --  The way of an image to the order of a mission

   Last_Processor : constant Natural :=
     Natural (System.Multiprocessors.Number_Of_CPUs) - 1;

   Apart : constant Boolean := Last_Processor > 0;
   --  The supervisor runs with --cpu

   Image_Period : constant := 100_000;
   --  microseconds, without --fps

   procedure Take_Bounds
     (Missions : Boolean;
      Result   : in out Response_Array;
      Orders   : in out Response)
   is
      Known : Analysis;

      procedure Take (Name : Activity_Name; From : Bound) is
      begin
         if From.Exists then
            Result (Name).Bound := Duration (From.Local) / 1_000_000;
         end if;
      end Take;

   begin
      Analyse
        (Of_The_Table, (if Apart then Real_Time_Apart else One_Processor),
         (others => <>), (Mission => Missions, others => <>), Known);
      for Name in Activity_Name loop
         Take (Name, Known.Bounds (Name));
      end loop;
      Take (Line_Request, Known.Owner (Other_Order).Request);
      Take (Line_Answer, Known.Owner (Other_Order).Outcome);
      if Known.Requirements (Mission_Order).Known then
         Orders.Bound :=
           Duration (Known.Requirements (Mission_Order).Bound) / 1_000_000;
      end if;
   end Take_Bounds;

   procedure Add (Item : in out Response; Span : Nanoseconds) is
      Time : constant Duration := Duration (Span / 1_000) / 1_000_000;
   begin
      Item.Times.Add (Time);
      if Item.Bound > 0.0 and then Time > Item.Bound then
         Item.Above := Item.Above + 1;
      end if;
   end Add;

   function Uses_Line (Name : Unbounded_String) return Boolean is
     (for some Who in
        Schedule.Th_Start_Robot_WD .. Schedule.Th_Battery_Level =>
        Schedule.Name_Of (Who) = Name);

   procedure Resume (S : in out Thread_State; Item : Event) is
   begin
      S.Waited := True;
      S.Answered := S.Answered or else S.Asking;
      if S.Due /= Never then
         S.Begun := Nanoseconds'Max (S.Due, S.Stopped);
         S.Due := Never;
      elsif not S.Asking
        and then not S.Waiting.Is_Empty
        and then S.Waiting.Last_Element.Command = 0
      then
         S.Begun := Nanoseconds'Max (S.Waiting.Last_Element.Time, S.Stopped);
         S.Waiting.Delete_Last;
      else
         S.Begun := Item.Time;
      end if;
   end Resume;

   function Activity_Of (S : Thread_State; Last : Boolean)
     return Activity_Name
   is
      First : Boolean := True;
   begin
      if S.Name = "th_sendToMon" then
         --  up to the gap, where there is one, nothing can be sent
         return (if Last then S.Sending else Environment);
      end if;
      if (S.Name = "th_cameraControl" or else S.Name = "th_arene")
        and then not S.Taken
      then
         return Environment;  --  another had its turn
      end if;
      if (S.Name = "th_camera" and then not S.Waited)
        or else ((S.Name = "th_stop" or else S.Name = "th_comMonPerdue")
                 and then S.Waited)
      then
         --  the camera is opened; the end of all is waited for
         return Environment;
      end if;
      if S.Name = "th_mission" then
         return
           (if S.Answered then Mission_Told
            elsif S.Waited then Line_Request
            else S.Looking);
      elsif S.Answered then
         return Line_Answer;
      elsif Uses_Line (S.Name) and then not Last then
         return Line_Request;
      elsif Uses_Line (S.Name) and then not S.Timed then
         return Environment;  --  without an exchange
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
      --  The activity under way has ended; Last: and its job
      Name : constant Activity_Name := Activity_Of (S, Last);
   begin
      if S.Begun /= Never and then Name /= Environment then
         Add (Result (Name), At_End - S.Begun);
      end if;
      S.Begun := Never;
   end Add;

   procedure Begin_Job (S : in out Thread_State; Item : Event) is
      --  Of th_sendToMon also: it may send the next message
      Place : Natural := 0;
   begin
      S.Timed := S.Due /= Never;
      S.Waited := False;
      S.Answered := False;
      S.Taken := Item.Command > 0;
      S.Sending := Environment;
      S.Looking :=
        (if Item.Command > 0 then Mission_Begin
         elsif S.Timed then Mission_Due
         else Mission_Seen);
      if S.Due /= Never then
         S.Begun := S.Due;
         S.Due := Never;
      elsif S.Name = "th_server"
        or else S.Name = "th_receiveFromMon"
        or else S.Name = "th_comMonPerdue"
      then
         --  by the kernel, just then; a signal begins the session
         S.Begun := (if S.Waiting.Is_Empty then Item.Time else Never);
      else
         Place := (if S.Waiting.Is_Empty then 0 else 1);
         for I in reverse 1 .. S.Waiting.Last_Index loop
            if S.Waiting (I).Command = Item.Command
              and then (Item.Command > 0 or else S.Name = "th_mission")
            then
               Place := I;
            end if;
         end loop;
         if Place > 0 then
            S.Begun := S.Waiting (Place).Time;
            S.Waiting.Delete (Place);
            if Uses_Line (S.Name) or else S.Name = "th_mission" then
               S.Begun := Nanoseconds'Max (S.Begun, S.Ready);
            end if;
         else
            S.Begun := Item.Time;
         end if;
      end if;
      --  a job that is for no command answers to all signals so far, and
      --  one for a command to its own and to those for none
      for I in reverse 1 .. S.Waiting.Last_Index loop
         if Item.Command = 0
           or else S.Waiting (I).Command in 0 | Item.Command
         then
            S.Waiting.Delete (I);
         end if;
      end loop;
   end Begin_Job;

   function Name_Of (Name : Activity_Name) return String is
     ((if Name in Line_Request .. Line_Open then "line" else Task_Name (Name))
      & (case Name is
            when Line_Request  => ", request",
            when Mission_Begin => ", begin",
            when Mission_Due   => ", due",
            when Mission_Seen  => ", position",
            when Mission_Told  => ", done",
            when Send_Mission  => ", mission",
            when Line_Answer   => ", answer",
            when Reload_Due | Battery_Due | Ping_Due    => ", due",
            when Camera_Order  => ", order",
            when Camera_Answer | Send_Answer => ", answer",
            when Send_Battery  => ", battery",
            when Send_Position => ", position",
            when Send_Image    => ", image",
            when others        => ""));

   procedure Take_Image (S : in out Sight; Time : Nanoseconds) is
      --  As Vision.Frames does
      function Age (Arrival : Nanoseconds)
        return Vision.Image_Grid.Microseconds
      is (Vision.Image_Grid.Microseconds
            (Nanoseconds'Min
               (Nanoseconds (Vision.Image_Grid.Microseconds'Last),
                Nanoseconds'Max (0, (Time - Arrival) / 1_000))));
   begin
      if S.Older /= Never and then S.Newest /= Never
        and then Vision.Image_Grid.Sends_Older
          (Newest_Age => Age (S.Newest),
           Older_Age  => Age (S.Older),
           Period     => Image_Period)
      then
         S.Taken := S.Older;
      else
         S.Taken := S.Newest;
         S.Newest := Never;
      end if;
      S.Older := Never;
   end Take_Image;

   procedure Follow
     (S      : in out Sight;
      States : State_Array;
      Item   : Event;
      Orders : in out Response)
   is
      --  Before the event is noted in States
      Who : Thread_State renames States (Item.Thread);
      N   : constant String := Name (Item);

      function Is_Under_Way (Thread : String) return Boolean is
        (for some Other of States =>
           (if Thread = "" then Uses_Line (Other.Name)
            else Other.Name = Thread)
           and then Other.Depth = 1);
      --  In a job, and not in a wait of it. "": any that uses the line

   begin
      if Who.Name = "th_camera" and then Item.Phase = 'E'
        and then Who.Depth = 2
      then
         S.Older := S.Newest;
         S.Newest := Item.Time;
      elsif Who.Name = "th_captureImg" and then Item.Phase = 'B'
        and then Who.Depth = 0
      then
         Take_Image (S, Item.Time);
      elsif Who.Name = "th_mission" and then N = "release"
        and then Item.Command = 0
        and then Is_Under_Way ("th_captureImg")
        and then not Is_Under_Way ("")
      then
         --  by the search; the line's releases are for the mission's command.
         --  An image that comes while the robot is asked does not count: what
         --  is ordered then follows from the answer
         S.Seen := (if Who.Depth = 0 then S.Taken else Never);
      elsif Who.Name = "th_mission" and then Item.Phase = 'E'
        and then Who.Depth = 1
      then
         S.Seen := Never;
      elsif N = "robot M" or else N = "robot T" then
         --  of a mission that has just seen the image
         if Who.Name = "th_mission" and then S.Seen /= Never then
            Add (Orders, Item.Time - S.Seen);
            S.Seen := Never;
         end if;
      end if;
   end Follow;

   procedure Read
     (Path     : String;
      Missions : Boolean;
      Result   : out Response_Array;
      Orders   : out Response)
   is
      --  Missions: the bounds are those beside missions. Orders: of missions,
      --  from the arrival of the image to the frame of the order. Raises
      --  Trace_Files.Bad_Trace where Path is no trace
      T      : Trace;
      States : State_Array;
      Image  : Sight;
   begin
      Result := (others => <>);
      Orders := (others => <>);
      Take_Bounds (Missions, Result, Orders);
      Trace_Files.Read (Path, T);
      for Number in Thread_Number loop
         States (Number).Name := T.Threads (Number).Name;
      end loop;
      for Item of T.Events loop
         declare
            S : Thread_State renames States (Item.Thread);
            N : constant String := Name (Item);
         begin
            Follow (Image, States, Item, Orders);
            case Item.Phase is
               when 'B' =>
                  S.Depth := S.Depth + 1;
                  if S.Depth = 1 then
                     Begin_Job (S, Item);
                  else
                     --  what lies between two exchanges of one transaction
                     --  is of both activities: left out
                     if not S.Answered then
                        Add (S, Item.Time, False, Result);
                     end if;
                     S.Stopped := Item.Time;
                     S.Asking := N = "wait for answer";
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
                  elsif S.Name = "th_sendToMon" then
                     S.Sending :=
                       (if N = "out RBLV" then Send_Battery
                        elsif N = "out MPRG" or else N = "out MEND"
                        then Send_Mission
                        elsif N = "out CPOS" then Send_Position
                        elsif N = "out CIMG" then Send_Image
                        else Send_Answer);
                     Add (S, Item.Time, True, Result);
                     Begin_Job (S, Item);
                  end if;
            end case;
         end;
      end loop;
   end Read;

   procedure Make (Path : String; Missions : Boolean) is
      --  A trace
      R : Rig;
   begin
      Loads.Carry_Out
        (R, Missions,
         "--trace " & Path
         & (if Apart and then not Bench_Settings.As_Service
            then " --cpu" & Last_Processor'Image else ""));
      R.Supervisor.Send_Signal (Libc.Sigterm);
      Check (R.Supervisor.Exit_Status = 0,
             "the supervisor did not end in good order");
      Check (not R.Supervisor.Says ("the trace is not complete"),
             R.Supervisor.Text);
   end Make;

   procedure Report (Path : String) is

      procedure Put (Name : String; Item : Response) is
      begin
         if Item.Times.Count > 0 then
            Reports.Put
              (Name, Item.Times,
               (if Item.Bound = 0.0 then Reports.No_Goals
                else (1 => (Reports.Max, 1.0E6 * Float (Item.Bound)))));
         end if;
      end Put;

      procedure Put_Sum (What : String; Set : Response_Array) is
         Number : Natural := 0;
         Above  : Natural := 0;
      begin
         for Item of Set loop
            if Item.Bound > 0.0 then
               Number := Number + Item.Times.Count;
               Above := Above + Item.Above;
            end if;
         end loop;
         Reports.Put_Number (What, Float (Number), "");
         Reports.Put_Number (What & " above their bounds", Float (Above), "",
                             Wanted => (1 => (Reports.Value, 0.0)));
      end Put_Sum;

      Own    : constant String := Programs.Temporary_Folder & "/trace.txt";
      Result : Response_Array;
      Beside : Response_Array;
      Orders : Response;
   begin
      Reports.Begin_Section
        ("responses", "what each task takes from its release to its end");
      if Path = "" then
         Make (Own, Missions => False);
      end if;
      Read ((if Path = "" then Own else Path), False, Result, Orders);
      for Name in Activity_Name loop
         Put (Name_Of (Name), Result (Name));
      end loop;
      Put_Sum ("responses", Result);
      if Path = "" then
         Make (Own, Missions => True);
      end if;
      Read ((if Path = "" then Own else Path), True, Beside, Orders);
      Check (Path /= "" or else Orders.Times.Count > 0,
             "no mission has ordered anything after an image");
      if Orders.Times.Count > 0 then
         for Name in Mission_Begin .. Mission_Told loop
            Put (Name_Of (Name), Beside (Name));
         end loop;
         Put (Name_Of (Send_Mission), Beside (Send_Mission));
         Put ("image to its order's first byte", Orders);
         Put_Sum ("responses beside missions", Beside);
      end if;
      Reports.Put_Note
        ("the bounds are those of proofs/schedulability for this machine");
      Reports.End_Section;
   end Report;

end Trace_Responses;
