--  SPDX-License-Identifier: GPL-3.0-or-later
--  Faults of the network and its users.

with Answer_Ledgers;        use Answer_Ledgers;
with Child_Processes;       use Child_Processes;
with Expectations;          use Expectations;
with Faults;                use Faults;
with Floods;
with Instants;              use Instants;
with Monitor_Clients;
with Network_Links;
with Random_Numbers;        use Random_Numbers;
with Raw_Probes;
with Tolerances;            use Tolerances;
with Worlds;                use Worlds;

package body Network_Faults is

   Commands : constant Arguments := Words
     ("ROPN RCLS RSOW RSWW RRST RPIN RLDW RGFW RGBW RGLF RGRI RSTP RMOV RTRN"
      & " RPOF RGBT RGST COPN CCLS CASA CACO CAIN CPCO CPST MSSG"
      & " MABT MGTO MPTH MGCM MPCM");
   --  All that the monitor can say, but LIVE, which obliges it to go on

   --  The monitor disconnects

   type Departure is new Fault with record
      How      : Manner := Orderly;
      Mid_Line : Boolean := False;
   end record;

   overriding procedure Inject (F : in out Departure; W : in out World);

   --  The way to the monitor is cut: no packet comes any more

   type Cut_Cable is new Fault with record
      How : Network_Links.Cut_Kind := Network_Links.Cable_Pulled;
   end record;

   overriding procedure Prepare (F : Cut_Cable; P : in out Plan);
   overriding procedure Inject (F : in out Cut_Cable; W : in out World);
   overriding procedure Lift (F : in out Cut_Cable; W : in out World);

   --  The monitor reads nothing

   type Stall is new Fault with record
      Length : Duration := 1.0;
   end record;

   overriding procedure Prepare (F : Stall; P : in out Plan);
   overriding procedure Inject (F : in out Stall; W : in out World);

   function Any_Command (W : in out World) return String is
     (Commands.Element (Whole (W.Source, 1, Natural (Commands.Length))));

   function Amid (W : in out World; Line, Part : String) return String is
      --  Line with Part put in somewhere
      Place : constant Natural := Whole (W.Source, 0, Line'Length);
   begin
      return Line (Line'First .. Line'First + Place - 1) & Part
        & Line (Line'First + Place .. Line'Last);
   end Amid;

   overriding procedure Inject (F : in out Departure; W : in out World) is
   begin
      if F.Mid_Line then
         declare
            Line : constant String := Any_Command (W) & ":-123";
         begin
            W.Say_Bytes
              (Line (1 .. Whole (W.Source, 1, Line'Length)));
         end;
      end if;
      W.Lose (F.How);
   end Inject;

   overriding procedure Prepare (F : Cut_Cable; P : in out Plan) is
      pragma Unreferenced (F);
   begin
      P.Through_Link := True;
   end Prepare;

   procedure Be_Missed (W : in out World; Within : Duration) is
      --  The supervisor finds that the monitor has gone without a word
      Log     : constant Natural := W.Session_Log;
      Start   : constant Instant := Now;
      Noticed : Boolean;
   begin
      if W.Present then
         W.Lose (Silently, Detection => Within);
         if W.The_Plan.Log_Is_Read then
            Noticed := W.Supervisor.Says
              ("monitor lost", Within + Noise, After => Log);
            Check
              (Noticed,
               "the monitor that vanished is not missed within "
               & Milliseconds (Now - Start));
         else
            --  the next admission shows whether it was
            delay Within;
         end if;
      end if;
   end Be_Missed;

   overriding procedure Inject (F : in out Cut_Cable; W : in out World) is
   begin
      W.Reachable := False;
      W.Listen;
      The_Link.Cut (F.How);
      Be_Missed (W, Vanished_Limit);
   end Inject;

   overriding procedure Lift (F : in out Cut_Cable; W : in out World) is
   begin
      The_Link.Mend (F.How);
      W.Monitor.Close;
      W.Reachable := True;
   end Lift;

   procedure Hang (W : in out World) is
      --  Its kernel goes on
   begin
      W.Say ("LIVE");
      Be_Missed (W, Silence_Limit);
   end Hang;

   overriding procedure Prepare (F : Stall; P : in out Plan) is
      pragma Unreferenced (F);
   begin
      P.Receive_Buffer := 8_192;
      --  soon full
   end Prepare;

   overriding procedure Inject (F : in out Stall; W : in out World) is
      use type Monitor_Clients.Closing;
      Filling : constant Duration := 1.5;
      --  Images in transit until the last one is taken, and a sample
      Start   : constant Instant := Now;
      Ends    : constant Instant := Start + F.Length;
   begin
      W.Listen;
      if not W.Present then
         return;
      end if;
      W.Monitor.Pause;
      while Now < Ends loop
         W.Talk (0.1, Calm => True);
         delay Duration'Max
           (0.0, Duration'Min (Ends - Now, Span (W.Source, 0.0, 2.0)));
      end loop;
      W.Monitor.Resume;
      if W.Present and then F.Length > Stalled_Limit
        and then W.Monitor.Closed_By_Peer (3.0) /= Monitor_Clients.Open
      then
         W.Listen;
         W.Nobody_In_Command
           (Start, Within => Stalled_Limit + Filling + Stop_Limit);
      end if;
   end Inject;

   procedure Send_Slowly (W : in out World) is
      Lines : constant Arguments := Words
        ("RPIN RGST RSTP RMOV:-12 RTRN:+45 nope RGBT RLDW");
   begin
      for Number in 1 .. 4 loop
         declare
            Line : constant String := Lines.Element
              (Whole (W.Source, 1, Natural (Lines.Length)));
         begin
            for C of Line loop
               W.Say_Bytes ((1 => C));
               delay Span (W.Source, 0.0, 0.04);
            end loop;
            W.Say ("", Kind_Of (Line));
         end;
      end loop;
   end Send_Slowly;

   procedure Send_Endless_Line (W : in out World) is
      Pieces : constant := 16;
      Piece  : constant String (1 .. 65_536) :=
        (others =>
           (if Chance (W.Source, 2) then '9' else Octet (W.Source)));
      Plain  : String := Piece;
   begin
      for C of Plain loop
         if C = ASCII.LF then
            C := '9';
         end if;
      end loop;
      if Chance (W.Source, 2) then
         W.Say_Bytes ("RMOV:");
      end if;
      for Number in 1 .. Pieces loop
         W.Say_Bytes (Plain);
      end loop;
      W.Say ("", Refused);
   end Send_Endless_Line;

   procedure Send_Nul_Bytes (W : in out World) is
   begin
      W.Say ((1 .. Whole (W.Source, 1, 300) => ASCII.NUL), Refused);
      for Number in 1 .. 20 loop
         W.Say
           (Amid (W, "RMOV:12", (1 => ASCII.NUL)), Refused);
         declare
            Name : constant String := Any_Command (W);
         begin
            W.Say (Amid (W, Name, (1 => ASCII.NUL)), Refused);
         end;
      end loop;
   end Send_Nul_Bytes;

   procedure Send_Invalid_Text (W : in out World) is

      function Bytes (First : Natural; Rest : String := "") return String is
        (Character'Val (First) & Rest);

      function Any_Flaw return String is
        (case Whole (W.Source, 1, 8) is
            when 1      => Bytes (16#C3#, "("),
            --  a continuation is missing
            when 2      => Bytes (16#80#),
            --  one without a beginning
            when 3      => Bytes (16#FF#, Bytes (16#FE#)),
            when 4      => Bytes (16#C0#, Bytes (16#8A#)),
            --  a line feed, too long
            when 5      => Bytes (16#ED#, Bytes (16#A0#, Bytes (16#80#))),
            --  half a surrogate pair
            when 6      => Bytes (16#F4#, Bytes (16#90#, Bytes
                                  (16#80#, Bytes (16#80#)))),
            --  past the last code point
            when 7      => Bytes (16#E2#, Bytes (16#82#)),
            --  cut off
            when others => Bytes (16#F8#, Bytes (Whole (W.Source, 128, 255))));

   begin
      for Number in 1 .. 20 loop
         W.Say (Amid (W, "RTRN:-7", Any_Flaw), Refused);
         declare
            Name : constant String := Any_Command (W);
         begin
            W.Say (Amid (W, Name, Any_Flaw), Refused);
         end;
         W.Say ("MSSG:" & Amid (W, "text", Any_Flaw), Silent);
      end loop;
   end Send_Invalid_Text;

   procedure Send_Odd_Data (W : in out World) is
      Count : constant Positive := Positive (Commands.Length);
      Shift : constant Natural := Whole (W.Source, 1, Count);

      procedure Say_All (Name : String) is
         --  Without its data, with a number beyond all bounds, a negative one,
         --  and nonsense
         Nines : constant String (1 .. Whole (W.Source, 6, 400)) :=
           (others => '9');
         Plain : constant Answer_Kind := Kind_Of (Name);
      begin
         if Name in "RMOV" | "RTRN" then
            W.Say (Name, Refused);
            W.Say (Name & ":", Refused);
            W.Say (Name & ":" & Nines, Usual);
            W.Say (Name & ":-" & Nines, Usual);
            W.Say (Name & ":--1", Refused);
            W.Say (Name & ":x" & Text (W.Source, 20), Refused);
         elsif Name in "MGTO" | "MPTH" | "MGCM" | "MPCM" then
            W.Say (Name, Refused);
            W.Say (Name & ":", Refused);
            W.Say (Name & ":" & Nines & "99;1", Refused);
            W.Say (Name & ":-9999999.5;-1", Usual);
            W.Say (Name & ":--1;1", Refused);
            W.Say (Name & ":x" & Text (W.Source, 20), Refused);
         elsif Name = "MSSG" then
            W.Say (Name, Refused);
            W.Say (Name & ":", Silent);
            W.Say (Name & ":" & Nines, Perhaps);
            W.Say (Name & ":-1", Silent);
            W.Say (Name & ":x" & Text (W.Source, 20), Silent);
         else
            W.Say (Name, Plain);
            W.Say (Name & ":", Plain);
            W.Say (Name & ":" & Nines, Refused);
            W.Say (Name & ":-" & Nines, Refused);
            W.Say (Name & ":x" & Text (W.Source, 20), Refused);
         end if;
      end Say_All;

   begin
      W.Listen;
      --  RPOF will switch it off
      W.Robot_Ready := W.Robot_Ready and then not W.Present;
      for Number in 1 .. Count loop
         Say_All (Commands.Element ((Number + Shift) mod Count + 1));
      end loop;
   end Send_Odd_Data;

   procedure Come_In_A_Crowd (W : in out World) is
      Count    : constant := 1_000;
      Patience : constant Duration := 20.0;
      --  A client that finds the kernel's queue full retries after 1, 3, 7 s
      Seen     : Raw_Probes.Crowd_Result;
   begin
      if W.Expected_End or else not W.Reachable then
         return;
      end if;
      W.Listen;
      Seen := Raw_Probes.Crowd (W.Address, W.Port, Count, Patience);
      W.Listen;
      --  Without a monitor, one of them becomes it until it disconnects. A
      --  client with unread data may see a reset before the reason.
      Check
        (not W.Present
         or else (Seen.Closed = Count and then Seen.Left = 0
                  and then Seen.Told > Count / 2),
         Seen.Told'Image & " of" & Count'Image & " were told why,"
         & Seen.Closed'Image & " were closed,"
         & Seen.Left'Image & " were left to wait");
   end Come_In_A_Crowd;

   procedure Flood (W : in out World) is
      Loopback : constant String := "127.0.0.1";
      Length   : constant Duration := 1.0;
      Queue    : constant := 512;
      Crowd    : Floods.Flood;
   begin
      if W.Expected_End or else not W.Reachable
        or else W.Address /= Loopback
      then
         return;
      end if;
      Crowd.Start (W.Port, Floods.Restless);
      W.Talk (Length, Calm => True);
      Crowd.Stop;
      W.Talk (Queue * Newcomer_Time, Calm => True);
   end Flood;

   procedure Scan (W : in out World) is
      Count : constant Positive := Whole (W.Source, 50, 300);
   begin
      Raw_Probes.Knock (W.Address, W.Port, Count, W.Source);
      --  later clients wait behind them; the monitor in command does not
      W.Talk (Count * Newcomer_Time, Calm => True);
   end Scan;

   procedure Scan_Half_Open (W : in out World) is
   begin
      if not Raw_Probes.Can_Half_Open then
         Skip ("packets of one's own need CAP_NET_RAW");
      end if;
      Raw_Probes.Half_Open
        (W.Address, W.Port, Whole (W.Source, 50, 300), W.Source);
   end Scan_Half_Open;

   procedure Be_Second (W : in out World) is
      use type Monitor_Clients.Closing;
      Mark  : constant String := "12321";
      --  no other movement is so long
      Other : Monitor_Clients.Client;
      Item  : Monitor_Clients.Message;
      Taken : Boolean;
   begin
      for Number in 1 .. Whole (W.Source, 1, 4) loop
         W.Listen;
         exit when not W.Present;
         Other.Connect (W.Port, W.Address, Real_Time => False);
         for Attempt in 1 .. Whole (W.Source, 1, 10) loop
            Taken := Other.Try_Send ("RMOV:" & Mark & ASCII.LF);
            exit when not Taken;
            W.Talk (0.0, Calm => True);
         end loop;
         Item := Other.Next (Return_Limit + Noise);
         W.Listen;
         exit when not W.Present;
         --  without a descriptor it can be neither admitted nor rejected, and
         --  waits in the kernel's queue
         Check
           (not W.Reachable
            or else Other.Closed_By_Peer (Return_Limit + Noise)
              /= Monitor_Clients.Open,
            "a second monitor is not turned away");
         Check
           ((Item.Number = 0 or else Item.Label = "MSSG")
            and then Other.Count <= 1,
            "a second monitor is answered " & Item.Label);
      end loop;
      Other.Close;
      Check
        (not W.Present
         or else W.Emulator.Count_Of ("M=" & Mark) = 0,
         "the robot has obeyed a second monitor");
   end Be_Second;

   procedure Add_Cut (Name : String; How : Network_Links.Cut_Kind) is
   begin
      Add (Network, Name, new Cut_Cable'(How => How, others => <>),
           Cost => 6.0, Ends => Session_Ends);
   end Add_Cut;

   procedure Register is
   begin
      Add (Network, "orderly close",
           new Departure'(How => Orderly, others => <>), Ends => Session_Ends);
      Add (Network, "reset", new Departure'(How => Abortive, others => <>),
           Ends => Session_Ends);
      Add (Network, "half a line, then close",
           new Departure'(How => Orderly, Mid_Line => True, others => <>),
           Ends => Session_Ends);
      Add (Network, "half a line, then reset",
           new Departure'(How => Abortive, Mid_Line => True, others => <>),
           Ends => Session_Ends);
      Add_Cut ("vanishing without a packet", Network_Links.Cable_Pulled);
      Add_Cut ("monitor's machine silent", Network_Links.Monitor_Gone);
      Add_Cut ("packets to the monitor dropped", Network_Links.Dropped_There);
      Add_Cut ("packets from the monitor dropped", Network_Links.Dropped_Here);
      Add_Cut ("own interface down", Network_Links.Interface_Down);
      Add_Cut ("own address gone", Network_Links.Address_Gone);
      Add_Cut ("own route gone", Network_Links.Route_Gone);
      Add (Network, "announced signs of life do not come", Hang'Access,
           Cost => 2.0, Ends => Session_Ends);
      Add (Network, "stall of 1 s", new Stall'(Length => 1.0, others => <>),
           Cost => 1.0, Camera => Camera_Streaming);
      Add (Network, "stall of 5 s", new Stall'(Length => 5.0, others => <>),
           Cost => 5.0, Camera => Camera_Streaming);
      Add (Network, "stall of 14 s", new Stall'(Length => 14.0, others => <>),
           Cost => 14.0, Camera => Camera_Streaming);
      Add (Network, "stall of 20 s", new Stall'(Length => 20.0, others => <>),
           Cost => 20.0, Ends => Session_Ends, Camera => Camera_Streaming);
      Add (Network, "byte by byte", Send_Slowly'Access);
      Add (Network, "a line of 1 MB without end", Send_Endless_Line'Access);
      Add (Network, "NUL bytes", Send_Nul_Bytes'Access);
      Add (Network, "invalid UTF-8", Send_Invalid_Text'Access);
      Add (Network, "every command with odd data", Send_Odd_Data'Access,
           Cost => 3.0);
      Add (Network, "1,000 connections at once", Come_In_A_Crowd'Access,
           Cost => 10.0);
      Add (Network, "flood of connections", Flood'Access, Cost => 5.0);
      Add (Network, "port scan", Scan'Access, Cost => 2.0);
      Add (Network, "half-open port scan", Scan_Half_Open'Access);
      Add (Network, "second monitor talks over the first", Be_Second'Access);
   end Register;

end Network_Faults;
