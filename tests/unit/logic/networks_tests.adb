--  SPDX-License-Identifier: GPL-3.0-or-later
--  Networks of IPv4: their text, their addresses, and whom a list admits.

with Bytes;         use Bytes;
with Networks;      use Networks;
with Plain_Numbers; use Plain_Numbers;
with Unit_Runs; use Unit_Runs;

procedure Networks_Tests is

   use type Byte;

   function Peer (A, B, C, D : Byte) return Host is (Mapped & (A, B, C, D));

   procedure Expect (Text : String; Good : Boolean) is
      N    : Network;
      Read : Boolean;
   begin
      Parse (Text, N, Read);
      Assert (Read = Good, Text & " is a network: " & Read'Image);
   end Expect;

   function Read (Text : String) return Network is
      --  A good one
      N    : Network;
      Good : Boolean;
   begin
      Parse (Text, N, Good);
      Assert (Good, Text & " is no network");
      return N;
   end Read;

   procedure Test_Clean is
   begin
      for Length in 0 .. 31 loop
         Expect ("0.0.0.0/" & Image (Length), True);
         Expect ("0.0.0.1/" & Image (Length), False);
         Expect ("255.255.255.255/" & Image (Length), False);
      end loop;
      Expect ("255.255.255.255/32", True);
      Expect ("128.0.0.0/1", True);
      Expect ("128.0.0.0/0", False);
      Expect ("10.128.0.0/9", True);
      Expect ("10.128.0.0/8", False);
      Expect ("192.168.1.4/30", True);
      Expect ("192.168.1.4/29", False);
   end Test_Clean;

   procedure Test_Peers is
      --  With networks that they contain, and others
      Local : constant Host := Peer (127, 0, 0, 1);
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

   begin
      Assert (Admits (L, (1 .. 16 => 0)), "an empty list admits all");
      Allow ("0.0.0.0/0");
      Assert (Admits (L, Peer (0, 0, 0, 0)), "all of IPv4");
      Assert (Admits (L, Peer (255, 255, 255, 255)), "all of IPv4, its last");
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
      Assert (Admits (L, Peer (192, 168, 1, 0)), "first");
      Assert (Admits (L, Peer (192, 168, 1, 255)), "last");
      Assert (not Admits (L, Peer (192, 168, 2, 0)), "next");
      Assert (not Admits (L, Peer (192, 168, 0, 255)), "before");
      Assert (Admits (L, Peer (10, 0, 0, 7)), "second network");
      Assert (not Admits (L, Peer (10, 0, 0, 6)), "not below");
      Assert (Admits (L, Peer (127, 0, 0, 2)), "eighth network");
      Assert (not Admits (L, Local), "beside it");
   end Test_Peers;

   procedure Test_Refused is
      Long : String (1 .. 512) := (others => '1');
   begin
      for Text of Split
        ("|1|1.2.3|1.2.3.|.1.2.3|1..2.3|1.2.3.4.5|1.2.3.4.|1.2.3.4 "
         & "| 1.2.3.4|1.2.3.256|256.2.3.4|1.2.3.1000|1.2.3.04|01.2.3.4"
         & "|1.2.3.-4|1.2.3.4-8|1,2,3,4|::1|::1/128|::ffff:1.2.3.4"
         & "|localhost|/8|1.2.3.4/|1.2.3.4/33|1.2.3.4/032|1.2.3.4/1000"
         & "|1.2.3.4/-1|1.2.3.4/+8|1.2.3.4/8/8|1.2.3.4/255.255.255.0"
         & "|1.2.3.4/32 ")
      loop
         Expect (Text, False);
      end loop;
      Expect (Long, False);
      Long (1 .. 8) := "1.2.3.4/";
      Expect (Long, False);
      Long := (1 .. 8 => '.', others => '0');
      Expect (Long, False);
   end Test_Refused;

   procedure Test_Text is
   begin
      Assert (Read ("0.0.0.0/0") = (0, 0), "all");
      Assert (Read ("0.0.0.0") = (0, 32), "without a length it is 32");
      Assert (Read ("1.2.3.4") = (16#0102_0304#, 32), "one");
      Assert (Read ("1.2.3.4/32") = (16#0102_0304#, 32), "one, said so");
      Assert (Read ("192.168.1.0/24") = (16#C0A8_0100#, 24), "24");
      Assert (Read ("10.0.0.0/8") = (16#0A00_0000#, 8), "8");
      Assert
        (Read ("255.255.255.255") = (16#FFFF_FFFF#, 32), "the last address");
      Assert (Read ("99.100.9.10/32") = (16#6364_090A#, 32), "all widths");
   end Test_Text;

begin
   Run_Test ("the text of a network", Test_Text'Access);
   Run_Test ("what is no network", Test_Refused'Access);
   Run_Test ("bits beyond the length", Test_Clean'Access);
   Run_Test ("lists, and peers of IPv4 and IPv6", Test_Peers'Access);
end Networks_Tests;
