--  SPDX-License-Identifier: GPL-3.0-or-later
--  A serial line in software: a pseudo-terminal, and a symbolic link to it.

with Interfaces.C; use Interfaces.C;

package Pseudo_Terminals is

   type Line is limited private;
   --  Closed by default

   procedure Open (L : in out Line; Done : out Boolean);
   --  A new device, raw, accessible to all users. Any number of clients may
   --  open and close it. L must be closed.

   procedure Close (L : in out Line);
   --  Hangs up: clients get a hang-up, and the device is removed

   function Is_Open (L : Line) return Boolean;

   function Device (L : Line) return String
     with Pre => Is_Open (L);
   --  Such as /dev/pts/3

   function Robot_End (L : Line) return int
     with Pre => Is_Open (L);
   --  The robot's end, for non-blocking reads and writes

   function Device_End (L : Line) return int
     with Pre => Is_Open (L);
   --  The device, which is also kept open here

   --  The link. Path is a link's own, Target what it points to.

   function Place_Link (Path, Target : String) return String;
   --  Makes it, or changes an existing link to Target: returns "". Anything
   --  else at Path is left, and the result names the error.

   procedure Remove_Link (Path, Target : String);
   --  Removes it if it still points to Target

private

   Max_Name : constant := 64;
   Closed   : constant int := -1;

   type Line is limited record
      Master : int := Closed;
      Slave  : int := Closed;
      --  Kept open: without any client, reads of the master fail
      Name   : String (1 .. Max_Name) := (others => ' ');
      Length : Natural := 0;
   end record;

end Pseudo_Terminals;
