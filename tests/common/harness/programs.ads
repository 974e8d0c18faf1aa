--  SPDX-License-Identifier: GPL-3.0-or-later
--  Paths of the programs under test: by default the folder of the running
--  program; and the clean-up after an aborted run.

with Ada.Exceptions;
with Interfaces.C;

package Programs is

   function Beside (Name : String) return String;
   --  The program with this name in the folder of the running one

   function Supervisor return String;
   function Emulator return String;
   function Monitor return String;

   function Vision_Library return String;
   --  The library that the supervisor loads when it first opens the camera

   function With_Sockets return Boolean;
   --  Whether emulators have a socket for a line. Not after --terminals, for
   --  supervisors of another processor

   function Preload (Library : String := "") return String;
   --  Runs a program, which follows, with libsocket_line.so if With_Sockets,
   --  and with this library from beside the running program

   function Read_Option return Boolean;
   --  If the current option of Option_Readers is --supervisor, --emulator or
   --  --monitor: its value becomes the path of that program; --terminals

   procedure Read_Option (Usage : String);
   --  The same, or --help: prints Usage and ends the program. Raises Bad_Usage
   --  for any other

   function Temporary_Folder return String;
   --  A folder for this run, made at first use, accessible to all users

   function New_File
     (Name, Text : String; Mode : Interfaces.C.unsigned := 8#644#)
      return String;
   --  Writes Text to this file of the temporary folder, made anew: its path

   function Copied (Path : String) return String;
   --  A copy in the temporary folder, where every user can run or load it, and
   --  whose path has no blank

   function Copied_Supervisor return String;
   --  A copy in the temporary folder, with its library, that every user can
   --  run

   As_User : constant String :=
     "setpriv --reuid=65534 --regid=65534 --clear-groups --inh-caps=-all";
   --  Runs what follows as an ordinary user

   function As_Service (Capabilities : String := "+sys_nice") return String
   is ("setpriv --reuid=65534 --regid=65534 --clear-groups"
       & " --inh-caps=-all," & Capabilities
       & " --ambient-caps=" & Capabilities
       & " --bounding-set=-all," & Capabilities);
   --  Runs a program, which follows, as an ordinary user with capabilities:
   --  by default with that of the unit. For root, if there is setpriv

   procedure Remove_Temporary_Folder;

   procedure Remove_Left (Process : Interfaces.C.int);
   --  Removes the temporary folder of a killed process

   procedure Give_Up (Reason : String; Status : Integer := 1) with No_Return;
   --  Ends the run with this status, even if its tasks are blocked: stops the
   --  programs, removes the temporary folder, then prints the reason, if
   --  possible

   procedure Give_Up (Problem : Ada.Exceptions.Exception_Occurrence)
     with No_Return;
   --  The same, exit status 2 for Bad_Usage, else 1

end Programs;
