--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Exceptions;
with GNAT.OS_Lib;
with GNAT.Sockets; use GNAT.Sockets;
with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;
with System;

package body Monitor.Sockets.Gate.Listener_Calls with
  SPARK_Mode    => Off,
  Refined_State => (Kernel => null)
is
   --  Off: addresses are passed to C; GNAT.Sockets raises exceptions

   procedure Listen
     (Address : Texts.Text;
      Port    : Options.Port_Number;
      Backlog : Positive;
      Server  : out Socket;
      Bound   : out Options.Port_Number;
      Reason  : out Texts.Text)
   is
      Made         : Socket_Type := No_Socket;
      Is_Address   : Boolean := False;
      Non_Blocking : Request_Type := (Non_Blocking_IO, True);
   begin
      Server := Nobody;
      Bound := 0;
      Texts.Set (Reason, "");
      declare
         Host : constant Inet_Addr_Type := Inet_Addr (Texts.Image (Address));
      begin
         Is_Address := True;
         Create_Socket (Made, Host.Family, Socket_Stream);
         Linux.Control (int (To_C (Made)), Linux.Close_On_Exec);
         Set_Socket_Option (Made, Socket_Level, (Reuse_Address, True));
         Bind_Socket (Made, Network_Socket_Address (Host, Port_Type (Port)));
      end;
      Listen_Socket (Made, Backlog);
      --  a client that has left again must not block the accept
      Control_Socket (Made, Non_Blocking);
      Bound := Natural (Get_Socket_Name (Made).Port);
      Server := Socket (To_C (Made));
   exception
      when E : others =>
         Texts.Set
           (Reason,
            (if Is_Address then Ada.Exceptions.Exception_Message (E)
             else "no address such as 0.0.0.0, 192.168.1.5 or ::1 (names are "
               & "not looked up)"));
         Linux.Close (int (To_C (Made)));
   end Listen;

   procedure Take_In
     (Server : Socket;
      Found  : out Socket;
      From   : out Admission.Networks.Socket_Address;
      Name   : out Texts.Text)
   is
      function C_Accept
        (From : Socket; Address, Size : System.Address; Flags : int)
         return Socket
      with Import, Convention => C, External_Name => "accept4";

      function Name_Of (A : Admission.Networks.Socket_Address) return String is
         V4   : constant Inet_Addr_V4_Type
         with Import, Address => A.Host_V4'Address;
         V6   : constant Inet_Addr_V6_Type
         with Import, Address => A.Host_V6'Address;
         Port : constant Port_Type := Port_Type
           (A.Port mod 256 * 256 + A.Port / 256);  --  network byte order
      begin
         return Image
           (if A.Family = Admission.Networks.Inet_Family
            then Sock_Addr_Type'(Family_Inet, (Family_Inet, V4), Port)
            else Sock_Addr_Type'(Family_Inet6, (Family_Inet6, V6), Port));
      end Name_Of;

      Size : unsigned := From'Size / 8;
   begin
      Found := C_Accept
        (Server, From'Address, Size'Address, 8#2000000#);  --  SOCK_CLOEXEC
      if Found /= Nobody then
         Texts.Set (Name, Name_Of (From));
      elsif GNAT.OS_Lib.Errno = Linux.EAGAIN then
         --  the client has already left: no failure
         Texts.Set (Name, "");
      else
         Texts.Set (Name, GNAT.OS_Lib.Errno_Message);
      end if;
   end Take_In;

end Monitor.Sockets.Gate.Listener_Calls;
