--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Exceptions;
with GNAT.OS_Lib;
with GNAT.Sockets; use GNAT.Sockets;
with Interfaces;   use Interfaces;
with Linux;        use Linux;
with System;

package body Monitor.Sockets.Gate.Listener_Calls with
  SPARK_Mode    => Off,
  Refined_State => (Kernel => null)
is
   --  Off: addresses are passed to C; GNAT.Sockets raises exceptions

   procedure Accept_Next
     (From    : Socket;
      Address : out Admission.Socket_Addresses.Socket_Address;
      Found   : out Socket;
      Error   : out Integer)
   is
      function C_Accept
        (From : Socket; Address, Size : System.Address; Flags : int)
         return Socket
      with Import, Convention => C, External_Name => "accept4";
      Size : unsigned := Address'Size / 8;
   begin
      Found := C_Accept
        (From, Address'Address, Size'Address, 8#2000000#);  --  SOCK_CLOEXEC
      Error := GNAT.OS_Lib.Errno;
   end Accept_Next;

   procedure Add_One (To : int) is
      One     : constant Unsigned_64 := 1;
      Ignored : constant Ssize := Linux.Write (To, One'Address, 8);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Add_One;

   procedure Attach
     (To     : Socket;
      Filter : Admission.Packet_Filters.Program;
      Done   : out Boolean)
   is
      function Set_Option
        (S : Socket; Level, Name : int; Value : System.Address; Size : int)
         return int
      with Import, Convention => C, External_Name => "setsockopt";
      --  struct sock_fprog (linux/filter.h)
      type Description is record
         Length : unsigned_short;
         Steps  : System.Address;
      end record with Convention => C;
      Described : constant Description :=
        (unsigned_short (Filter.Length), Filter.Steps'Address);
   begin
      --  SOL_SOCKET, SO_ATTACH_FILTER
      Done := Set_Option
        (To, 1, 26, Described'Address, Described'Size / 8) = 0;
   end Attach;

   procedure Clear (Counter : int) is
      Count   : Unsigned_64;
      Ignored : constant Ssize := Linux.Read (Counter, Count'Address, 8);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Clear;

   procedure Get_Host
     (Family : int;
      Host   : Bytes.Byte_Array;
      Text   : out Admission.Socket_Addresses.Host_Text)
   is
      procedure To_Text
        (Family : int; Host, Text : System.Address; Size : unsigned)
      with Import, Convention => C, External_Name => "inet_ntop";
   begin
      Text := (others => ASCII.NUL);
      To_Text (Family, Host'Address, Text'Address, Text'Length);
   end Get_Host;

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
         Control (int (To_C (Made)), Close_On_Exec);
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

   procedure New_Counter (Counter : out int) is
   begin
      Counter := Event_Counter (0, Event_Non_Blocking);
   end New_Counter;

end Monitor.Sockets.Gate.Listener_Calls;
