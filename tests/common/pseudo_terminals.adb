--  SPDX-License-Identifier: GPL-3.0-or-later
--  A serial line in software: a pseudo-terminal and its link.

with Libc; use Libc;

package body Pseudo_Terminals is

   procedure Close (File : in out int);
   --  It is Closed afterwards

   procedure Make_Raw (Terminal : int; Done : out Boolean);
   --  8 bits, no echo, nothing translated, 9600 baud for who asks

   function Target_Of (Path : String) return String;
   --  Of the symbolic link at Path; "" where there is none

   procedure Close (File : in out int) is
      Ignored : int;
   begin
      if File /= Closed then
         Ignored := Libc.Close (File);
         File := Closed;
      end if;
   end Close;

   procedure Close (L : in out Line) is
   begin
      Close (L.Slave);
      Close (L.Master);
      L.Length := 0;
   end Close;

   function Device (L : Line) return String is (L.Name (1 .. L.Length));

   function Is_Open (L : Line) return Boolean is (L.Master /= Closed);

   procedure Open (L : in out Line; Done : out Boolean) is
      Everyone : constant := 8#666#;

      Name    : char_array (1 .. Max_Name) := (others => nul);
      Ignored : int;
   begin
      Done := False;
      L.Master :=
        Posix_Openpt (O_Rdwr + O_Noctty + O_Nonblock + O_Cloexec);
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
         declare
            Text : constant String := To_Ada (Name);
         begin
            L.Length := Text'Length;
            L.Name (1 .. L.Length) := Text;
         end;

         --  A supervisor that runs as an ordinary user must be able to open
         --  what an emulator run by root offers

         Ignored := Chmod (Name, Everyone);
      else
         Close (L);
      end if;
   end Open;

   procedure Make_Raw (Terminal : int; Done : out Boolean) is
      Value   : Terminal_Attributes := (others => 0);
      Ignored : int;
   begin
      Done := Tcgetattr (Terminal, Value'Address) = 0;
      if Done then
         Cfmakeraw (Value'Address);
         Ignored := Cfsetspeed (Value'Address, B9600);
         Done := Tcsetattr (Terminal, Tcsanow, Value'Address) = 0;
      end if;
   end Make_Raw;

   function Place_Link (Path, Target : String) return String is
      Own     : constant String := Path & ".new";
      Ignored : int;
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
         Ignored := Unlink (To_C (Own));
      end if;
      if Symlink (To_C (Target), To_C (Own)) = 0
        and then Rename (To_C (Own), To_C (Path)) = 0
      then
         return "";
      end if;
      return Last_Error;
   end Place_Link;

   procedure Remove_Link (Path, Target : String) is
      Ignored : int;
   begin
      if Target_Of (Path) = Target then
         Ignored := Unlink (To_C (Path));
      end if;
   end Remove_Link;

   function Robot_End (L : Line) return int is (L.Master);

   function Device_End (L : Line) return int is (L.Slave);

   function Target_Of (Path : String) return String is
      Data   : char_array (1 .. 4_096) := (others => nul);
      Length : constant long :=
        Readlink (To_C (Path), Data'Address, Data'Length);
   begin
      if Length <= 0 then
         return "";
      end if;
      return To_Ada (Data (1 .. size_t (Length)), Trim_Nul => False);
   end Target_Of;

end Pseudo_Terminals;
