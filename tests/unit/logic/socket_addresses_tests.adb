--  SPDX-License-Identifier: GPL-3.0-or-later
--  Addresses of peers as the kernel gives them.

with AUnit.Assertions;           use AUnit.Assertions;

with Admission.Networks;
with Admission.Socket_Addresses; use Admission.Socket_Addresses;
with Bytes;                      use Bytes;
with Texts;
with Unit_Runs; use Unit_Runs;

package body Socket_Addresses_Tests is

   Near : constant Socket_Address :=
     (Family  => 2,
      Port    => (21, 168),
      Host_V4 => (192, 168, 1, 7),
      others  => <>);

   Far : constant Socket_Address :=
     (Family  => 10,
      Port    => (255, 255),
      Host_V6 => (1 => 16#20#, 2 => 1, 3 => 13, 4 => 16#B8#, 16 => 1,
                  others => 0),
      others  => <>);

   function Host (Value : String) return Host_Text is
      Result : Host_Text := (others => ASCII.NUL);
   begin
      Result (1 .. Value'Length) := Value;
      return Result;
   end Host;

   function Named (A : Socket_Address; Value : Host_Text) return String is
      Result : Texts.Text;
   begin
      Set_Name (Result, A, Value);
      return Texts.Image (Result);
   end Named;

   procedure Test_Layout is
      A : Socket_Address;
      --  sizeof (struct sockaddr_in6), and offsets of its members
   begin
      Assert (Socket_Address'Size = 28 * 8, "size");
      Assert (A.Port'Position = 2, "port");
      Assert (A.Host_V4'Position = 4, "IPv4 address");
      Assert (A.Host_V6'Position = 8, "IPv6 address");
   end Test_Layout;

   procedure Test_Name is
      Longest : constant Host_Text := (others => 'f');
   begin
      Assert
        (Named (Near, Host ("192.168.1.7")) = "192.168.1.7:5544", "IPv4");
      Assert
        (Named (Far, Host ("2001:db8::1")) = "[2001:db8::1]:65535", "IPv6");
      Assert (Named (Near, Host ("")) = ":5544", "no address");
      Assert (Named (Far, Longest) = "[" & Longest & "]:65535", "no end");
   end Test_Name;

   procedure Test_Peer is
   begin
      Assert
        (Peer_Of (Near) = (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255,
                           192, 168, 1, 7),
         "mapped");
      Assert (Peer_Of (Far) = Far.Host_V6, "IPv6 as it is");
      Assert (not Admission.Networks.Is_IPv4 (Peer_Of (Far)), "no IPv4");
      Assert (Port_Of (Near) = 5544, "port");
   end Test_Peer;

   procedure Add_Tests is
   begin
      Add_Test ("as in C", Test_Layout'Access);
      Add_Test ("the peer", Test_Peer'Access);
      Add_Test ("its name in the log", Test_Name'Access);
   end Add_Tests;

end Socket_Addresses_Tests;
