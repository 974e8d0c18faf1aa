--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with Interfaces;    use Interfaces;
with Interfaces.C;  use Interfaces.C;
with Monitor.Sockets.Stream_Calls;
with Schedule;

package body Monitor.Sockets.Gate with
  SPARK_Mode,
  Refined_State => (Newcomers => (Waker, Streams.Kernel))
is

   package Streams is new Monitor.Sockets.Stream_Calls;
   --  Of the pending connections

   Waker : constant Event_Counters.Counter := Event_Counters.New_Counter;
   --  Of Wake_Server

   Listening : constant Positive := Place'Last + 1;
   Waking    : constant Positive := Place'Last + 2;
   --  Indices of the other descriptors that th_server waits for

   Look_Now      : constant := 16#42#;    --  MSG_PEEK, MSG_DONTWAIT
   Receive_Now   : constant := 16#40#;    --  MSG_DONTWAIT
   Send_With_End : constant := 16#C040#;
   --  MSG_NOSIGNAL, MSG_DONTWAIT, MSG_MORE
   Sending       : constant := 1;         --  SHUT_WR

   procedure Wait (Watched : Socket_Array; Pending : Boolean) is
      Server  : constant Socket := Monitor.Sockets.Listener.Listening;
      Entries : Streams.Watch_Array (1 .. Waking);
      Ignored : Natural;
   begin
      for I in Place loop
         Entries (I).Descriptor := int (Watched (I));
      end loop;
      Entries (Listening).Descriptor := int (Server);
      Entries (Waking).Descriptor := Event_Counters.Descriptor (Waker);
      Streams.Poll
        (Entries,
         (if Pending then int (Schedule.Pending_Period / Milliseconds (1))
          else -1));
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
      Got           : Streams.Outcome;
      Error         : Integer;
      Ignored_Error : Integer;
   begin
      Streams.Receive (From, Look_Now, Data, Got, Error);
      Open := Got > 0
        or else (Got < 0
                 and then Error in Streams.Try_Again | Streams.Interrupted);
      Length := Integer'Max (0, Got);
      for I in 1 .. Length loop
         pragma Loop_Invariant (Length = Got);
         if Data (Data'First + (I - 1)) = ASCII.LF then
            Length := I;
            exit;
         end if;
      end loop;
      if Length > 0 then
         Streams.Receive
           (From, Receive_Now, Data (Data'First .. Data'First + (Length - 1)),
            Got, Ignored_Error);
         Length := Integer'Max (0, Got);
      end if;
   end Read_Line;

   procedure Refuse (Refused : Socket; Message : String) is
      Ignored_Data  : String (1 .. 256) := (others => ' ');
      Ignored_Count : Streams.Outcome;
      Ignored_Error : Integer;
   begin
      --  message and FIN in one packet, which takes half the time: there may
      --  be a flood of rejections
      Streams.Send
        (Refused, Send_With_End, Message, Ignored_Count, Ignored_Error);
      Streams.Shut_Down (Refused, Sending);
      --  unread data would turn the close into a reset, which could overtake
      --  the message
      Streams.Receive
        (Refused, Receive_Now, Ignored_Data, Ignored_Count, Ignored_Error);
      Streams.Close (Refused);
   end Refuse;

end Monitor.Sockets.Gate;
