--  SPDX-License-Identifier: GPL-3.0-or-later
--  A monitor of the tests.

with Ada.Containers.Vectors;
with Ada.Exceptions;
with Ada.Numerics.Float_Random;
with Ada.Streams;           use Ada.Streams;
with Ada.Strings;           use Ada.Strings;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;      use Ada.Strings.Maps;
with Ada.Unchecked_Deallocation;
with GNAT.Sockets;          use GNAT.Sockets;
with Interfaces.C;          use Interfaces.C;

with Expectations;          use Expectations;
with Network_Links;
with Own_Process;
with Polls;
with Whole_Sends;

package body Monitor_Clients is

   Kept_Images : constant := 100;
   --  the newest, whole

   package Message_Vectors is new Ada.Containers.Vectors
     (Positive, Message);

   type Kept_Image is record
      Number : Natural := 0;
      Text   : Unbounded_String;
   end record;

   package Image_Vectors is new Ada.Containers.Vectors
     (Positive, Kept_Image);

   protected type Inbox is
      procedure Add (Item : Message; Image : Unbounded_String);
      function Count return Natural;
      function Element (Number : Positive) return Message;
      function Image (Number : Natural) return String;
      function Broken_Images return Natural;
   private
      Messages : Message_Vectors.Vector;
      Images   : Image_Vectors.Vector;
      Broken   : Natural := 0;
   end Inbox;

   task type Receiver (Object : not null access Parts; Real_Time : Boolean) is
      pragma Storage_Size (1024 * 1024);
   end Receiver;

   type Receiver_Access is access Receiver;

   type Parts is limited record
      Socket : Socket_Type := No_Socket;
      Box    : Inbox;
      State  : Closing := Open with Atomic;
      Reader : Receiver_Access;
      Taken  : Natural := 0;

      --  What the receiver is to do: see Pause, Limit_Reading, Be_Late
      Paused      : Boolean  := False with Atomic;
      Rate        : Natural  := 0 with Atomic;
      Late_Each   : Boolean  := False with Atomic;
      Least, Most : Duration := 0.0 with Atomic;
      Leaving     : Boolean  := False with Atomic;
   end record;

   procedure Free is new Ada.Unchecked_Deallocation
     (Receiver, Receiver_Access);
   procedure Free is new Ada.Unchecked_Deallocation (Parts, Parts_Access);

   Base64_Digits : constant Character_Set := To_Set
     (Character_Ranges'(('A', 'Z'), ('a', 'z'), ('0', '9'), ('+', '+'),
                        ('/', '/')));

   function Is_Jpeg_Text (Text : Unbounded_String) return Boolean is
      --  Base64, whole groups of four, a JPEG's first bytes
      Size    : constant Natural := Length (Text);
      Padding : constant Natural :=
        Index (Text, Base64_Digits, Test => Outside);
   begin
      return Size >= 16 and then Size mod 4 = 0
        and then Slice (Text, 1, 3) = "/9j"
        and then (Padding = 0
                  or else Slice (Text, Padding, Size) in "=" | "==");
   end Is_Jpeg_Text;

   protected body Inbox is

      procedure Add (Item : Message; Image : Unbounded_String) is
         Numbered : Message := Item;
      begin
         Numbered.Number := Natural (Messages.Length) + 1;
         Messages.Append (Numbered);
         if Item.Label = "CIMG" then
            if not Is_Jpeg_Text (Image) then
               Broken := Broken + 1;
            end if;
            Images.Append ((Numbered.Number, Image));
            if Images.Last_Index > Kept_Images then
               Images.Delete_First;
            end if;
         end if;
      end Add;

      function Count return Natural is (Natural (Messages.Length));

      function Element (Number : Positive) return Message is
        (Messages.Element (Number));

      function Image (Number : Natural) return String is
      begin
         if Number = 0 then
            return (if Images.Is_Empty then ""
                    else To_String (Images.Last_Element.Text));
         end if;
         for Item of Images loop
            if Item.Number = Number then
               return To_String (Item.Text);
            end if;
         end loop;
         return "";
      end Image;

      function Broken_Images return Natural is (Broken);

   end Inbox;

   task body Receiver is
      Buffer : Stream_Element_Array (1 .. 65_536);
      Most   : Stream_Element_Offset;
      Last   : Stream_Element_Offset;
      Rest   : Unbounded_String;
      Group  : Positive := 1;
      Late   : Duration := 0.0;
      Chance : Ada.Numerics.Float_Random.Generator;

      procedure Be_Late is
         Start : constant Instant := Now;
      begin
         if Object.Most > 0.0 then
            delay Object.Least
              + (Object.Most - Object.Least)
              * Duration (Ada.Numerics.Float_Random.Random (Chance));
         end if;
         Late := Now - Start;
      end Be_Late;

      procedure Take (Text : Unbounded_String; Time : Instant) is
         Label : constant Message_Label := To_String (Head (Text, 4));
         Data  : constant Unbounded_String := Tail
           (Text, Natural'Max (0, Length (Text) - 5));
      begin
         Object.Box.Add
           ((Number => 0, Time => Time, Group => Group, Late => Late,
             Label  => Label,
             Data   => (if Label = "CIMG"
                        then Head (Data, Natural'Min (Length (Data), 200))
                        else Data),
             Size   => Length (Text)),
            Image => Data);
      end Take;

   begin
      Ada.Numerics.Float_Random.Reset (Chance);
      if Real_Time then
         Own_Process.Prefer_Real_Time (True);
      end if;

      while not Object.Leaving loop
         if Object.Paused then
            delay 0.005;
         elsif Polls.Is_Readable (int (To_C (Object.Socket)), 0.02)
           and then not Object.Paused and then not Object.Leaving
         then
            Most := Buffer'Last;
            if Object.Rate > 0 then
               Most := Stream_Element_Offset'Min
                 (Most, Stream_Element_Offset (Object.Rate) / 50 + 1);
               delay Duration (Most) / Object.Rate;
            end if;
            if Object.Late_Each and then Length (Rest) = 0 then
               Be_Late;
            end if;
            Receive_Socket (Object.Socket, Buffer (1 .. Most), Last);
            if Last < Buffer'First then
               Object.State := Orderly;
               exit;
            end if;
            declare
               Time  : constant Instant := Now;
               Bytes : String (1 .. Natural (Last))
                 with Import, Address => Buffer'Address;
               First : Positive := 1;
               Place : Natural;
            begin
               loop
                  Place := Index
                    (Bytes (First .. Bytes'Last), (1 => ASCII.LF));
                  exit when Place = 0;
                  Append (Rest, Bytes (First .. Place - 1));
                  Take (Rest, Time);
                  Rest := Null_Unbounded_String;
                  First := Place + 1;
                  exit when First > Bytes'Last;
               end loop;
               if First > Bytes'Last then
                  Group := Group + 1;
                  if not Object.Late_Each then
                     Be_Late;
                  end if;
               else
                  Append (Rest, Bytes (First .. Bytes'Last));
               end if;
            end;
         end if;
      end loop;
   exception
      when Socket_Error =>
         Object.State := Broken;
   end Receiver;

   procedure Connect
     (Object         : in out Client;
      Port           : Positive;
      Address        : String  := "127.0.0.1";
      Source         : String  := "";
      Receive_Buffer : Natural := 0;
      By_Link        : Boolean := False;
      Real_Time      : Boolean := True)
   is
      Server : constant Inet_Addr_Type := Inet_Addr
        (if By_Link then Network_Links.Supervisor_Side else Address);
      Status : Selector_Status;
   begin
      Object.Close;
      Object.Inner := new Parts;
      if By_Link then
         Network_Links.Enter;
      end if;
      Create_Socket (Object.Inner.Socket, Server.Family);
      if By_Link then
         Network_Links.Leave;
      end if;
      if Source /= "" then
         Bind_Socket (Object.Inner.Socket,
                      Network_Socket_Address (Inet_Addr (Source), Any_Port));
      end if;
      if Receive_Buffer > 0 then
         Set_Socket_Option (Object.Inner.Socket, Socket_Level,
                            (GNAT.Sockets.Receive_Buffer, Receive_Buffer));
      end if;
      Set_Socket_Option
        (Object.Inner.Socket, Socket_Level, (Send_Timeout, 30.0));
      Connect_Socket (Object.Inner.Socket,
                      Network_Socket_Address (Server, Port_Type (Port)),
                      Timeout => Patience, Status => Status);
      Check (Status = Completed, "no connection to port" & Port'Image);
      Set_Socket_Option
        (Object.Inner.Socket, IP_Protocol_For_TCP_Level, (No_Delay, True));
      Object.Inner.Reader := new Receiver (Object.Inner, Real_Time);
   exception
      when Occurrence : Socket_Error =>
         raise Failed with "no connection to port" & Port'Image & ": "
           & Ada.Exceptions.Exception_Message (Occurrence);
   end Connect;

   procedure Send (Object : in out Client; Bytes : String) is
   begin
      Check (Object.Try_Send (Bytes), "the supervisor takes nothing more");
   end Send;

   procedure Send_Urgent (Object : in out Client; Byte : Character) is
      Last : Stream_Element_Offset;
   begin
      Send_Socket
        (Object.Inner.Socket, (1 => Character'Pos (Byte)), Last, null,
         Process_Out_Of_Band_Data);
   end Send_Urgent;

   procedure Send_Line (Object : in out Client; Command : String) is
   begin
      Object.Send (Command & ASCII.LF);
   end Send_Line;

   function Try_Send (Object : in out Client; Bytes : String) return Boolean is
   begin
      Whole_Sends.Send (Object.Inner.Socket, Bytes);
      return True;
   exception
      when Socket_Error =>
         return False;
   end Try_Send;

   function Next
     (Object : in out Client; Within : Duration := Expectations.Patience)
      return Message
   is
      Deadline : constant Instant := Now + Within;
   begin
      loop
         declare
            Late : constant Boolean := Now >= Deadline;
         begin
            if Object.Inner.Taken < Object.Inner.Box.Count then
               Object.Inner.Taken := Object.Inner.Taken + 1;
               return Object.Inner.Box.Element (Object.Inner.Taken);
            end if;
            if Late then
               return (others => <>);
            end if;
         end;
         delay 0.000_5;
      end loop;
   end Next;

   function Next_Of (Object : in out Client; Labels : String) return Message is
      Deadline : constant Instant := Now + Patience;
      Item     : Message;
   begin
      loop
         Item := Object.Next (Duration'Max (0.0, Deadline - Now));
         Check (Item.Number > 0 or else Object.Inner.State = Open,
                "no " & Labels & ", the connection is closed");
         Check (Item.Number > 0, "no " & Labels);
         if Index (Labels, Item.Label) > 0 then
            return Item;
         end if;
      end loop;
   end Next_Of;

   procedure Await
     (Object : in out Client; Labels : String; Count : Positive := 1)
   is
      Unused : Message;
   begin
      for Number in 1 .. Count loop
         Unused := Object.Next_Of (Labels);
      end loop;
   end Await;

   function Next_Answer
     (Object : in out Client; Command : String := "") return Message
   is
      Extra : constant String :=
        (if Command = "RGBT" then " RBLV"
         elsif Command = "RGST" then " RCST"
         elsif Command = "CASA" then " CIMG"
         elsif Command in "RVER" | "CARN" then " " & Command
         else "");
   begin
      return Object.Next_Of (Answers & Extra);
   exception
      when Occurrence : Failed =>
         raise Failed with Command & ": "
           & Ada.Exceptions.Exception_Message (Occurrence);
   end Next_Answer;

   function Ask (Object : in out Client; Command : String) return Message is
   begin
      Object.Skip_To_Now;
      Object.Send_Line (Command);
      return Object.Next_Answer (Command);
   end Ask;

   procedure Judge (Condition : Boolean; Item : Message; Text : String) is
      --  An answer of the robot may merely have been late
   begin
      if not Condition and then Item.Label = "ATIM" then
         raise Too_Late with Text;
      end if;
      Check (Condition, Text);
   end Judge;

   procedure Check_Label (Item : Message; Labels : String; What : String) is
   begin
      Judge (Index (Labels, Item.Label) > 0, Item,
             What & ": " & Item.Label & " instead of " & Labels);
   end Check_Label;

   procedure Expect (Object : in out Client; Command, Answer : String) is
      Item : constant Message := Object.Ask (Command);
      Text : constant String :=
        Item.Label
        & (if Length (Item.Data) = 0 then "" else ":")
        & To_String (Item.Data);
   begin
      Judge
        ((if Answer'Length = 4 then Item.Label = Answer else Text = Answer),
         Item, Command & " was answered " & Text & " instead of " & Answer);
   end Expect;

   procedure Skip_To_Now (Object : in out Client) is
   begin
      Object.Inner.Taken := Object.Inner.Box.Count;
   end Skip_To_Now;

   procedure Expect_Silence
     (Object : in out Client; Labels : String; For_Time : Duration)
   is
      Deadline : constant Instant := Now + For_Time;
      Item     : Message;
   begin
      loop
         Item := Object.Next (Duration'Max (0.0, Deadline - Now));
         exit when Item.Number = 0;
         Check (Index (Labels, Item.Label) = 0,
                "unexpected " & Item.Label & ":" & To_String (Item.Data));
      end loop;
   end Expect_Silence;

   function Count (Object : Client) return Natural is
     (Object.Inner.Box.Count);

   function Element (Object : Client; Number : Positive) return Message is
     (Object.Inner.Box.Element (Number));

   function Count_Of (Object : Client; Label : Message_Label) return Natural is
      Result : Natural := 0;
   begin
      for Number in 1 .. Object.Inner.Box.Count loop
         if Object.Inner.Box.Element (Number).Label = Label then
            Result := Result + 1;
         end if;
      end loop;
      return Result;
   end Count_Of;

   function Image (Object : Client; Number : Natural := 0) return String is
     (Object.Inner.Box.Image (Number));

   function Broken_Images (Object : Client) return Natural is
     (Object.Inner.Box.Broken_Images);

   procedure Pause (Object : in out Client) is
   begin
      Object.Inner.Paused := True;
      delay 0.05;
      --  a recv that had begun is over
   end Pause;

   procedure Resume (Object : in out Client) is
   begin
      Object.Inner.Paused := False;
   end Resume;

   procedure Limit_Reading (Object : in out Client; Rate : Natural) is
   begin
      Object.Inner.Rate := Rate;
   end Limit_Reading;

   procedure Be_Late
     (Object : in out Client; Least, Most : Duration; To_Each : Boolean) is
   begin
      Object.Inner.Most := Most;
      Object.Inner.Least := Least;
      Object.Inner.Late_Each := To_Each;
   end Be_Late;

   function Closed_By_Peer
     (Object : Client; Within : Duration := Expectations.Patience)
      return Closing
   is
      Deadline : constant Instant := Now + Within;
   begin
      while Object.Inner.State = Open and then Now < Deadline loop
         delay 0.001;
      end loop;
      return Object.Inner.State;
   end Closed_By_Peer;

   procedure Half_Close (Object : in out Client) is
   begin
      Object.Left := Now;
      Shutdown_Socket (Object.Inner.Socket, Shut_Write);
   end Half_Close;

   procedure Let_Go (Object : in out Client; Abortive : Boolean) is
      --  The order of the events towards the supervisor is the test's: the
      --  shutdown comes first, the end of the reader afterwards; before a
      --  reset the reader ends
   begin
      if Object.Inner = null then
         return;
      end if;
      if Object.Inner.Reader /= null then
         Object.Left := Now;
         if not Abortive then
            begin
               Shutdown_Socket (Object.Inner.Socket, Shut_Write);
            exception
               when Socket_Error =>
                  null;
            end;
         end if;
         Object.Inner.Leaving := True;
         while not Object.Inner.Reader'Terminated loop
            delay 0.001;
         end loop;
         Free (Object.Inner.Reader);
      end if;
      if Object.Inner.Socket /= No_Socket then
         if Abortive then
            Set_Socket_Option
              (Object.Inner.Socket, Socket_Level, (Linger, True, 0));
            Object.Left := Now;
         end if;
         Close_Socket (Object.Inner.Socket);
      end if;
      Free (Object.Inner);
   end Let_Go;

   procedure Close (Object : in out Client) is
   begin
      Let_Go (Object, Abortive => False);
   end Close;

   procedure Reset (Object : in out Client) is
   begin
      Let_Go (Object, Abortive => True);
   end Reset;

   function Left_At (Object : Client) return Instant is (Object.Left);

   overriding procedure Finalize (Object : in out Client) is
   begin
      Object.Close;
   end Finalize;

end Monitor_Clients;
