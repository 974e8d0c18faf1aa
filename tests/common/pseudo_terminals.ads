--  SPDX-License-Identifier: GPL-3.0-or-later
--  A serial line in software: a pseudo-terminal, and the symbolic link that
--  gives it a name of its own.

with Interfaces.C; use Interfaces.C;

package Pseudo_Terminals is

   type Line is limited private;
   --  Closed by default

   procedure Open (L : in out Line; Done : out Boolean);
   --  A new device, raw, for every user of the machine. Any number of
   --  clients may open and close it. L must be closed.

   procedure Close (L : in out Line);
   --  Hangs up: who has the device open is told so, and it is gone

   function Is_Open (L : Line) return Boolean;

   function Device (L : Line) return String
     with Pre => Is_Open (L);
   --  Such as /dev/pts/3

   function Robot_End (L : Line) return int
     with Pre => Is_Open (L);
   --  Where the robot reads and writes, without ever waiting

   function Device_End (L : Line) return int
     with Pre => Is_Open (L);
   --  The device, as it is kept open here

   --  The link. Path is a link's own, Target what it points to.

   function Place_Link (Path, Target : String) return String;
   --  Makes it, or lets an existing link point to Target: "" when done.
   --  Anything else at Path stays, and the result says what is wrong.

   procedure Remove_Link (Path, Target : String);
   --  Removes it if it still points to Target

private

   Max_Name : constant := 64;
   Closed   : constant int := -1;

   type Line is limited record
      Master : int := Closed;
      Slave  : int := Closed;
      --  Held open by us: without any client the master would only read
      --  errors
      Name   : String (1 .. Max_Name) := (others => ' ');
      Length : Natural := 0;
   end record;

end Pseudo_Terminals;
