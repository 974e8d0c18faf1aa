--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;     use Ada.Real_Time;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Process;
with Robot.Serial_Line.Calls;
with Schedule;
with Trace;

package body Robot.Serial_Line with
  SPARK_Mode,
  Refined_State => (Device => (Calls.Port, Descriptor, Is_Gone))
is

   Descriptor : Calls.Outcome := Calls.No_Descriptor
     with Atomic, Async_Readers, Async_Writers, Export, Convention => C,
          External_Name => "destijl_robot_line";
   --  In a crash its handler writes there (crash_handlers.cpp)

   Is_Gone : Boolean := False with Atomic, Async_Readers, Async_Writers;

   procedure Note_End (Result : Calls.Outcome) is
      --  Notes whether the device has gone, by what a call returned
   begin
      if Result in 0 | Calls.Input_Output_Error | Calls.No_Such_Address
                 | Calls.No_Such_Device
      then
         Is_Gone := True;
      end if;
   end Note_End;

   procedure Append_Hexadecimal (To : in out Texts.Text; Number : Natural) is
      --  Two digits or more
      All_Digits : constant String := "0123456789abcdef";
      Weights    : constant array (0 .. 4) of Positive :=
        (1, 16#10#, 16#100#, 16#1000#, 16#1_0000#);
      Left       : Natural;
      Digit      : Positive range 1 .. 16;
   begin
      for Place in reverse 0 .. 4 loop
         Left := Number / Weights (Place);
         Digit := Left mod 16 + 1;
         if Left > 0 or else Place < 2 then
            Texts.Append (To, All_Digits (Digit .. Digit));
         end if;
      end loop;
   end Append_Hexadecimal;

   procedure Find_Lock
     (Table : String; Locked : Calls.File_Numbers; Owner : out Texts.Text)
   with Pre => Table'First = 1 and then Table'Last < Integer'Last
   is
      --  The number of the process that has the first lock of the file, in
      --  decimal; empty if there is none. Table: /proc/locks, a line for each,
      --  such as "1: FLOCK  ADVISORY  WRITE 1234 00:1a:3 0 EOF", with the
      --  process and the file's place and inode
      Wanted : Texts.Text := Texts.To_Text (" ");
      Place  : Natural;
      Start  : Positive;
   begin
      Texts.Set (Owner, "");
      Append_Hexadecimal (Wanted, Locked.Place.Major);
      Texts.Append (Wanted, ":");
      Append_Hexadecimal (Wanted, Locked.Place.Minor);
      Texts.Append (Wanted, ":");
      Texts.Append (Wanted, Locked.Inode);
      Texts.Append (Wanted, " ");
      Place := Index (Table, Texts.Image (Wanted));
      if Place > 0 then
         Start := Place;
         while Start > 1 and then Table (Start - 1) in '0' .. '9' loop
            pragma Loop_Invariant (Start <= Place);
            Start := Start - 1;
         end loop;
         Texts.Set (Owner, Table (Start .. Place - 1));
      end if;
   end Find_Lock;

   procedure Append_Process (To : in out Texts.Text; Number : String) is
      --  Its name, and its number
      Name : String (1 .. 16) := (others => ' ');
      Last : Natural;
   begin
      Calls.Get_Start ("/proc/" & Number & "/comm", Name, Last);
      --  without the line feed behind it
      Texts.Append (To, Name (1 .. Integer'Max (0, Last - 1)));
      Texts.Append (To, " (process ");
      Texts.Append (To, Number);
      Texts.Append (To, ")");
   end Append_Process;

   procedure Explain
     (Path : Texts.Text; Error : Calls.Outcome; Reason : out Texts.Text)
   with Pre => Error < 0
   is
      --  Why the device cannot be opened, after a call has failed with Error
      Table : String (1 .. 8_192) := (others => ' ');
      Last  : Natural;
      File  : Calls.File_Numbers;
      Owner : Texts.Text;
   begin
      if Error = Calls.No_Terminal then
         Texts.Set (Reason, "not a serial line");
         return;
      elsif Error /= Calls.Busy and then Error /= Calls.No_Data then
         Process.Describe (-Error, Reason);
         if Error = Calls.Not_Permitted then
            Texts.Append
              (Reason, ": your user must be in the group dialout");
         end if;
         return;
      end if;
      Calls.Get_Numbers (Texts.Image (Path), File);
      Calls.Get_Start ("/proc/locks", Table, Last);
      Find_Lock (Table (1 .. Last), File, Owner);
      Texts.Set (Reason, "in use by ");
      if Owner.Length = 0 then
         Texts.Append (Reason, "another program");
      else
         Append_Process (Reason, Texts.Image (Owner));
      end if;
   end Explain;

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Opened  : Calls.Outcome;
      Ignored : Boolean;
   begin
      Close (Ignored);
      Calls.Open (Texts.Image (Path), Opened);
      Success := Opened >= 0;
      if Success then
         Descriptor := Opened;
         Is_Gone := False;
         Calls.Discard (Opened, Calls.Received);
         Texts.Set (Reason, "");
      else
         Explain (Path, Opened, Reason);
      end if;
   end Open;

   procedure Close (All_Sent : out Boolean) is
      Old    : constant Calls.Outcome := Descriptor;
      Unsent : Calls.Outcome;
      Now    : Time;
      Limit  : Time;
   begin
      All_Sent := True;
      if Old = Calls.No_Descriptor then
         return;
      end if;
      Descriptor := Calls.No_Descriptor;
      Now := Clock;
      Limit := Now + Schedule.Unsent_Limit;
      loop
         Calls.Get_Unsent (Old, Unsent);
         exit when Unsent <= 0 or else Now >= Limit;
         delay until Now + Schedule.Release_Poll;
         Now := Clock;
      end loop;
      if Unsent > 0 then
         All_Sent := False;
         Calls.Discard (Old, Calls.Written);
      end if;
      Calls.Close (Old);
   end Close;

   procedure Discard_Input is
      Line : constant Calls.Outcome := Descriptor;
   begin
      Calls.Discard (Line, Calls.Received);
   end Discard_Input;

   function Next_Wait (Now, Until_Time : Time) return Calls.Nanoseconds is
      --  Up to Until_Time, or for a part of that. 0 if it has passed
      --  32 bits hold 2.1 seconds of nanoseconds
      Longest : constant Time_Span := Milliseconds (900);
      Left    : Time_Span := Time_Span_Zero;
   begin
      if Now < Until_Time then
         Left := Until_Time - Now;
         if Longest < Left then
            Left := Longest;
         end if;
      end if;
      --  a limit that GNATprove knows, too
      return Integer'Max
        (0, Integer'Min (Left / Nanoseconds (1), Calls.Nanoseconds'Last));
   end Next_Wait;

   procedure Write
     (Item    : Robot.Protocol.Command;
      Mode    : Robot.Session.Mode_Kind;
      Length  : out Robot.Protocol.Frame_Length;
      Success : out Boolean)
   is
      pragma Unreferenced (Mode);
      Line  : constant Calls.Outcome := Descriptor;
      Frame : Robot.Protocol.Frame;
      Sent  : Calls.Outcome;
   begin
      Robot.Protocol.Encode (Item, Frame);
      Length := Frame.Length;
      Calls.Write (Line, Frame.Data, Frame.Length, Sent);
      Note_End (Sent);
      Success := Sent = Frame.Length;
   end Write;

   procedure Read
     (Data    : out Bytes.Byte_Array;
      Length  : out Natural;
      Until_Time : Ada.Real_Time.Time;
      Success : out Boolean)
   is
      Line   : constant Calls.Outcome := Descriptor;
      Result : Calls.Outcome;
      Now    : Time := Clock;
   begin
      Data := (others => 0);
      Length := 0;
      --  Ends because the clock goes on: each pass but the last begins before
      --  Until_Time, or was interrupted by a signal. GNATprove does not know
      --  that of the clock
      loop
         Calls.Wait_Input (Line, Next_Wait (Now, Until_Time), Result);
         exit when Result /= 0 and then Result /= Calls.Interrupted;
         Now := Clock;
         exit when Result = 0 and then Until_Time <= Now;
      end loop;
      Success := Result >= 0;
      if Result > 0 then
         Calls.Read (Line, Data, Result);
         if Result > 0 then
            Length := Result;
         else
            Note_End (Result);
            --  0: removed. Nothing to read is none: another wait follows
            Success := Result = Calls.No_Data;
         end if;
      end if;
   end Read;

   procedure Send_Stop
     (Path : Texts.Text; Sent : out Boolean; Report : out Texts.Text)
   is
      Reason         : Texts.Text;
      Ignored_Length : Robot.Protocol.Frame_Length;
      All_Sent       : Boolean;
   begin
      Open (Path, Sent, Reason);
      if Sent then
         Write
           (Robot.Protocol.Stop, Robot.Session.Not_Started, Ignored_Length,
            Sent);
         Close (All_Sent);
         Sent := Sent and All_Sent;
         Texts.Set (Reason, "it takes nothing");
      end if;
      Texts.Set
        (Report,
         (if Sent then "the robot was sent a stop on "
          else "no stop was sent on "));
      Texts.Append (Report, Texts.Image (Path));
      if not Sent then
         Texts.Append (Report, ": ");
         Texts.Append (Report, Texts.Image (Reason));
      end if;
   end Send_Stop;

   procedure Get_Gone (Gone : out Boolean) is
   begin
      Gone := Is_Gone;
   end Get_Gone;

   function Is_Console
     (Table : String; Number : Calls.Device_Number) return Boolean
   is
      --  The kernel writes its messages to the device. Table: /proc/consoles,
      --  a line for each, such as "ttyS0   -W- (EC p a)    4:64"
      Wanted : Texts.Text := Texts.To_Text (" ");
   begin
      Texts.Append (Wanted, Number.Major);
      Texts.Append (Wanted, ":");
      Texts.Append (Wanted, Number.Minor);
      Texts.Append (Wanted, (1 => Character'Val (10)));
      return Index (Table, Texts.Image (Wanted)) > 0;
   end Is_Console;

   function Is_Of_Session
     (Stat : String; Number : Calls.Device_Number) return Boolean
   with Pre => Stat'First = 1 and then Stat'Last < Integer'Last
   is
      --  The device, which is no pseudo-terminal (containers have the same
      --  numbers), is the terminal of a process' session, such as a login's.
      --  Stat: its /proc/PID/stat, "512 (agetty) S 1 512 512 1088 512 ..."
      Wanted : Texts.Text := Texts.To_Text (" ");
      Blanks : Natural range 0 .. 5 := 0;
   begin
      Texts.Append
        (Wanted,
         Number.Minor mod 2 ** 8 + 2 ** 8 * Number.Major
         + 2 ** 20 * (Number.Minor / 2 ** 8));
      Texts.Append (Wanted, " ");
      --  the name may have a parenthesis, too: the last one counts
      for I in Index (Stat, ")", Ada.Strings.Backward) + 1 .. Stat'Last loop
         pragma Loop_Invariant (Blanks < 5);
         if Stat (I) = ' ' then
            Blanks := Blanks + 1;
            --  before the fifth word after the name
            if Blanks = 5 then
               return Number.Major not in 0 | 136 .. 143  --  0: none
                 and then
                   Index (Stat (I .. Stat'Last), Texts.Image (Wanted)) = I;
            end if;
         end if;
      end loop;
      return False;
   end Is_Of_Session;

   procedure Get_Use (Path : Texts.Text; Used : out Texts.Text) is
      File    : Calls.File_Numbers;
      Table   : String (1 .. 2_048) := (others => ' ');
      Last    : Natural;
      Numbers : String (1 .. 65_536) := (others => ' ');
      Count   : Natural;
      Start   : Positive := 1;
   begin
      Texts.Set (Used, "");
      Calls.Get_Numbers (Texts.Image (Path), File);
      Calls.Get_Start ("/proc/consoles", Table, Last);
      if Is_Console (Table (1 .. Last), File.Itself) then
         Texts.Set (Used, "it is a console of the kernel");
         return;
      end if;
      Calls.Get_Processes (Numbers, Count);
      for I in 1 .. Count loop
         pragma Loop_Invariant (Start <= I);
         if Numbers (I) = ' ' then
            Calls.Get_Start
              ("/proc/" & Numbers (Start .. I - 1) & "/stat", Table, Last);
            if Is_Of_Session (Table (1 .. Last), File.Itself) then
               Append_Process (Used, Numbers (Start .. I - 1));
               Texts.Append (Used, " has it as its terminal");
               return;
            end if;
            Start := I + 1;
         end if;
      end loop;
   end Get_Use;

   procedure Stop_Blindly is
      Ignored_Length : Robot.Protocol.Frame_Length;
      Ignored        : Boolean;
   begin
      Write
        (Robot.Protocol.Stop, Robot.Session.Not_Started, Ignored_Length,
         Ignored);
      Trace.Put
        (Trace.Ordered, Schedule.Th_Stop,
         Label => Robot.Protocol.Letter (Robot.Protocol.Stop.Kind)
           & "     ");
   end Stop_Blindly;

end Robot.Serial_Line;
