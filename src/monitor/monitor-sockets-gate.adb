--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces;    use Interfaces;
with Interfaces.C;  use Interfaces.C;
with Schedule;
with Trace;

package body Monitor.Sockets.Gate with
  SPARK_Mode,
  Refined_State => (Waiting => Waker)
is

   Waker : constant Event_Counters.Counter := Event_Counters.New_Counter;
   --  Of Wake_Server

   Coming : constant Positive := Place'Last + 1;
   Waking : constant Positive := Place'Last + 2;
   --  Indices of the other descriptors that th_server waits for

   Look_Now      : constant := 16#42#;    --  MSG_PEEK, MSG_DONTWAIT
   Receive_Now   : constant := 16#40#;    --  MSG_DONTWAIT
   Send_With_End : constant := 16#C040#;
   --  MSG_NOSIGNAL, MSG_DONTWAIT, MSG_MORE
   Sending       : constant := 1;         --  SHUT_WR

   procedure Wait (Watched : Socket_Array; Pending : Boolean) is
      Server  : constant Socket := Listening;
      Entries : Watch_Array (1 .. Waking);
      Ignored : Natural;
   begin
      for I in Place loop
         Entries (I).Descriptor := int (Watched (I));
      end loop;
      Entries (Coming).Descriptor := int (Server);
      Entries (Waking).Descriptor := Event_Counters.Descriptor (Waker);
      Poll
        (Entries,
         (if Pending then int (Schedule.Pending_Period / Milliseconds (1))
          else -1));
      Trace.Put (Trace.Start, Schedule.Th_Server);
      if Entries (Waking).Returned /= 0 then
         Event_Counters.Take (Waker, Ignored);
      end if;
   end Wait;

   procedure Wake_Server is
   begin
      Event_Counters.Add (Waker);
   end Wake_Server;

   procedure Read_Line
     (From   : Socket;
      Data   : in out String;
      Length : out Natural;
      Open   : out Boolean)
   is
      Got           : Outcome;
      Error         : Integer;
      Ignored_Error : Integer;
   begin
      Receive (From, Look_Now, Data, Got, Error);
      Open := Got > 0
        or else (Got < 0
                 and then Error in Try_Again | Interrupted);
      Length := Integer'Max (0, Got);
      for I in 1 .. Length loop
         pragma Loop_Invariant (Length = Got);
         if Data (Data'First + (I - 1)) = ASCII.LF then
            Length := I;
            exit;
         end if;
      end loop;
      if Length > 0 then
         Receive
           (From, Receive_Now, Data (Data'First .. Data'First + (Length - 1)),
            Got, Ignored_Error);
         Length := Integer'Max (0, Got);
      end if;
   end Read_Line;

   procedure Refuse (Refused : Socket; Message : String) is
      Ignored_Data  : String (1 .. 256) := (others => ' ');
      Ignored_Count : Outcome;
      Ignored_Error : Integer;
   begin
      --  message and FIN in one packet, which takes half the time: there may
      --  be a flood of rejections
      Send
        (Refused, Send_With_End, Message, Ignored_Count, Ignored_Error);
      Shut_Down (Refused, Sending);
      --  unread data would turn the close into a reset, which could overtake
      --  the message
      Receive
        (Refused, Receive_Now, Ignored_Data, Ignored_Count, Ignored_Error);
      Close (Refused);
   end Refuse;

end Monitor.Sockets.Gate;
