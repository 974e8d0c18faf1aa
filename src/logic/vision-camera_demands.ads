--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whether the camera is wanted, and whether its owner has taken that up. A
--  camera that took long to open may no longer be wanted when it is there.

package Vision.Camera_Demands with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Vision.Camera_Demands);
   --  A claim that GNATprove checks: every subprogram ends

   type Request_Number is mod 2 ** 32;

   type State is record
      Current : Request_Number := 0;
      Wanted  : Boolean := False;
      Pending : Boolean := False;
      --  asked for, not yet taken up
      Held    : Boolean := False;
      --  the owner has taken it up, and not closed the camera yet
   end record;

   function Is_Idle (S : State) return Boolean is
     (not S.Held and then not S.Pending);
   --  The owner has nothing to do with the camera, nor will it

   function Is_Wanted (S : State; Number : Request_Number) return Boolean is
     (S.Wanted and then Number = S.Current);
   --  The camera that was opened for Number is wanted still

   procedure Ask (S : in out State)
   with Post => S = (S'Old.Current + 1, True, True, S'Old.Held);
   --  What was asked for before is no longer wanted

   procedure Withdraw (S : in out State)
   with Post => S = (S'Old.Current, False, S'Old.Pending, S'Old.Held);

   procedure Take
     (S : in out State; Number : out Request_Number; Found : out Boolean)
   with
     Post => Found = S'Old.Pending
       and then Number = S.Current
       and then S = (S'Old.Current, S'Old.Wanted, False,
                     S'Old.Held or else Found);
   --  The owner takes up what was asked for, wanted or not: whoever has asked
   --  waits for what comes of it

   procedure Release (S : in out State)
   with Post => S = (S'Old.Current, S'Old.Wanted, S'Old.Pending, False);

end Vision.Camera_Demands;
