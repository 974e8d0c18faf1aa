--  SPDX-License-Identifier: GPL-3.0-or-later
--  IPv4 networks, and the list of networks whose monitors are admitted
--  (--allow). The address of a peer as the kernel gives it.

with Bytes;
with Interfaces;

package Admission.Networks with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Admission.Networks);

   use type Bytes.Byte;
   use type Interfaces.Unsigned_16;
   use type Interfaces.Unsigned_32;

   subtype Address is Interfaces.Unsigned_32;
   --  IPv4: the first octet is the most significant

   function Joined (A, B, C, D : Bytes.Byte) return Address is
     (Address (A) * 2 ** 24 + Address (B) * 2 ** 16
      + Address (C) * 2 ** 8 + Address (D));
   --  The address a.b.c.d

   type Network is record
      Start  : Address               := 0;
      Length : Natural range 0 .. 32 := 0;
   end record;
   --  All addresses whose first Length bits are those of Start

   function Contains (N : Network; A : Address) return Boolean is
     (Interfaces.Shift_Right (A xor N.Start, 32 - N.Length) = 0);

   function Is_Network (N : Network) return Boolean is
     (Interfaces.Shift_Left (N.Start, N.Length) = 0);
   --  Start has no bit set beyond the first Length

   procedure Parse (Text : String; N : out Network; Good : out Boolean)
   with Post => (if Good then Is_Network (N));
   --  The network ADDRESS/LEN, or ADDRESS for ADDRESS/32, in which no number
   --  has a leading zero (some programs read such a one as octal)

   --  Peers

   Inet_Family : constant := 2;  --  AF_INET; else it is AF_INET6

   type Socket_Address is record
      Family  : Interfaces.Unsigned_16     := 0;
      Port    : Interfaces.Unsigned_16     := 0;
      Host_V4 : Bytes.Byte_Array (1 .. 4)  := (others => 0);
      Host_V6 : Bytes.Byte_Array (1 .. 16) := (others => 0);
      Scope   : Interfaces.Unsigned_32     := 0;
   end record
   with Convention => C;
   --  struct sockaddr_in, sockaddr_in6: all but Family in network byte order

   function Is_IPv4 (A : Socket_Address) return Boolean is
     (A.Family = Inet_Family
      or else ((for all I in 1 .. 10 => A.Host_V6 (I) = 0)
               and then A.Host_V6 (11) = 255
               and then A.Host_V6 (12) = 255));
   --  At an IPv6 socket it is mapped: ::ffff:a.b.c.d (RFC 4291, 2.5.5.2)

   function IPv4 (A : Socket_Address) return Address is
     (if A.Family = Inet_Family
      then Joined (A.Host_V4 (1), A.Host_V4 (2), A.Host_V4 (3), A.Host_V4 (4))
      else Joined (A.Host_V6 (13), A.Host_V6 (14), A.Host_V6 (15),
                   A.Host_V6 (16)));

   --  Lists

   Max_Networks : constant := 8;

   type Network_Array is array (1 .. Max_Networks) of Network;

   type List is record
      Items : Network_Array;
      Count : Natural range 0 .. Max_Networks := 0;
   end record;
   --  The first Count items

   function Admits (L : List; A : Socket_Address) return Boolean is
     (L.Count = 0
      or else (Is_IPv4 (A)
               and then (for some I in 1 .. L.Count =>
                           Contains (L.Items (I), IPv4 (A)))));
   --  An empty list admits everybody, any other only IPv4 addresses in one of
   --  its networks

end Admission.Networks;
