--  SPDX-License-Identifier: GPL-3.0-or-later
--  The robot's serial line: a pseudo-terminal and its link.

with Interfaces.C; use Interfaces.C;

package body Pseudo_Terminals is

   use Libc;

   function Target_Of (Path : String) return String;
   --  Of the symbolic link at Path; "" where there is none

   -----------
   -- Close --
   -----------

   procedure Close (L : in out Line) is
   begin
      Close (L.Slave);
      Close (L.Master);
      L.Length := 0;
   end Close;

   ------------
   -- Device --
   ------------

   function Device (L : Line) return String is (L.Name (1 .. L.Length));

   -------------
   -- Is_Open --
   -------------

   function Is_Open (L : Line) return Boolean is (L.Master /= No_Descriptor);

   ----------
   -- Open --
   ----------

   procedure Open (L : in out Line; Done : out Boolean) is
      Everyone : constant := 8#666#;

      Name    : char_array (1 .. Max_Name) := (others => nul);
      Ignored : int;
   begin
      Done := False;
      L.Master :=
        Open_Master (O_RDWR + O_NOCTTY + O_NONBLOCK + O_CLOEXEC);
      if L.Master /= No_Descriptor
        and then Grant (L.Master) = 0
        and then Unlock (L.Master) = 0
        and then Slave_Name (L.Master, Name'Address, Name'Length) = 0
      then
         L.Slave := Open (Name, O_RDWR + O_NOCTTY + O_CLOEXEC);
         if L.Slave /= No_Descriptor then
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

         Ignored := Change_Mode (Name, Everyone);
      else
         Close (L);
      end if;
   end Open;

   ----------------
   -- Place_Link --
   ----------------

   function Place_Link (Path, Target : String) return String is
      Own     : constant String := Path & ".new";
      Ignored : int;
   begin
      if Make_Link (To_C (Target), To_C (Path)) = 0 then
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
         Ignored := Remove (To_C (Own));
      end if;
      if Make_Link (To_C (Target), To_C (Own)) = 0
        and then Rename (To_C (Own), To_C (Path)) = 0
      then
         return "";
      end if;
      return Last_Error;
   end Place_Link;

   -----------------
   -- Remove_Link --
   -----------------

   procedure Remove_Link (Path, Target : String) is
      Ignored : int;
   begin
      if Target_Of (Path) = Target then
         Ignored := Remove (To_C (Path));
      end if;
   end Remove_Link;

   ---------------
   -- Robot_End --
   ---------------

   function Robot_End (L : Line) return Descriptor is (L.Master);

   ---------------
   -- Target_Of --
   ---------------

   function Target_Of (Path : String) return String is
      Data   : char_array (1 .. 4_096) := (others => nul);
      Length : constant Byte_Count :=
        Read_Link (To_C (Path), Data'Address, Data'Length);
   begin
      if Length <= 0 then
         return "";
      end if;
      return To_Ada (Data (1 .. size_t (Length)), Trim_Nul => False);
   end Target_Of;

end Pseudo_Terminals;
