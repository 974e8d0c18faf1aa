--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Exceptions;
with Bytes;
with GNAT.OS_Lib;
with GNAT.Sockets; use GNAT.Sockets;
with Linux;        use Linux;
with System;

package body Monitor.Sockets with
  SPARK_Mode    => Off,
  Refined_State => (Kernel => null)
is
   --  Off: addresses are passed to C; GNAT.Sockets raises exceptions

   use type Bytes.Byte;
   use type Bytes.Byte_Array;

   Queue_Length : constant := 512;
   --  Backlog of connections not yet accepted: empty after half a second. A
   --  client that finds it full retries at growing intervals

   Error_Option : constant := 4;   --  SO_ERROR
   Info_Option  : constant := 11;  --  TCP_INFO

   Server : Socket := Nobody with Atomic;

   function Get_Option
     (S : Socket; Level, Name : int; Value, Size : System.Address) return int
   with Import, Convention => C, External_Name => "getsockopt";

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Bound   : out Options.Port_Number;
      Success : out Boolean;
      Reason  : out Texts.Text)
   is
      Made         : Socket_Type := No_Socket;
      Host         : Inet_Addr_Type;
      Non_Blocking : Request_Type := (Non_Blocking_IO, True);
   begin
      Success := False;
      Bound := 0;
      Texts.Set
        (Reason, "no address such as 0.0.0.0, 192.168.1.5 or ::1 (names are "
         & "not looked up)");
      Host := Inet_Addr (Texts.Image (Address));
      Texts.Set (Reason, "");
      Create_Socket (Made, Host.Family, Socket_Stream);
      Linux.Control (int (To_C (Made)), Linux.Close_On_Exec);
      Set_Socket_Option (Made, Socket_Level, (Reuse_Address, True));
      Bind_Socket (Made, Network_Socket_Address (Host, Port_Type (Port)));
      Listen_Socket (Made, Queue_Length);
      --  a client that has left again must not block the accept
      Control_Socket (Made, Non_Blocking);
      Bound := Natural (Get_Socket_Name (Made).Port);
      Server := Socket (To_C (Made));
      Success := True;
   exception
      when E : others =>
         if Reason.Length = 0 then
            Texts.Set (Reason, Ada.Exceptions.Exception_Message (E));
         end if;
         Linux.Close (int (To_C (Made)));
   end Listen;

   function Listening return Socket is (Server);

   procedure Take_In
     (Found : out Socket;
      From  : out Networks.Host;
      Name  : out Texts.Text)
   is
      function C_Accept
        (From : Socket; Address, Size : System.Address; Flags : int)
         return Socket
      with Import, Convention => C, External_Name => "accept4";

      Raw  : Bytes.Byte_Array (1 .. 28) := (others => 0);
      --  struct sockaddr_in or sockaddr_in6: family, port (in network byte
      --  order), and, from 5 or 9 on, the address
      V4   : Inet_Addr_V4_Type with Import, Address => Raw (5)'Address;
      V6   : Inet_Addr_V6_Type with Import, Address => Raw (9)'Address;
      Size : unsigned := Raw'Length;

      function Name_Of (Host : Inet_Addr_Type) return String is
        (Image (Network_Socket_Address
                  (Host, Port_Type (Raw (3)) * 256 + Port_Type (Raw (4)))));

   begin
      Found := C_Accept
        (Server, Raw'Address, Size'Address, 8#2000000#);  --  SOCK_CLOEXEC
      From := Raw (9 .. 24);
      if Found = Nobody then
         --  the client has already left, no failure
         Texts.Set
           (Name, (if GNAT.OS_Lib.Errno = -Try_Again then ""
                   else GNAT.OS_Lib.Errno_Message));
      elsif Raw (1) = 2 then  --  AF_INET
         From := Networks.Mapped & Raw (5 .. 8);
         Texts.Set (Name, Name_Of ((Family_Inet, V4)));
      else
         Texts.Set (Name, Name_Of ((Family_Inet6, V6)));
      end if;
   end Take_In;

   procedure Receive
     (From : Socket; Flags : int; Data : in out String; Got : out Outcome)
   is
      function C_Receive
        (From : Socket; Data : System.Address; Length : size_t; Flags : int)
         return Ssize
      with Import, Convention => C, External_Name => "recv";
   begin
      Got := Outcome_Of
        (Ssize'Min (C_Receive (From, Data'Address, Data'Length, Flags),
                    Data'Length));
   end Receive;

   procedure Send
     (To : Socket; Flags : int; Data : String; Put : out Outcome)
   is
      function C_Send
        (To : Socket; Data : System.Address; Length : size_t; Flags : int)
         return Ssize
      with Import, Convention => C, External_Name => "send";
   begin
      Put := Outcome_Of
        (Ssize'Min (C_Send (To, Data'Address, Data'Length, Flags),
                    Data'Length));
   end Send;

   procedure Set_Number (S : Socket; Level, Name, Value : int) is
      procedure Set_Option
        (S : Socket; Level, Name : int; Value : System.Address; Size : int)
      with Import, Convention => C, External_Name => "setsockopt";
   begin
      Set_Option (S, Level, Name, Value'Address, Value'Size / 8);
   end Set_Number;

   procedure Get_Error (S : Socket; Error : out Integer) is
      Size    : unsigned := Error'Size / 8;
      Ignored : int;
      pragma Unreferenced (Ignored);
   begin
      Error := 0;
      Ignored := Get_Option
        (S, Level_Socket, Error_Option, Error'Address, Size'Address);
   end Get_Error;

   procedure Get_Info
     (S : Socket; Info : out Monitor.Link.Tcp_Info; Filled : out Natural)
   is
      Size : unsigned := Info'Size / 8;
   begin
      Filled :=
        (if Get_Option
           (S, Level_Tcp, Info_Option, Info'Address, Size'Address) = 0
         then Natural (Size) else 0);
   end Get_Info;

   procedure Poll (Entries : in out Watch_Array; Wait_Ms : int) is
   begin
      Linux.Poll (Entries'Address, Entries'Length, Wait_Ms);
   end Poll;

   procedure Shut_Down (S : Socket; How : int) is
      procedure C_Shutdown (S : Socket; How : int)
      with Import, Convention => C, External_Name => "shutdown";
   begin
      C_Shutdown (S, How);
   end Shut_Down;

   procedure Close (S : Socket) is
   begin
      Linux.Close (int (S));
   end Close;

end Monitor.Sockets;
