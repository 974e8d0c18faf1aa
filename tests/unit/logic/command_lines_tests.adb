--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line: every option, its limits, and what is refused.

with Ada.Strings.Fixed;

with Command_Lines;    use Command_Lines;
with Missions;
with Options;          use Options;
with Texts;
with Unit_Runs; use Unit_Runs;

procedure Command_Lines_Tests is

   use type Texts.Text;

   use type Missions.Arena_Size;

   type Words is array (Positive range <>) of Texts.Text;

   function To_Text (Value : String) return Texts.Text renames Texts.To_Text;

   function Read (Line : String) return Reading is
      --  The arguments are separated by single spaces
      Result : Reading;
      First  : Positive := Line'First;
      Last   : Natural;
   begin
      while First <= Line'Last loop
         Last := Ada.Strings.Fixed.Index (Line, " ", First);
         if Last = 0 then
            Last := Line'Last + 1;
         end if;
         Take (Result, Ada.Strings.Fixed.Head
                         (Line (First .. Last - 1), Last - First));
         First := Last + 1;
      end loop;
      Finish (Result);
      return Result;
   end Read;

   procedure Expect_Wrong (Line : String; Reason : String) is
      --  Reason is what stands on standard error
      R : constant Reading := Read (Line);
   begin
      Assert (R.Request = Wrong, "taken: " & Line);
      Assert (Texts.Image (R.Reason) = Reason,
              Line & ": " & Texts.Image (R.Reason));
   end Expect_Wrong;

   procedure Expect_Limits
     (Option, Value, Limits : String; Of_It : String := "") is
      --  Value, or the part Of_It, is no number within them
   begin
      Expect_Wrong (Option & " " & Value,
                    Option & ": '" & (if Of_It = "" then Value else Of_It)
                    & "' is not a number in " & Limits);
   end Expect_Limits;

   procedure Expect_No_Network (Value : String) is
   begin
      Expect_Wrong
        ("--allow=" & Value,
         "--allow: '" & Value & "' is no IPv4 network, such as 192.168.1.0/24,"
         & " with no bit set after its length");
   end Expect_No_Network;

   procedure Test_Defaults is
      Plain : Reading;
   begin
      Texts.Set (Plain.Chosen.Bind, "127.0.0.1");
      Assert (Read ("") = Plain, "not the defaults");
      for Line of Words'
        (To_Text ("--token /a"), To_Text ("--allow 10.0.0.0/8"))
      loop
         Assert
           (Texts.Image (Read (Texts.Image (Line)).Chosen.Bind) = "0.0.0.0",
            "listens for this machine: " & Texts.Image (Line));
         Assert
           (Texts.Image
              (Read (Texts.Image (Line) & " --bind ::1").Chosen.Bind) = "::1",
            "not the address that was given");
      end loop;
   end Test_Defaults;

   procedure Test_Equals is
   begin
      Assert (Read ("--port=0").Chosen.Port = 0, "port");
      Assert (Texts.Image (Read ("--camera=http://h/?a=b").Chosen.Camera)
              = "http://h/?a=b",
              "only the first sign separates");
      Assert (Texts.Image (Read ("--serial=--odd").Chosen.Serial) = "--odd",
              "a value that looks like a name");
      Expect_Wrong ("--port=", "--port: '' is not a number in 0 .. 65535");
      Expect_Wrong ("--check=1", "option '--check' takes no value");
      Expect_Wrong ("--=1", "unknown option '--'");
      Expect_Wrong ("--marker-size 80",
                    "--marker-size: nothing to print without --print-markers");
   end Test_Equals;

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
         Assert (Read ("--log-level "
                       & (case L is
                             when Error => "error", when Warning => "warning",
                             when Info  => "info",  when Debug   => "debug"))
                   .Chosen.Log_Level = L,
                 "level" & L'Image);
      end loop;
      Assert (Read ("--cpu auto").Chosen.Cpu = Last_Processor, "auto");
      Assert (Read ("").Chosen.Cpu = No_Processor, "no processor");
      Assert
        (Read ("--cpu auto --cpu 0").Chosen.Cpu = 0, "the last one counts");
      Assert (Read ("--marker aruco").Chosen.Marker = Aruco, "aruco");
      Assert (Read ("--draw all").Chosen.Drawing = All_Of_It, "all");
      Assert (Read ("--draw arena").Chosen.Drawing = Options.Arena, "arena");
   end Test_Every_Option;

   procedure Test_Limits is
   begin
      Assert (Read ("--port 65535").Chosen.Port = 65_535, "highest port");
      Assert (Read ("--port 0000000080").Chosen.Port = 80, "zeros in front");
      Expect_Limits ("--port", "1000000080", "0 .. 65535");
      Expect_Limits ("--port", "65536", "0 .. 65535");
      Expect_Limits ("--port", "-1", "0 .. 65535");
      Expect_Limits ("--fps", "0", "1 .. 100");
      Assert (Read ("--frame-size 16x4096").Chosen.Height = 4_096, "height");
      Expect_Limits ("--frame-size", "15x20", "16 .. 4096", Of_It => "15");
      Expect_Limits ("--frame-size", "16x4097", "16 .. 4096", Of_It => "4097");
      Expect_Wrong
        ("--frame-size 1024", "--frame-size: '1024' is not WIDTHxHEIGHT");
      Expect_Wrong
        ("--frame-size x", "--frame-size: '' is not a number in 16 .. 4096");
      Assert (Read ("").Chosen.Arena_Size = (80, 60), "the arena's default");
      Assert (Read ("--arena-size 30x1000").Chosen.Arena_Size = (30, 1_000),
              "the arena's limits");
      Expect_Limits ("--arena-size", "29x60", "30 .. 1000", Of_It => "29");
      Expect_Limits ("--arena-size", "80x1001", "30 .. 1000", Of_It => "1001");
      Expect_Wrong
        ("--arena-size 80", "--arena-size: '80' is not WIDTHxHEIGHT");
      Expect_Limits ("--cpu", "1024", "0 .. 1023");
      Expect_Limits ("--cpu", "Auto", "0 .. 1023");
   end Test_Limits;

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

   procedure Test_Networks is
      Eight : constant String :=
        "--allow 10.0.0.1 --allow 10.0.0.2 --allow 10.0.0.3"
        & " --allow 10.0.0.4 --allow 10.0.0.5 --allow 10.0.0.6"
        & " --allow 10.0.0.7 --allow=10.0.0.8";
   begin
      Assert (Read (Eight).Request = Run, "eight of them");
      Assert (Read (Eight).Chosen.Allowed.Count = 8, "their count");
      Expect_Wrong
        (Eight & " --allow 10.0.0.9", "--allow: more than 8 networks");
      Expect_No_Network ("10.0.0.1/8");
      Expect_No_Network ("10.0.0.0/33");
      Expect_No_Network ("::1");
      Expect_No_Network ("");
   end Test_Networks;

   procedure Test_Requests is
   begin
      Assert (Read ("--help").Request = Show_Help, "--help");
      Assert (Read ("-h").Request = Show_Help, "-h");
      Assert (Read ("--version").Request = Show_Version, "--version");
      Assert (Read ("--check --port 7").Request = Check, "--check");
      Assert (Read ("--check --port 7").Chosen.Port = 7, "its port");
      Assert (Read ("--stop --port 7").Request = Stop, "--stop");
      Assert (Read ("--print-markers 7").Request = Print_Markers,
              "--print-markers");
      Expect_Limits ("--print-markers", "1000", "0 .. 999");
      Assert (Read ("--help --port x").Request = Show_Help,
              "what follows a request for help counts no more");
      Assert (Read ("--port x --help").Request = Wrong,
              "what follows a mistake counts no more");
   end Test_Requests;

   procedure Test_Wrong is
   begin
      Expect_Wrong ("--nonsense", "unknown option '--nonsense'");
      Expect_Wrong ("--ports 7", "unknown option '--ports'");
      Expect_Wrong ("-port 7", "unexpected argument '-port'");
      Expect_Wrong ("stray", "unexpected argument 'stray'");
      Expect_Wrong ("--port 7 stray", "unexpected argument 'stray'");
      for Option of Split ("--allow|--token|--serial|--trace") loop
         Expect_Wrong (Option, "a value is missing after " & Option);
      end loop;
      for Option of Split ("--token|--serial|--trace") loop
         Expect_Wrong (Option & "=", "a value is missing after " & Option);
      end loop;
      Expect_Wrong ("--serial --port 7", "a value is missing after --serial");
      Expect_Wrong ("--marker square",
                    "--marker: 'square' is neither aruco nor triangle");
      Expect_Wrong
        ("--draw robots", "--draw: 'robots' is not all, arena or none");
      Expect_Wrong
        ("--log-level loud", "--log-level: 'loud' is no level of the log");
   end Test_Wrong;

begin
   Run_Test ("nothing given", Test_Defaults'Access);
   Run_Test ("every option", Test_Every_Option'Access);
   Run_Test ("name=value", Test_Equals'Access);
   Run_Test ("limits of the numbers", Test_Limits'Access);
   Run_Test ("networks", Test_Networks'Access);
   Run_Test ("requests", Test_Requests'Access);
   Run_Test ("bad usage", Test_Wrong'Access);
   Run_Test ("an endless argument", Test_Long'Access);
end Command_Lines_Tests;
