--  SPDX-License-Identifier: GPL-3.0-or-later
--  IPv4 networks, and the list of networks whose monitors are admitted
--  (--allow). The source to which a peer's connections are counted.

with Bytes; use Bytes;
with Interfaces;

package Admission.Networks with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Admission.Networks);

   use type Byte;
   use type Interfaces.Unsigned_32;
   use type Interfaces.Unsigned_64;

   subtype Address is Interfaces.Unsigned_32;
   --  The first octet is the most significant.

   subtype Prefix_Length is Natural range 0 .. 32;

   subtype Bit_Place is Positive range 1 .. 32;
   --  1 is the first bit of the first octet.

   function Bit (A : Address; I : Bit_Place) return Boolean is
     ((Interfaces.Shift_Right (A, 32 - I) and 1) = 1);

   type Network is record
      Start  : Address       := 0;
      Length : Prefix_Length := 0;
   end record;
   --  All addresses whose first Length bits are those of Start.

   function Is_Network (N : Network) return Boolean is
     (for all I in N.Length + 1 .. 32 => not Bit (N.Start, I));
   --  Start has no bit set beyond the first Length.

   function Contains (N : Network; A : Address) return Boolean is
     (for all I in 1 .. N.Length => Bit (A, I) = Bit (N.Start, I));

   --  Peers

   subtype Peer_Address is Byte_Array (1 .. 16);
   --  In IPv6 notation. An IPv4 address is mapped, ::ffff:a.b.c.d, whatever
   --  the socket (RFC 4291, 2.5.5.2).

   function Is_IPv4 (P : Peer_Address) return Boolean is
     ((for all I in 1 .. 10 => P (I) = 0)
      and then P (11) = 255
      and then P (12) = 255);

   function Joined (A, B, C, D : Byte) return Address is
     (Address (A) * 2 ** 24 + Address (B) * 2 ** 16
      + Address (C) * 2 ** 8 + Address (D));
   --  The address a.b.c.d

   function IPv4 (P : Peer_Address) return Address is
     (Joined (P (13), P (14), P (15), P (16)))
   with Pre => Is_IPv4 (P);

   --  Sources

   subtype Source is Interfaces.Unsigned_64;
   --  The unit by which connections are counted: an IPv4 address, or the first
   --  64 bits of an IPv6 address, as each subscriber has a /64.

   IPv4_Sources : constant Source := 16#FFFF_0000_0000#;
   --  Followed by the IPv4 address. No IPv6 address in use begins so (RFC
   --  4291, 2.4: 0000::/8 is reserved).

   function Octets
     (P : Peer_Address; First : Positive) return Source
   is (Source (P (First)) * 2 ** 24 + Source (P (First + 1)) * 2 ** 16
       + Source (P (First + 2)) * 2 ** 8 + Source (P (First + 3)))
   with Pre => First <= 13;

   function Source_Of (P : Peer_Address) return Source is
     (if Is_IPv4 (P) then IPv4_Sources + Octets (P, 13)
      else Octets (P, 1) * 2 ** 32 + Octets (P, 5));

   function Is_IPv4 (S : Source) return Boolean is
     ((S and 16#FFFF_FFFF_0000_0000#) = IPv4_Sources);

   --  Lists

   Max_Networks : constant := 8;

   subtype Network_Count is Natural range 0 .. Max_Networks;

   type Network_Array is array (1 .. Max_Networks) of Network;

   type List is record
      Items : Network_Array;
      Count : Network_Count := 0;
   end record;
   --  The first Count items are valid. Initially none.

   function Admits (L : List; P : Peer_Address) return Boolean is
     (L.Count = 0
      or else
        (Is_IPv4 (P)
         and then (for some I in 1 .. L.Count =>
                     Contains (L.Items (I), IPv4 (P)))));
   --  An empty list admits everybody, any other only IPv4 addresses in one of
   --  its networks.

   procedure Add (L : in out List; N : Network)
   with
     Pre  => L.Count < Max_Networks,
     Post => L.Count = L.Count'Old + 1
       and then L.Items (L.Count) = N
       and then (for all I in 1 .. L.Count - 1 =>
                   L.Items (I) = L.Items'Old (I));

   --  The text of a network: ADDRESS/LEN, or ADDRESS for ADDRESS/32

   Max_Text : constant := 512;
   --  Characters; no valid text is longer.

   subtype Text_Place is Natural range 0 .. Max_Text + 8;

   function Digits_End (Text : String; First : Positive) return Text_Place
   with
     Pre  => Text'First = 1
       and then Text'Last <= Max_Text
       and then First <= Max_Text + 1,
     Post =>
       (if First > Text'Last then Digits_End'Result = First - 1
        else Digits_End'Result in First - 1 .. Text'Last
          and then (for all I in First .. Digits_End'Result =>
                      Text (I) in '0' .. '9')
          and then (if Digits_End'Result < Text'Last then
                       Text (Digits_End'Result + 1) not in '0' .. '9'));
   --  The last digit of the number that begins at First; First - 1 if none.

   function Digit_Value (C : Character) return Natural is
     (Character'Pos (C) - Character'Pos ('0'))
   with Pre => C in '0' .. '9';

   function Is_Number
     (Text : String; First : Positive; Last : Natural) return Boolean
   is (First <= Last
       and then Last - First <= 2
       and then (for all I in First .. Last => Text (I) in '0' .. '9')
       and then (if First < Last then Text (First) /= '0'))
   with Pre => First >= Text'First and then Last <= Text'Last;
   --  One to three digits, without a leading zero: some programs read such a
   --  number as octal.

   function Number
     (Text : String; First : Positive; Last : Natural) return Natural
   is (if Last = First then Digit_Value (Text (First))
       elsif Last = First + 1 then
          10 * Digit_Value (Text (First)) + Digit_Value (Text (Last))
       else 100 * Digit_Value (Text (First))
         + 10 * Digit_Value (Text (First + 1))
         + Digit_Value (Text (Last)))
   with
     Pre  => First >= Text'First
       and then Last <= Text'Last
       and then Is_Number (Text, First, Last),
     Post => Number'Result <= 999;

   function Is_Octet
     (Text : String; First : Positive; Last : Natural) return Boolean
   is (Is_Number (Text, First, Last)
       and then Number (Text, First, Last) <= 255)
   with Pre => First >= Text'First and then Last <= Text'Last;

   function Is_Length
     (Text : String; First : Positive; Last : Natural) return Boolean
   is (Is_Number (Text, First, Last)
       and then Number (Text, First, Last) <= 32)
   with Pre => First >= Text'First and then Last <= Text'Last;

   type Octet_Ends is array (1 .. 4) of Text_Place;

   function Ends (Text : String) return Octet_Ends
   with
     Pre  => Text'First = 1 and then Text'Last <= Max_Text,
     Post => Ends'Result (1) = Digits_End (Text, 1)
       and then
         (for all I in 2 .. 4 =>
            Ends'Result (I) =
              (if Ends'Result (I - 1) < Text'Last
               then Digits_End (Text, Ends'Result (I - 1) + 2)
               else Ends'Result (I - 1)));
   --  Where the four octets of the address at the beginning of Text end.

   function Begins_With_Address (Text : String) return Boolean is
     (Ends (Text) (4) <= Text'Last
      and then Ends (Text) (1) < Ends (Text) (2)
      and then Ends (Text) (2) < Ends (Text) (3)
      and then Ends (Text) (3) < Ends (Text) (4)
      and then Text (Ends (Text) (1) + 1) = '.'
      and then Text (Ends (Text) (2) + 1) = '.'
      and then Text (Ends (Text) (3) + 1) = '.'
      and then Is_Octet (Text, 1, Ends (Text) (1))
      and then Is_Octet (Text, Ends (Text) (1) + 2, Ends (Text) (2))
      and then Is_Octet (Text, Ends (Text) (2) + 2, Ends (Text) (3))
      and then Is_Octet (Text, Ends (Text) (3) + 2, Ends (Text) (4)))
   with Pre => Text'First = 1 and then Text'Last <= Max_Text;

   function Address_Of (Text : String) return Address is
     (Joined
        (Byte (Number (Text, 1, Ends (Text) (1))),
         Byte (Number (Text, Ends (Text) (1) + 2, Ends (Text) (2))),
         Byte (Number (Text, Ends (Text) (2) + 2, Ends (Text) (3))),
         Byte (Number (Text, Ends (Text) (3) + 2, Ends (Text) (4)))))
   with Pre => Text'First = 1
     and then Text'Last <= Max_Text
     and then Begins_With_Address (Text);

   function Has_Length (Text : String) return Boolean is
     (Ends (Text) (4) < Text'Last and then Text (Ends (Text) (4) + 1) = '/')
   with Pre => Text'First = 1
     and then Text'Last <= Max_Text
     and then Begins_With_Address (Text);

   type Verdict is
     (Good,
      No_Address,   --  not ADDRESS, nor ADDRESS/ and something
      No_Length,    --  LEN is no number in 0 .. 32
      Not_Clean);   --  bits of ADDRESS beyond the first LEN are set

   procedure Parse (Text : String; N : out Network; V : out Verdict)
   with
     Pre  => Text'First = 1 and then Text'Last <= Max_Text,
     Post =>
       V = (if not Begins_With_Address (Text)
              or else (Ends (Text) (4) < Text'Last
                       and then not Has_Length (Text))
            then No_Address
            elsif Has_Length (Text)
              and then not Is_Length (Text, Ends (Text) (4) + 2, Text'Last)
            then No_Length
            elsif not Is_Network (N) then Not_Clean
            else Good)
       and then
         (if V in Good | Not_Clean then
             N.Start = Address_Of (Text)
             and then N.Length =
               (if Has_Length (Text)
                then Number (Text, Ends (Text) (4) + 2, Text'Last)
                else 32));
   --  The network that Text denotes.

end Admission.Networks;
