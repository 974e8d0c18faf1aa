--  SPDX-License-Identifier: GPL-3.0-or-later
--  A cable between this machine and another one, that is, a pair of virtual
--  interfaces and a network namespace: it can be pulled out.

private with Ada.Finalization;
with Interfaces.C;

package Network_Links is

   function Supervisor_Side return String;
   function Monitor_Side return String;
   --  Addresses, this process's own: several may run at a time

   function Obstacle return String;
   --  Why no link can be made here; "" where one can

   type Link is tagged limited private;
   --  Removed when it leaves its scope

   procedure Make (Object : in out Link);
   --  Raises Failed, or Skipped where there is an Obstacle

   function Namespace (Object : Link) return String;

   procedure Cut (Object : in out Link);
   --  The cable is out at the monitor's end
   procedure Mend (Object : in out Link);

   procedure Remove (Object : in out Link);
   --  If it has been made

   procedure Remove_Left (Process : Interfaces.C.int);
   --  What a process that was killed has left

   procedure Fall_Silent (Object : in out Link);
   --  The cable is in, but the monitor's machine no longer answers

   procedure Enter (Namespace : String);
   --  For the calling thread, until Leave
   procedure Leave;

private

   type Link is new Ada.Finalization.Limited_Controlled with record
      Made : Boolean := False;
   end record;

   overriding procedure Finalize (Object : in out Link);

end Network_Links;
