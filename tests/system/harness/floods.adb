--  SPDX-License-Identifier: GPL-3.0-or-later
--  Others who connect.

with Ada.Unchecked_Deallocation;
with GNAT.Sockets;   use GNAT.Sockets;
with Interfaces.C;   use Interfaces.C;

with Libc;

package body Floods is

   Connections : constant := 64;
   --  of each sender at a time

   procedure Free is new Ada.Unchecked_Deallocation (Sender, Sender_Access);

   --------------
   -- Progress --
   --------------

   protected body Progress is

      procedure Count_One is
      begin
         Counted := Counted + 1;
      end Count_One;

      procedure Finish is
      begin
         Over := True;
      end Finish;

      function Count return Natural is (Counted);

      function Is_Over return Boolean is (Over);

   end Progress;

   ------------
   -- Sender --
   ------------

   task body Sender is
      Own     : constant Sock_Addr_Type :=
        (Family_Inet, Inet_Addr ("127.0.1." & Character'Val (48 + Number)),
         0);
      Place   : constant Sock_Addr_Type :=
        (Family_Inet, Inet_Addr ("127.0.0.1"), Port_Type (Port));
      Sockets : array (1 .. Connections) of Socket_Type;
      Files   : array (1 .. Connections) of aliased Libc.Poll_Descriptor;
      Unused  : int;

      procedure Connect (Index : Positive);

      procedure Disconnect (Index : Positive);
      --  By a reset: nothing of it is left that could run short

      procedure Connect (Index : Positive) is
         At_Once : Request_Type := (Non_Blocking_IO, True);
      begin
         Create_Socket (Sockets (Index));
         Bind_Socket (Sockets (Index), Own);
         Control_Socket (Sockets (Index), At_Once);
         Files (Index) :=
           (int (To_C (Sockets (Index))), Libc.Poll_In, 0);
         Connect_Socket (Sockets (Index), Place);
      exception
         when Socket_Error =>
            --  under way
            null;
      end Connect;

      procedure Disconnect (Index : Positive) is
      begin
         Set_Socket_Option
           (Sockets (Index), Socket_Level, (Linger, True, 0));
         Close_Socket (Sockets (Index));
      end Disconnect;

   begin
      for Index in Sockets'Range loop
         Connect (Index);
      end loop;
      while not Seen.Is_Over loop
         Unused := Libc.Poll (Files (1)'Access, Files'Length, 100);
         for Index in Files'Range loop
            if Files (Index).Returned /= 0 then
               Seen.Count_One;
               Disconnect (Index);
               Connect (Index);
            end if;
         end loop;
      end loop;
      for Index in Sockets'Range loop
         Disconnect (Index);
      end loop;
   end Sender;

   -----------
   -- Start --
   -----------

   procedure Start (Object : in out Flood; Port : Positive) is
   begin
      for Number in Object.Tasks'Range loop
         Object.Tasks (Number) :=
           new Sender (Number, Port, Object.Seen'Unchecked_Access);
      end loop;
   end Start;

   ------------
   -- Served --
   ------------

   function Served (Object : Flood) return Natural is (Object.Seen.Count);

   ----------
   -- Stop --
   ----------

   procedure Stop (Object : in out Flood) is
   begin
      Object.Seen.Finish;
      for Item of Object.Tasks loop
         if Item /= null then
            while not Item'Terminated loop
               delay 0.01;
            end loop;
            Free (Item);
         end if;
      end loop;
   end Stop;

end Floods;
