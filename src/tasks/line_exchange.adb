--  SPDX-License-Identifier: GPL-3.0-or-later
--  Carries out a request on the serial line, step by step as the session's
--  logic says. For the owner of the line only.

with Ada.Real_Time;  use Ada.Real_Time;
with Bytes;
with Interfaces;
with Journal;
with Options;
with Robot_Protocol; use Robot_Protocol;
with Schedule;
with Serial_Line;
with Settings;
with Texts;
with Trace;

package body Line_Exchange with SPARK_Mode is

   use type Interfaces.Unsigned_64;
   use type Robot_Session.Mode_Kind;
   use type Robot_Session.Step_Kind;
   use type Serial_Line.Line_Record;

   procedure Open_Device (Success : out Boolean);

   function Is_Written (Item : Command; Before : Serial_Line.Line_Record)
     return Boolean
   is (Serial_Line.Written.Count = Before.Count + 1
       and then Serial_Line.Written.Last.OK
       and then Serial_Line.Written.Last.Value.Kind = Item.Kind
       and then
         (if Item.Kind in With_Argument then
             Serial_Line.Written.Last.Value.Value = Item.Value))
   with Ghost;
   --  Since Before one frame has been written, that of Item

   procedure Exchange
     (Item      : Command;
      Skip_Late : Boolean;
      Ok        : out Boolean;
      Answer    : out Reply)
   with Post => Is_Written (Item, Serial_Line.Written'Old);
   --  Sends Item and waits for its answer. Skip_Late: frames that are no
   --  answer of its class are late ones to earlier commands

   procedure Take_Step
     (State    : Robot_Session.State;
      Progress : Robot_Session.Progress;
      Step     : Robot_Session.Step;
      Last     : out Robot_Session.Step_Result)
   with
     Pre  => Robot_Session.Is_Under_Way (State, Progress)
       and then Robot_Session.Is_Allowed (State, Progress, Step),
     Post =>
       (if Robot_Session.Is_Sent (Step) then
           Is_Written (Step.Command, Serial_Line.Written'Old)
           and then
             (if Is_Movement (Serial_Line.Written.Last) then
                 State.Mode /= Robot_Session.Not_Started)
        else Serial_Line.Written = Serial_Line.Written'Old);
   --  What goes over the line is the step's command and nothing else; and a
   --  movement only while the robot is started

   -----------------
   -- Open_Device --
   -----------------

   procedure Open_Device (Success : out Boolean) is
      Chosen : Options.Values renames Settings.Command_Line.Chosen;
      Reason : Texts.Text;
      Line   : Texts.Text;
   begin
      Serial_Line.Open (Chosen.Serial, Success, Reason);
      if Success then
         Texts.Set (Line, "robot line open on ");
      else
         Texts.Set (Line, "robot line cannot be opened on ");
      end if;
      Texts.Append (Line, Chosen.Serial.Data (1 .. Chosen.Serial.Length));
      if Success then
         Journal.Put (Options.Info, Line);
      else
         Texts.Append (Line, ": ");
         Texts.Append (Line, Reason.Data (1 .. Reason.Length));
         Journal.Put (Options.Error, Line);
      end if;
   end Open_Device;

   --------------
   -- Exchange --
   --------------

   procedure Exchange
     (Item      : Command;
      Skip_Late : Boolean;
      Ok        : out Boolean;
      Answer    : out Reply)
   is
      Out_Frame : Frame;
      In_Frame  : Frame;
      Receiving : Receiver;
      Data      : Bytes.Byte_Array (1 .. Max_Frame);
      Length    : Natural;
      Alive     : Boolean;
      Complete  : Boolean;
      Deadline  : Time;
      Now       : Time;
   begin
      Answer := (others => <>);
      Encode (Item, Out_Frame);
      Serial_Line.Discard_Input;
      Clear (Receiving);
      Deadline := Clock;
      Deadline := Deadline + Schedule.Answer_Timeout
        + Out_Frame.Length * Schedule.Byte_Time;
      Serial_Line.Write (Out_Frame, Ok);
      Trace.Ordered (Schedule.Th_Line, Item.Kind);
      Trace.Wait (Schedule.Th_Line, Trace.Answer);
      if not Ok then
         return;
      end if;
      Ok := False;
      loop
         Serial_Line.Read (Data, Length, Deadline, Alive);
         if not Alive or else Length = 0 then
            return;
         end if;
         for I in 1 .. Length loop
            Accept_Byte (Receiving, Data (I), Complete);
            if Complete then
               Get (Receiving, In_Frame);
               Decode (In_Frame, Item.Kind, Answer);
               if Skip_Late then
                  Ok := Is_Answer (Answer.Kind, Item.Kind);
               else
                  Ok := Answer.Kind not in Failed_Reply;
                  return;
               end if;
            end if;
            exit when Ok;
         end loop;
         exit when Ok;
         --  a line that never falls silent does not put the deadline off
         Now := Clock;
         exit when Now >= Deadline;
      end loop;
   end Exchange;

   ---------------
   -- Carry_Out --
   ---------------

   procedure Carry_Out
     (State   : in out Robot_Session.State;
      Request : Robot_Session.Request;
      Result  : out Robot_Session.Outcome)
   is
      Progress : Robot_Session.Progress;
      Step     : Robot_Session.Step;
      Last     : Robot_Session.Step_Result;
   begin
      Robot_Session.Start_Request (State, Request, Progress, Step);
      while Step.Kind /= Robot_Session.Finish loop
         pragma Loop_Invariant (Robot_Session.Is_Under_Way (State, Progress));
         pragma Loop_Invariant
           (Robot_Session.Is_Allowed (State, Progress, Step));
         pragma Loop_Variant
           (Decreases => Robot_Session.Steps_Left (State, Progress));
         Take_Step (State, Progress, Step, Last);
         Trace.Resume (Schedule.Th_Line);
         Robot_Session.Continue_Request (State, Progress, Last, Step);
      end loop;
      Result := Robot_Session.Result (Progress);
   end Carry_Out;

   ---------------
   -- Take_Step --
   ---------------

   procedure Take_Step
     (State    : Robot_Session.State;
      Progress : Robot_Session.Progress;
      Step     : Robot_Session.Step;
      Last     : out Robot_Session.Step_Result)
   is
      pragma Unreferenced (State, Progress);
      Sending : Frame;
   begin
      Last := (others => <>);
      case Step.Kind is
         when Robot_Session.Open_Device =>
            Open_Device (Last.Ok);
         when Robot_Session.Close_Device =>
            Serial_Line.Close;
            Journal.Put (Options.Info, "robot line closed");
         when Robot_Session.Send =>
            Encode (Step.Command, Sending);
            Serial_Line.Write (Sending, Last.Ok);
            Trace.Ordered (Schedule.Th_Line, Step.Command.Kind);
         when Robot_Session.Exchange =>
            Exchange (Step.Command, False, Last.Ok, Last.Reply);
         when Robot_Session.Synchronise =>
            Exchange (Step.Command, True, Last.Ok, Last.Reply);
         when Robot_Session.Finish =>
            null;
      end case;
   end Take_Step;

end Line_Exchange;
