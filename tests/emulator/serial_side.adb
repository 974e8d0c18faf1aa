--  SPDX-License-Identifier: GPL-3.0-or-later
--  The serial line's task: bytes between the pseudo-terminal and the robot.

with Ada.Exceptions;
with Ada.Text_IO;
with Interfaces.C;     use Interfaces.C;

with GNAT.OS_Lib;

with Answer_Faults;
with Instants;         use Instants;
with Libc;             use Libc;
with Own_Process;
with Polls;
with Pseudo_Terminals; use Pseudo_Terminals;
with Robot_Bench;

package body Serial_Side is

   type Request_Kind is (Send, Hang, Return_Line, Finish);

   subtype Data_Length is Natural range 0 .. 256;

   type Request (Length : Data_Length := 0) is record
      Kind : Request_Kind := Finish;
      Data : Robot_Core.Octets (1 .. Length);
   end record;

   protected Desk is

      entry Ask (R : Request);
      procedure Take (R : out Request; Present : out Boolean);
      procedure Answer (Text : Unbounded_String);
      entry Wait (Text : out Unbounded_String);
      procedure Set_Device (Name : Unbounded_String);
      function Device_Name return Unbounded_String;

   private
      Waiting  : Boolean := False;   --  a request not yet taken
      Answered : Boolean := False;
      Busy     : Boolean := False;   --  from the request to its answer
      Current  : Request;
      Outcome  : Unbounded_String;
      Device   : Unbounded_String := To_Unbounded_String ("-");
   end Desk;
   --  Where other tasks leave what they want of the line

   Bell : constant int := Eventfd (0, O_Nonblock + O_Cloexec);
   --  Rung when a request is there

   function Ask (R : Request) return String;
   --  Leaves the request, wakes the task and waits for the outcome

   task Carrier is
      entry Start
        (Baud : Baud_Rate; Link : String; Problem : out Unbounded_String);
   end Carrier;

   --  Bytes on their way

   type Timed_Byte is record
      Byte    : Robot_Core.Octet := 0;
      Started : Instant := 0;
      Ended   : Instant := 0;
   end record;

   Room : constant := 1_024;
   --  In each direction. Towards the robot, what does not fit waits in the
   --  terminal, as it would in a real one's driver.

   type Timed_Bytes is array (0 .. Room - 1) of Timed_Byte;

   type Queue is record
      Data  : Timed_Bytes;
      Head  : Natural := 0;
      Count : Natural := 0;
      Until_When : Instant := 0;
      --  End of the last byte
   end record;

   procedure Add
     (Q : in out Queue; Byte : Robot_Core.Octet; From, Time : Instant);
   --  A byte that may start at From takes Time; dropped where Q is full

   procedure Remove_Head (Q : in out Queue);

   function Is_Due (Q : Queue; Time : Instant) return Boolean is
     (Q.Count > 0 and then Q.Data (Q.Head).Ended <= Time);

   procedure Add
     (Q : in out Queue; Byte : Robot_Core.Octet; From, Time : Instant)
   is
      Started : constant Instant := Instant'Max (From, Q.Until_When);
   begin
      if Q.Count < Room then
         Q.Until_When := Started + Time;
         Q.Data ((Q.Head + Q.Count) mod Room) :=
           (Byte, Started, Q.Until_When);
         Q.Count := Q.Count + 1;
      end if;
   end Add;

   function Ask (R : Request) return String is
      One     : constant Interfaces.Unsigned_64 := 1;
      Ignored : long;
      Text    : Unbounded_String;
   begin
      Desk.Ask (R);
      Ignored := Write (Bell, One'Address, One'Size / 8);
      Desk.Wait (Text);
      return To_String (Text);
   end Ask;

   task body Carrier is

      Idle_Wait : constant Instant := 1_000_000_000;
      --  The robot is made to grow older at least this often

      Above_Tasks : constant := 50;
      --  A priority above every task of a supervisor on the same machine, as
      --  the robot's own processor would be

      The_Line  : Line;
      Link_Path : Unbounded_String;
      Byte_Time : Instant := 0;
      To_Robot  : Queue;
      To_Client : Queue;

      procedure Open_Line (Problem : out Unbounded_String);
      procedure Close_Line;
      procedure Publish;
      procedure Serve_Requests;
      procedure Deliver;
      procedure Babble;
      procedure Transmit;
      procedure Collect;
      procedure Wait;

      procedure Babble is
         Shortest : constant Instant := 200_000;
         --  Where bytes take no time an endless answer still does

         Byte    : Robot_Core.Octet;
         Present : Boolean;
      begin
         if To_Client.Count = 0 then
            Robot_Bench.Bench.Babble (Byte, Present);
            if Present then
               Add (To_Client, Byte, From => Now,
                    Time => Instant'Max (Byte_Time, Shortest));
            end if;
         end if;
      end Babble;

      procedure Close_Line is
      begin
         if Is_Open (The_Line) then
            if Link_Path /= "" then
               Remove_Link (To_String (Link_Path), Device (The_Line));
            end if;
            Close (The_Line);
         end if;
         To_Robot  := (others => <>);
         To_Client := (others => <>);
      end Close_Line;

      procedure Collect is
         Time   : Instant;
         Data   : Robot_Core.Octets (1 .. Room);
         Length : long;
      begin
         Length := Read
           (Robot_End (The_Line), Data'Address,
            size_t (Room - To_Robot.Count));
         --  The poll said so: there is something, and room for it
         Time := Now;
         for K in 1 .. Integer (long'Max (Length, 0)) loop
            Add (To_Robot, Data (K), From => Time, Time => Byte_Time);
         end loop;
      end Collect;

      procedure Deliver is
         Wire : Answer_Faults.Wire_Bytes;
         Late : Instant;
      begin
         while Is_Due (To_Robot, Now) loop
            declare
               B : constant Timed_Byte := To_Robot.Data (To_Robot.Head);
            begin
               Remove_Head (To_Robot);
               Robot_Bench.Bench.Hear
                 (B.Byte, B.Started, B.Ended, Wire, Late);
               for K in 1 .. Wire.Length loop
                  Add (To_Client, Wire.Data (K), From => B.Ended + Late,
                       Time => Byte_Time);
               end loop;
            end;
         end loop;
      end Deliver;

      procedure Open_Line (Problem : out Unbounded_String) is
         Done : Boolean;
      begin
         Open (The_Line, Done);
         if not Done then
            Problem := To_Unbounded_String
              ("no pseudo-terminal: " & Last_Error);
            return;
         end if;
         Problem := Null_Unbounded_String;
         if Link_Path /= "" then
            declare
               Failure : constant String := Place_Link
                 (To_String (Link_Path), Device (The_Line));
            begin
               if Failure /= "" then
                  Close (The_Line);
                  Problem := "no link at " & Link_Path & ": " & Failure;
               end if;
            end;
         end if;
      end Open_Line;

      procedure Publish is
      begin
         Desk.Set_Device
           (To_Unbounded_String
              (if Is_Open (The_Line) then Device (The_Line) else "-"));
      end Publish;

      procedure Serve_Requests is
         R       : Request;
         Present : Boolean;
         Problem : Unbounded_String;
         Hung_Up : constant Unbounded_String :=
           To_Unbounded_String ("the line is hung up");
      begin
         Desk.Take (R, Present);
         if not Present then
            return;
         end if;

         case R.Kind is
            when Send =>
               if Is_Open (The_Line) then
                  for K in R.Data'Range loop
                     Add (To_Client, R.Data (K), From => Now,
                          Time => Byte_Time);
                  end loop;
               else
                  Problem := Hung_Up;
               end if;

            when Hang =>
               if Is_Open (The_Line) then
                  Close_Line;
               else
                  Problem := Hung_Up & " already";
               end if;

            when Return_Line =>
               if Is_Open (The_Line) then
                  Problem := To_Unbounded_String ("the line is not hung up");
               else
                  Open_Line (Problem);
               end if;

            when Finish =>
               Close_Line;
         end case;

         Publish;
         Desk.Answer (Problem);
      end Serve_Requests;

      procedure Transmit is
         Data    : Robot_Core.Octets (1 .. Room);
         Last    : Natural := 0;
         Ignored : long;
      begin
         while Is_Due (To_Client, Now) loop
            Last := Last + 1;
            Data (Last) := To_Client.Data (To_Client.Head).Byte;
            Remove_Head (To_Client);
         end loop;

         --  What a full terminal does not take is lost, as on a line that
         --  nobody listens to

         if Last > 0 and then Is_Open (The_Line) then
            Ignored := Write
              (Robot_End (The_Line), Data'Address, size_t (Last));
         end if;
      end Transmit;

      procedure Wait is
         Files   : Poll_Array (1 .. 2);
         Time    : constant Instant := Now;
         Wake_Up : Instant := Time + Idle_Wait;
         Rung    : Interfaces.Unsigned_64 := 0;
         Ignored : long;
      begin
         Files (1) := (Bell, Poll_In, 0);
         if Is_Open (The_Line) and then To_Robot.Count < Room then
            Files (2) := (Robot_End (The_Line), Poll_In, 0);
         end if;
         if To_Robot.Count > 0 then
            Wake_Up := Instant'Min
              (Wake_Up, To_Robot.Data (To_Robot.Head).Ended);
         end if;
         if To_Client.Count > 0 then
            Wake_Up := Instant'Min
              (Wake_Up, To_Client.Data (To_Client.Head).Ended);
         end if;

         Polls.Wait (Files, Wake_Up - Time);
         if Files (2).Returned /= 0 then
            Collect;
         end if;
         if Files (1).Returned /= 0 then
            Ignored := Read (Bell, Rung'Address, Rung'Size / 8);
            Serve_Requests;
         end if;
      end Wait;

   begin
      accept Start
        (Baud : Baud_Rate; Link : String; Problem : out Unbounded_String)
      do
         Link_Path := To_Unbounded_String (Link);
         if Baud > 0 then
            Byte_Time := 10 * 1_000_000_000 / Instant (Baud);
         end if;
         Open_Line (Problem);
         Publish;
      end Start;

      Own_Process.Wake_On_Time;
      Own_Process.Prefer_Real_Time (True, Above_Tasks);
      loop
         Deliver;
         Babble;
         Transmit;
         Wait;
         Robot_Bench.Bench.Let_Time_Pass;
      end loop;

   exception
      when Failure : others =>
         Ada.Text_IO.Put_Line
           (Ada.Text_IO.Standard_Error,
            "destijl_emulator: the serial line failed: "
            & Ada.Exceptions.Exception_Information (Failure));
         GNAT.OS_Lib.OS_Exit (3);
   end Carrier;

   protected body Desk is

      procedure Answer (Text : Unbounded_String) is
      begin
         Outcome  := Text;
         Answered := True;
      end Answer;

      entry Ask (R : Request) when not Busy is
      begin
         Busy    := True;
         Waiting := True;
         Current := R;
      end Ask;

      function Device_Name return Unbounded_String is (Device);

      procedure Set_Device (Name : Unbounded_String) is
      begin
         Device := Name;
      end Set_Device;

      procedure Take (R : out Request; Present : out Boolean) is
      begin
         R       := Current;
         Present := Waiting;
         Waiting := False;
      end Take;

      entry Wait (Text : out Unbounded_String) when Answered is
      begin
         Text     := Outcome;
         Answered := False;
         Busy     := False;
      end Wait;

   end Desk;

   function Device return String is (To_String (Desk.Device_Name));

   function Hang_Up return String is
     (Ask ((Length => 0, Kind => Hang, Data => (others => 0))));

   function Put_Back return String is
     (Ask ((Length => 0, Kind => Return_Line, Data => (others => 0))));

   procedure Remove_Head (Q : in out Queue) is
   begin
      Q.Head  := (Q.Head + 1) mod Room;
      Q.Count := Q.Count - 1;
   end Remove_Head;

   function Send_Unasked (Data : Robot_Core.Octets) return String is
     (Ask ((Length => Data'Length, Kind => Send, Data => Data)));

   procedure Start
     (Baud : Baud_Rate; Link : String; Problem : out Unbounded_String) is
   begin
      Carrier.Start (Baud, Link, Problem);
   end Start;

   procedure Stop is
      Ignored : constant String :=
        Ask ((Length => 0, Kind => Finish, Data => (others => 0)));
      pragma Unreferenced (Ignored);
   begin
      null;
   end Stop;

end Serial_Side;
