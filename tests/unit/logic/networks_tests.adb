--  SPDX-License-Identifier: GPL-3.0-or-later
--  Networks of IPv4: their text, their addresses, and whom a list admits.

with Bytes;         use Bytes;
with Networks;      use Networks;
with Plain_Numbers; use Plain_Numbers;
with Unit_Runs; use Unit_Runs;

procedure Networks_Tests is

   use type Byte;

   use type Address;

   function Peer (A : Address) return Host is
     (Mapped & (Byte (A / 2 ** 24), Byte (A / 2 ** 16 mod 2 ** 8),
                Byte (A / 2 ** 8 mod 2 ** 8), Byte (A mod 2 ** 8)));

   function Read (Text : String) return Network is
      --  A good one
      N    : Network;
      Good : Boolean;
   begin
      Parse (Text, N, Good);
      Assert (Good, Text & " is no network");
      return N;
   end Read;

   procedure Test_Peers is
      --  With networks that they contain, and others
      Local : constant Host := Peer (16#7F00_0001#);
      L     : List;
      Near  : Host;

      procedure Allow (Networks : String) is
      begin
         L.Count := 0;
         for Text of Split (Networks) loop
            L.Count := L.Count + 1;
            L.Items (L.Count) := Read (Text);
         end loop;
      end Allow;

      procedure Check (Peers : String; Admitted : Boolean) is
      begin
         for Text of Split (Peers) loop
            Assert (Admits (L, Peer (Read (Text).Start)) = Admitted, Text);
         end loop;
      end Check;

   begin
      Assert (Admits (L, (1 .. 16 => 0)), "an empty list admits all");
      Allow ("0.0.0.0/0");
      Check ("0.0.0.0|255.255.255.255", True);
      Assert (not Admits (L, (1 .. 15 => 0, 16 => 1)), "::1");
      Assert (not Admits (L, (1 => 16#FE#, 2 => 16#80#, 3 .. 16 => 0)),
              "fe80::");
      for I in 1 .. 12 loop
         Near := Local;
         Near (I) := Near (I) xor 1;
         Assert (not Admits (L, Near), "not quite IPv4" & I'Image);
      end loop;
      Allow ("192.168.1.0/24|10.0.0.7|1.1.1.1|1.1.1.2|1.1.1.3|1.1.1.4|1.1.1.5"
             & "|127.0.0.2");
      Check ("192.168.1.0|192.168.1.255|10.0.0.7|127.0.0.2", True);
      Check ("192.168.2.0|192.168.0.255|10.0.0.6|127.0.0.1", False);
   end Test_Peers;

   procedure Test_Refused is
      --  That no bit is set beyond the length has been proved
      Long : String (1 .. 512) := (others => '1');

      procedure Refuse (Text : String) is
         N    : Network;
         Good : Boolean;
      begin
         Parse (Text, N, Good);
         Assert (not Good, Text & " is a network");
      end Refuse;

   begin
      for Text of Split
        ("|1|1.2.3|1.2.3.|.1.2.3|1..2.3|1.2.3.4.5|1.2.3.4.|1.2.3.4 "
         & "| 1.2.3.4|1.2.3.256|256.2.3.4|1.2.3.1000|1.2.3.04|01.2.3.4"
         & "|1.2.3.-4|1.2.3.4-8|1,2,3,4|::1|::1/128|::ffff:1.2.3.4"
         & "|localhost|/8|1.2.3.4/|1.2.3.4/33|1.2.3.4/032|1.2.3.4/1000"
         & "|1.2.3.4/-1|1.2.3.4/+8|1.2.3.4/8/8|1.2.3.4/255.255.255.0"
         & "|1.2.3.4/32 ")
      loop
         Refuse (Text);
      end loop;
      Refuse (Long);
      Long (1 .. 8) := "1.2.3.4/";
      Refuse (Long);
      Long := (1 .. 8 => '.', others => '0');
      Refuse (Long);
   end Test_Refused;

   procedure Test_Text is
   begin
      for Row of Split
        ("0.0.0.0/0=16#00000000#/0|0.0.0.0=16#00000000#/32"
         & "|1.2.3.4=16#01020304#/32|1.2.3.4/32=16#01020304#/32"
         & "|192.168.1.0/24=16#C0A80100#/24|10.0.0.0/8=16#0A000000#/8"
         & "|255.255.255.255=16#FFFFFFFF#/32|99.100.9.10/32=16#6364090A#/32"
         & "|255.255.255.255/32=16#FFFFFFFF#/32|128.0.0.0/1=16#80000000#/1"
         & "|10.128.0.0/9=16#0A800000#/9|192.168.1.4/30=16#C0A80104#/30")
      loop
         declare
            Part : constant Line_Vectors.Vector := Split (Row, '=');
            Like : constant Line_Vectors.Vector := Split (Part (2), '/');
         begin
            Assert (Read (Part (1)) =
                      (Address'Value (Like (1)), Natural'Value (Like (2))),
                    Row);
         end;
      end loop;
      for Length in 0 .. 32 loop
         Assert (Read ("0.0.0.0/" & Image (Length)) = (0, Length), "all");
      end loop;
   end Test_Text;

begin
   Run_Test ("the text of a network", Test_Text'Access);
   Run_Test ("what is no network", Test_Refused'Access);
   Run_Test ("lists, and peers of IPv4 and IPv6", Test_Peers'Access);
end Networks_Tests;
