--  SPDX-License-Identifier: GPL-3.0-or-later
--  A serial line in software: a pseudo-terminal and its link.

with GNAT.Sockets;

with Libc; use Libc;

package body Pseudo_Terminals is

   procedure Make_Raw (Terminal : int; Done : out Boolean) is
      --  8 bits, no echo, nothing translated, 9600 baud for who asks
      Value   : Terminal_Attributes := (others => 0);
   begin
      Done := Tcgetattr (Terminal, Value'Address) = 0;
      if Done then
         Cfmakeraw (Value'Address);
         Cfsetspeed (Value'Address, B9600);
         Done := Tcsetattr (Terminal, Tcsanow, Value'Address) = 0;
      end if;
   end Make_Raw;

   function Target_Of (Path : String) return String is
      --  Of the symbolic link at Path; "" where there is none
      Data   : char_array (1 .. 4_096) := (others => nul);
      Length : constant long :=
        Readlink (To_C (Path), Data'Address, Data'Length);
   begin
      if Length <= 0 then
         return "";
      end if;
      return To_Ada (Data (1 .. size_t (Length)), Trim_Nul => False);
   end Target_Of;

   procedure Close (File : in out int) is
      --  It is Closed afterwards
   begin
      if File /= Closed then
         Libc.Close (File);
         File := Closed;
      end if;
   end Close;

   procedure Close (L : in out Line) is
   begin
      Close (L.Slave);
      Close (L.Master);
      if L.Socket /= Closed then
         Close (L.Socket);
         Unlink (To_C (Device (L)));
      end if;
      L.Length := 0;
   end Close;

   procedure Free (L : Line) is
      Is_Exclusive : int := 0;
      Ignored      : int;
   begin
      if L.Slave /= Closed
        and then Ioctl (L.Slave, Tiocgexcl, Is_Exclusive'Address) = 0
        and then Is_Exclusive /= 0
        --  whoever has it for itself has locked it, too
        and then Flock (L.Slave, Lock_Ex + Lock_Nb) = 0
      then
         Ignored := Ioctl (L.Slave, Tiocnxcl, System.Null_Address);
         Ignored := Flock (L.Slave, Lock_Un);
      end if;
   end Free;

   function Device (L : Line) return String is (L.Name (1 .. L.Length));

   function Is_Open (L : Line) return Boolean is
     (L.Master /= Closed or else L.Socket /= Closed);

   Everyone : constant := 8#666#;
   --  A supervisor that runs as an ordinary user must be able to open what an
   --  emulator run by root offers

   procedure Set_Name (L : in out Line; Name : String) is
      Ignored : int;
   begin
      L.Length := Name'Length;
      L.Name (1 .. L.Length) := Name;
      Ignored := Chmod (To_C (Name), Everyone);
   end Set_Name;

   procedure Listen (L : in out Line; Path : String; Done : out Boolean) is
      use GNAT.Sockets;
      Socket  : Socket_Type;
      Request : Request_Type := (Non_Blocking_IO, True);
   begin
      Create_Socket (Socket, Family_Unix, Socket_Stream);
      L.Socket := int (To_C (Socket));
      Control_Socket (Socket, Request);
      Bind_Socket (Socket, Unix_Socket_Address (Path));
      Listen_Socket (Socket);
      Set_Name (L, Path);
      Done := True;
   exception
      when Socket_Error =>
         Close (L.Socket);
         Done := False;
   end Listen;

   procedure Read
     (L : in out Line; Data : System.Address; Length : in out long)
   is
      use GNAT.Sockets;
      Client  : Socket_Type;
      Unused  : Sock_Addr_Type;
      Request : Request_Type := (Non_Blocking_IO, True);
   begin
      if L.Master /= Closed then
         Length := Read (L.Master, Data, size_t (Length));
         if L.Socket /= Closed and then Length <= 0 then
            Close (L.Master);
         end if;
      else
         Length := 0;
         Accept_Socket (To_Ada (Integer (L.Socket)), Client, Unused);
         Control_Socket (Client, Request);
         L.Master := int (To_C (Client));
      end if;
   exception
      when Socket_Error =>
         null;  --  it has gone again
   end Read;

   procedure Open (L : in out Line; Done : out Boolean) is
      Name : char_array (1 .. Max_Name) := (others => nul);
   begin
      Done := False;
      L.Master := Posix_Openpt (O_Rdwr + O_Noctty + O_Nonblock + O_Cloexec);
      if L.Master /= Closed
        and then Grantpt (L.Master) = 0
        and then Unlockpt (L.Master) = 0
        and then Ptsname_R (L.Master, Name'Address, Name'Length) = 0
      then
         L.Slave := Open (Name, O_Rdwr + O_Noctty + O_Cloexec);
         if L.Slave /= Closed then
            Make_Raw (L.Slave, Done);
         end if;
      end if;

      if Done then
         Set_Name (L, To_Ada (Name));
      else
         Close (L);
      end if;
   end Open;

   function Place_Link (Path, Target : String) return String is
      Own     : constant String := Path & ".new";
   begin
      if Symlink (To_C (Target), To_C (Path)) = 0 then
         return "";
      end if;
      declare
         Reason : constant String := Last_Error;
      begin
         if Target_Of (Path) = "" then
            return Reason;
         end if;
      end;

      --  By renaming, so that there is a link at every moment

      if Target_Of (Own) /= "" then
         Unlink (To_C (Own));
      end if;
      if Symlink (To_C (Target), To_C (Own)) = 0
        and then Rename (To_C (Own), To_C (Path)) = 0
      then
         return "";
      end if;
      return Last_Error;
   end Place_Link;

   procedure Remove_Link (Path, Target : String) is
   begin
      if Target_Of (Path) = Target then
         Unlink (To_C (Path));
      end if;
   end Remove_Link;

   function Robot_End (L : Line) return int is
     (if L.Master /= Closed then L.Master else L.Socket);

   function Device_End (L : Line) return int is (L.Slave);

end Pseudo_Terminals;
