--  SPDX-License-Identifier: GPL-3.0-or-later
--  Addresses of peers as the kernel gives them.

with AUnit.Assertions;           use AUnit.Assertions;

with Admission.Networks;
with Admission.Socket_Addresses; use Admission.Socket_Addresses;
with Bytes;                      use Bytes;
with Texts;

package body Socket_Addresses_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

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

   function Host (Value : String) return Host_Text;

   function Named (A : Socket_Address; Value : Host_Text) return String;

   procedure Test_Layout (T : in out Any_Test);
   procedure Test_Peer (T : in out Any_Test);
   procedure Test_Name (T : in out Any_Test);

   function Host (Value : String) return Host_Text is
      Result : Host_Text := (others => ASCII.NUL);
   begin
      Result (1 .. Value'Length) := Value;
      return Result;
   end Host;

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Admission.Socket_Addresses"));

   function Named (A : Socket_Address; Value : Host_Text) return String is
      Result : Texts.Text;
   begin
      Set_Name (Result, A, Value);
      return Texts.Image (Result);
   end Named;

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_Layout'Access, "as in C");
      Register_Routine (T, Test_Peer'Access, "the peer");
      Register_Routine (T, Test_Name'Access, "its name in the log");
   end Register_Tests;

   procedure Test_Layout (T : in out Any_Test) is
      pragma Unreferenced (T);
      A : Socket_Address;
      --  sizeof (struct sockaddr_in6), and offsets of its members
   begin
      Assert (Socket_Address'Size = 28 * 8, "size");
      Assert (A.Port'Position = 2, "port");
      Assert (A.Host_V4'Position = 4, "IPv4 address");
      Assert (A.Host_V6'Position = 8, "IPv6 address");
   end Test_Layout;

   procedure Test_Name (T : in out Any_Test) is
      pragma Unreferenced (T);
      Longest : constant Host_Text := (others => 'f');
   begin
      Assert
        (Named (Near, Host ("192.168.1.7")) = "192.168.1.7:5544", "IPv4");
      Assert
        (Named (Far, Host ("2001:db8::1")) = "[2001:db8::1]:65535", "IPv6");
      Assert (Named (Near, Host ("")) = ":5544", "no address");
      Assert (Named (Far, Longest) = "[" & Longest & "]:65535", "no end");
   end Test_Name;

   procedure Test_Peer (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      Assert
        (Peer_Of (Near) = (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255,
                           192, 168, 1, 7),
         "mapped");
      Assert (Peer_Of (Far) = Far.Host_V6, "IPv6 as it is");
      Assert (not Admission.Networks.Is_IPv4 (Peer_Of (Far)), "no IPv4");
      Assert (Port_Of (Near) = 5544, "port");
   end Test_Peer;

end Socket_Addresses_Tests;
