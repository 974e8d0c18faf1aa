--  SPDX-License-Identifier: GPL-3.0-or-later
--  The address of a peer as the kernel gives it, for IPv4 and IPv6: what it
--  means, and its text.

with Admission.Networks;
with Bytes;
with Interfaces;
with Texts;

package Admission.Socket_Addresses with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Admission.Socket_Addresses);

   use type Bytes.Byte;
   use type Bytes.Byte_Array;
   use type Interfaces.Unsigned_16;

   Inet_Family : constant := 2;  --  AF_INET; else it is AF_INET6

   type Socket_Address is record
      Family  : Interfaces.Unsigned_16     := 0;
      Port    : Bytes.Byte_Array (1 .. 2)  := (others => 0);
      Host_V4 : Bytes.Byte_Array (1 .. 4)  := (others => 0);
      Host_V6 : Bytes.Byte_Array (1 .. 16) := (others => 0);
      Scope   : Interfaces.Unsigned_32     := 0;
   end record
   with Convention => C;
   --  struct sockaddr_in, sockaddr_in6: port and IPv4 address in network byte
   --  order

   function Is_IPv4 (A : Socket_Address) return Boolean is
     (A.Family = Inet_Family);

   function Peer_Of
     (A : Socket_Address) return Admission.Networks.Peer_Address
   is (if Is_IPv4 (A)
       then Bytes.Byte_Array'(1 .. 10 => 0, 11 .. 12 => 255) & A.Host_V4
       else A.Host_V6)
   with
     Post =>
       (if Is_IPv4 (A) then
           Admission.Networks.Is_IPv4 (Peer_Of'Result)
           and then (for all I in A.Host_V4'Range =>
                       Peer_Of'Result (12 + I) = A.Host_V4 (I)));
   --  In IPv6 notation, an IPv4 address mapped

   subtype Port_Number is Natural range 0 .. 65_535;

   function Port_Of (A : Socket_Address) return Port_Number is
     (Natural (A.Port (1)) * 256 + Natural (A.Port (2)));

   subtype Host_Text is String (1 .. 46);
   --  Of an address, without its port: ended by NUL (INET6_ADDRSTRLEN)

   procedure Set_Name
     (Name : out Texts.Text; A : Socket_Address; Host : Host_Text);
   --  HOST:PORT, or [HOST]:PORT for IPv6. Host: the text of its address

end Admission.Socket_Addresses;
