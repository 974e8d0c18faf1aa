--  SPDX-License-Identifier: GPL-3.0-or-later
--  A serial line in software: a pseudo-terminal and a symbolic link to it, or
--  a socket. The kernel carries the bytes of a pseudo-terminal in a thread of
--  ordinary priority (on a loaded machine p99.9 53 ms), those of a socket at
--  once; who opens the socket as a device needs libsocket_line.so.

with Interfaces.C; use Interfaces.C;
with System;

package Pseudo_Terminals is

   type Line is limited private;
   --  Closed by default

   procedure Open (L : in out Line; Done : out Boolean);
   --  A new device, raw, accessible to all users. Any number of clients may
   --  open and close it. L must be closed.

   procedure Listen (L : in out Line; Path : String; Done : out Boolean);
   --  A socket at Path, for one client at a time. L must be closed.

   procedure Close (L : in out Line);
   --  Hangs up: clients get a hang-up, and the device is removed

   procedure Free (L : Line);
   --  The kernel lets nobody else open a terminal that a client had for itself
   --  (TIOCEXCL), also when that has been killed; a real serial port is free
   --  then, and so is this one now

   function Is_Open (L : Line) return Boolean;

   function Device (L : Line) return String with Pre => Is_Open (L);
   --  Such as /dev/pts/3, or the socket's path

   function Robot_End (L : Line) return int with Pre => Is_Open (L);
   --  The robot's end, for non-blocking writes, and to be polled for input

   procedure Read
     (L : in out Line; Data : System.Address; Length : in out long)
     with Pre => Is_Open (L);
   --  What there is for the robot, Length bytes at most; here a client of the
   --  socket comes or goes

   function Device_End (L : Line) return int with Pre => Is_Open (L);
   --  The device, which is also kept open here

   --  The link. Path is a link's own, Target what it points to.

   function Place_Link (Path, Target : String) return String;
   --  Makes it, or changes an existing link to Target: returns "". Anything
   --  else at Path is left, and the result names the error.

   procedure Remove_Link (Path, Target : String);
   --  Removes it if it still points to Target

private

   Max_Name : constant := 108;
   Closed   : constant int := -1;

   type Line is limited record
      Master : int := Closed;
      Slave  : int := Closed;
      --  Kept open: without any client, reads of the master fail
      Socket : int := Closed;
      --  Where clients connect, instead of a slave; the master is a client's
      Name   : String (1 .. Max_Name) := (others => ' ');
      Length : Natural := 0;
   end record;

end Pseudo_Terminals;
