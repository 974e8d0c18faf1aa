--  SPDX-License-Identifier: GPL-3.0-or-later
--  Programs started by a test.

with Ada.Containers.Vectors;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;
with Ada.Unchecked_Deallocation;
with Interfaces.C;      use Interfaces.C;
with Interfaces.C.Strings; use Interfaces.C.Strings;

with Expectations; use Expectations;
with Libc;
with Process_Facts;
with System;

package body Child_Processes is

   package Line_Vectors is new Ada.Containers.Vectors (Positive, Line);

   protected type Line_List is
      procedure Append (Item : Line);
      procedure Close;
      procedure Set_Ignored (Value : Boolean);
      function Ignored return Boolean;
      function Length return Natural;
      function Element (Number : Positive) return Line;
      function Closed return Boolean;
   private
      Lines : Line_Vectors.Vector;
      Ended : Boolean := False;
      Held  : Boolean := False;
   end Line_List;

   task type Collector
     (File : int; List : not null access Line_List)
   is
      pragma Storage_Size (512 * 1024);
   end Collector;
   --  Reads File to its end

   type Collector_Access is access Collector;

   type Line_Lists is array (Stream) of aliased Line_List;
   type Collectors is array (Stream) of Collector_Access;

   type Parts is record
      Name      : Unbounded_String;
      Pid       : int := -1;
      Input     : int := -1;
      Outputs   : Libc.Pipe_Ends := (-1, -1);
      Lists     : Line_Lists;
      Readers   : Collectors;
      Ended     : Boolean := False;
      Status    : Integer := -1;
   end record;

   procedure Free is new Ada.Unchecked_Deallocation
     (Collector, Collector_Access);
   procedure Free is new Ada.Unchecked_Deallocation (Parts, Parts_Access);

   --  Programs that run, for Stop_All

   package Pid_Vectors is new Ada.Containers.Vectors (Positive, int);

   protected Running is
      procedure Add (Pid : int);
      procedure Remove (Pid : int);
      procedure Kill_All;
   private
      Pids : Pid_Vectors.Vector;
   end Running;

   Last_Lines : Arguments;

   protected body Running is

      procedure Add (Pid : int) is
      begin
         Pids.Append (Pid);
      end Add;

      procedure Remove (Pid : int) is
         Place : constant Natural := Pids.Find_Index (Pid);
      begin
         if Place /= Pid_Vectors.No_Index then
            Pids.Delete (Place);
         end if;
      end Remove;

      procedure Kill_All is
         Unused : int;
      begin
         for Pid of Pids loop
            Unused := Libc.Kill (Pid, Libc.Sigkill);
         end loop;
      end Kill_All;

   end Running;

   protected body Line_List is

      procedure Append (Item : Line) is
      begin
         Lines.Append (Item);
      end Append;

      procedure Close is
      begin
         Ended := True;
      end Close;

      procedure Set_Ignored (Value : Boolean) is
      begin
         Held := Value;
      end Set_Ignored;

      function Ignored return Boolean is (Held);

      function Length return Natural is (Natural (Lines.Length));

      function Element (Number : Positive) return Line is
        (Lines.Element (Number));

      function Closed return Boolean is (Ended);

   end Line_List;

   task body Collector is
      Buffer : String (1 .. 8192);
      Rest   : Unbounded_String;
      Last   : long;
   begin
      loop
         while List.Ignored loop
            delay 0.01;
         end loop;
         Last := Libc.Read (File, Buffer'Address, Buffer'Length);
         exit when Last <= 0;
         declare
            Time  : constant Instant := Now;
            First : Positive := 1;
         begin
            for Place in 1 .. Natural (Last) loop
               if Buffer (Place) = ASCII.LF then
                  List.Append ((Time, Rest & Buffer (First .. Place - 1)));
                  Rest := Null_Unbounded_String;
                  First := Place + 1;
               end if;
            end loop;
            Append (Rest, Buffer (First .. Natural (Last)));
         end;
      end loop;
      if Length (Rest) > 0 then
         List.Append ((Now, Rest));
      end if;
      List.Close;
   exception
      when others =>
         List.Close;
   end Collector;

   function Words
     (Text : String; Separator : Character := ' ') return Arguments
   is
      Result : Arguments;
      First  : Positive := Text'First;
      Last   : Natural;
   begin
      while First <= Text'Last loop
         Last := Index (Text & Separator, (1 => Separator), First) - 1;
         if Last >= First then
            --  Head makes its first index 1
            Result.Append (Head (Text (First .. Last), Last - First + 1));
         end if;
         First := Last + 2;
      end loop;
      return Result;
   end Words;

   procedure Start
     (Object    : in out Child;
      Program   : String;
      Options   : Arguments := String_Vectors.Empty_Vector;
      Name      : String := "")
   is
      Count   : constant Natural := Natural (Options.Length);
      Vector  : Libc.Argument_Vector (0 .. Count + 1) := (others => Null_Ptr);
      Input   : Libc.Pipe_Ends;
      Output  : Libc.Pipe_Ends;
      Errors  : Libc.Pipe_Ends;
      Empty   : aliased Libc.Signal_Set;
      Pid     : int;
      Unused_Action : System.Address;
   begin
      Object.Stop;
      Object.Finalize;
      Object.Inner := new Parts;
      Object.Inner.Name := To_Unbounded_String
        (if Name = "" then Program else Name);

      Vector (0) := New_String (Program);
      for Number in 1 .. Count loop
         Vector (Number) := New_String (Options.Element (Number));
      end loop;

      Check (Libc.Pipe2 (Input, Libc.O_Cloexec) = 0
             and then Libc.Pipe2 (Output, Libc.O_Cloexec) = 0
             and then Libc.Pipe2 (Errors, Libc.O_Cloexec) = 0,
             "no pipe to be had");
      Libc.Sigemptyset (Empty'Access);

      Pid := Libc.Fork;
      if Pid = 0 then
         --  Between fork and exec only calls that need no lock: other tasks
         --  may have held any at the moment of the fork.
         Libc.Prctl
           (Libc.Pr_Set_Pdeathsig, unsigned_long (Libc.Sigkill));
         Libc.Sigprocmask (Libc.Set_Mask, Empty'Access, null);
         Unused_Action := Libc.Signal (Libc.Sigpipe, Libc.Default_Action);
         --  which nohup ignores, and so would the supervisor
         Unused_Action := Libc.Signal (Libc.Sighup, Libc.Default_Action);
         Libc.Dup2 (Input (0), 0);
         Libc.Dup2 (Output (1), 1);
         Libc.Dup2 (Errors (1), 2);
         Libc.Execv (Vector (0), Vector);
         Libc.Exit_Now (127);
      end if;

      for Word of Vector loop
         Free (Word);
      end loop;
      Libc.Close (Input (0));
      Libc.Close (Output (1));
      Libc.Close (Errors (1));
      if Pid < 0 then
         Libc.Close (Input (1));
         Libc.Close (Output (0));
         Libc.Close (Errors (0));
         Free (Object.Inner);
         raise Failed with "cannot start " & Program;
      end if;

      Running.Add (Pid);
      Object.Inner.Pid := Pid;
      Object.Inner.Input := Input (1);
      Object.Inner.Outputs := (Output (0), Errors (0));
      Object.Inner.Readers :=
        (Child_Processes.Output =>
           new Collector
             (Output (0),
              Object.Inner.Lists (Child_Processes.Output)'Unchecked_Access),
         Child_Processes.Errors =>
           new Collector
             (Errors (0),
              Object.Inner.Lists (Child_Processes.Errors)'Unchecked_Access));
   end Start;

   function Pid (Object : Child) return int is
     (if Object.Inner = null then -1 else Object.Inner.Pid);

   function Is_Running (Object : in out Child) return Boolean is
      Status : aliased int := 0;
   begin
      if Object.Inner = null or else Object.Inner.Ended then
         return False;
      end if;
      if Libc.Waitpid (Object.Inner.Pid, Status'Access, Libc.No_Hang)
        = Object.Inner.Pid
      then
         --  The layout of the status is that of every Linux
         Object.Inner.Status :=
           (if Status mod 128 = 0
            then Integer (Status / 256) mod 256
            else 128 + Integer (Status mod 128));
         Object.Inner.Ended := True;
         Running.Remove (Object.Inner.Pid);
         return False;
      end if;
      return True;
   end Is_Running;

   procedure Send_Signal (Object : Child; Signal : int) is
   begin
      Check (Object.Inner /= null and then not Object.Inner.Ended
             and then Libc.Kill (Object.Inner.Pid, Signal) = 0,
             "cannot signal a program that has ended");
   end Send_Signal;

   procedure Put_Line (Object : Child; Text : String) is
      Bytes : constant String := Text & ASCII.LF;
   begin
      Check (Object.Inner /= null
             and then Libc.Write
               (Object.Inner.Input, Bytes'Address, Bytes'Length) =
                 long (Bytes'Length),
             "cannot write to the program's input");
   end Put_Line;

   procedure Close_Input (Object : in out Child) is
   begin
      if Object.Inner /= null and then Object.Inner.Input >= 0 then
         Libc.Close (Object.Inner.Input);
         Object.Inner.Input := -1;
      end if;
   end Close_Input;

   function Count (Object : Child; From : Stream) return Natural is
     (Object.Inner.Lists (From).Length);

   function Element
     (Object : Child; From : Stream; Number : Positive) return Line
   is (Object.Inner.Lists (From).Element (Number));

   function Awaited
     (Object  : Child;
      From    : Stream;
      Pattern : String;
      Within  : Duration := 0.0;
      After   : Natural  := 0) return Natural
   is
      Deadline : constant Instant := Now + Within;
      Seen     : Natural := After;
   begin
      loop
         declare
            Late   : constant Boolean := Now >= Deadline;
            Closed : constant Boolean := Object.Inner.Lists (From).Closed;
         begin
            while Seen < Object.Inner.Lists (From).Length loop
               Seen := Seen + 1;
               if Pattern = "" or else Index
                 (Object.Inner.Lists (From).Element (Seen).Text, Pattern) > 0
               then
                  return Seen;
               end if;
            end loop;
            if Late or else Closed then
               return 0;
            end if;
         end;
         delay 0.001;
      end loop;
   end Awaited;

   procedure Ignore (Object : in out Child; From : Stream) is
   begin
      Object.Inner.Lists (From).Set_Ignored (True);
   end Ignore;

   function Exit_Status (Object : in out Child) return Integer is
      Deadline : constant Instant := Now + Patience;
   begin
      while Object.Is_Running loop
         if Now >= Deadline then
            raise Failed with
              To_String (Object.Inner.Name) & " does not end: "
              & Process_Facts.State (Object.Inner.Pid);
         end if;
         delay 0.001;
      end loop;
      --  Its last output is still being read; with a limit, as a grandchild
      --  may hold the pipe
      for From in Stream loop
         for Attempt in 1 .. 5_000 loop
            exit when Object.Inner.Readers (From)'Terminated
              or else Object.Inner.Lists (From).Ignored;
            delay 0.001;
         end loop;
      end loop;
      return Object.Inner.Status;
   end Exit_Status;

   procedure Stop (Object : in out Child) is
      Unused_Status : Integer;
      Unused        : int;
   begin
      if Object.Inner /= null and then Object.Is_Running then
         Unused := Libc.Kill (Object.Inner.Pid, Libc.Sigkill);
         Unused_Status := Object.Exit_Status;
      end if;
   end Stop;

   procedure Finalize (Object : in out Child) is
      Kept   : constant array (Stream) of Positive :=
        (Output => 4, Errors => 40);
   begin
      if Object.Inner = null then
         return;
      end if;
      Object.Stop;
      Object.Close_Input;
      for From in Stream loop
         Object.Inner.Lists (From).Set_Ignored (False);
         --  A grandchild may still hold the pipe: limited wait
         for Attempt in 1 .. 1000 loop
            exit when Object.Inner.Readers (From)'Terminated;
            delay 0.001;
         end loop;
         if Object.Inner.Readers (From)'Terminated then
            Libc.Close (Object.Inner.Outputs (Stream'Pos (From)));
         end if;
      end loop;
      for From in Stream loop
         if Object.Count (From) > 0 then
            Last_Lines.Append ("--- " & To_String (Object.Inner.Name) & ", "
                               & Stream'Image (From) & ", status"
                               & Integer'Image (Object.Inner.Status));
         end if;
         for Number in
           Integer'Max (1, Object.Count (From) - Kept (From) + 1)
           .. Object.Count (From)
         loop
            declare
               Text : constant String :=
                 To_String (Object.Element (From, Number).Text);
            begin
               Last_Lines.Append (Text (1 .. Integer'Min (Text'Length, 200)));
            end;
         end loop;
      end loop;
      if (for all Reader of Object.Inner.Readers => Reader'Terminated) then
         for Reader of Object.Inner.Readers loop
            Free (Reader);
         end loop;
         Free (Object.Inner);
      else
         Object.Inner := null;
      end if;
   end Finalize;

   procedure Stop_All is
   begin
      Running.Kill_All;
   end Stop_All;

   procedure Print_Last_Lines is
   begin
      for Text of Last_Lines loop
         Ada.Text_IO.Put_Line ("      | " & Text);
      end loop;
      Ada.Text_IO.Flush;
   end Print_Last_Lines;

   procedure Forget_Last_Lines is
   begin
      Last_Lines.Clear;
   end Forget_Last_Lines;

end Child_Processes;
