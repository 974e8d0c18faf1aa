--  SPDX-License-Identifier: GPL-3.0-or-later
--  The sources of images: files, what cannot be opened, pace, scaling.

with Ada.Real_Time; use Ada.Real_Time;
with Ada.Streams;   use Ada.Streams;
with GNAT.Sockets;  use GNAT.Sockets;
with Interfaces.C;  use Interfaces.C;
with Interfaces.C.Strings;

with Pictures;
with Scenes;
with Vision.Library;
with Vision_C; use Vision_C;
with Unit_Runs; use Unit_Runs;

procedure Vision_Source_Tests is

   procedure Open (Path : String; Width, Height : int; Keep : Boolean := False)
   is
      --  Removes the file afterwards, unless it is to Keep
   begin
      Assert (Open (To_C (Path), Width, Height, 10) = Ok, "open " & Path);
      if not Keep then
         Pictures.Remove (Path);
      end if;
   end Open;

   procedure Close is
   begin
      Assert (Close = Ok, "close");
   end Close;

   procedure Check_Pace (Images : Positive; Rate : Positive; What : String) is
      --  So many images of the open source take as long as Rate a second says:
      --  never less, and not more, at one time at least
      Attempts : constant := 10;
      --  the machine may have other work
      Start    : Time;
      Taken    : Duration;
      Due      : constant Duration := Duration (Images) / Rate;
   begin
      for Attempt in 1 .. Attempts loop
         Start := Clock;
         for K in 1 .. Images loop
            Assert (Grab (0) = Ok, What & ": grab" & K'Image);
         end loop;
         Taken := To_Duration (Clock - Start);
         Assert (Taken >= Due - 1.5 / Duration (Rate),
                 What & ": took" & Taken'Image);
         exit when Taken <= Due + 0.5;
      end loop;
      Assert (Taken <= Due + 0.5, What & ": took" & Taken'Image);
   end Check_Pace;

   procedure Check_Refused (Source : String) is
      --  Cannot be opened, and that is found out soon
      Limit : constant Duration := 10.0;
      --  a third of OpenCV's own, with room for a machine that has other work
      Start : constant Time := Clock;
   begin
      Assert (Open (To_C (Source), 640, 480, 10) = No_Camera,
              Source & ": refused");
      Assert (To_Duration (Clock - Start) < Limit, Source & ": in time");
      Assert (Grab (0) = No_Camera, Source & ": not open");
   end Check_Refused;

   procedure Test_Still is
      Path  : constant String := Pictures.Temporary ("still.jpg");
      Found : aliased Arena;
   begin
      Pictures.Save (Scenes.Default, Path);
      Open (Path, 640, 480);
      Check_Pace (10, 25, "still image");
      Pictures.Check_Size (0, 640, 480, "still image");
      Assert (Find_Arena (0, Found'Access) = Ok, "the image of the file");
      Assert (Grab (3) = Ok and then Find_Arena (3, Found'Access) = Ok,
              "into another slot");
      Assert (Draw_Arena (3, Found'Access) = Ok, "draw");
      Assert (Grab (3) = Ok and then Find_Arena (3, Found'Access) = Ok,
              "a drawing does not stay");
      delay 0.4;
      Check_Pace (10, 25, "what was missed is not made up for");
      Close;
   end Test_Still;

   procedure Test_Video is
      Path    : constant String := Pictures.Temporary ("loop.avi");
      Last    : Time;
      Longest : Duration;
      Gap     : Duration := Duration'Last;
   begin
      Pictures.Save_Video (Scenes.Default, 5, 20, Path);
      Open (Path, 640, 480, Keep => True);
      Check_Pace (18, 20, "three times round and a half");
      Pictures.Check_Size (0, 640, 480, "video");

      --  five images later it begins again: as if it went on, in one of four
      --  times at least, whatever else the machine does
      for Round in 1 .. 4 loop
         Longest := 0.0;
         for Image in 1 .. 5 loop
            Last := Clock;
            Assert (Grab (0) = Ok, "grab");
            Longest := Duration'Max (Longest, To_Duration (Clock - Last));
         end loop;
         Gap := Duration'Min (Gap, Longest);
      end loop;
      Assert (Gap < 0.06, "a gap of" & Gap'Image & " s at the end");
      Close;
      Pictures.Remove (Path);
   end Test_Video;

   procedure Test_Video_Of_One_Image is
      Path : constant String := Pictures.Temporary ("one.avi");
   begin
      Pictures.Save_Video (Scenes.Default, 1, 25, Path);
      Open (Path, 320, 480, Keep => True);
      Check_Pace (5, 25, "one image");
      Pictures.Check_Size (0, 320, 240, "scaled");
      Pictures.Remove (Path);
      Assert (Grab (0) = No_Image, "the file is gone");
      Close;
   end Test_Video_Of_One_Image;

   procedure Test_Scaling is

      procedure Check (From_W, From_H : Positive; To_W, To_H : int) is
         --  Fitted into 640 x 480
         Path : constant String := Pictures.Temporary ("size.ppm");
      begin
         Pictures.Save_Plain (From_W, From_H, Path);
         Open (Path, 640, 480);
         Assert (Grab (0) = Ok, "grab");
         Pictures.Check_Size
           (0, To_W, To_H, From_W'Image & " x" & From_H'Image);
      end Check;
   begin
      Check (640, 480, 640, 480);
      Check (320, 240, 640, 480);
      Check (1_280, 960, 640, 480);
      Check (1_280, 720, 640, 360);
      Check (480, 640, 360, 480);
      Check (1, 1, 480, 480);
      Check (3_000, 2, 640, 1);
      Check (2, 3_000, 1, 480);
      Close;
   end Test_Scaling;

   procedure Test_Reopen is
      One : constant String := Pictures.Temporary ("one.ppm");
      Two : constant String := Pictures.Temporary ("two.ppm");
   begin
      Pictures.Save_Plain (64, 48, One);
      Pictures.Save_Plain (48, 64, Two);
      for Round in 1 .. 20 loop
         Open (One, 64, 64, Keep => True);
         Assert (Grab (0) = Ok, "grab" & Round'Image);
         Close;
         Assert (Grab (0) = No_Camera, "closed");
         Close;
      end loop;
      Pictures.Check_Size (0, 64, 48, "the last image stays");
      Open (One, 64, 64);
      Open (Two, 64, 64);
      Assert (Grab (0) = Ok, "grab");
      Pictures.Check_Size (0, 48, 64, "the second");
      Assert (Open (To_C ("/no/such/file"), 64, 64, 10) = No_Camera,
              "the third is refused");
      Assert (Grab (0) = No_Camera, "and the second closed");
   end Test_Reopen;

   procedure Test_Refused_Files is
      Path : constant String := Pictures.Temporary ("broken.jpg");
   begin
      for Text of Split
        ("|not an image at all|" & Character'Val (16#FF#)
         & Character'Val (16#D8#) & Character'Val (16#FF#)
         & Character'Val (16#E0#) & "cut")
      loop
         Pictures.Save_Text (Text, Path);
         Check_Refused (Path);
      end loop;
      Pictures.Save_Text ("P6 60000 60000 255 short", Path);
      Assert (Open (To_C (Path), 640, 480, 10) in No_Camera | Failed,
              "a huge image that is not there");
      Assert (Grab (0) = No_Camera, "not open");
      Pictures.Remove (Path);
   end Test_Refused_Files;

   procedure Test_Refused_Names is
   begin
      for Name of Split
        ("/no/such/file.jpg|/tmp|nonsense| |-1|99999999999999999999|/dev/null"
         & "|%s%s%n|" & (1 .. 1_024 => 'x') & "|97|9999|/dev/zero"
         & "|http://127.0.0.1:9/stream.mjpg|rtsp://127.0.0.1:9/stream"
         & "|nonsense://127.0.0.1/|http://|! ! !"
         & "|fakesrc ! valve drop=true ! appsink")
      loop
         Check_Refused (Name);
      end loop;
      Assert (Open (To_C (""), 640, 480, 10) = Bad_Argument, "empty");
   end Test_Refused_Names;

   procedure Check_Cause (Source, Shown, Cause : String) is
      --  Shown: without secrets. The cause fits into a message of the
      --  supervisor

      function Reason return Strings.chars_ptr
      with Import, Convention => C, External_Name => "vision_reason";
   begin
      Assert (Open (To_C (Source), 640, 480, 10) = No_Camera,
              Source & ": refused");
      declare
         Text : constant String := Strings.Value (Reason);
      begin
         Assert (Text = Shown & ": cannot be opened: " & Cause,
                 "the reason is " & Text);
         Assert (Text'Length <= Vision.Library.Reason_Text'Length, "too long");
      end;
   end Check_Cause;

   function Bound (Listens : Boolean := False) return Socket_Type is
      --  To a free port of 127.0.0.1
      Socket : Socket_Type;
   begin
      Create_Socket (Socket);
      Bind_Socket (Socket, (Family_Inet, Loopback_Inet_Addr, Any_Port));
      if Listens then
         Listen_Socket (Socket);
      end if;
      return Socket;
   end Bound;

   End_Of_Line : constant String := (1 => ASCII.CR, 2 => ASCII.LF);

   procedure Check_Reply
     (Reply, Cause : String;
      Connections  : Positive := 1;
      Scheme       : String   := "http")
   is
      Listener : constant Socket_Type := Bound (Listens => True);

      task Server;

      task body Server is
         Client   : Socket_Type;
         Address  : Sock_Addr_Type;
         Accepted : Selector_Status;
         Request  : Stream_Element_Array (1 .. 2_000);
         Last     : Stream_Element_Offset;
      begin
         for Connection in 1 .. Connections loop
            Accept_Socket (Listener, Client, Address, 10.0, null, Accepted);
            exit when Accepted /= Completed;
            Receive_Socket (Client, Request, Last);
            String'Write (Stream (Client), Reply);
            Close_Socket (Client);
         end loop;
      end Server;
   begin
      Check_Cause
        (Scheme & "://admin:secret@" & Image (Get_Socket_Name (Listener))
         & "/x?k",
         Scheme & "://...@" & Image (Get_Socket_Name (Listener)) & "/x?...",
         Cause);
      Close_Socket (Listener);
   end Check_Reply;

   procedure Check_Http (Reply, Cause : String; Connections : Positive := 1) is
   begin
      Check_Reply
        ("HTTP/1.1 " & Reply & End_Of_Line & End_Of_Line & "<html>", Cause,
         Connections);
   end Check_Http;

   procedure Test_Causes_Of_Streams is
      Socket : constant Socket_Type := Bound;
      Where  : constant String := Image (Get_Socket_Name (Socket));
   begin
      Check_Http ("404 Not Found", "HTTP error 404 Not Found");
      Check_Http
        ("401 Unauthorized" & ASCII.LF & "WWW-Authenticate: Basic realm=x",
         "HTTP error 401 Unauthorized", Connections => 2);
      Check_Http
        ("200 OK" & ASCII.LF & "content-type: text/html; charset=utf-8",
         "HTTP 200 with text/html, no stream of images");
      Check_Http ("503 Bus" & ASCII.ESC & "y", "HTTP error 503 Bus y");

      for Scheme of Split ("http|rtsp") loop
         Check_Cause (Scheme & "://" & Where & "/x",
                      Scheme & "://" & Where & "/x", "Connection refused");
      end loop;
      Listen_Socket (Socket);
      --  a client is connected, but nobody accepts it
      Check_Cause
        ("http://" & Where & "/x", "http://" & Where & "/x", "no answer");
      Check_Cause ("http://no..where/" & String'(1 .. 200 => 'x'),
                   "http://no..where/" & (1 .. 55 => 'x') & "...",
                   "Name or service not known");
      Close_Socket (Socket);
   end Test_Causes_Of_Streams;

   procedure Test_Nobody_Else_Is_Asked is
      --  Whatever the host of the URL answers
      Other    : constant Socket_Type := Bound (Listens => True);
      Where    : constant String := Image (Get_Socket_Name (Other));
      Client   : Socket_Type;
      Address  : Sock_Addr_Type;
      Accepted : Selector_Status;

      procedure Check (Reply, Cause : String; Scheme : String := "http") is
      begin
         Check_Reply (Reply, Cause, Scheme => Scheme);
         Accept_Socket (Other, Client, Address, 0.0, null, Accepted);
         Assert (Accepted = Expired, "the other host was asked: " & Reply);
      end Check;

      function Document (Kind, Text : String) return String
      is ("HTTP/1.1 200 OK" & End_Of_Line & "Content-Type: " & Kind
          & End_Of_Line & End_Of_Line & Text & ASCII.LF);
   begin
      for Status in 301 .. 303 loop
         Check ("HTTP/1.1" & Status'Image & " Moved" & End_Of_Line
                & "Location: http://k:k@" & Where & "/y?k" & End_Of_Line
                & "Content-Type: text/html" & End_Of_Line & End_Of_Line,
                "redirected to http://...@" & Where & "/y?...");
      end loop;
      Check ("RTSP/1.0 302 Moved" & End_Of_Line & "CSeq: 1" & End_Of_Line
             & "Location: rtsp://" & Where & "/y" & End_Of_Line & End_Of_Line,
             "redirected to rtsp://" & Where & "/y", Scheme => "rtsp");
      Check
        (Document
           ("application/vnd.apple.mpegurl",
            "#EXTM3U" & ASCII.LF & "#EXT-X-TARGETDURATION:1" & ASCII.LF
            & "#EXTINF:1," & ASCII.LF & "http://" & Where & "/y.ts"),
         "HTTP 200 with application/vnd.apple.mpegurl, no stream of images");
      Check
        (Document
           ("application/dash+xml",
            "<MPD xmlns=""urn:mpeg:dash:schema:mpd:2011"" type=""static"""
            & " mediaPresentationDuration=""PT9S""><Period><AdaptationSet"
            & " mimeType=""video/mp4""><Representation id=""1"" bandwidth="
            & """1""><BaseURL>http://" & Where & "/y.mp4</BaseURL>"
            & "</Representation></AdaptationSet></Period></MPD>"),
         "HTTP 200 with application/dash+xml, no stream of images");
      Check
        (Document
           ("text/plain",
            "ffconcat version 1.0" & ASCII.LF & "file http://" & Where
            & "/y"),
         "HTTP 200 with text/plain, no stream of images");
      Close_Socket (Other);
   end Test_Nobody_Else_Is_Asked;

   procedure Test_Causes_Of_Pipelines is

      procedure Check (Source, Cause : String) is
      begin
         Check_Cause (Source, Source, Cause);
      end Check;
   begin
      Check ("fakesrc ! nosuchelement ! fakesink",
             "no element ""nosuchelement""");
      Check ("fakesrc ! avdec_none ! fakesink",
             "no element ""avdec_none"", see gstreamer1.0-libav");
      Check ("fakesrc nosuch=1 ! fakesink",
             "no property ""nosuch"" in element ""fakesrc""");
      Check ("fakesrc ! fakesink", "a pipeline must end with appsink");
   end Test_Causes_Of_Pipelines;

begin
   Run_Test ("a still image, also after a delay", Test_Still'Access);
   Run_Test ("a video, looped and paced", Test_Video'Access);
   Run_Test ("a video of one image, and its loss",
             Test_Video_Of_One_Image'Access);
   Run_Test ("scaling", Test_Scaling'Access);
   Run_Test ("closing, and opening what is open", Test_Reopen'Access);
   Run_Test ("no files, cameras, streams", Test_Refused_Names'Access);
   Run_Test ("broken files", Test_Refused_Files'Access);
   Run_Test ("the cause: streams", Test_Causes_Of_Streams'Access);
   Run_Test ("only the host of a URL is asked",
             Test_Nobody_Else_Is_Asked'Access);
   Run_Test ("the cause: pipelines", Test_Causes_Of_Pipelines'Access);
end Vision_Source_Tests;
