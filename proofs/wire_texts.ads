--  SPDX-License-Identifier: GPL-3.0-or-later
--  The literal texts of both protocols, as in docs/wire.md. Encoder and
--  decoder share one table, so a mistake in it would cancel out. GNATprove
--  compares the tables with these texts.

with Monitor.Protocol; use Monitor.Protocol;
with Order_Meanings;   use Order_Meanings;
with Robot.Protocol;   use Robot.Protocol;
with Robot.Session;

package Wire_Texts with SPARK_Mode, Ghost is

   use type Robot.Session.Outcome_Kind;

   --  Messages of the monitor

   function Is_Label (Text : Label_Text; Kind : Known_Kind) return Boolean is
     (Text =
        (case Kind is
            when Open_Robot                   => "ROPN",
            when Close_Robot                  => "RCLS",
            when Start_Robot                  => "RSOW",
            when Start_Robot_Watchdog         => "RSWW",
            when Reset_Robot                  => "RRST",
            when Ping_Robot                   => "RPIN",
            when Reload_Watchdog              => "RLDW",
            when Go_Forward                   => "RGFW",
            when Go_Backward                  => "RGBW",
            when Go_Left                      => "RGLF",
            when Go_Right                     => "RGRI",
            when Stop_Robot                   => "RSTP",
            when Abort_Mission                => "MABT",
            when Move_Robot                   => "RMOV",
            when Turn_Robot                   => "RTRN",
            when Power_Off_Robot              => "RPOF",
            when Monitor.Protocol.Get_Battery => "RGBT",
            when Get_State                    => "RGST",
            when Open_Camera                  => "COPN",
            when Close_Camera                 => "CCLS",
            when Ask_Arena                    => "CASA",
            when Confirm_Arena                => "CACO",
            when Reject_Arena                 => "CAIN",
            when Start_Position               => "CPCO",
            when Stop_Position                => "CPST",
            when Go_To_Pixels                 => "MGTO",
            when Follow_Pixels                => "MPTH",
            when Go_To_Centimetres            => "MGCM",
            when Follow_Centimetres           => "MPCM",
            when Sign_Of_Life                 => "LIVE",
            when Log_Message                  => "MSSG"));

   procedure Prove_Label (Kind : Known_Kind)
   with Post => Is_Label (Label (Kind), Kind);

   --  The resulting commands to the robot

   function Is_Command
     (Letter : Character; Value : Integer; M : Message) return Boolean
   is (case Robot_Order'(M.Kind) is
          when Open_Robot | Reset_Robot     => Letter = 'r',
          when Start_Robot                  => Letter = 'u',
          when Start_Robot_Watchdog         => Letter = 'W',
          when Ping_Robot                   => Letter = 'p',
          when Reload_Watchdog              => Letter = 'w',
          when Power_Off_Robot              => Letter = 'z',
          when Monitor.Protocol.Get_Battery => Letter = 'v',
          when Get_State                    => Letter = 'b',
          when Close_Robot | Stop_Robot | Abort_Mission =>
            Letter = 'M' and then Value = 0,
          when Go_Forward                   =>
            Letter = 'M' and then Value = 32_767,
          when Go_Backward                  =>
            Letter = 'M' and then Value = -32_768,
          when Go_Left                      =>
            Letter = 'T' and then Value = 32_767,
          when Go_Right                     =>
            Letter = 'T' and then Value = -32_768,
          when Move_Robot                   =>
            Letter = 'M' and then Value = M.Value,
          when Turn_Robot                   =>
            Letter = 'T' and then Value = M.Value)
   with Pre => M.Kind in Robot_Order;
   --  The letter of the frame and the number after it

   procedure Prove_Command (M : Message)
   with
     Pre  => M.Kind in Robot_Order,
     Post => Is_Command
       (Letter (Robot.Session.Command_For (Request_Of (M)).Kind),
        Robot.Session.Command_For (Request_Of (M)).Value, M);

   --  Answers to the monitor

   function Says (Line : Short_Text; Text : String) return Boolean is
     (Line.Length = Text'Length + 1
      and then Line.Data (1 .. Text'Length) = Text
      and then Line.Data (Line.Length) = Line_Feed)
   with Pre => Text'Length < Max_Short;

   procedure Prove_Answer
     (Kind : Robot_Order; Result : Robot.Session.Outcome)
   with
     Post => Says
       (Wire_Text (Answer_To (Kind, Result)),
        (case Result.Kind is
            when Robot.Session.Refused    => "ACRJ",
            when Robot.Session.Timed_Out  => "ATIM",
            when Robot.Session.Not_Open
               | Robot.Session.Not_Opened => "ANAK",
            when Robot.Session.Done       =>
              (if Kind = Monitor.Protocol.Get_Battery then
                 (case Result.Value is
                     when 0 => "RBLV:0",
                     when 1 => "RBLV:1",
                     when 2 => "RBLV:2")
               elsif Kind = Get_State then
                 (if Result.Value = 0 then "RCST:0" else "RCST:1")
               else "AACK")));

   procedure Prove_Vision_Answer (Done : Boolean)
   with
     Post => Says
       (Wire_Text (Answer_To (Done)), (if Done then "AACK" else "ANAK"));

   procedure Prove_Other_Answers
   with
     Post => Says (Wire_Text (Not_Understood), "ACER")
       and then Says (Wire_Text (Monitor.Protocol.Timed_Out), "ATIM")
       and then Says (Wire_Text (Battery_Answer (-1)), "RBLV:-1");

end Wire_Texts;
