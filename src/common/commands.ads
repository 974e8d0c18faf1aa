--  SPDX-License-Identifier: GPL-3.0-or-later
--  The table of commands: all that distinguishes one command of the monitor
--  from the others. Its urgency and the robot's frame follow from what it asks
--  of the robot (Robot.Session, Robot.Requests).

with Interfaces;
with Missions;
with Schedule; use Schedule;

package Commands with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Commands);  --  proved

   --  What is asked of the robot

   subtype Argument is Integer range -32_768 .. 32_767;
   --  Millimetres or degrees; the firmware uses 16 bits

   type Movement_Kind is (Move, Turn);

   type Movement is record
      Kind  : Movement_Kind := Move;
      Value : Argument      := 0;
   end record;

   Forward  : constant Movement := (Move, 32_767);
   Backward : constant Movement := (Move, -32_768);
   Left     : constant Movement := (Turn, 32_767);
   Right    : constant Movement := (Turn, -32_768);
   Still    : constant Movement := (Move, 0);

   type Request_Kind is
     (Open_Line,        --  then resets the robot: a known state
      Close_Line,       --  stops a started robot first
      Start,            --  without watchdog
      Start_Watchdog,
      Reset,            --  stops a started robot first
      Ping,
      Power_Off,        --  stops a started robot first
      Get_Battery,
      Get_Version,
      Get_Moving,
      Drive,            --  a movement order: only while started
      Stop,             --  sent unless the robot is known not to run: firmware
                        --  dumber-v2 may hang on a stop then
      Reload,           --  the periodic reload of the watchdog
      Reload_By_Hand,   --  by the monitor: no effect during periodic ones
      Keep_Alive);      --  a ping: is the line lost? Keeps the robot on

   type Request is record
      Kind    : Request_Kind := Ping;
      Command : Movement     := Still;
      --  of Drive only
   end record;

   --  What becomes of it

   subtype Answer_Length is Natural range 0 .. 49;

   type Answer_Text is record
      Data   : String (1 .. Answer_Length'Last) := (others => ' ');
      Length : Answer_Length                    := 0;
   end record;
   --  The robot's answer: the first Length characters of Data are valid

   type Outcome_Kind is
     (Done,             --  acknowledged by the robot, or nothing to do
      Refused,          --  refused by the robot, or certain to be
      Timed_Out,        --  no valid answer
      Not_Open,         --  the line is not open
      Not_Opened);      --  the device cannot be opened

   type Note_Kind is
     (Nothing,
      Missed_Window,    --  a reload was refused, the robot still runs
      Not_Running,      --  a reload, or a movement or stop, and then a stop
                        --  was refused: the robot has stopped running
      Robot_Lost);      --  the fourth failure in a row: the line is closed

   type Outcome is record
      Kind : Outcome_Kind := Done;
      Text : Answer_Text;
      --  the robot's, when Done
      Note : Note_Kind := Nothing;
   end record;

   function Is_Zero (Result : Outcome) return Boolean is
     (Result.Text.Data (1) = '0');
   --  Of Get_Battery: it is empty; of Get_Moving: the robot does not move

   --  The commands of the monitor

   type Command_Name is
     (Open_Robot,
      Close_Robot,
      Start_Robot,
      Start_Robot_Watchdog,
      Reset_Robot,
      Ping_Robot,
      Reload_Watchdog,
      Go_Forward,
      Go_Backward,
      Go_Left,
      Go_Right,
      Stop_Robot,
      Abort_Mission,
      Move_Robot,
      Turn_Robot,
      Power_Off_Robot,
      Get_Battery,
      Get_Version,
      Get_State,
      Open_Camera,
      Close_Camera,
      Ask_Arena,
      Confirm_Arena,
      Reject_Arena,
      Get_Ground,
      Start_Position,
      Stop_Position,
      Go_To_Pixels,
      Follow_Pixels,
      Go_To_Centimetres,
      Follow_Centimetres,
      Sign_Of_Life,
      Log_Message,
      Malformed);  --  a line that is none of these

   subtype Known_Command is Command_Name range Open_Robot .. Log_Message;
   subtype Robot_Command is Command_Name range Open_Robot .. Get_State;
   subtype Vision_Command is Command_Name range Open_Camera .. Stop_Position;
   subtype Mission_Command is
     Command_Name range Go_To_Pixels .. Follow_Centimetres;

   type Data_Kind is
     (None,
      Number,
      Text,
      Pixel_Point,   --  one point, or a path of several, in pixels of the
      Pixel_Path,    --  image or in centimetres of the arena
      Arena_Point,
      Arena_Path);

   subtype Path_Data is Data_Kind range Pixel_Point .. Arena_Path;

   subtype Label_Text is String (1 .. 4);

   Done_Label : constant Label_Text := "AACK";
   No_Reply   : constant Label_Text := "    ";

   type Row is record
      Label : Label_Text;
      Data  : Data_Kind;
      By    : Task_Name;
      --  the thread that carries it out
      Asks  : Request;
      --  of the robot; No_Request: it is no Robot_Command. The number that is
      --  the data becomes that of the movement
      Reply : Label_Text;
      --  when it is done. Any but Done_Label is followed by data
   end record;

   No_Request : constant Request := (Ping, Still);

   function Table (Name : Command_Name) return Row is
     (case Name is
      when Open_Robot =>
        ("ROPN", None, Th_Open_Com_Robot, (Open_Line, Still), Done_Label),
      when Close_Robot =>
        ("RCLS", None, Th_Open_Com_Robot, (Close_Line, Still), Done_Label),
      when Start_Robot =>
        ("RSOW", None, Th_Start_Robot, (Start, Still), Done_Label),
      when Start_Robot_Watchdog =>
        ("RSWW", None, Th_Start_Robot_WD, (Start_Watchdog, Still), Done_Label),
      when Reset_Robot =>
        ("RRST", None, Th_Reset_Robot, (Reset, Still), Done_Label),
      when Ping_Robot =>
        ("RPIN", None, Th_Open_Com_Robot, (Ping, Still), Done_Label),
      when Reload_Watchdog =>
        ("RLDW", None, Th_Start_Robot_WD, (Reload_By_Hand, Still), Done_Label),
      when Go_Forward =>
        ("RGFW", None, Th_Move, (Drive, Forward), Done_Label),
      when Go_Backward =>
        ("RGBW", None, Th_Move, (Drive, Backward), Done_Label),
      when Go_Left =>
        ("RGLF", None, Th_Move, (Drive, Left), Done_Label),
      when Go_Right =>
        ("RGRI", None, Th_Move, (Drive, Right), Done_Label),
      when Stop_Robot =>
        ("RSTP", None, Th_Move, (Stop, Still), Done_Label),
      when Abort_Mission =>
        ("MABT", None, Th_Move, (Stop, Still), Done_Label),
      when Move_Robot =>
        ("RMOV", Number, Th_Move, (Drive, (Move, 0)), Done_Label),
      when Turn_Robot =>
        ("RTRN", Number, Th_Move, (Drive, (Turn, 0)), Done_Label),
      when Power_Off_Robot =>
        ("RPOF", None, Th_Reset_Robot, (Power_Off, Still), Done_Label),
      when Get_Battery =>
        ("RGBT", None, Th_Battery_Level, (Get_Battery, Still), "RBLV"),
      when Get_Version =>
        ("RVER", None, Th_Open_Com_Robot, (Get_Version, Still), "RVER"),
      when Get_State =>
        ("RGST", None, Th_Move, (Get_Moving, Still), "RCST"),
      when Open_Camera =>
        ("COPN", None, Th_Camera_Control, No_Request, Done_Label),
      when Close_Camera =>
        ("CCLS", None, Th_Camera_Control, No_Request, Done_Label),
      when Ask_Arena =>
        ("CASA", None, Th_Arene, No_Request, "CIMG"),
      when Confirm_Arena =>
        ("CACO", None, Th_Arene, No_Request, No_Reply),
      when Reject_Arena =>
        ("CAIN", None, Th_Arene, No_Request, No_Reply),
      when Get_Ground =>
        ("CARN", None, Th_Arene, No_Request, "CARN"),
      when Start_Position =>
        ("CPCO", None, Th_Camera_Control, No_Request, Done_Label),
      when Stop_Position =>
        ("CPST", None, Th_Camera_Control, No_Request, Done_Label),
      when Go_To_Pixels =>
        ("MGTO", Pixel_Point, Th_Mission, No_Request, Done_Label),
      when Follow_Pixels =>
        ("MPTH", Pixel_Path, Th_Mission, No_Request, Done_Label),
      when Go_To_Centimetres =>
        ("MGCM", Arena_Point, Th_Mission, No_Request, Done_Label),
      when Follow_Centimetres =>
        ("MPCM", Arena_Path, Th_Mission, No_Request, Done_Label),
      when Sign_Of_Life =>
        ("LIVE", None, Th_Receive_From_Mon, No_Request, No_Reply),
      when Log_Message =>
        ("MSSG", Text, Th_Receive_From_Mon, No_Request, No_Reply),
      when Malformed =>
        ("none", None, Th_Receive_From_Mon, No_Request, "ACER"));

   type Command is record
      Name  : Command_Name := Malformed;
      Value : Argument     := 0;
   end record;
   --  As it was received. Value: its number, if it takes one, otherwise 0.
   --  The path of a mission and a text are read from its line

   function Takes_Number (Name : Command_Name) return Boolean is
     (Table (Name).Data = Number);

   function Is_Answered (Name : Command_Name) return Boolean is
     (Table (Name).Reply /= No_Reply);
   --  The monitor gets exactly one reply, or none

   function Measure (Name : Mission_Command) return Missions.Unit is
     (if Table (Name).Data in Pixel_Point | Pixel_Path then Missions.Pixels
      else Missions.Centimetres);

   function Most_Points (Name : Mission_Command) return Missions.Point_Number
   is (if Table (Name).Data in Pixel_Point | Arena_Point then 1
       else Missions.Max_Points);
   --  Of its path

   function Request_Of (C : Command) return Request is
     (if Takes_Number (C.Name) then
        (Drive, (Table (C.Name).Asks.Command.Kind, C.Value))
      else Table (C.Name).Asks);

   function Is_By_Hand (Name : Command_Name) return Boolean is
     (Name in Robot_Command
      and then Table (Name).Asks.Kind in
        Close_Line | Reset | Power_Off | Drive | Stop);
   --  It moves or stops the robot, and so ends a mission, which sends nothing
   --  more. An opened line and a started robot stay as they are when they are
   --  opened and started again; a new start ends the mission, too, but with a
   --  stop of its own

   --  On the way to the task that carries it out

   type Ticket is new Interfaces.Unsigned_64;
   --  The number of a command, counted from 1 over the whole run: unique
   --  across sessions. 0: none

   Capacity : constant := 256;
   --  Commands that may wait for their answers (docs/wire.md, rule 2)

   subtype Order_Count is Natural range 0 .. Capacity;

   type Order is record
      Number  : Ticket := 0;
      Command : Commands.Command;
      After   : Ticket := 0;
      --  the last earlier order that changes the robot's session (opens,
      --  closes, starts, resets), which is carried out first
      Owed    : Boolean := False;
      --  its answer is still due, or later commands wait for it: the task that
      --  holds the order answers it or passes it on, once
   end record;

end Commands;
