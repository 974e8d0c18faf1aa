--  SPDX-License-Identifier: GPL-3.0-or-later
--  Where the programs under test are: beside the running one, unless told;
--  and what is left of them when a run is given up.

with Interfaces.C;

package Programs is

   function Beside (Name : String) return String;
   --  The program with this name in the folder of the running one

   function Supervisor return String;
   function Emulator return String;
   function Monitor return String;

   function Vision_Library return String;
   --  What the supervisor loads when the camera is opened first, beside it

   function Read_Option return Boolean;
   --  The option that Option_Readers is at is --supervisor, --emulator or
   --  --monitor: its value is the path of that program from now on

   function Temporary_Folder return String;
   --  One for this run, made at its first use, open to every user

   function Copied_Supervisor return String;
   --  A copy in the temporary folder, with its library, that every user can
   --  run

   procedure Remove_Temporary_Folder;

   procedure Remove_Left (Process : Interfaces.C.int);
   --  The temporary folder of a process that was killed

   procedure Give_Up (Reason : String) with No_Return;
   --  Ends the run, exit status 1, whatever its tasks wait for: stops the
   --  programs and removes the temporary folder, then says why, where that
   --  can still be said

end Programs;
