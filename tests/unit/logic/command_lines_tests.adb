--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line: every option, its limits, and what is refused.

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;

with Command_Lines;    use Command_Lines;
with Missions;
with Options;          use Options;
with Texts;
with Unit_Runs; use Unit_Runs;

procedure Command_Lines_Tests is

   use type Missions.Arena_Size;

   Eight_Networks : constant String :=
     "--allow 10.0.0.1 --allow 10.0.0.2 --allow 10.0.0.3 --allow 10.0.0.4"
     & " --allow 10.0.0.5 --allow 10.0.0.6 --allow 10.0.0.7 --allow=10.0.0.8";

   No_Network : constant String :=
     " is no IPv4 network, such as 192.168.1.0/24, with no bit set after its"
     & " length";

   function Read (Line : String) return Reading is
      --  The arguments are separated by single spaces
   begin
      return Result : Reading do
         if Line /= "" then
            for Word of Split (Line, ' ') loop
               Take (Result, Head (Word, Word'Length));
            end loop;
         end if;
         Finish (Result);
      end return;
   end Read;

   function Chosen (Line : String) return Values is (Read (Line).Chosen);

   procedure Test_Defaults is
      Plain : Reading;
   begin
      Texts.Set (Plain.Chosen.Bind, "127.0.0.1");
      Assert (Read ("") = Plain, "not the defaults");
      for Line of Split ("--token /a|--allow 10.0.0.0/8") loop
         Assert (Texts.Image (Chosen (Line).Bind) = "0.0.0.0",
                 "listens for this machine: " & Line);
         Assert (Texts.Image (Chosen (Line & " --bind ::1").Bind) = "::1",
                 "not the address that was given");
      end loop;
   end Test_Defaults;

   procedure Test_Every_Option is
      R : constant Reading := Read
        ("--port 7 --bind 127.0.0.1 --allow 10.0.0.0/8 --allow 127.0.0.1"
         & " --token /etc/token --monitor-silence 30 --serial /dev/pts/3"
         & " --answer-timeout 150 --camera a.mp4"
         & " --frame-size 320x240 --fps 25 --jpeg-quality 55"
         & " --marker triangle --draw none --arena-size 120x90 --message-gap 9"
         & " --log-level debug --cpu 3"
         & " --trace /tmp/trace.json"
         & " --print-markers 7 --marker-size 90");
   begin
      Assert (R.Request = Print_Markers, Texts.Image (R.Reason));
      Assert
        (R.Chosen = Values'
           (Port        => 7,
            Bind        => Texts.To_Text ("127.0.0.1"),
            Allowed     =>
              (Items => (1      => (16#0A00_0000#, 8),
                         2      => (16#7F00_0001#, 32),
                         others => (0, 0)),
               Count => 2),
            Token_File  => Texts.To_Text ("/etc/token"),
            Silence     => 30,
            Serial      => Texts.To_Text ("/dev/pts/3"),
            Answer_Timeout => 150,
            Camera      => Texts.To_Text ("a.mp4"),
            Width       => 320,
            Height      => 240,
            Frame_Rate  => 25,
            Quality     => 55,
            Marker      => Triangle,
            Drawing     => Nothing,
            First_Marker => 7,
            Marker_Size  => 90,
            Arena_Size  => (Width => 120, Height => 90),
            Message_Gap => 9,
            Log_Level   => Debug,
            Cpu         => 3,
            Trace_File  => Texts.To_Text ("/tmp/trace.json")),
         "not what was chosen");
      for L in Level loop
         Assert (Chosen ("--log-level " & To_Lower (L'Image)).Log_Level = L,
                 "level" & L'Image);
      end loop;
      Assert (Chosen ("--cpu auto").Cpu = Last_Processor, "auto");
      Assert (Chosen ("").Cpu = No_Processor, "no processor");
      Assert (Chosen ("--cpu auto --cpu 0").Cpu = 0, "the last one counts");
      Assert (Chosen ("--marker aruco").Marker = Aruco, "aruco");
      Assert (Chosen ("--draw all").Drawing = All_Of_It, "all");
      Assert (Chosen ("--draw arena").Drawing = Options.Arena, "arena");
      Assert (Chosen ("--port 65535").Port = 65_535, "highest port");
      Assert (Chosen ("--port 0000000080").Port = 80, "zeros in front");
      Assert (Chosen ("--port=0").Port = 0, "least port");
      Assert (Texts.Image (Chosen ("--camera=http://h/?a=b").Camera)
              = "http://h/?a=b", "only the first sign separates");
      Assert (Texts.Image (Chosen ("--serial=--odd").Serial) = "--odd",
              "a value that looks like a name");
      Assert (Chosen ("--frame-size 16x4096").Height = 4_096, "height");
      Assert (Chosen ("").Arena_Size = (80, 60), "the arena's default");
      Assert (Chosen ("--arena-size 30x1000").Arena_Size = (30, 1_000),
              "the arena's limits");
      Assert (Read (Eight_Networks).Request = Run
              and then Chosen (Eight_Networks).Allowed.Count = 8,
              "eight networks");
   end Test_Every_Option;

   procedure Test_Long is
      R : Reading;
   begin
      Take (R, "--serial");
      Take (R, (1 .. Texts.Max_Length => 's'));
      Assert (R.Chosen.Serial.Length = Texts.Max_Length, "the longest value");
      Take (R, (1 .. Texts.Max_Length + 1 => 's'));
      Assert
        (Texts.Image (R.Reason) = "an argument has more than 512 characters",
         Texts.Image (R.Reason));
      R := (others => <>);
      Take (R, (1 .. Texts.Max_Length => '-'));
      Assert (R.Request = Wrong, "a name as long as can be");
   end Test_Long;

   procedure Test_Requests is
   begin
      --  What follows a request for help or a mistake counts no more
      for Row of Split
        ("--help=Show_Help|-h=Show_Help|--version=Show_Version"
         & "|--check --port 7=Check|--stop --port 7=Stop"
         & "|--print-markers 7=Print_Markers|--help --port x=Show_Help"
         & "|--port x --help=Wrong")
      loop
         Assert (Read (Split (Row, '=') (1)).Request
                 = Request_Kind'Value (Split (Row, '=') (2)), Row);
      end loop;
      Assert (Chosen ("--check --port 7").Port = 7, "its port");
   end Test_Requests;

   procedure Test_Wrong is
      --  With what stands on standard error
   begin
      for Row of Split
        ("--nonsense#unknown option '--nonsense'"
         & "|--ports 7#unknown option '--ports'"
         & "|--=1#unknown option '--'"
         & "|-port 7#unexpected argument '-port'"
         & "|stray#unexpected argument 'stray'"
         & "|--port 7 stray#unexpected argument 'stray'"
         & "|--check=1#option '--check' takes no value"
         & "|--allow#a value is missing after --allow"
         & "|--token#a value is missing after --token"
         & "|--token=#a value is missing after --token"
         & "|--serial#a value is missing after --serial"
         & "|--serial=#a value is missing after --serial"
         & "|--serial --port 7#a value is missing after --serial"
         & "|--trace#a value is missing after --trace"
         & "|--trace=#a value is missing after --trace"
         & "|--marker square#--marker: 'square' is neither aruco nor triangle"
         & "|--marker-size 80"
         & "#--marker-size: nothing to print without --print-markers"
         & "|--draw robots#--draw: 'robots' is not all, arena or none"
         & "|--log-level loud#--log-level: 'loud' is no level of the log"
         & "|--port=#--port: '' is not a number in 0 .. 65535"
         & "|--port 1000000080"
         & "#--port: '1000000080' is not a number in 0 .. 65535"
         & "|--port 65536#--port: '65536' is not a number in 0 .. 65535"
         & "|--port -1#--port: '-1' is not a number in 0 .. 65535"
         & "|--fps 0#--fps: '0' is not a number in 1 .. 100"
         & "|--frame-size 15x20"
         & "#--frame-size: '15' is not a number in 16 .. 4096"
         & "|--frame-size 16x4097"
         & "#--frame-size: '4097' is not a number in 16 .. 4096"
         & "|--frame-size 1024#--frame-size: '1024' is not WIDTHxHEIGHT"
         & "|--frame-size x#--frame-size: '' is not a number in 16 .. 4096"
         & "|--arena-size 29x60"
         & "#--arena-size: '29' is not a number in 30 .. 1000"
         & "|--arena-size 80x1001"
         & "#--arena-size: '1001' is not a number in 30 .. 1000"
         & "|--arena-size 80#--arena-size: '80' is not WIDTHxHEIGHT"
         & "|--cpu 1024#--cpu: '1024' is not a number in 0 .. 1023"
         & "|--cpu Auto#--cpu: 'Auto' is not a number in 0 .. 1023"
         & "|--print-markers 1000"
         & "#--print-markers: '1000' is not a number in 0 .. 999"
         & "|" & Eight_Networks
         & " --allow 10.0.0.9#--allow: more than 8 networks"
         & "|--allow=10.0.0.1/8#--allow: '10.0.0.1/8'" & No_Network
         & "|--allow=10.0.0.0/33#--allow: '10.0.0.0/33'" & No_Network
         & "|--allow=::1#--allow: '::1'" & No_Network
         & "|--allow=#--allow: ''" & No_Network)
      loop
         declare
            Part : constant Line_Vectors.Vector := Split (Row, '#');
            R    : constant Reading := Read (Part (1));
         begin
            Assert (R.Request = Wrong
                    and then Texts.Image (R.Reason) = Part (2),
                    Row & ": " & R.Request'Image & " "
                    & Texts.Image (R.Reason));
         end;
      end loop;
   end Test_Wrong;

begin
   Run_Test ("nothing given", Test_Defaults'Access);
   Run_Test ("every option, and its limits", Test_Every_Option'Access);
   Run_Test ("requests", Test_Requests'Access);
   Run_Test ("bad usage", Test_Wrong'Access);
   Run_Test ("an endless argument", Test_Long'Access);
end Command_Lines_Tests;
