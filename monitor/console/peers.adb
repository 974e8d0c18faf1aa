--  SPDX-License-Identifier: GPL-3.0-or-later
--  Who may be told the token.

with Ada.Directories;
with Ada.Streams;           use Ada.Streams;
with Ada.Strings.Fixed;     use Ada.Strings.Fixed;
with Ada.Strings.Maps;      use Ada.Strings.Maps;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.Sockets;          use GNAT.Sockets;
with Interfaces;

package body Peers is

   Looks : constant := 250;
   Pause : constant Duration := 0.02;
   --  After each look

   Local  : constant := 2;
   Remote : constant := 3;
   State  : constant := 4;
   Owner  : constant := 8;
   Inode  : constant := 10;
   --  Fields of a line of /proc/net/tcp

   Closed : constant String := "06";
   --  A state

   function Own_User return Interfaces.Unsigned_32
     with Import, Convention => C, External_Name => "geteuid";

   function Is_Trusted (User : String) return Boolean is
     (User = "0" or else User = Trim (Own_User'Image, Ada.Strings.Left)
      or else Long_Long_Integer'Value (User) in 61_184 .. 65_519);
   --  Root, ourselves, and those that systemd makes for a service while it
   --  runs (DynamicUser=)

   function Is_Here (Made : Socket_Type) return Boolean is
      --  On this machine
      Its : constant Inet_Addr_Type := Get_Peer_Name (Made).Addr;
   begin
      return Its = Get_Socket_Name (Made).Addr
        or else Its = Loopback_Inet6_Addr
        or else (Its.Family = Family_Inet and then Its.Sin_V4 (1) = 127);
   end Is_Here;

   function Ending (Port : Port_Type) return String is
      --  Of an address in the table
      Figures : constant String := "0123456789ABCDEF";
      Text    : String  := ":....";
      Rest    : Natural := Natural (Port);
   begin
      for Place in reverse 2 .. Text'Last loop
         Text (Place) := Figures (Rest mod 16 + 1);
         Rest := Rest / 16;
      end loop;
      return Text;
   end Ending;

   function Field (Line : String; Number : Positive) return String is
      First : Positive;
      Last  : Natural := 0;
   begin
      for Each in 1 .. Number loop
         Find_Token
           (Line, To_Set (' '), Last + 1, Ada.Strings.Outside, First, Last);
      end loop;
      return Line (First .. Last);
   end Field;

   function User (Made : Socket_Type) return String is
      --  Of its program. If several connections have these two ports, one
      --  that is not trusted; empty: one has not been accepted, and is
      --  nobody's yet
      Here  : constant String := Ending (Get_Socket_Name (Made).Port);
      There : constant String := Ending (Get_Peer_Name (Made).Port);

      Whose   : Unbounded_String;
      Waiting : Boolean := False;

      procedure Look (Table : String) is
         File : File_Type;
      begin
         Open (File, In_File, Table);
         while not End_Of_File (File) loop
            declare
               Line : constant String := Get_Line (File);
            begin
               if Tail (Field (Line, Local), 5) = There
                 and then Tail (Field (Line, Remote), 5) = Here
                 and then Field (Line, State) /= Closed
               then
                  Waiting := Waiting or else Field (Line, Inode) = "0";
                  if Whose = "" or else Is_Trusted (To_String (Whose)) then
                     Whose := To_Unbounded_String (Field (Line, Owner));
                  end if;
               end if;
            end;
         end loop;
         Close (File);
      end Look;

   begin
      Look ("/proc/self/net/tcp");
      if Ada.Directories.Exists ("/proc/self/net/tcp6") then
         Look ("/proc/self/net/tcp6");
      end if;
      return (if Waiting then "" else To_String (Whose));
   end User;

   function Said (Made : Socket_Type) return String is
      --  What has come from it
      Size : Request_Type (N_Bytes_To_Read);
      Data : Stream_Element_Array (1 .. 100);
      Last : Stream_Element_Offset := 0;
      Text : Unbounded_String;
   begin
      Control_Socket (Made, Size);
      if Size.Size > 0 then
         Receive_Socket (Made, Data, Last);
      end if;
      for Octet of Data (1 .. Last) loop
         exit when Octet = Character'Pos (ASCII.LF);
         Append (Text, Character'Val (Octet));
      end loop;
      return To_String (Text);
   end Said;

   function Objection (Made : Socket_Type) return String is
   begin
      if not Is_Here (Made) then
         return "";
      end if;

      for Each in 1 .. Looks loop
         declare
            Whose   : constant String := User (Made);
            Refusal : constant String :=
              (if Whose = "" then Said (Made) else "");
         begin
            if Refusal /= "" then
               return Refusal;
            elsif Whose /= "" then
               return (if Is_Trusted (Whose) then ""
                       else "a program of user " & Whose
                         & " listens there; it is not told the token");
            end if;
         end;
         delay Pause;
      end loop;
      return "it does not accept the connection";
   end Objection;

end Peers;
