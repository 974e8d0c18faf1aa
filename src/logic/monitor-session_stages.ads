--  SPDX-License-Identifier: GPL-3.0-or-later
--  The stages of the session with the monitor, in sequence. No session begins
--  when the supervisor is stopping.

package Monitor.Session_Stages with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Monitor.Session_Stages);

   type Stage_Kind is
     (Free,       --  no monitor: the next one is admitted
      Active,     --  a monitor is in command
      Closing);   --  it is lost: robot, camera and queues are reset

   type State is record
      Stage    : Stage_Kind := Free;
      Stopping : Boolean    := False;
   end record;

   function May_Begin (S : State) return Boolean is
     (S.Stage = Free and then not S.Stopping);

   function After (Stage : Stage_Kind) return Stage_Kind is
     (if Stage = Closing then Free else Stage_Kind'Succ (Stage));

   procedure Begin_Active (S : in out State; Admitted : out Boolean)
   with
     Post => Admitted = May_Begin (S'Old)
       and then S.Stopping = S'Old.Stopping
       and then S.Stage = (if Admitted then Active else S'Old.Stage);

   procedure Go_On (S : in out State; To : Stage_Kind)
   with
     Pre  => To /= Active,
     Post => S.Stopping = S'Old.Stopping
       and then S.Stage =
         (if After (S'Old.Stage) = To then To else S'Old.Stage);
   --  No effect if To is not the next stage

   procedure Stop (S : in out State)
   with Post => S.Stopping and then S.Stage = S'Old.Stage;
   --  Permanent

end Monitor.Session_Stages;
