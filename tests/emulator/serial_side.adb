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
with Radio_Links;      use Radio_Links;
with Robot_Bench;

package body Serial_Side is

   use type Interfaces.Unsigned_32;

   subtype Data_Length is Natural range 0 .. 256;

   type Request (Length : Data_Length := 0) is record
      Kind : Request_Kind := Finish;
      Data : Robot_Core.Octets (1 .. Length);
   end record;

   Bell : constant int := Eventfd (0, O_Nonblock + O_Cloexec);
   --  Rung when somebody is about to ask for something

   task Carrier is
      entry Start (Chosen : Choice; Problem : out Unbounded_String);
      entry Obey (R : Request; Outcome : out Unbounded_String);
      --  Outcome: the line's name, or what is wrong
   end Carrier;

   --  Bytes on their way

   type Timed_Byte is record
      Byte    : Robot_Core.Octet := 0;
      Started : Instant := 0;  --  on the first wire
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

   type Way is record
      First  : Queue;
      Radios : Link;
      Second : Queue;
   end record;
   --  In one direction. Without radios the first wire is the only one.

   procedure Remove_Head (Q : in out Queue) is
   begin
      Q.Head  := (Q.Head + 1) mod Room;
      Q.Count := Q.Count - 1;
   end Remove_Head;

   function Is_Due (Q : Queue; Time : Instant) return Boolean is
     (Q.Count > 0 and then Q.Data (Q.Head).Ended <= Time);

   procedure Add
     (Q          : in out Queue;
      Byte       : Robot_Core.Octet;
      From, Time : Instant;
      Sent       : Instant := Never)
   is
      --  A byte that may start at From takes Time; dropped where Q is full.
      --  Sent: when it started on the first wire, if this is the second
      Started : constant Instant := Instant'Max (From, Q.Until_When);
   begin
      if Q.Count < Room then
         Q.Until_When := Started + Time;
         Q.Data ((Q.Head + Q.Count) mod Room) :=
           (Byte, (if Sent = Never then Started else Sent), Q.Until_When);
         Q.Count := Q.Count + 1;
      end if;
   end Add;

   function Gathering (W : Way) return Timed_Byte is
     (W.First.Data ((W.First.Head + W.Radios.Length) mod Room));
   --  The next byte for the radio

   function Ask
     (Kind : Request_Kind; Data : Robot_Core.Octets := (1 .. 0 => 0))
      return String
   is
      One     : constant Interfaces.Unsigned_64 := 1;
      Ignored : long;
      Text    : Unbounded_String;
   begin
      Ignored := Write (Bell, One'Address, One'Size / 8);
      Carrier.Obey ((Data'Length, Kind, Data), Text);
      return To_String (Text);
   end Ask;

   task body Carrier is

      Idle_Wait : constant Instant := 20_000_000;
      --  The robot is made to grow older at least this often

      Asking : constant Instant := 1_000_000;
      --  Whoever has rung is not yet there, and is not waited for: bytes go on

      Above_Tasks : constant := 50;
      --  A priority above every task of a supervisor on the same machine, as
      --  the robot's own processor would be

      Noted : constant Duration := 0.02;
      --  How late a byte is told to be

      The_Line  : Line;
      Chosen    : Choice;
      Byte_Time : Instant := 0;
      Asked     : Boolean := False;
      --  the bell has rung, and nobody has asked yet
      To_Robot  : Way;
      To_Client : Way;

      procedure Babble is
         Shortest : constant Instant := 200_000;
         --  Where bytes take no time an endless answer still does

         Byte    : Robot_Core.Octet;
         Present : Boolean;
      begin
         if (if Chosen.Radio then To_Client.First.Until_When <= Now
             else To_Client.First.Count = 0)
         then
            Robot_Bench.Bench.Babble (Byte, Present);
            if Present then
               Add (To_Client.First, Byte, From => Now,
                    Time => Instant'Max (Byte_Time, Shortest));
            end if;
         end if;
      end Babble;

      procedure Carry (W : in out Way; Commands : Boolean) is
         --  Packets that are complete, to the second wire
         Due     : constant Instant := Now;
         Each    : constant Time := Time (Byte_Time);
         Length  : Packet_Length;
         Arrival : Time;
         Lost    : Boolean;
         B       : Timed_Byte;
      begin
         loop
            if W.First.Count > W.Radios.Length
              and then Gathering (W).Ended <= Due
              and then Joins (W.Radios, Time (Gathering (W).Ended), Each)
            then
               Gather (W.Radios, Time (Gathering (W).Ended));
            elsif W.Radios.Length > 0
              and then Closing (W.Radios, Each) <= Time (Due)
            then
               Length := W.Radios.Length;
               Send (W.Radios, Robot_Bench.Bench.Chances,
                     Closing (W.Radios, Each), Arrival, Lost);
               if Lost and then not Commands then
                  Robot_Bench.Bench.Miss_Answers;
               end if;
               for K in 1 .. Length loop
                  B := W.First.Data (W.First.Head);
                  Remove_Head (W.First);
                  if not Lost then
                     Add (W.Second, B.Byte, From => Instant (Arrival),
                          Time => Byte_Time, Sent => B.Started);
                  elsif Commands then
                     Robot_Bench.Bench.Miss (B.Byte, B.Started, B.Ended);
                  end if;
               end loop;
            else
               exit;
            end if;
         end loop;
      end Carry;

      procedure Clear (W : in out Way) is
      begin
         W.First  := (others => <>);
         W.Second := (others => <>);
         W.Radios := (Seed => W.Radios.Seed, others => <>);
      end Clear;

      function Has_Link return Boolean is
        (Chosen.Link /= "" and then not Chosen.Socket);

      procedure Close_Line is
      begin
         if Is_Open (The_Line) then
            if Has_Link then
               Remove_Link (To_String (Chosen.Link), Device (The_Line));
            end if;
            Close (The_Line);
         end if;
         Clear (To_Robot);
         Clear (To_Client);
      end Close_Line;

      procedure Collect is
         Time   : Instant;
         Data   : Robot_Core.Octets (1 .. Room);
         Length : long := long (Room - To_Robot.First.Count);
      begin
         Read (The_Line, Data'Address, Length);
         --  The poll said so: there is something, and room for it
         Time := Now;
         for K in 1 .. Integer (long'Max (Length, 0)) loop
            Add (To_Robot.First, Data (K), From => Time, Time => Byte_Time);
         end loop;
      end Collect;

      procedure Deliver (Q : in out Queue) is
         Wire : Answer_Faults.Wire_Bytes;
         Late : Instant;
      begin
         while Is_Due (Q, Now) loop
            declare
               B : constant Timed_Byte := Q.Data (Q.Head);
            begin
               Remove_Head (Q);
               Robot_Bench.Bench.Hear (B.Byte, B.Started, B.Ended, Wire, Late);
               for K in 1 .. Wire.Length loop
                  Add (To_Client.First, Wire.Data (K), From => B.Ended + Late,
                       Time => Byte_Time);
               end loop;
            end;
         end loop;
      end Deliver;

      function Next_Event (W : Way) return Instant is
        (Instant'Min
           (Instant'Min
              ((if W.First.Count > W.Radios.Length
                then Gathering (W).Ended else Instant'Last),
               (if W.Radios.Length > 0
                then Instant (Closing (W.Radios, Time (Byte_Time)))
                else Instant'Last)),
            (if W.Second.Count > 0
             then W.Second.Data (W.Second.Head).Ended else Instant'Last)));

      procedure Open_Line (Problem : out Unbounded_String) is
         Done : Boolean;
      begin
         if Chosen.Socket then
            Listen (The_Line, To_String (Chosen.Link), Done);
         else
            Open (The_Line, Done);
         end if;
         if not Done then
            Problem := To_Unbounded_String ("no line: " & Last_Error);
            return;
         end if;
         Problem := Null_Unbounded_String;
         if Has_Link then
            Problem := To_Unbounded_String
              (Place_Link (To_String (Chosen.Link), Device (The_Line)));
            if Problem /= "" then
               Close (The_Line);
               Problem := "no link at " & Chosen.Link & ": " & Problem;
            end if;
         end if;
      end Open_Line;

      procedure Serve (R : Request; Outcome : out Unbounded_String) is
      begin
         Outcome := Null_Unbounded_String;
         if R.Kind = Return_Line and then not Is_Open (The_Line) then
            Open_Line (Outcome);
         elsif R.Kind = Return_Line then
            Outcome := To_Unbounded_String ("the line is not hung up");
         elsif R.Kind = Name then
            Outcome := To_Unbounded_String
              (if Is_Open (The_Line) then Device (The_Line) else "-");
         elsif not Is_Open (The_Line) then
            Outcome := To_Unbounded_String ("the line is hung up");
         elsif R.Kind = Send then
            for Byte of R.Data loop
               Add (To_Client.First, Byte, From => Now, Time => Byte_Time);
            end loop;
         else
            Close_Line;
         end if;
      end Serve;

      procedure Transmit (Q : in out Queue) is
         Data    : Robot_Core.Octets (1 .. Room);
         Last    : Natural := 0;
         Late    : Duration := 0.0;
         Ignored : long;
      begin
         while Is_Due (Q, Now) loop
            Late := Duration'Max (Late, Now - Q.Data (Q.Head).Ended);
            Last := Last + 1;
            Data (Last) := Q.Data (Q.Head).Byte;
            Remove_Head (Q);
         end loop;

         --  What a full terminal does not take is lost, as on a line that
         --  nobody listens to

         if Last > 0 and then Is_Open (The_Line) then
            Ignored := Write
              (Robot_End (The_Line), Data'Address, size_t (Last));
         end if;
         if Late > Noted then
            Ada.Text_IO.Put_Line (Ada.Text_IO.Standard_Error,
                                  "late by " & Milliseconds (Late));
         end if;
      end Transmit;

      procedure Wait is
         Files   : Poll_Array (1 .. 2);
         Time    : constant Instant := Now;
         Wake_Up : constant Instant := Instant'Min
           (Time + (if Asked then Asking else Idle_Wait),
            Instant'Min (Next_Event (To_Robot), Next_Event (To_Client)));
         Rung    : Interfaces.Unsigned_64 := 0;
         Ignored : long;
      begin
         Files (1) := (Bell, Poll_In, 0);
         if Is_Open (The_Line) and then To_Robot.First.Count < Room then
            Files (2) := (Robot_End (The_Line), Poll_In, 0);
         end if;
         Polls.Wait (Files, Wake_Up - Time);
         if Files (2).Returned = 0 then
            Free (The_Line);
         else
            Collect;
         end if;
         if Files (1).Returned /= 0 then
            Ignored := Read (Bell, Rung'Address, Rung'Size / 8);
            Asked := True;
         end if;
      end Wait;

   begin
      accept Start (Chosen : Choice; Problem : out Unbounded_String) do
         Carrier.Chosen := Chosen;
         To_Robot.Radios.Seed  := 2 * Interfaces.Unsigned_32 (Chosen.Seed);
         To_Client.Radios.Seed := To_Robot.Radios.Seed + 1;
         if Chosen.Baud > 0 then
            Byte_Time := 10 * 1_000_000_000 / Instant (Chosen.Baud);
         end if;
         Open_Line (Problem);
      end Start;

      Own_Process.Wake_On_Time;
      Own_Process.Prefer_Real_Time (True, Above_Tasks);
      loop
         if Chosen.Radio then
            Carry (To_Robot, Commands => True);
            Deliver (To_Robot.Second);
            Babble;
            Carry (To_Client, Commands => False);
            Transmit (To_Client.Second);
         else
            Deliver (To_Robot.First);
            Babble;
            Transmit (To_Client.First);
         end if;
         Wait;
         select
            accept Obey (R : Request; Outcome : out Unbounded_String) do
               Serve (R, Outcome);
            end Obey;
            Asked := False;
         else
            null;
         end select;
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

   procedure Start (Chosen : Choice; Problem : out Unbounded_String) is
   begin
      Carrier.Start (Chosen, Problem);
   end Start;

   procedure Stop is
      Unused : constant String := Ask (Finish);
   begin
      null;
   end Stop;

end Serial_Side;
