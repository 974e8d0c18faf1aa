--  SPDX-License-Identifier: GPL-3.0-or-later
--  The session with the monitor: who is in command, how a session begins and
--  ends, and the events that pass between the tasks that see to it.

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with Schedule;
with Trace;

package body Session with SPARK_Mode is

   Server_Allowed  : Suspension_Object;
   Listening       : Suspension_Object;
   Receive_Begins  : Suspension_Object;
   Receive_Ended   : Suspension_Object;
   Watch_Begins    : Suspension_Object;

   protected State with Priority => Schedule.Session_Ceiling is
      procedure Begin_Active (Admitted : out Boolean);
      procedure Set (Stage : Stage_Kind);
      procedure Get (Stage : out Stage_Kind);
      procedure Stop;
      procedure Get_Stopping (Value : out Boolean);
   private
      Current  : Stage_Kind := Free;
      Stopping : Boolean    := False;
   end State;

   protected body State is

      procedure Begin_Active (Admitted : out Boolean) is
      begin
         Admitted := not Stopping;
         if Admitted then
            Current := Active;
         end if;
      end Begin_Active;

      procedure Set (Stage : Stage_Kind) is
      begin
         Current := Stage;
      end Set;

      procedure Get (Stage : out Stage_Kind) is
      begin
         Stage := Current;
      end Get;

      procedure Stop is
      begin
         Stopping := True;
      end Stop;

      procedure Get_Stopping (Value : out Boolean) is
      begin
         Value := Stopping;
      end Get_Stopping;

   end State;

   ---------------
   -- Get_Stage --
   ---------------

   procedure Get_Stage (Stage : out Stage_Kind) is
   begin
      State.Get (Stage);
   end Get_Stage;

   ------------------
   -- Begin_Active --
   ------------------

   procedure Begin_Active (Admitted : out Boolean) is
   begin
      State.Begin_Active (Admitted);
   end Begin_Active;

   ----------------
   -- Begin_Work --
   ----------------

   procedure Begin_Work is
   begin
      Set_True (Receive_Begins);
      Set_True (Watch_Begins);
   end Begin_Work;

   -------------------
   -- Begin_Closing --
   -------------------

   procedure Begin_Closing is
   begin
      State.Set (Closing);
   end Begin_Closing;

   -----------------
   -- End_Closing --
   -----------------

   procedure End_Closing is
   begin
      State.Set (Closed);
   end End_Closing;

   ----------------
   -- End_Closed --
   ----------------

   procedure End_Closed is
   begin
      State.Set (Free);
   end End_Closed;

   ------------------
   -- Request_Stop --
   ------------------

   procedure Request_Stop is
   begin
      State.Stop;
   end Request_Stop;

   ------------------
   -- Get_Stopping --
   ------------------

   procedure Get_Stopping (Stopping : out Boolean) is
   begin
      State.Get_Stopping (Stopping);
   end Get_Stopping;

   ------------------
   -- Allow_Server --
   ------------------

   procedure Allow_Server is
   begin
      Set_True (Server_Allowed);
   end Allow_Server;

   -----------------
   -- Wait_Server --
   -----------------

   procedure Wait_Server is
   begin
      Suspend_Until_True (Server_Allowed);
   end Wait_Server;

   --------------------
   -- Server_Listens --
   --------------------

   procedure Server_Listens is
   begin
      Set_True (Listening);
   end Server_Listens;

   --------------------
   -- Wait_Listening --
   --------------------

   procedure Wait_Listening is
   begin
      Suspend_Until_True (Listening);
   end Wait_Listening;

   ------------------
   -- Wait_Receive --
   ------------------

   procedure Wait_Receive is
   begin
      Suspend_Until_True (Receive_Begins);
   end Wait_Receive;

   -------------------
   -- Receiver_Left --
   -------------------

   procedure Receiver_Left is
   begin
      Set_True (Receive_Ended);
   end Receiver_Left;

   ------------------------
   -- Wait_Receiver_Left --
   ------------------------

   procedure Wait_Receiver_Left is
   begin
      Trace.Wait (Schedule.Th_Com_Mon_Perdue, Trace.Tasks);
      Suspend_Until_True (Receive_Ended);
      Trace.Resume (Schedule.Th_Com_Mon_Perdue);
   end Wait_Receiver_Left;

   ----------------
   -- Wait_Watch --
   ----------------

   procedure Wait_Watch is
   begin
      Suspend_Until_True (Watch_Begins);
   end Wait_Watch;

end Session;
