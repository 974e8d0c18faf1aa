--  SPDX-License-Identifier: GPL-3.0-or-later
--  A simulated cable to another machine: a pair of virtual interfaces and a
--  network namespace. It can be cut in every way.

private with Ada.Finalization;
with Interfaces.C;

package Network_Links is

   function Supervisor_Side return String;
   --  The supervisor's address. Addresses are per process: several may
   --  run at a time

   type Link is tagged limited private;
   --  Removed at the end of its scope

   procedure Make (Object : in out Link);
   --  Raises Failed, or Skipped where none can be made, with the reason

   type Cut_Kind is
     (Cable_Pulled,    --  at the monitor's end: no carrier at the supervisor's
      Monitor_Gone,    --  its machine does not answer
      Dropped_There,   --  no packet gets to the monitor
      Dropped_Here,    --  none gets from it
      Interface_Down,  --  of the supervisor's machine
      Address_Gone,    --  the same
      Route_Gone);     --  the same: none to the monitor, but from it

   procedure Cut (How : Cut_Kind := Cable_Pulled);

   procedure Remove_Left (Process : Interfaces.C.int);
   --  Removes the link of a killed process

   procedure Enter;
   --  The calling thread is at the monitor's end, until Leave
   procedure Leave;

private

   type Link is new Ada.Finalization.Limited_Controlled with record
      Made : Boolean := False;
   end record;

   overriding procedure Finalize (Object : in out Link);

end Network_Links;
