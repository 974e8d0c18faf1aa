--  SPDX-License-Identifier: GPL-3.0-or-later
--  IPv4 networks, and the list of networks whose monitors are admitted
--  (--allow).

with Bytes;
with Interfaces;

package Networks with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Networks);  --  proved

   use type Bytes.Byte_Array;
   use type Interfaces.Unsigned_32;

   subtype Address is Interfaces.Unsigned_32;
   --  IPv4: the first octet is the most significant

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

   subtype Host is Bytes.Byte_Array (1 .. 16);
   --  IPv6; an IPv4 address is mapped to one: ::ffff:a.b.c.d (RFC 4291,
   --  2.5.5.2)

   Mapped : constant Bytes.Byte_Array (1 .. 12) :=
     (11 | 12 => 255, others => 0);

   function Is_IPv4 (H : Host) return Boolean is (H (1 .. 12) = Mapped);

   function IPv4 (H : Host) return Address is
     (Address (H (13)) * 2 ** 24 + Address (H (14)) * 2 ** 16
      + Address (H (15)) * 2 ** 8 + Address (H (16)));

   --  Lists

   Max_Networks : constant := 8;

   type Network_Array is array (1 .. Max_Networks) of Network;

   type List is record
      Items : Network_Array;
      Count : Natural range 0 .. Max_Networks := 0;
   end record;
   --  The first Count items

   function Admits (L : List; H : Host) return Boolean is
     (L.Count = 0
      or else (Is_IPv4 (H)
               and then (for some I in 1 .. L.Count =>
                           Contains (L.Items (I), IPv4 (H)))));
   --  An empty list admits everybody, any other only IPv4 addresses in one of
   --  its networks

end Networks;
