--  SPDX-License-Identifier: GPL-3.0-or-later
--  Programs started by a test.

with Ada.Containers.Vectors;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Text_IO;
with Ada.Unchecked_Deallocation;
with Interfaces.C.Strings; use Interfaces.C.Strings;

with Expectations; use Expectations;
with Libc;
with Process_Facts;
with System;

package body Child_Processes is

   package Line_Vectors is new Ada.Containers.Vectors (Positive, Line);

   protected type Line_List is
      procedure Append (Item : Line);
      function Length return Natural;
      function Element (Number : Positive) return Line;
   private
      Lines : Line_Vectors.Vector;
   end Line_List;

   type Reading;

   task type Collector (From : not null access Reading) is
      pragma Storage_Size (512 * 1024);
   end Collector;
   --  Reads a stream to its end

   type Collector_Access is access Collector;

   type Reading is limited record
      File    : int := -1;
      List    : Line_List;
      Closed  : Boolean := False with Atomic;
      Ignored : Boolean := False with Atomic;
      Reader  : Collector_Access;
   end record;

   type Readings is array (Stream) of aliased Reading;

   type Parts is limited record
      Name    : Unbounded_String;
      Pid     : int := -1;
      Input   : int := -1;
      Streams : Readings;
      Ended   : Boolean := False;
      Status  : Integer := -1;
   end record;

   procedure Free is new Ada.Unchecked_Deallocation
     (Collector, Collector_Access);
   procedure Free is new Ada.Unchecked_Deallocation (Parts, Parts_Access);

   Last_Lines : Arguments;
   Kept_Lines : constant := 150;

   protected body Line_List is

      procedure Append (Item : Line) is
      begin
         Lines.Append (Item);
      end Append;

      function Length return Natural is (Natural (Lines.Length));

      function Element (Number : Positive) return Line is
        (Lines.Element (Number));

   end Line_List;

   task body Collector is
      Buffer : String (1 .. 8192);
      Rest   : Unbounded_String;
      Last   : long;
   begin
      loop
         while From.Ignored loop
            delay 0.01;
         end loop;
         Last := Libc.Read (From.File, Buffer'Address, Buffer'Length);
         exit when Last <= 0;
         declare
            Time  : constant Instant := Now;
            First : Positive := 1;
         begin
            for Place in 1 .. Natural (Last) loop
               if Buffer (Place) = ASCII.LF then
                  From.List.Append
                    ((Time, Rest & Buffer (First .. Place - 1)));
                  Rest := Null_Unbounded_String;
                  First := Place + 1;
               end if;
            end loop;
            Append (Rest, Buffer (First .. Natural (Last)));
         end;
      end loop;
      if Length (Rest) > 0 then
         From.List.Append ((Now, Rest));
      end if;
      From.Closed := True;
   exception
      when others =>
         From.Closed := True;
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

   procedure Launch
     (Object  : in out Child;
      Program : String;
      Options : Arguments;
      Name    : String := "")
   is
      Count  : constant Natural := Natural (Options.Length);
      Vector : Libc.Argument_Vector (0 .. Count + 1) := (others => Null_Ptr);
      Pipes  : array (0 .. 2) of Libc.Pipe_Ends;
      Empty  : aliased Libc.Signal_Set;
      Pid    : int;
      Unused_Action : System.Address;
   begin
      Object.Finalize;
      Object.Inner := new Parts;
      Object.Inner.Name := To_Unbounded_String
        (if Name = "" then Program else Name);

      Vector (0) := New_String (Program);
      for Number in 1 .. Count loop
         Vector (Number) := New_String (Options.Element (Number));
      end loop;
      for Pipe of Pipes loop
         Check (Libc.Pipe2 (Pipe, Libc.O_Cloexec) = 0, "no pipe to be had");
      end loop;
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
         Libc.Dup2 (Pipes (0) (0), 0);
         Libc.Dup2 (Pipes (1) (1), 1);
         Libc.Dup2 (Pipes (2) (1), 2);
         Libc.Execv (Vector (0), Vector);
         Libc.Exit_Now (127);
      end if;

      for Word of Vector loop
         Free (Word);
      end loop;
      Libc.Close (Pipes (0) (0));
      Libc.Close (Pipes (1) (1));
      Libc.Close (Pipes (2) (1));
      if Pid < 0 then
         Libc.Close (Pipes (0) (1));
         Libc.Close (Pipes (1) (0));
         Libc.Close (Pipes (2) (0));
         Free (Object.Inner);
         raise Failed with "cannot start " & Program;
      end if;

      Object.Inner.Pid := Pid;
      Object.Inner.Input := Pipes (0) (1);
      for From in Stream loop
         declare
            Item : Reading renames Object.Inner.Streams (From);
         begin
            Item.File := Pipes (Stream'Pos (From) + 1) (0);
            Item.Reader := new Collector
              (Object.Inner.Streams (From)'Unchecked_Access);
         end;
      end loop;
   end Launch;

   procedure Launch
     (Object : in out Child; Command : String; Separator : Character := ' ')
   is
      Options : Arguments := Words (Command, Separator);
      Program : constant String := Options.First_Element;
   begin
      Options.Delete_First;
      Object.Launch (Program, Options);
   end Launch;

   function Status_Of
     (Command : String; Separator : Character := ' ') return Integer
   is
      Tool : Child;
   begin
      Tool.Launch (Command, Separator);
      return Tool.Exit_Status;
   end Status_Of;

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
      if Object.Inner.Input >= 0 then
         Libc.Close (Object.Inner.Input);
         Object.Inner.Input := -1;
      end if;
   end Close_Input;

   function Count (Object : Child; From : Stream := Errors) return Natural is
     (Object.Inner.Streams (From).List.Length);

   function Element
     (Object : Child; From : Stream; Number : Positive) return Line
   is (Object.Inner.Streams (From).List.Element (Number));

   function Text (Object : Child; From : Stream := Errors) return String is
      Result : Unbounded_String;
   begin
      for Number in 1 .. Object.Count (From) loop
         Append (Result, Object.Element (From, Number).Text & ASCII.LF);
      end loop;
      return To_String (Result);
   end Text;

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
            Closed : constant Boolean := Object.Inner.Streams (From).Closed;
         begin
            while Seen < Object.Count (From) loop
               Seen := Seen + 1;
               if Pattern = ""
                 or else Index (Object.Element (From, Seen).Text, Pattern) > 0
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

   procedure Ignore_Errors (Object : in out Child) is
   begin
      Object.Inner.Streams (Errors).Ignored := True;
   end Ignore_Errors;

   procedure Await_Readers (Inner : Parts_Access; Milliseconds : Positive) is
      --  With a limit, as a grandchild may hold the pipe
   begin
      for Item of Inner.Streams loop
         for Attempt in 1 .. Milliseconds loop
            exit when Item.Reader'Terminated or else Item.Ignored;
            delay 0.001;
         end loop;
      end loop;
   end Await_Readers;

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
      --  Its last output is still being read
      Await_Readers (Object.Inner, 5_000);
      return Object.Inner.Status;
   end Exit_Status;

   procedure Expect_Exit (Object : in out Child; Status : Integer) is
      Seen : constant Integer := Object.Exit_Status;
   begin
      Check (Seen = Status,
             To_String (Object.Inner.Name) & ": exit status" & Seen'Image
             & " instead of" & Status'Image & ": " & Object.Text (Output)
             & Object.Text (Errors));
   end Expect_Exit;

   procedure Stop (Object : in out Child) is
      Unused_Status : Integer;
      Unused        : int;
   begin
      if Object.Is_Running then
         Unused := Libc.Kill (Object.Inner.Pid, Libc.Sigkill);
         Unused_Status := Object.Exit_Status;
      end if;
   end Stop;

   procedure Keep_Last_Lines (Object : Child) is
      Most : constant array (Stream) of Positive :=
        (Output => 4, Errors => 40);
   begin
      for From in Stream loop
         if Object.Count (From) > 0 then
            Last_Lines.Append ("--- " & To_String (Object.Inner.Name) & ", "
                               & Stream'Image (From) & ", status"
                               & Integer'Image (Object.Inner.Status));
         end if;
         for Number in
           Integer'Max (1, Object.Count (From) - Most (From) + 1)
           .. Object.Count (From)
         loop
            Last_Lines.Append
              (Head (To_String (Object.Element (From, Number).Text),
                     Integer'Min
                       (Length (Object.Element (From, Number).Text), 200)));
         end loop;
      end loop;
      while Last_Lines.Last_Index > Kept_Lines loop
         Last_Lines.Delete_First;
      end loop;
   end Keep_Last_Lines;

   procedure Finalize (Object : in out Child) is
   begin
      if Object.Inner = null then
         return;
      end if;
      Object.Stop;
      Object.Close_Input;
      for Item of Object.Inner.Streams loop
         Item.Ignored := False;
      end loop;
      Await_Readers (Object.Inner, 1_000);
      Keep_Last_Lines (Object);
      for Item of Object.Inner.Streams loop
         if Item.Reader'Terminated then
            Libc.Close (Item.File);
         end if;
      end loop;
      if (for all Item of Object.Inner.Streams => Item.Reader'Terminated) then
         for Item of Object.Inner.Streams loop
            Free (Item.Reader);
         end loop;
         Free (Object.Inner);
      else
         Object.Inner := null;
      end if;
   end Finalize;

   procedure Print_Last_Lines is
   begin
      for Text of Last_Lines loop
         Ada.Text_IO.Put_Line ("      | " & Text);
      end loop;
      Ada.Text_IO.Flush;
   end Print_Last_Lines;

end Child_Processes;
