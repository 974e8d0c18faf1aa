--  SPDX-License-Identifier: GPL-3.0-or-later
--  Short-lived connections, as from a port scanner.

with Ada.Streams;    use Ada.Streams;
with GNAT.Sockets;   use GNAT.Sockets;
with Interfaces;     use Interfaces;
with Interfaces.C;   use Interfaces.C;

with Instants;       use Instants;
with Polls;
with Random_Numbers; use Random_Numbers;

package body Raw_Probes is

   procedure Set_Abortive (Socket : Socket_Type) is
      --  Its close will be a reset
   begin
      Set_Socket_Option (Socket, Socket_Level, (Linger, True, 0));
   end Set_Abortive;

   procedure Begin_Connection
     (Socket : out Socket_Type; Place : Sock_Addr_Type; Waits : Boolean)
   is
      --  Waits: until it is established or refused
      At_Once : Request_Type := (Non_Blocking_IO, not Waits);
   begin
      Create_Socket (Socket);
      Set_Socket_Option (Socket, Socket_Level, (Send_Timeout, 3.0));
      --  of a connection as well
      Control_Socket (Socket, At_Once);
      begin
         Connect_Socket (Socket, Place);
      exception
         when Socket_Error =>
            --  under way, or refused: seen when it is used
            null;
      end;
   end Begin_Connection;

   procedure Knock
     (Address : String;
      Port    : Positive;
      Count   : Positive;
      Source  : in out Generator)
   is
      Place  : constant Sock_Addr_Type :=
        (Family_Inet, Inet_Addr (Address), Port_Type (Port));
      Socket : Socket_Type;
      Bytes  : constant Stream_Element_Array := (16#16#, 3, 1, 0, 10, 71);
      Last   : Stream_Element_Offset;
   begin
      for Number in 1 .. Count loop
         begin
            case Whole (Source, 1, 5) is
               when 1 =>
                  Begin_Connection (Socket, Place, Waits => True);
               when 2 =>
                  Begin_Connection (Socket, Place, Waits => True);
                  Set_Abortive (Socket);
               when 3 =>
                  Begin_Connection (Socket, Place, Waits => False);
               when 4 =>
                  Begin_Connection (Socket, Place, Waits => True);
                  Send_Socket (Socket, Bytes, Last);
               when others =>
                  Begin_Connection (Socket, Place, Waits => True);
                  Shutdown_Socket (Socket, Shut_Write);
            end case;
         exception
            when Socket_Error =>
               --  the other side was faster
               null;
         end;
         Close_Socket (Socket);
      end loop;
   end Knock;

   function Can_Half_Open return Boolean is
      Socket : Socket_Type;
   begin
      Create_Socket
        (Socket, Family_Inet, Socket_Raw, IP_Protocol_For_TCP_Level);
      Close_Socket (Socket);
      return True;
   exception
      when Socket_Error =>
         return False;
   end Can_Half_Open;

   procedure Half_Open
     (Address : String;
      Port    : Positive;
      Count   : Positive;
      Source  : in out Generator)
   is
      Host   : constant Inet_Addr_Type := Inet_Addr (Address);
      Place  : aliased Sock_Addr_Type := (Family_Inet, Host, 0);
      Socket : Socket_Type;
      Size   : constant := 20;
      Packet : Stream_Element_Array (1 .. Size);
      Last   : Stream_Element_Offset;

      procedure Put (First : Stream_Element_Offset; Value : Unsigned_16) is
      begin
         Packet (First) := Stream_Element (Shift_Right (Value, 8));
         Packet (First + 1) := Stream_Element (Value and 16#FF#);
      end Put;

      function Checksum return Unsigned_16 is
         --  Of the segment and its pseudo-header (RFC 9293, 3.1)
         Protocol : constant := 6;
         Sum      : Unsigned_32 := Protocol + Size;
      begin
         --  both addresses are this machine's
         for Part in 1 .. 2 loop
            Sum := Sum
              + 2 * (Unsigned_32 (Host.Sin_V4 (2 * Part - 1)) * 256
                     + Unsigned_32 (Host.Sin_V4 (2 * Part)));
         end loop;
         for Part in 0 .. Stream_Element_Offset'(Size / 2 - 1) loop
            Sum := Sum + Unsigned_32 (Packet (2 * Part + 1)) * 256
              + Unsigned_32 (Packet (2 * Part + 2));
         end loop;
         while Sum > 16#FFFF# loop
            Sum := (Sum and 16#FFFF#) + Shift_Right (Sum, 16);
         end loop;
         return not Unsigned_16 (Sum);
      end Checksum;

   begin
      Create_Socket
        (Socket, Family_Inet, Socket_Raw, IP_Protocol_For_TCP_Level);
      for Number in 1 .. Count loop
         Packet := (others => 0);
         Put (1, Unsigned_16 (Whole (Source, 20_000, 32_000)));
         Put (3, Unsigned_16 (Port));
         Put (5, Unsigned_16 (Whole (Source, 0, 65_535)));
         --  the upper half of the sequence number
         Put (13, 16#5002#);
         --  five words of header; SYN
         Put (15, 1024);
         --  the window
         Put (17, Checksum);
         Send_Socket (Socket, Packet, Last, To => Place'Access);
      end loop;
      Close_Socket (Socket);
   end Half_Open;

   function Crowd
     (Address : String; Port : Positive; Count : Positive; Within : Duration)
      return Crowd_Result
   is
      Place    : constant Sock_Addr_Type :=
        (Family_Inet, Inet_Addr (Address), Port_Type (Port));
      Sockets  : array (1 .. Count) of Socket_Type := (others => No_Socket);
      Heard    : array (1 .. Count) of Boolean := (others => False);
      Waiting  : Natural := Count;
      Patience : constant Duration := 1.5;
      --  If its queue is full, the kernel forgets a connection that this end
      --  regards as established, until a byte arrives: so a client without
      --  reply sends one
      Asked    : Instant;
      Result   : Crowd_Result;
      Deadline : Instant;
      Bytes    : Stream_Element_Array (1 .. 512);
      Last     : Stream_Element_Offset;

      procedure Speak (Socket : Socket_Type) is
         Line_End : constant Stream_Element_Array :=
           (1 => Character'Pos (ASCII.LF));
      begin
         Send_Socket (Socket, Line_End, Last);
      exception
         when Socket_Error =>
            --  its end is about to be seen
            null;
      end Speak;

      procedure Look (Number : Positive) is
         Over : Boolean := False;
      begin
         if Polls.Is_Readable (int (To_C (Sockets (Number))), 0.0) then
            Receive_Socket (Sockets (Number), Bytes, Last);
            Over := Last < Bytes'First;
            Heard (Number) := Heard (Number)
              or else (not Over
                       and then Bytes (Last) = Character'Pos (ASCII.LF));
            if Over then
               Result.Closed := Result.Closed + 1;
            end if;
         end if;
         if Over then
            Close_Socket (Sockets (Number));
            Sockets (Number) := No_Socket;
            Waiting := Waiting - 1;
         end if;
      exception
         when Socket_Error =>
            Result.Closed := Result.Closed + 1;
            Close_Socket (Sockets (Number));
            Sockets (Number) := No_Socket;
            Waiting := Waiting - 1;
      end Look;

   begin
      for Socket of Sockets loop
         Begin_Connection (Socket, Place, Waits => False);
      end loop;
      Deadline := Now + Within;
      Asked := Now;
      while Waiting > 0 and then Now < Deadline loop
         for Number in Sockets'Range loop
            if Sockets (Number) /= No_Socket then
               Look (Number);
            end if;
         end loop;
         if Now - Asked > Patience then
            Asked := Now;
            for Socket of Sockets loop
               if Socket /= No_Socket then
                  Speak (Socket);
               end if;
            end loop;
         end if;
         delay 0.005;
      end loop;
      for Number in Sockets'Range loop
         if Sockets (Number) /= No_Socket then
            Set_Abortive (Sockets (Number));
            Close_Socket (Sockets (Number));
         end if;
         if Heard (Number) then
            Result.Told := Result.Told + 1;
         end if;
      end loop;
      Result.Left := Waiting;
      return Result;
   end Crowd;

end Raw_Probes;
