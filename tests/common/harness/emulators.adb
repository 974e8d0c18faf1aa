--  SPDX-License-Identifier: GPL-3.0-or-later
--  The emulated robot and its arena camera.

with Ada.Strings;       use Ada.Strings;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with Ada.Streams;       use Ada.Streams;
with Ada.Streams.Stream_IO;
with GNAT.Sockets;      use GNAT.Sockets;

with Expectations;      use Expectations;
with Plain_Numbers;     use Plain_Numbers;
with Programs;
with Whole_Sends;

package body Emulators is

   Made : Natural := 0;
   --  for names of links

   function Next_Line (Object : in out Emulator) return String is
      --  Of its output; raises Failed when it stays silent
   begin
      Check
        (Object.Says ("", Patience, After => Object.Seen, From => Output),
         "the emulator does not answer");
      Object.Seen := Object.Seen + 1;
      return To_String (Object.Element (Output, Object.Seen).Text);
   end Next_Line;

   function Value (Line : String; Key : String) return String is
      --  Of a line of key=value words; "" where it has no such key
      Text  : constant String := " " & Line & " ";
      Place : constant Natural := Index (Text, " " & Key & "=");
      First : Positive;
   begin
      if Place = 0 then
         return "";
      end if;
      First := Place + Key'Length + 2;
      return Text (First .. Index (Text, " ", First) - 1);
   end Value;

   function Seconds (Text : String) return Instant is
      --  Seconds with six decimals
      Point : constant Natural := Index (Text, ".");
   begin
      return Instant'Value (Text (Text'First .. Point - 1)) * 1_000_000_000
        + Instant'Value (Text (Point + 1 .. Text'Last)) * 1_000;
   end Seconds;

   procedure Start
     (Object   : in out Emulator;
      Camera   : Boolean;
      Options  : String  := "";
      Terminal : Boolean := True)
   is
      use type Arguments;
      Address : constant String := "camera ";
   begin
      Made := Made + 1;
      Object.Seen := 0;
      Object.Link := To_Unbounded_String
        (Programs.Temporary_Folder & "/robot" & Image (Made));
      Object.Launch
        (Programs.Emulator,
         Words
           ("--boot-ms 100 "
            & (if Terminal or else not Programs.With_Sockets then "--link "
               else "--socket ")
            & To_String (Object.Link)
           & (if Camera then " --camera-port 0" else ""))
         & Words (Options),
         "emulator");
      Check (Index (Next_Line (Object), "device ") = 1,
             "the emulator names no device");
      if Camera then
         Object.Url := To_Unbounded_String (Next_Line (Object));
         Check (Index (Object.Url, Address) = 1, "the emulator has no camera");
         Delete (Object.Url, 1, Address'Length);
      end if;
      if Index (Options, "--boot-ms") = 0 then
         Object.Await_Status ("state", "idle");
      end if;
   end Start;

   function Device (Object : Emulator) return String is
     (To_String (Object.Link));

   function Camera_Url (Object : Emulator) return String is
     (To_String (Object.Url));

   procedure Tell (Object : in out Emulator; Command : String) is
   begin
      Object.Put_Line (Command);
      declare
         Line : constant String := Next_Line (Object);
      begin
         Check (Index (Line, "ok") = 1,
                "the emulator answers " & Command & " with " & Line);
      end;
   end Tell;

   function Status (Object : in out Emulator; Key : String) return String is
   begin
      Object.Put_Line ("status");
      declare
         Line : constant String := Next_Line (Object);
      begin
         return Seen : constant String := Value (Line, Key) do
            Check (Seen /= "", "no " & Key & " in status: " & Line);
         end return;
      end;
   end Status;

   function Status_Number
     (Object : in out Emulator; Key : String) return Integer
   is (Integer'Value (Object.Status (Key)));

   procedure Await_Status (Object : in out Emulator; Key, Value : String) is
      Deadline : constant Instant := Now + Patience;
   begin
      loop
         declare
            Late : constant Boolean := Now > Deadline;
            Seen : constant String := Object.Status (Key);
         begin
            exit when Seen = Value;
            Check (not Late,
                   "the robot's " & Key & " is " & Seen & " instead of "
                   & Value);
         end;
         delay 0.005;
      end loop;
   end Await_Status;

   procedure Clear_Journal (Object : in out Emulator) is
   begin
      Object.Tell ("journal clear");
   end Clear_Journal;

   function Note_Of (Line : String) return Note is
      Interval : constant String := Value (Line, "interval");
   begin
      return
        (First    => Seconds (Value (Line, "first")),
         Last     => Seconds (Value (Line, "last")),
         Command  => To_Unbounded_String (Value (Line, "command")),
         Answer   => To_Unbounded_String (Value (Line, "answer")),
         Interval =>
           (if Interval = "" then 0.0
            else Duration'Value (Interval) / 1000));
   end Note_Of;

   function Journal (Object : in out Emulator) return Notes is
      Result : Notes;
   begin
      Object.Put_Line ("journal");
      loop
         declare
            Line : constant String := Next_Line (Object);
         begin
            exit when Line = "end";
            Result.Append (Note_Of (Line));
         end;
      end loop;
      return Result;
   end Journal;

   function Wire_Text
     (Object : in out Emulator; Prefixes : String := "MT") return String
   is
      Result : Unbounded_String;
   begin
      for Item of Object.Journal loop
         if Length (Item.Command) > 0
           and then Index
             (Prefixes, (1 => Element (Item.Command, 1))) > 0
         then
            Append (Result, Item.Command & " ");
         end if;
      end loop;
      return To_String (Result);
   end Wire_Text;

   function Count_Of
     (Object : in out Emulator; Command : String) return Natural
   is
      Result : Natural := 0;
   begin
      for Item of Object.Journal loop
         if Item.Command = Command then
            Result := Result + 1;
         end if;
      end loop;
      return Result;
   end Count_Of;

   function Await_On_Wire
     (Object : in out Emulator; Command : String) return Note
   is
      Deadline : constant Instant := Now + Patience;
      Late     : Boolean;
   begin
      loop
         Late := Now > Deadline;
         for Item of Object.Journal loop
            if Item.Command = Command then
               return Item;
            end if;
         end loop;
         Check (not Late,
                "no " & Command & " on the wire, but: "
                & Object.Wire_Text ("MTWurwpvbz"));
         delay 0.005;
      end loop;
   end Await_On_Wire;

   function Fetched (Object : Emulator; Path : String)
      return Stream_Element_Array
   is
      --  The body of the camera's answer
      Url     : constant String := To_String (Object.Url);
      First   : constant Positive := Index (Url, ":", Backward) + 1;
      Room    : constant := 1_000_000;
      Buffer  : Stream_Element_Array (1 .. Room);
      Request : constant String :=
        "GET " & Path & " HTTP/1.0" & ASCII.CR & ASCII.LF
        & ASCII.CR & ASCII.LF;
      Socket  : Socket_Type;
      Used    : Stream_Element_Offset := 0;
      Last    : Stream_Element_Offset;
   begin
      Create_Socket (Socket);
      Set_Socket_Option (Socket, Socket_Level, (Receive_Timeout, Patience));
      Connect_Socket
        (Socket,
         (Family_Inet, Loopback_Inet_Addr,
          Port_Type'Value (Url (First .. Index (Url, "/", First) - 1))));
      Whole_Sends.Send (Socket, Request);
      loop
         Receive_Socket (Socket, Buffer (Used + 1 .. Room), Last);
         exit when Last <= Used;
         Used := Last;
      end loop;
      Close_Socket (Socket);
      for First in 1 .. Used - 3 loop
         if Buffer (First .. First + 3) = (13, 10, 13, 10) then
            return Buffer (First + 4 .. Used);
         end if;
      end loop;
      raise Failed with "no answer from the camera's " & Path;
   exception
      when Socket_Error =>
         Close_Socket (Socket);
         raise Failed with "no connection to the camera for " & Path;
   end Fetched;

   function Pose (Object : Emulator) return Truth is
      Bytes : constant Stream_Element_Array := Fetched (Object, "/pose");
      Text  : String (1 .. Bytes'Length) with Import, Address => Bytes'Address;
      Parts : constant Arguments :=
        Words (Text (1 .. Index (Text & ASCII.LF, (1 => ASCII.LF)) - 1));

      function Number (Place : Positive) return Float is
        (Float'Value (Parts.Element (Place)));
   begin
      return
        (X => Number (1), Y => Number (2), Heading => Number (3),
         Cx => Number (4), Cy => Number (5),
         Dx => Number (6), Dy => Number (7), Angle => Number (8));
   end Pose;

   procedure Save_Snapshot (Object : Emulator; Path : String) is
      use Ada.Streams.Stream_IO;
      File : Ada.Streams.Stream_IO.File_Type;
   begin
      Create (File, Out_File, Path);
      Write (File, Fetched (Object, "/snapshot.jpg"));
      Close (File);
   end Save_Snapshot;

end Emulators;
