--  SPDX-License-Identifier: GPL-3.0-or-later
--  The object only locks; Monitor.Session_Stages decides.

with Event;
with Schedule;
with Trace;

package body Monitor.Session with SPARK_Mode is

   use type Monitor.Session_Stages.Stage_Kind;

   package Server_Allowed is new Event;
   package Listening is new Event;
   package Receive_Begins is new Event;
   package Receive_Ended is new Event;
   package Watch_Begins is new Event;

   protected State with Priority => Schedule.Session_Ceiling is
      procedure Begin_Active (Admitted : out Boolean);
      procedure Go_On (To : Monitor.Session_Stages.Stage_Kind)
      with Pre => To /= Monitor.Session_Stages.Active;
      procedure Stop;
      procedure Get (Value : out Monitor.Session_Stages.State);
   private
      Current : Monitor.Session_Stages.State;
   end State;

   protected body State is

      procedure Begin_Active (Admitted : out Boolean) is
      begin
         Monitor.Session_Stages.Begin_Active (Current, Admitted);
      end Begin_Active;

      procedure Go_On (To : Monitor.Session_Stages.Stage_Kind) is
      begin
         Monitor.Session_Stages.Go_On (Current, To);
      end Go_On;

      procedure Stop is
      begin
         Monitor.Session_Stages.Stop (Current);
      end Stop;

      procedure Get (Value : out Monitor.Session_Stages.State) is
      begin
         Value := Current;
      end Get;

   end State;

   procedure Get (Current : out Monitor.Session_Stages.State) is
   begin
      State.Get (Current);
   end Get;

   procedure Begin_Active (Admitted : out Boolean) is
   begin
      State.Begin_Active (Admitted);
   end Begin_Active;

   procedure Begin_Work is
   begin
      Receive_Begins.Set;
      Watch_Begins.Set;
   end Begin_Work;

   procedure Begin_Closing is
   begin
      State.Go_On (Monitor.Session_Stages.Closing);
   end Begin_Closing;

   procedure End_Closing is
   begin
      State.Go_On (Monitor.Session_Stages.Closed);
   end End_Closing;

   procedure End_Closed is
   begin
      State.Go_On (Monitor.Session_Stages.Free);
   end End_Closed;

   procedure Request_Stop is
   begin
      State.Stop;
   end Request_Stop;

   procedure Allow_Server is
   begin
      Server_Allowed.Set;
   end Allow_Server;

   procedure Wait_Server is
   begin
      Server_Allowed.Wait;
   end Wait_Server;

   procedure Server_Listens is
   begin
      Listening.Set;
   end Server_Listens;

   procedure Wait_Listening is
   begin
      Listening.Wait;
   end Wait_Listening;

   procedure Wait_Receive is
   begin
      Receive_Begins.Wait;
   end Wait_Receive;

   procedure Receiver_Left is
   begin
      Receive_Ended.Set;
   end Receiver_Left;

   procedure Wait_Receiver_Left is
   begin
      Trace.Wait (Schedule.Th_Com_Mon_Perdue, Trace.Tasks);
      Receive_Ended.Wait;
      Trace.Resume (Schedule.Th_Com_Mon_Perdue);
   end Wait_Receiver_Left;

   procedure Wait_Watch is
   begin
      Watch_Begins.Wait;
   end Wait_Watch;

end Monitor.Session;
