--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time;  use Ada.Real_Time;
with Bytes;          use type Bytes.Byte;
with Command_Lines;
with Journal;
with Options;
with Robot.Health;
with Robot.Protocol; use Robot.Protocol;
with Robot.Serial_Line;
with Robot.Session;  use Robot.Session;
with Texts;
with Trace;

package body Robot.Exchange with SPARK_Mode is

   use type Commands.Outcome_Kind;
   use type Commands.Request_Kind;

   procedure Open_Device
     (Held : in out Line_Status.Dialogue; Success : out Boolean)
   is
      Chosen : Options.Values renames Command_Lines.Given.Chosen;
      Reason : Texts.Text;
   begin
      Serial_Line.Open (Chosen.Serial, Success, Reason);
      Held.Told := False;
      Held.Unasked := 0;
      Held.Gone := False;
      if Success then
         Journal.Put
           (Options.Info, "robot line open on " & Texts.Image (Chosen.Serial));
      else
         Journal.Put
           (Options.Error,
            "robot line cannot be opened on " & Texts.Image (Chosen.Serial)
            & ": " & Texts.Image (Reason));
      end if;
   end Open_Device;

   procedure Discard_Input
     (Held      : in out Line_Status.Dialogue;
      Kind      : Command_Kind;
      In_Step   : Boolean;
      Until_Now : Time;
      Talks     : out Boolean)
   is
      --  Discards what has come before a command of Kind is sent. Talks: there
      --  was a whole frame in step. That may be noise, or the device goes on
      --  like that
      In_Frame : Frame;
      Data     : Bytes.Byte_Array (1 .. Max_Frame);
      Length   : Natural;
   begin
      Talks := False;
      Serial_Line.Read (Data, Length, Until_Now, Held.Gone);
      if Length > 0 then
         Serial_Line.Discard_Input;
      end if;
      if not In_Step then
         return;
      end if;
      for I in 1 .. Length loop
         if Data (I) /= Terminator then
            Append (In_Frame, Data (I));
         else
            Talks := Talks
              or else Decode (In_Frame, Kind).Kind
                not in Bad_Checksum | Malformed;
            In_Frame.Length := 0;
         end if;
      end loop;
      Held.Unasked :=
        (if Talks then Natural'Min (Held.Unasked + 2, 6)
         else Natural'Max (Held.Unasked - 1, 0));
      if Talks and then not Held.Told then
         Held.Told := True;
         Journal.Put
           (Options.Warning,
            "the device of the robot's line sends without being asked");
      end if;
   end Discard_Input;

   procedure Exchange
     (Who   : Schedule.Task_Name;
      Held  : in out Line_Status.Dialogue;
      Item  : Command;
      State : Session.State;
      Last  : out Step_Result)
   with Pre => (if Is_Movement (Item) then State.Mode /= Not_Started)
   is
      --  Sends Item and waits for its answer. Out of step, frames of other
      --  classes are late answers to earlier commands, and are skipped.
      --  Otherwise none is due before, and what a device sends that goes on
      --  sending is no answer
      In_Step  : constant Boolean := Health.In_Step (State.Health);
      In_Frame : Frame;
      Data     : Bytes.Byte_Array (1 .. Max_Frame);
      Ignored  : Bytes.Byte_Array (1 .. Max_Frame);
      Length   : Natural;
      Talks    : Boolean;
      Has_Left : Time;
      Deadline : Time;
      Now      : Time;
   begin
      Last := (others => <>);
      Now := Clock;
      Discard_Input (Held, Item.Kind, In_Step, Now, Talks);
      Serial_Line.Write (Who, Item, State.Mode, Length);
      Has_Left := Now + Length * Schedule.Byte_Time;
      Deadline := Has_Left
        + Milliseconds (Command_Lines.Given.Chosen.Answer_Timeout);
      Trace.Put (Trace.Wait, Who, Label => Trace.Answer);
      if Length = 0 or else Held.Unasked > 4
        or else (Held.Unasked > 0 and then Item.Kind in Start | Start_Watchdog)
      then
         return;
      end if;
      loop
         Serial_Line.Read (Data, Length, Deadline, Held.Gone);
         Now := Clock;
         --  before it has left the robot cannot have heard the command
         if Length = 0 or else (Talks and then Now < Has_Left) then
            return;
         end if;
         for I in 1 .. Length loop
            if Data (I) /= Terminator then
               Append (In_Frame, Data (I));
            else
               Last.Reply := Decode (In_Frame, Item.Kind);
               Last.Text := Text_Of (In_Frame);
               In_Frame.Length := 0;
               Last.Ok :=
                 (if In_Step then
                     Last.Reply.Kind not in Failed_Reply
                     and then not (Talks and then I < Length)
                  else Is_Answer (Last.Reply.Kind, Item.Kind));
               if not Last.Ok and then In_Step then
                  return;
               end if;
            end if;
            exit when Last.Ok;
         end loop;
         exit when Last.Ok;
         --  a line that never falls silent must not postpone the time-out
         exit when Now >= Deadline;
      end loop;
      if Last.Ok and then (Talks or else not In_Step) then
         --  a device that goes on sending is no robot
         Serial_Line.Read (Ignored, Length, Deadline, Held.Gone);
         Last.Ok := not Held.Gone and then Length = 0;
      end if;
   end Exchange;

   procedure Take_Step
     (Who   : Schedule.Task_Name;
      Held  : in out Line_Status.Dialogue;
      State : Session.State;
      Step  : Session.Step;
      Last  : out Step_Result)
   is
      Length   : Frame_Length;
      All_Sent : Boolean;
   begin
      Last := (others => <>);
      case Step.Kind is
         when Open_Device =>
            Open_Device (Held, Last.Ok);
         when Close_Device =>
            Serial_Line.Close (All_Sent);
            if All_Sent then
               Journal.Put (Options.Info, "robot line closed");
            else
               Journal.Put
                 (Options.Warning,
                  "robot line closed: its device did not take all within "
                  & "100 ms, the rest was discarded");
            end if;
         when Send =>
            Serial_Line.Write (Who, Step.Command, State.Mode, Length);
            Last.Ok := Length > 0;
         when Session.Exchange =>
            Exchange (Who, Held, Step.Command, State, Last);
         when Finish =>
            null;
      end case;
   end Take_Step;

   procedure Carry_Out
     (Who     : Schedule.Task_Name;
      Held    : in out Line_Status.Dialogue;
      Request : Commands.Request;
      Result  : out Commands.Outcome)
   is
      State    : Session.State := Held.State;
      Progress : Session.Progress;
      Step     : Session.Step;
      Last     : Step_Result;
   begin
      Start_Request
        (State,
         (if Request.Kind = Commands.Open_Line and then State.Line_Open
          then (Kind => Commands.Ping, others => <>)
          else Request),
         Progress);
      loop
         pragma Loop_Invariant (Is_Under_Way (State, Progress));
         pragma Loop_Variant
           (Decreases => Steps_Left (State, Progress));
         Step := Next_Step (State, Progress);
         exit when Step.Kind = Finish;
         if Is_Sent (Step)
           and then Step.Command.Kind in Start | Start_Watchdog | Reload
         then
            Held.Counted := Clock;
         end if;
         Take_Step (Who, Held, State, Step, Last);
         Trace.Put (Trace.Resume, Who);
         Continue_Request (State, Progress, Last);
      end loop;
      Held.State := State;
      Result := Progress.Result;
      Held.Empty := State.Line_Open
        and then
          (if Request.Kind = Commands.Get_Battery
             and then Result.Kind = Commands.Done
           then Commands.Is_Zero (Result) else Held.Empty);
   end Carry_Out;

end Robot.Exchange;
