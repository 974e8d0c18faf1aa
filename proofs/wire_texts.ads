--  SPDX-License-Identifier: GPL-3.0-or-later
--  The literal texts of both protocols, as in docs/wire.md. Encoder and
--  decoder share one table, so a mistake in it would cancel out. GNATprove
--  compares the tables with these texts.

with Commands;         use Commands;
with Monitor.Protocol; use Monitor.Protocol;
with Robot.Protocol;   use Robot.Protocol;
with Robot.Session;

package Wire_Texts with SPARK_Mode, Ghost is

   use type Commands.Outcome_Kind;

   --  Commands of the monitor

   procedure Prove_Labels
   with
     Post => Table (Open_Robot).Label = "ROPN"
       and then Table (Close_Robot).Label = "RCLS"
       and then Table (Start_Robot).Label = "RSOW"
       and then Table (Start_Robot_Watchdog).Label = "RSWW"
       and then Table (Reset_Robot).Label = "RRST"
       and then Table (Ping_Robot).Label = "RPIN"
       and then Table (Reload_Watchdog).Label = "RLDW"
       and then Table (Go_Forward).Label = "RGFW"
       and then Table (Go_Backward).Label = "RGBW"
       and then Table (Go_Left).Label = "RGLF"
       and then Table (Go_Right).Label = "RGRI"
       and then Table (Stop_Robot).Label = "RSTP"
       and then Table (Abort_Mission).Label = "MABT"
       and then Table (Move_Robot).Label = "RMOV"
       and then Table (Turn_Robot).Label = "RTRN"
       and then Table (Power_Off_Robot).Label = "RPOF"
       and then Table (Get_Battery).Label = "RGBT"
       and then Table (Get_Version).Label = "RVER"
       and then Table (Get_State).Label = "RGST"
       and then Table (Open_Camera).Label = "COPN"
       and then Table (Close_Camera).Label = "CCLS"
       and then Table (Ask_Arena).Label = "CASA"
       and then Table (Confirm_Arena).Label = "CACO"
       and then Table (Reject_Arena).Label = "CAIN"
       and then Table (Get_Ground).Label = "CARN"
       and then Table (Start_Position).Label = "CPCO"
       and then Table (Stop_Position).Label = "CPST"
       and then Table (Go_To_Pixels).Label = "MGTO"
       and then Table (Follow_Pixels).Label = "MPTH"
       and then Table (Go_To_Centimetres).Label = "MGCM"
       and then Table (Follow_Centimetres).Label = "MPCM"
       and then Table (Sign_Of_Life).Label = "LIVE"
       and then Table (Log_Message).Label = "MSSG";

   --  The resulting commands to the robot

   function Is_Frame
     (Letter : Character; Value : Integer; C : Commands.Command)
     return Boolean
   is (case Robot_Command'(C.Name) is
          when Open_Robot | Reset_Robot => Letter = 'r',
          when Start_Robot              => Letter = 'u',
          when Start_Robot_Watchdog     => Letter = 'W',
          when Ping_Robot               => Letter = 'p',
          when Reload_Watchdog          => Letter = 'w',
          when Power_Off_Robot          => Letter = 'z',
          when Get_Battery              => Letter = 'v',
          when Get_Version              => Letter = 'V',
          when Get_State                => Letter = 'b',
          when Close_Robot | Stop_Robot | Abort_Mission =>
            Letter = 'M' and then Value = 0,
          when Go_Forward               =>
            Letter = 'M' and then Value = 32_767,
          when Go_Backward              =>
            Letter = 'M' and then Value = -32_768,
          when Go_Left                  =>
            Letter = 'T' and then Value = 32_767,
          when Go_Right                 =>
            Letter = 'T' and then Value = -32_768,
          when Move_Robot               =>
            Letter = 'M' and then Value = C.Value,
          when Turn_Robot               =>
            Letter = 'T' and then Value = C.Value)
   with Pre => C.Name in Robot_Command;
   --  The letter of the frame and the number after it

   procedure Prove_Frame (C : Commands.Command)
   with
     Pre  => C.Name in Robot_Command,
     Post => Is_Frame
       (Letter (Robot.Session.Command_For (Request_Of (C)).Kind),
        Robot.Session.Command_For (Request_Of (C)).Value, C);

   --  Replies to the monitor

   function Says (Line : Short_Text; Text : String) return Boolean is
     (Line.Length = Text'Length + 1
      and then Line.Data (1 .. Text'Length) = Text
      and then Line.Data (Line.Length) = Line_Feed)
   with Pre => Text'Length < Max_Short_Line;

   procedure Prove_Reply
     (Name : Robot_Command; Result : Commands.Outcome)
   with
     Post =>
       (case Result.Kind is
           when Commands.Refused    =>
             Reply_To (Name, Result) = Monitor.Protocol.Refused,
           when Commands.Timed_Out  =>
             Reply_To (Name, Result) = Monitor.Protocol.Timed_Out,
           when Commands.Not_Open | Commands.Not_Opened =>
             Reply_To (Name, Result) = Not_Done,
           when Commands.Done       =>
             (if Name not in Get_Battery | Get_Version | Get_State then
                 Reply_To (Name, Result) = Acknowledged));

   procedure Prove_Data_Labels
   with
     Post => Table (Get_Battery).Reply = "RBLV"
       and then Table (Get_Version).Reply = "RVER"
       and then Table (Get_State).Reply = "RCST"
       and then Separator = ':';
   --  Of the replies with data, which Reply_To writes after them

   procedure Prove_Vision_Reply (Done : Boolean)
   with
     Post => Reply_To (Done) = (if Done then Acknowledged else Not_Done);

   procedure Prove_Battery (Result : Commands.Outcome)
   with
     Post =>
       (if Result.Kind = Commands.Done
        then Battery_Notice (Result) = Reply_To (Get_Battery, Result)
        else Says (Battery_Notice (Result), "RBLV:-1"));

   procedure Prove_Texts
   with
     Post => Says (Acknowledged, "AACK")
       and then Says (Not_Done, "ANAK")
       and then Says (Monitor.Protocol.Refused, "ACRJ")
       and then Says (Monitor.Protocol.Timed_Out, "ATIM")
       and then Says (Not_Understood, "ACER");

end Wire_Texts;
