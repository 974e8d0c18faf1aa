--  SPDX-License-Identifier: GPL-3.0-or-later
--  The connection to the supervisor.

with Accounts;
with Ada.Exceptions;
with Ada.Real_Time;         use Ada.Real_Time;
with Ada.Streams;           use Ada.Streams;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Commands;
with Exchanges;             use Exchanges;
with GNAT.OS_Lib;
with GNAT.Sockets;          use GNAT.Sockets;
with Monitor.Protocol;
with Mutexes;
with Numerals;
with Peers;
with Terminals;

package body Connections is

   use type Words.Message_Class;

   Max_Line : constant := 6 * 2 ** 20;
   --  Characters: base64 of an image of more than 4 MB

   Tick : constant Duration := 0.02;
   --  Polling period for unanswered commands

   Life : constant Time_Span := Milliseconds (100);
   --  Between two signs of life. Without one for 800 ms the supervisor stops
   --  the robot: seven may be late

   Longest_Mission : constant Duration := 600.0;

   Farewell : constant Duration := 1.0;
   --  Until the supervisor has read all and closes its side

   Socket : Socket_Type := No_Socket;
   Limit  : Duration    := 0.0;
   --  For an answer

   Writing : Mutexes.Mutex;

   Line   : String (1 .. Max_Line);
   Length : Natural := 0;
   --  The line being received: Line (1 .. Length)

   Too_Long : Boolean := False;
   Begun_At : Time    := Time_First;

   procedure Take (Data : Stream_Element_Array; Now : Time) is
      --  Bytes of lines
      C : Character;
   begin
      for Octet of Data loop
         C := Character'Val (Octet);
         if C = Monitor.Protocol.Line_Feed then
            if Length > 0 and then Line (Length) = ASCII.CR then
               Length := Length - 1;
            end if;
            if Too_Long then
               Accounts.Take_Too_Long (Now);
            else
               Accounts.Take
                 (Line (1 .. Length),
                  (if Length = 0 then Now else Begun_At), Now);
            end if;
            Length := 0;
            Too_Long := False;
         elsif Length = Max_Line then
            Too_Long := True;
         else
            if Length = 0 then
               Begun_At := Now;
            end if;
            Length := Length + 1;
            Line (Length) := C;
         end if;
      end loop;
   end Take;

   procedure Write_Line (Line : String) is
      --  Sends it to the supervisor, with its end
      Text  : constant String := Line & Monitor.Protocol.Line_Feed;
      Data  : Stream_Element_Array (1 .. Text'Length);
      First : Stream_Element_Offset := 1;
      Last  : Stream_Element_Offset;
   begin
      for I in Text'Range loop
         Data (Stream_Element_Offset (I - Text'First + 1)) :=
           Character'Pos (Text (I));
      end loop;
      Writing.Seize;
      while First <= Data'Last loop
         Send_Socket (Socket, Data (First .. Data'Last), Last);
         First := Last + 1;
      end loop;
      Writing.Release;
   exception
      when others =>
         Writing.Release;
         raise;
   end Write_Line;

   task Reader is
      entry Start;
   end Reader;

   task Timekeeper is
      entry Start;
   end Timekeeper;

   procedure Await (Class : Words.Message_Class; Come : out Boolean) is
   begin
      if Class /= Words.Mission then
         Exchange.Watch (Class);
      end if;
      select
         Exchange.Seen (Class);
         Come := True;
      or
         delay (if Class = Words.Mission then Longest_Mission else Limit);
         Come := False;
      end select;
   end Await;

   procedure Await_Answers is
   begin
      Exchange.Settled;
   end Await_Answers;

   procedure Finish (Status : Natural) is
      First : Boolean;
   begin
      Exchange.Claim_End (First);
      if not First then
         loop
            delay 60.0;  --  the program is ending
         end loop;
      end if;

      --  So that the last line still arrives: closing a socket with unread
      --  data resets the connection
      begin
         Shutdown_Socket (Socket, Shut_Write);
      exception
         when Socket_Error =>
            null;
      end;
      select
         Exchange.Reading_Ended;
      or
         delay Farewell;
      end select;

      Terminals.Finish;
      Accounts.Put_Summary;
      GNAT.OS_Lib.OS_Exit
        (if Status = 0 and then Exchange.Unanswered > 0 then 1 else Status);
   end Finish;

   function Last_Answer return String is (To_String (Exchange.Last_Answer));

   function Last_End return String is (To_String (Exchange.Last_End));

   procedure Lose (Reason : String) is
      --  The connection is lost, unless it is being closed
      Waiting : constant Natural := Exchange.Unanswered;
   begin
      Exchange.End_Reading;
      if not Exchange.Is_Ending then
         Terminals.Put_Error
           ("the connection is lost: " & Reason
            & (if Waiting = 0 then ""
               else "; commands without an answer: "
                 & Numerals.Image (Waiting)));
         Finish (1);
      end if;
   end Lose;

   procedure Open
     (Host       : String;
      Port       : Positive;
      First_Line : String;
      Failed     : out Boolean)
   is
      Status : Selector_Status := Expired;
      Reason : Unbounded_String;
      --  of each address
   begin
      for Found of Get_Address_Info (Host, Numerals.Image (Port)) loop
         begin
            Create_Socket (Socket, Found.Addr.Family);
            Connect_Socket
              (Socket, Found.Addr, Timeout => 5.0, Status => Status);
            if Status = Completed and then First_Line /= "" then
               declare
                  Objection : constant String := Peers.Objection (Socket);
               begin
                  if Objection /= "" then
                     raise Socket_Error with Objection;
                  end if;
               end;
            end if;
         exception
            when Error : Socket_Error =>
               Status := Aborted;
               Append
                 (Reason,
                  (if Reason = "" then ": " else "; ")
                  & Ada.Exceptions.Exception_Message (Error));
         end;
         exit when Status = Completed;
      end loop;
      Failed := Status /= Completed;
      if Failed then
         Terminals.Put_Error
           ("cannot connect to " & Host & " port " & Numerals.Image (Port)
            & (if Reason = "" then ": no answer within 5 s"
               else To_String (Reason)));
      else
         Set_Socket_Option
           (Socket, IP_Protocol_For_TCP_Level, (No_Delay, True));
         if First_Line /= "" then
            Write_Line (First_Line);
         end if;
      end if;
   exception
      when Error : Host_Error =>
         Failed := True;
         Terminals.Put_Error
           ("unknown host " & Host & ": "
            & Ada.Exceptions.Exception_Message (Error));
      when Error : Socket_Error =>
         Failed := True;
         Terminals.Put_Error
           ("cannot connect to " & Host & " port " & Numerals.Image (Port)
            & ": " & Ada.Exceptions.Exception_Message (Error));
   end Open;

   task body Reader is
      Data : Stream_Element_Array (1 .. 65_536);
      Last : Stream_Element_Offset;
   begin
      select
         accept Start;
      or
         terminate;
      end select;

      loop
         Receive_Socket (Socket, Data, Last);
         exit when Last < Data'First;
         Take (Data (1 .. Last), Clock);
      end loop;
      Lose ("the supervisor closed it");
   exception
      when Error : others =>
         Lose (Ada.Exceptions.Exception_Message (Error));
   end Reader;

   procedure Send (Line : String) is
      use Commands;

      Known : Commands.Command;
      OK    : Boolean := True;
   begin
      Monitor.Protocol.Parse (Line, Known);
      Accounts.Put_Sent (Line);
      if Is_Answered (Known.Name) then
         Exchange.Note_Sent
           ((To_Unbounded_String (Line), Known.Name, Clock, False), OK);
      end if;
      if not OK then
         Terminals.Put_Error ("not sent: too many commands are waiting");
         return;
      end if;

      if Known.Name in Mission_Command then
         Exchange.Watch (Words.Mission);
      end if;
      Write_Line (Line);
   exception
      when Error : Socket_Error =>
         Lose (Ada.Exceptions.Exception_Message (Error));
   end Send;

   procedure Show_Life is
   begin
      Write_Line (Commands.Table (Commands.Sign_Of_Life).Label);
   exception
      when Socket_Error =>
         null;  --  the reader sees why
   end Show_Life;

   procedure Start (Timeout : Duration) is
   begin
      Limit := Timeout;
      Reader.Start;
      Timekeeper.Start;
   end Start;

   task body Timekeeper is
      Found   : Boolean;
      Given   : Command;
      Next_At : Time := Clock;
   begin
      select
         accept Start;
      or
         terminate;
      end select;

      while not Exchange.Is_Ending loop
         if Clock >= Next_At then
            Show_Life;
            Next_At := Clock + Life;
         end if;
         Exchange.Give_Up (Clock - To_Time_Span (Limit), Found, Given);
         if Found then
            Accounts.Put_Unanswered (To_String (Given.Text), Limit);
            Exchange.Published;
         else
            delay Tick;
         end if;
      end loop;
   end Timekeeper;

end Connections;
