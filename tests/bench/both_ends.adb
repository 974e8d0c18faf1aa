--  SPDX-License-Identifier: GPL-3.0-or-later
--  Both ends in one hand.

with Ada.Strings.Fixed; use Ada.Strings.Fixed;
with GNAT.Sockets;
with Interfaces;        use Interfaces;
with Interfaces.C;      use Interfaces.C;

with Expectations;      use Expectations;
with Libc;
with Polls;
with Pseudo_Terminals;

package body Both_Ends is

   Limit      : constant Duration := 10.0;
   Label_Size : constant := 4;

   type State is record
      Socket   : int     := -1;
      By_Lines : Boolean := False;
      Frame    : Event;  --  that is coming in
      Message  : Event;
      Frames   : Event_Vectors.Vector;
      Messages : Event_Vectors.Vector;
      Held     : Unbounded_String;
      --  a frame that the robot does not answer at once
   end record;

   States : array (Place) of State;
   Lines  : array (Place) of Pseudo_Terminals.Line;

   function Answer_To (Command : String) return String is
     (case Command (Command'First) is
         when 'v'    => "2",
         when 'b'    => "0",
         when 'V'    => "3.5",
         when others => "O");

   function Framed (Text : String) return String is
      Sum : Unsigned_8 := 0;
   begin
      for C of Text loop
         Sum := Sum xor Unsigned_8 (Character'Pos (C));
      end loop;
      return Text
        & Character'Val (if Sum = 16#0D# then 16#0E# else Sum) & ASCII.CR;
   end Framed;

   procedure Write (File : int; Text : String) is
   begin
      Check (Libc.Write (File, Text'Address, Text'Length) = Text'Length,
             "cannot be written");
   end Write;

   procedure Open_Line (Where : Place) is
      Open : Boolean;
   begin
      Pseudo_Terminals.Open (Lines (Where), Open);
      Check (Open, "no pseudo-terminal to be had");
   end Open_Line;

   function Device (Where : Place) return String is
     (Pseudo_Terminals.Device (Lines (Where)));

   function Master (Where : Place) return int is
     (if Pseudo_Terminals.Is_Open (Lines (Where))
      then Pseudo_Terminals.Robot_End (Lines (Where)) else -1);
   --  The robot's end of the line, -1 where none is open

   procedure Connect (Where : Place; Port : Positive; By_Lines : Boolean) is
      use GNAT.Sockets;
      S      : State renames States (Where);
      Socket : Socket_Type;
   begin
      Create_Socket (Socket);
      Connect_Socket
        (Socket,
         (Family_Inet, Inet_Addr ("127.0.0.1"), Port_Type (Port)));
      Set_Socket_Option (Socket, IP_Protocol_For_TCP_Level, (No_Delay, True));
      S.Socket := int (To_C (Socket));
      S.By_Lines := By_Lines;
      S.Message := (others => <>);
   end Connect;

   procedure Disconnect (Where : Place) is
   begin
      if States (Where).Socket >= 0 then
         Libc.Close (States (Where).Socket);
         States (Where).Socket := -1;
      end if;
   end Disconnect;

   procedure Close_All is
   begin
      for Where in Place loop
         Disconnect (Where);
         Pseudo_Terminals.Close (Lines (Where));
         States (Where) := (others => <>);
      end loop;
   end Close_All;

   function Frames (Where : Place) return Event_Vectors.Vector is
     (States (Where).Frames);

   function Messages (Where : Place) return Event_Vectors.Vector is
     (States (Where).Messages);

   procedure Forget (Where : Place) is
   begin
      States (Where).Frames.Clear;
      States (Where).Messages.Clear;
   end Forget;

   procedure Set_Unanswered (Where : Place; Frame : String) is
   begin
      States (Where).Held := To_Unbounded_String (Frame);
   end Set_Unanswered;

   procedure Hear (Where : Place) is
      --  What has come at the robot's end
      S    : State renames States (Where);
      Data : String (1 .. 256);
      Last : long;
      Time : Instant;
   begin
      Last := Libc.Read (Master (Where), Data'Address, Data'Length);
      Time := Now;
      for C of Data (1 .. Natural (long'Max (0, Last))) loop
         if S.Frame.Begun = Never then
            S.Frame.Begun := Time;
         end if;
         if C = ASCII.CR then
            S.Frame.Ended := Time;
            --  without its checksum
            S.Frame.Text := Head
              (S.Frame.Text, Natural'Max (1, Length (S.Frame.Text)) - 1);
            S.Frames.Append (S.Frame);
            if S.Frame.Text /= S.Held and then Length (S.Frame.Text) > 0 then
               Write (Master (Where),
                      Framed (Answer_To (To_String (S.Frame.Text))));
            end if;
            S.Frame := (others => <>);
         else
            Append (S.Frame.Text, C);
         end if;
      end loop;
   end Hear;

   procedure Receive (Where : Place) is
      --  What has come at the monitor's end
      S    : State renames States (Where);
      Data : String (1 .. 65_536);
      Last : long;
      Next : Positive := 1;
      Stop : Natural;
      Time : Instant;
   begin
      Last := Libc.Read (S.Socket, Data'Address, Data'Length);
      Time := Now;
      if Last <= 0 then
         Disconnect (Where);
         S.Messages.Append (Event'(Time, Time, To_Unbounded_String ("gone")));
         return;
      end if;
      if not S.By_Lines then
         S.Messages.Append
           (Event'(Time, Time, To_Unbounded_String ("data")));
         return;
      end if;
      while Next <= Natural (Last) loop
         if S.Message.Begun = Never then
            S.Message.Begun := Time;
         end if;
         Stop := Index (Data (Next .. Natural (Last)), (1 => ASCII.LF));
         if Length (S.Message.Text) < Label_Size then
            Append (S.Message.Text,
                    Data (Next .. (if Stop = 0 then Natural (Last)
                                   else Stop - 1)));
            S.Message.Text := Head
              (S.Message.Text,
               Natural'Min (Label_Size, Length (S.Message.Text)));
         end if;
         exit when Stop = 0;
         S.Message.Ended := Time;
         S.Messages.Append (S.Message);
         S.Message := (others => <>);
         Next := Stop + 1;
      end loop;
   end Receive;

   procedure Look (Until_Time : Instant) is
      --  Waits for something at any end, and takes it
      Files : Libc.Poll_Array (1 .. 2 * (Place'Pos (Place'Last) + 1)) :=
        (others => (-1, Libc.Poll_In, 0));
   begin
      for Where in Place loop
         Files (2 * Place'Pos (Where) + 1).File := Master (Where);
         Files (2 * Place'Pos (Where) + 2).File := States (Where).Socket;
      end loop;
      Polls.Wait (Files, Until_Time - Now);
      for Where in Place loop
         if Files (2 * Place'Pos (Where) + 1).Returned /= 0 then
            Hear (Where);
         end if;
         if Files (2 * Place'Pos (Where) + 2).Returned /= 0 then
            Receive (Where);
         end if;
      end loop;
   end Look;

   procedure Serve (For_Time : Duration) is
      End_Time : constant Instant := Now + For_Time;
   begin
      loop
         Look (End_Time);
         exit when Now >= End_Time;
      end loop;
   end Serve;

   procedure Send (Where : Place; Text : String) is
   begin
      Write (States (Where).Socket, Text);
   end Send;

   procedure Await_Message
     (Where : Place; Label : String; Count : Positive := 1)
   is
      S        : State renames States (Where);
      End_Time : constant Instant := Now + Limit;
      Seen     : Natural := 0;
      Next     : Positive := 1;
   begin
      loop
         while Next <= S.Messages.Last_Index loop
            if Index (Label, To_String (S.Messages (Next).Text)) > 0 then
               Seen := Seen + 1;
            end if;
            Next := Next + 1;
         end loop;
         exit when Seen >= Count;
         Check (Now < End_Time, "no " & Label & " came");
         Look (End_Time);
      end loop;
   end Await_Message;

   function Begun_At (Where : Place; Frame : String) return Instant is
      --  When it came to the robot; Never before
   begin
      for Item of States (Where).Frames loop
         if Item.Text = Frame then
            return Item.Begun;
         end if;
      end loop;
      return Never;
   end Begun_At;

   procedure Await_Frame (Where : Place; Text : String; Time : out Instant) is
      End_Time : constant Instant := Now + 2.0;
   begin
      loop
         Time := Begun_At (Where, Text);
         exit when Time /= Never;
         Check (Now < End_Time, "no " & Text & " on the line");
         Look (End_Time);
      end loop;
   end Await_Frame;

   procedure Measure
     (Where   : Place;
      Command : String;
      Frame   : String;
      Result  : out Exchange)
   is
      S     : State renames States (Where);
      Begun : Instant;

      Patience : constant Duration := 1.0;

      function Answer return Event is
         --  What came to the monitor; its times are Never before
      begin
         for Item of S.Messages loop
            if not S.By_Lines
              or else Index ("AACK ATIM ACRJ ANAK", To_String (Item.Text)) > 0
            then
               return Item;
            end if;
         end loop;
         return (others => <>);
      end Answer;

   begin
      Result := (others => <>);
      Forget (Where);
      Set_Unanswered (Where, Frame);
      Begun := Now;
      Write (S.Socket, Command);
      while Begun_At (Where, Frame) = Never and then Answer.Ended = Never
        and then Now - Begun < Patience
      loop
         Look (Begun + Patience);
      end loop;
      Result.Order := Begun_At (Where, Frame) - Begun;
      Result.Clean :=
        Begun_At (Where, Frame) /= Never and then S.Frames.Last_Index = 1;
      Serve (0.001);
      Begun := Now;
      Write (Master (Where), Framed ("O"));
      while Answer.Ended = Never and then Now - Begun < Patience loop
         Look (Begun + Patience);
      end loop;
      Result.Answer := Answer.Ended - Begun;
      Result.Clean := Result.Clean
        and then Answer.Ended /= Never
        and then Index ("AACK data", To_String (Answer.Text)) > 0;
      Set_Unanswered (Where, "");
   end Measure;

end Both_Ends;
