--  SPDX-License-Identifier: GPL-3.0-or-later
--  A camera above the arena: one task draws, and each viewer has a task of
--  its own, so that a slow one hurts nobody.

with Ada.Exceptions;
with Ada.Long_Float_Text_IO;
with Ada.Numerics.Long_Elementary_Functions;
with Ada.Streams;      use Ada.Streams;
with Ada.Strings;
with Ada.Strings.Fixed;
with Ada.Text_IO;
with Interfaces.C;     use Interfaces.C;

with GNAT.Random_Numbers;
with GNAT.Sockets;     use GNAT.Sockets;

with Instants;         use Instants;
with Journals;
with Libc;
with Own_Process;
with Polls;
with Random_Numbers;   use Random_Numbers;
with Robot_Bench;
with Robot_Core;
with Robot_Motion;
with Scenes;
with Whole_Sends;      use Whole_Sends;

package body Arena_Camera is

   use all type Settings.Kind;

   Max_Viewers : constant := 8;

   Max_Connections : constant := Max_Viewers + 4;
   --  The others are for /pose, which needs no image
   subtype Viewer_Number is Positive range 1 .. Max_Connections;

   Largest_Image : constant := 4_000_000;
   --  Bytes. More than any image of the largest size at this quality.

   Quality : constant := 85;
   --  Of the JPEG: what a camera of this kind delivers

   subtype Image_Index is Stream_Element_Offset range 1 .. Largest_Image;
   type Image is array (Image_Index) of aliased Stream_Element
     with Pack;
   subtype Image_Length is Stream_Element_Offset range 0 .. Largest_Image;

   type Viewer_Flags is array (Viewer_Number) of Boolean;

   Largest_Alive : constant := 1_920 * 1_440;
   --  Pixels. What is larger is drawn once: it would take half a second

   type Shot is record
      Scene  : Scenes.Description;
      Number : Natural := 0;
      Time   : Instant := 0;
   end record;
   --  What was to be seen when

   subtype Choice is Settings.Values (Settings.Camera_Kind);

   function Mode (C : Choice) return Mode_Kind is
     (Mode_Kind'Val (C (Camera_Mode)));

   protected Studio is

      procedure Open;
      --  Before that nothing is to be seen

      procedure Set (Kind : Settings.Camera_Kind; Value : Integer);
      procedure Mend;

      procedure Begin_Watching (Who : Viewer_Number; Allowed : out Boolean);
      --  Not where the camera is off or has all its viewers
      procedure Leave (Who : Viewer_Number);
      --  Whether it watches or not

      entry Next (Viewer_Number)
        (Data : out Image; Length : out Image_Length; Bare : out Boolean);
      --  An image newer than the last one; Length 0: the camera is off

      entry Wait_For_Work;
      function Has_Work return Boolean;
      procedure Publish
        (S : Shot; Data : Image; Length : Image_Length; Bare : Boolean);

      function Configuration return Choice;
      function Newest return Shot;
      function Watching return Natural;

   private
      Chosen  : Choice := Settings.Usual (Settings.Camera_Kind);
      Usual   : Choice;
      --  When it was opened
      Ready   : Boolean := False;
      Looking : Viewer_Flags := (others => False);
      Fresh   : Viewer_Flags := (others => False);
      Lookers : Natural := 0;
      Last    : Shot;
      Picture : Image;
      Size    : Image_Length := 0;
      Is_Bare : Boolean := False;
   end Studio;

   task Painter with Storage_Size => 8 * 1_024 * 1_024;
   --  OpenCV runs on its stack

   task type Viewer is
      entry Start (Server : Socket_Type; Who : Viewer_Number);
   end Viewer;

   Viewer_Tasks : array (Viewer_Number) of Viewer;

   Drawn  : Image;
   --  The painter's
   Copies : array (Viewer_Number) of Image;
   --  Each viewer's own

   function Scene_Now (Time : Instant; Seed : Natural; C : Choice)
     return Scenes.Description
   is
      --  What there is to be seen
      Robot : Robot_Core.Robot;
      Pose  : Robot_Motion.Pose;
   begin
      Robot_Bench.Bench.Look
        (Robot, Time,
         Ago => Instant (C (Camera_Delay)) * 1_000_000);
      Pose := Robot_Core.Pose (Robot);
      return
        (Width  => int (C (Frame_Width)),
         Height => int (C (Frame_Height)),
         Arena  => 1,
         Fill   => 0.85,
         Turn | Blur | Uneven | Lean_X | Lean_Y => 0.0,
         Noise  => double (C (Noise)),
         Seed   => unsigned (Seed),
         Robots => 1,
         Robot  =>
           (0      =>
              (Marker  => int (C (Marker)),
               Id      => int (C (Marker_Id)),
               X       => double (Pose.X) / 10_000.0,
               Y       => double (Pose.Y) / 10_000.0,
               Heading => double (Pose.Angle) / 1_000_000.0),
            others => (0, 0, 0.0, 0.0, 0.0)));
   end Scene_Now;

   function Truth (S : Shot) return String is
      --  A line of /pose

      function Decimal (Value : double) return String is
         Text : String (1 .. 32);
      begin
         Ada.Long_Float_Text_IO.Put
           (Text, Long_Float (Value), Aft => 6, Exp => 0);
         return Ada.Strings.Fixed.Trim (Text, Ada.Strings.Left);
      end Decimal;

      Robot          : Scenes.Robot renames S.Scene.Robot (0);
      Cx, Cy, Dx, Dy : double := 0.0;
      Angle          : double := 0.0;
   begin
      if Scenes.Robot_Truth (S.Scene, 0, Cx, Cy, Dx, Dy) = 0
        and then (Cx /= Dx or else Cy /= Dy)
      then
         Angle := double (Ada.Numerics.Long_Elementary_Functions.Arctan
           (Long_Float (Cy - Dy), Long_Float (Cx - Dx), Cycle => 360.0));
      end if;
      return Decimal (Robot.X) & ' ' & Decimal (Robot.Y)
        & ' ' & Decimal (Robot.Heading)
        & ' ' & Decimal (Cx) & ' ' & Decimal (Cy)
        & ' ' & Decimal (Dx) & ' ' & Decimal (Dy)
        & ' ' & Decimal (Angle)
        & S.Number'Image & ' ' & Journals.Image (S.Time);
   end Truth;

   procedure Spoil
     (Data   : in out Image;
      Length : in out Image_Length;
      Bare   : out Boolean;
      Number : Natural)
     with Pre => Length > 0
   is
      --  Makes of a good image one of the kinds of bad ones, as its number has
      --  it. Bare: to be sent without the header of its part.
      Source : Random_Numbers.Generator;

      procedure Set_One (Last : Image_Length) is
         --  At random, and so is its place
      begin
         Data (Image_Index (Whole (Source, 1, Integer (Last)))) :=
           Stream_Element (Whole (Source, 0, 255));
      end Set_One;

      type Kind is
        (Noise, Half, Wrong_Bytes, Wrong_Head, Nothing, No_Header);

      Chosen : constant Kind := Kind'Val (Number mod 6);
      Head   : constant Image_Length := Image_Length'Min (Length, 700);
      --  Of a JPEG: markers, tables and the size
   begin
      Start (Source, Number, "bad image");
      Bare := Chosen = No_Header;
      case Chosen is
         when Noise | No_Header =>
            for Byte of Data (1 .. Length) loop
               Byte := Stream_Element (Whole (Source, 0, 255));
            end loop;
         when Half =>
            Length := Image_Length'Max (1, Length / 2);
         when Wrong_Bytes =>
            for K in 1 .. 100 loop
               Set_One (Length);
            end loop;
         when Wrong_Head =>
            for K in 1 .. 40 loop
               Set_One (Head);
            end loop;
         when Nothing =>
            Length := 1;
      end case;
   end Spoil;

   procedure Configure (Socket : Socket_Type) is
      --  A viewer that takes nothing for long is given up, and little of what
      --  it has not taken waits in the kernel
   begin
      Set_Socket_Option
        (Socket, Socket_Level, (Receive_Timeout, Timeout => 5.0));
      Set_Socket_Option
        (Socket, Socket_Level, (Send_Timeout, Timeout => 30.0));
      Set_Socket_Option (Socket, Socket_Level, (Send_Buffer, Size => 65_536));
      Set_Socket_Option
        (Socket, IP_Protocol_For_TCP_Level, (No_Delay, Enabled => True));
   end Configure;

   procedure Displace (Scene : in out Scenes.Description; By : double) is
      --  Its robot, by pixels of this standard deviation
      Width  : constant double := double (Robot_Motion.Arena_Width) / 10_000.0;
      Height : constant double :=
        double (Robot_Motion.Arena_Height) / 10_000.0;

      Robot       : Scenes.Robot renames Scene.Robot (0);
      Beside      : Scenes.Description := Scene;
      Here, There : double;
      Cy, Dx, Dy  : double;
      Source      : GNAT.Random_Numbers.Generator;
      Centimetres : double;

      function Deviate return Long_Float is
        (GNAT.Random_Numbers.Random_Gaussian (Source));
   begin
      Beside.Robot (0).X := Robot.X + 1.0;
      if Scenes.Robot_Truth (Scene, 0, Here, Cy, Dx, Dy) /= 0
        or else Scenes.Robot_Truth (Beside, 0, There, Cy, Dx, Dy) /= 0
      then
         return;
      end if;
      Centimetres := By / (There - Here);

      GNAT.Random_Numbers.Reset (Source, Integer (Scene.Seed));
      Robot.X := double'Max
        (0.0, double'Min (Width, Robot.X + Centimetres * double (Deviate)));
      Robot.Y := double'Max
        (0.0, double'Min (Height, Robot.Y + Centimetres * double (Deviate)));
   end Displace;

   task body Painter is
      S      : Shot;
      Due    : Instant;
      Wanted : Choice;
      Length : int := 0;
      Size   : Image_Length;
      Bare   : Boolean;
      Again  : Boolean := False;
      --  What is in Drawn may be delivered once more
   begin
      Own_Process.Give_Way;
      loop
         Studio.Wait_For_Work;
         Due := Now;
         while Studio.Has_Work loop
            S.Time   := Now;
            S.Number := Studio.Newest.Number + 1;
            Wanted   := Studio.Configuration;
            if not (Again
                    and then S.Scene.Width = int (Wanted (Frame_Width))
                    and then S.Scene.Height = int (Wanted (Frame_Height)))
            then
               S.Scene := Scene_Now (S.Time, S.Number, Wanted);
               if Wanted (Position_Noise) > 0 then
                  Displace (S.Scene, double (Wanted (Position_Noise)));
               end if;
               Length := Scenes.Jpeg
                 (S.Scene, Quality, Drawn'Address, Largest_Image);
            end if;
            Again := False;
            if Length > 0 then
               Size := Image_Length (Length);
               Bare := False;
               if Mode (Studio.Configuration) = Garbage then
                  Spoil (Drawn, Size, Bare, S.Number);
               else
                  Again := Wanted (Frame_Width) * Wanted (Frame_Height)
                    > Largest_Alive;
               end if;
               Studio.Publish (S, Drawn, Size, Bare);
            end if;

            Due := Due + 1_000_000_000
              / Instant (Studio.Configuration (Camera_Fps));
            if Due < Now then
               Due := Now;
               --  Too slow: images are left out, not made up for
            end if;
            delay Due - Now;
         end loop;
      end loop;
   exception
      when Failure : others =>
         Ada.Text_IO.Put_Line
           (Ada.Text_IO.Standard_Error,
            "destijl_emulator: the camera failed: "
            & Ada.Exceptions.Exception_Information (Failure));
   end Painter;

   procedure Serve_Viewer (Who : Viewer_Number; Socket : Socket_Type) is
      --  One connection from beginning to end. Socket_Error where it breaks.

      NL : constant String := (ASCII.CR, ASCII.LF);

      function Is_Gone return Boolean is
         --  The viewer has closed
         Files : Libc.Poll_Array (1 .. 1) :=
           (1 => (int (To_C (Socket)), Libc.Poll_Hang_Up, 0));
      begin
         Polls.Wait (Files, 0.0);
         return Files (1).Returned /= 0;
      end Is_Gone;

      procedure Make_Wait is
         --  As long as opening the camera takes, unless the viewer goes
         Step : constant Duration := 0.05;
         Left : Duration :=
           Duration (Studio.Configuration (Camera_Opening)) / 1_000;
      begin
         while Left > 0.0 and then not Is_Gone loop
            delay Duration'Min (Left, Step);
            Left := Left - Step;
         end loop;
      end Make_Wait;

      procedure Next_Image
        (Length : in out Image_Length; Bare : in out Boolean)
      is
         --  Waits for it. Where drawing takes more than a second, on a busy
         --  machine, the last one comes again: a camera has its own processor.
         --  0: the camera is off, or the viewer has gone.
         Waited : Natural := 0;
      begin
         loop
            select
               Studio.Next (Who) (Copies (Who), Length, Bare);
               return;
            or
               delay 0.6;
               if Is_Gone then
                  Bare   := False;
                  Length := 0;
                  return;
               end if;
               Waited :=
                 (if Mode (Studio.Configuration) = On then Waited + 1 else 0);
               exit when Waited = 2 and then Length > 0;
            end select;
         end loop;
      end Next_Image;

      procedure Read_Path (Path : out Unbounded_String) is
         --  Of a GET request; "" where it is anything else
         Room   : constant := 4_096;
         Text   : String (1 .. Room);
         Data   : Stream_Element_Array (1 .. Room)
           with Import, Address => Text'Address;
         Last   : Stream_Element_Offset := 0;
         Filled : Natural := 0;
         Stop   : Natural;
      begin
         Path := Null_Unbounded_String;
         loop
            Receive_Socket (Socket, Data (Last + 1 .. Room), Last);
            exit when Natural (Last) = Filled;
            Filled := Natural (Last);
            exit when Ada.Strings.Fixed.Index
              (Text (1 .. Filled), NL & NL) > 0
              or else Filled = Room;
         end loop;

         if Filled >= 4 and then Text (1 .. 4) = "GET " then
            Stop := Ada.Strings.Fixed.Index (Text (5 .. Filled), " ");
            if Stop > 0 then
               Path := To_Unbounded_String (Text (5 .. Stop - 1));
            end if;
         end if;
      end Read_Path;

      procedure Reply (Status, Kind : String; Length : Image_Length) is
         --  The head
      begin
         Send (Socket, "HTTP/1.0 " & Status & NL
               & "Content-Type: " & Kind & NL
               & "Content-Length:" & Length'Image & NL
               & "Cache-Control: no-store" & NL
               & "Connection: close" & NL & NL);
      end Reply;

      procedure Reply (Status, Text : String) is
      begin
         Reply (Status, "text/plain", Text'Length + 1);
         Send (Socket, Text & ASCII.LF);
      end Reply;

      procedure Send_Image (Length : Image_Length) is
         Data : Stream_Element_Array (1 .. Length)
           with Import, Address => Copies (Who)'Address;
      begin
         Send (Socket, Data);
      end Send_Image;

      Path    : Unbounded_String;
      Length  : Image_Length := 0;
      Bare    : Boolean := False;
      Allowed : Boolean;

   begin
      Configure (Socket);
      Read_Path (Path);

      if Path = "/pose" then
         declare
            Time : constant Instant := Now;
            Sees : Choice := Studio.Configuration;
         begin
            Sees (Camera_Delay) := 0;
            Reply ("200 OK",
                   Truth ((Scene_Now (Time, 0, Sees),
                           Studio.Newest.Number, Time)));
         end;

      elsif Path = "/stream.mjpg" or else Path = "/snapshot.jpg" then
         Make_Wait;
         Studio.Begin_Watching (Who, Allowed);
         if not Allowed then
            Reply ("503 Service Unavailable",
                   "the camera is off, or has its 8 viewers");
            return;
         end if;
         if Path = "/snapshot.jpg" then
            Next_Image (Length, Bare);
            Reply ("200 OK", "image/jpeg", Length);
            Send_Image (Length);
            return;
         end if;
         Send (Socket, "HTTP/1.0 200 OK" & NL
               & "Content-Type: "
               & "multipart/x-mixed-replace; boundary=frame" & NL
               & "Cache-Control: no-store" & NL
               & "Connection: close" & NL & NL);
         loop
            Next_Image (Length, Bare);
            exit when Length = 0;
            if not Bare then
               Send (Socket, "--frame" & NL
                     & "Content-Type: image/jpeg" & NL
                     & "Content-Length:" & Length'Image & NL & NL);
            end if;
            Send_Image (Length);
            Send (Socket, NL);
         end loop;

      elsif Path = "" then
         Reply ("400 Bad Request", "GET only");
      else
         Reply ("404 Not Found", "/stream.mjpg /snapshot.jpg /pose");
      end if;
   end Serve_Viewer;

   protected body Studio is

      procedure Begin_Watching (Who : Viewer_Number; Allowed : out Boolean) is
      begin
         Allowed := Mode (Chosen) /= Off and then Lookers < Max_Viewers;
         if Allowed then
            Looking (Who) := True;
            Fresh (Who)   := False;
            Lookers       := Lookers + 1;
         end if;
      end Begin_Watching;

      function Configuration return Choice is (Chosen);

      function Has_Work return Boolean is
        (Ready and then Lookers > 0 and then Mode (Chosen) in On | Garbage);

      procedure Leave (Who : Viewer_Number) is
      begin
         if Looking (Who) then
            Looking (Who) := False;
            Lookers       := Lookers - 1;
         end if;
      end Leave;

      procedure Mend is
      begin
         Chosen := Usual;
      end Mend;

      function Newest return Shot is (Last);

      entry Next (for Who in Viewer_Number)
        (Data : out Image; Length : out Image_Length; Bare : out Boolean)
        when Fresh (Who) or else Mode (Chosen) = Off is
      begin
         Bare := Is_Bare;
         Fresh (Who) := False;
         if Mode (Chosen) = Off then
            Length := 0;
         else
            Length := Size;
            Data (1 .. Size) := Picture (1 .. Size);
         end if;
      end Next;

      procedure Open is
      begin
         Usual := Chosen;
         Ready := True;
      end Open;

      procedure Publish
        (S : Shot; Data : Image; Length : Image_Length; Bare : Boolean) is
      begin
         if Mode (Chosen) in On | Garbage then
            Last    := S;
            Size    := Length;
            Is_Bare := Bare;
            Picture (1 .. Length) := Data (1 .. Length);
            Fresh   := Looking;
         end if;
      end Publish;

      procedure Set (Kind : Settings.Camera_Kind; Value : Integer) is
      begin
         Chosen (Kind) := Value;
      end Set;

      entry Wait_For_Work when Has_Work is
      begin
         null;
      end Wait_For_Work;

      function Watching return Natural is (Lookers);

   end Studio;

   task body Viewer is
      Server, Peer : Socket_Type;
      Number       : Viewer_Number;
      From         : Sock_Addr_Type;
   begin
      accept Start (Server : Socket_Type; Who : Viewer_Number) do
         Viewer.Server := Server;
         Number := Who;
      end Start;
      loop
         begin
            Accept_Socket (Server, Peer, From);
            begin
               Serve_Viewer (Number, Peer);
               Shutdown_Socket (Peer);
            exception
               when others =>
                  null;
                  --  The viewer has gone, or talks nonsense: the next one
            end;
            Studio.Leave (Number);
            Close_Socket (Peer);
         exception
            when Socket_Error =>
               delay 0.1;
               --  Perhaps out of descriptors, temporarily
         end;
      end loop;
   end Viewer;

   procedure Mend is
   begin
      Studio.Mend;
   end Mend;

   procedure Set (Kind : Settings.Camera_Kind; Value : Integer) is
   begin
      Studio.Set (Kind, Value);
   end Set;

   procedure Start (Port : in out Natural; Problem : out Unbounded_String)
   is
      Server  : Socket_Type;
      Address : Sock_Addr_Type;
   begin
      Problem := Null_Unbounded_String;
      Address.Addr := Inet_Addr ("127.0.0.1");
      Address.Port := Port_Type (Port);
      Create_Socket (Server);
      Set_Socket_Option
        (Server, Socket_Level, (Reuse_Address, Enabled => True));
      Bind_Socket (Server, Address);
      Listen_Socket (Server, Length => Max_Connections);
      Port := Natural (Get_Socket_Name (Server).Port);
      Studio.Open;
      for Who in Viewer_Number loop
         Viewer_Tasks (Who).Start (Server, Who);
      end loop;
   exception
      when Failure : Socket_Error =>
         Problem := To_Unbounded_String
           (Ada.Exceptions.Exception_Message (Failure));
   end Start;

   function Frames return Natural is (Studio.Newest.Number);

   function Viewers return Natural is (Studio.Watching);

end Arena_Camera;
