--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whether the camera is requested, and whether its owner has accepted that. A
--  camera that is slow to open may no longer be needed once it is open.

package Vision.Camera_Demands with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Vision.Camera_Demands);

   type Request_Number is mod 2 ** 32;

   type State is record
      Current : Request_Number := 0;
      Wanted  : Boolean := False;
      Pending : Boolean := False;
      --  requested, not yet accepted
      Held    : Boolean := False;
      --  the owner has accepted, and not closed the camera since
   end record;

   function Is_Idle (S : State) return Boolean is
     (not S.Held and then not S.Pending);
   --  The owner has no work with the camera, now or pending

   function Is_Wanted (S : State; Number : Request_Number) return Boolean is
     (S.Wanted and then Number = S.Current);
   --  The camera opened for Number is still requested

   procedure Ask (S : in out State)
   with Post => S = (S'Old.Current + 1, True, True, S'Old.Held);
   --  Earlier requests are withdrawn

   procedure Withdraw (S : in out State)
   with Post => S = (S'Old.Current, False, S'Old.Pending, S'Old.Held);

   procedure Take
     (S : in out State; Number : out Request_Number; Found : out Boolean)
   with
     Post => Found = S'Old.Pending
       and then Number = S.Current
       and then S = (S'Old.Current, S'Old.Wanted, False,
                     S'Old.Held or else Found);
   --  The owner accepts the request, even if withdrawn: the task that made it
   --  waits for the result

   procedure Release (S : in out State)
   with Post => S = (S'Old.Current, S'Old.Wanted, S'Old.Pending, False);

end Vision.Camera_Demands;
