--  SPDX-License-Identifier: GPL-3.0-or-later
--  Others who connect.

with Ada.Unchecked_Deallocation;
with GNAT.Sockets;   use GNAT.Sockets;
with Interfaces.C;   use Interfaces.C;

with Libc;
with Polls;
with Whole_Sends;

package body Floods is

   Connections : constant array (Manner) of Positive :=
     (Patient | Restless => 64, Slow => 5);
   --  of each sender at a time

   Noise : constant String := "GET / HTTP/1.1" & ASCII.CR & ASCII.LF;

   function Server (Port : Positive) return Sock_Addr_Type is
     (Family_Inet, Inet_Addr ("127.0.0.1"), Port_Type (Port));

   procedure Say (Socket : Socket_Type; Text : String) is
      --  Where it is connected
   begin
      Whole_Sends.Send (Socket, Text);
   exception
      when Socket_Error =>
         --  not yet, or no longer
         null;
   end Say;

   procedure Free is new Ada.Unchecked_Deallocation (Sender, Sender_Access);

   function Address (Number : Positive) return String is
     ("127.0.1." & Character'Val (48 + Number));

   procedure Begin_Connection
     (Socket : out Socket_Type; Own, Place : Sock_Addr_Type)
   is
      --  From the address Own; does not wait for it
      At_Once : Request_Type := (Non_Blocking_IO, True);
   begin
      Create_Socket (Socket);
      Bind_Socket (Socket, Own);
      Control_Socket (Socket, At_Once);
      Connect_Socket (Socket, Place);
   exception
      when Socket_Error =>
         --  under way
         null;
   end Begin_Connection;

   procedure Come (Object : in out Crowd; Port : Positive; Own : String) is
   begin
      for Index in Object.Sockets'Range loop
         Begin_Connection
           (Object.Sockets (Index), (Family_Inet, Inet_Addr (Own), 0),
            Server (Port));
         Say (Object.Sockets (Index), Noise);
         if Index mod 2 = 0 then
            Close_Socket (Object.Sockets (Index));
            Object.Sockets (Index) := No_Socket;
         end if;
      end loop;
   end Come;

   procedure Disconnect (Socket : in out Socket_Type) is
      --  By a reset: nothing of it is left that could run short
   begin
      if Socket /= No_Socket then
         Set_Socket_Option (Socket, Socket_Level, (Linger, True, 0));
         Close_Socket (Socket);
         Socket := No_Socket;
      end if;
   end Disconnect;

   overriding procedure Finalize (Object : in out Crowd) is
   begin
      for Socket of Object.Sockets loop
         Disconnect (Socket);
      end loop;
   end Finalize;

   task body Sender is
      Own     : constant Sock_Addr_Type :=
        (Family_Inet, Inet_Addr (Address (Number)), 0);
      Place   : constant Sock_Addr_Type := Server (Port);
      Sockets : Socket_Array (1 .. Connections (How)) := (others => No_Socket);
      Files   : Libc.Poll_Array (1 .. Connections (How));

      procedure Connect (Index : Positive) is
      begin
         Begin_Connection (Sockets (Index), Own, Place);
         Files (Index) := (int (To_C (Sockets (Index))), Libc.Poll_In, 0);
      end Connect;

      procedure Connect_Again is
         --  Those that have been told something
      begin
         for Index in Files'Range loop
            if Files (Index).Returned /= 0 then
               Seen.Served := Seen.Served + 1;
               Disconnect (Sockets (Index));
               Connect (Index);
            end if;
         end loop;
      end Connect_Again;

   begin
      if How /= Restless then
         for Index in Sockets'Range loop
            Connect (Index);
         end loop;
      end if;
      while not Seen.Over loop
         case How is
            when Patient =>
               Polls.Wait (Files, 0.1);
               Connect_Again;
            when Slow =>
               Polls.Wait (Files, 0.0);
               Connect_Again;
               for Socket of Sockets loop
                  Say (Socket, "A");
               end loop;
               delay 0.02;
            when Restless =>
               for Index in Sockets'Range loop
                  Disconnect (Sockets (Index));
                  Connect (Index);
                  Say (Sockets (Index), Noise);
               end loop;
               --  for others on this machine
               delay 0.001;
         end case;
      end loop;
      for Socket of Sockets loop
         Disconnect (Socket);
      end loop;
   end Sender;

   procedure Start
     (Object : in out Flood; Port : Positive; How : Manner := Patient) is
   begin
      for Number in Object.Tasks'Range loop
         Object.Tasks (Number) :=
           new Sender
             (Number, Port, How, Object.Seen (Number)'Unchecked_Access);
      end loop;
   end Start;

   function Served (Object : Flood) return Natural is
   begin
      return Sum : Natural := 0 do
         for Part of Object.Seen loop
            Sum := Sum + Part.Served;
         end loop;
      end return;
   end Served;

   procedure Stop (Object : in out Flood) is
   begin
      for Part of Object.Seen loop
         Part.Over := True;
      end loop;
      for Item of Object.Tasks loop
         if Item /= null then
            while not Item'Terminated loop
               delay 0.01;
            end loop;
            Free (Item);
         end if;
      end loop;
   end Stop;

end Floods;
