--  SPDX-License-Identifier: GPL-3.0-or-later
--  A simulated cable to another machine: a pair of virtual interfaces and a
--  network namespace. It can be pulled out.

private with Ada.Finalization;
with Interfaces.C;

package Network_Links is

   function Supervisor_Side return String;
   function Monitor_Side return String;
   --  Addresses are per process: several may run at a time

   function Obstacle return String;
   --  Why no link can be made here; "" if it can

   type Link is tagged limited private;
   --  Removed at the end of its scope

   procedure Make (Object : in out Link);
   --  Raises Failed, or Skipped if there is an Obstacle

   function Namespace (Object : Link) return String;

   procedure Cut (Object : in out Link);
   --  Pulls the cable at the monitor's end
   procedure Mend (Object : in out Link);

   procedure Remove (Object : in out Link);
   --  If it exists

   procedure Remove_Left (Process : Interfaces.C.int);
   --  Removes links left by killed processes

   procedure Fall_Silent (Object : in out Link);
   --  The cable is in, but the monitor's machine does not answer

   procedure Enter (Namespace : String);
   --  Applies to the calling thread, until Leave
   procedure Leave;

private

   type Link is new Ada.Finalization.Limited_Controlled with record
      Made : Boolean := False;
   end record;

   overriding procedure Finalize (Object : in out Link);

end Network_Links;
