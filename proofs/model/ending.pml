/* SPDX-License-Identifier: GPL-3.0-or-later
   The end of the process: an orderly stop, at any point of a session, or
   the failure of any task; and the log, which nobody waits for. */

#include "common.pml"

#define LINES  1         /* the log's buffer; a line more is not kept */

bool Left  = false;      /* the process has ended: nothing runs any more */
bool Moves = false;      /* a movement has gone out, and no stop since */
bool Fault = false;      /* a task has failed */
bool Orderly = false;    /* an orderly stop is under way */

mtype:signal = { None, Stop_Request, Failure };
mtype:signal Pending = None;

mtype:task = { Nobody, Of_Stop, Of_Main, Of_Move, Of_Lost, Other };
mtype:task Failed = Nobody;

/* Journal */
typedef Journal_Buffer_Type { byte Count; bool Writing };
PROTECTED (Journal_Buffer);
EVENT (Journal_Arrived);
bool Console_Stuck = false;       /* takes no more: a pipe nobody reads */

inline Put_Line () {
   /*: Journal.Buffer.Put */
   atomic {
      if
      :: Journal_Buffer.Count < LINES -> Journal_Buffer.Count++
      :: else
      fi
   };
#ifndef MUTANT_LOG_WITHOUT_EVENT
   Set_Event (Journal_Arrived)
#else
   skip
#endif
}

active proctype Th_Console () provided (!Left)
{
   /*: whole */
look:
   atomic {
      /*: Journal.Buffer.Take */
      if
      :: Journal_Buffer.Count > 0 ->
         Journal_Buffer.Count--;
         Journal_Buffer.Writing = true;
         goto write
      :: else -> Journal_Buffer.Writing = false
      fi
   };
   atomic { Wait_For_Work (Journal_Arrived); goto look };
write:
end_stuck:
   atomic { !Console_Stuck -> goto look }
}

EVENT (Monitor_Session_Server_Allowed);
EVENT (Support_Tasks_Stop_Failed);

/* Robot.Line, Monitor.Session, as far as the end needs them: the session's tasks
   are in session.pml, the robot's in orders.pml */
mtype:stage = { Free, Active, Closing };
mtype:stage Stage = Free;
bool Stopping  = false;
bool Line_Open = false;
bool Refused   = false;   /* Robot.Line: no order is carried out any more */

inline Refuse_Orders () {
   /*: Line.Grant.Begin_Session in orders */
   Refused = true
}

/* The fall-back handler of a task that ends; runs in that task */
typedef Failures_Handler_Type { bool Used };
PROTECTED (Failures_Handler);

inline Stop_Blindly () {
   /*: Robot.Serial_Line.Stop_Blindly */
   Moves = false
}

inline Ended (which) {
   atomic {
      /*: Handler.Ended */
      Failures_Handler.Used = true;
      Put_Line ();
      if
      :: which == Of_Stop ->
         Stop_Blindly ();
#ifndef MUTANT_FAILED_STOP_NOT_TOLD
         Set_Event (Support_Tasks_Stop_Failed)
#endif
      :: else ->
         /*: Report_Failure */
         Pending = Failure
      fi
   }
}

/* Any task may fail, once, at any time but during an orderly stop */
active proctype Any_Task () provided (!Left)
{
   mtype:task which;
   /*: once Failures.Handler.Ended */
   if
   :: which = Of_Stop
   :: which = Of_Main
   :: which = Of_Move
   :: which = Of_Lost
   :: which = Other
   :: goto none
   fi;
   atomic {
      if
      :: Orderly -> goto none
      :: else -> Failed = which; Fault = true
      fi;
      Ended (which)
   };
none:
   skip
}

/* A signal from outside, at any time, or never; a console that sticks */
active proctype User () provided (!Left)
{
   if
   :: atomic { Pending == None -> Pending = Stop_Request }
   :: skip
   fi;
   if
   :: Console_Stuck = true
   :: skip
   fi
}

active proctype Supervisor () provided (!Left && Failed != Of_Main)
{
   /*: whole */
   Set_Event (Monitor_Session_Server_Allowed);
   /*: Wait_Event (Listening) in session */
   Put_Line ();
   Put_Line ();
   Wait_For_Work (Support_Tasks_Stop_Failed);
   Refuse_Orders ();
   /* its last lines are written meanwhile */
   /*: delay */
   atomic {
      Stop_Blindly ();
      /*: Process.Leave */
      Left = true
   }
}

/* Admits a monitor, not while the supervisor stops */
active proctype Th_Server () provided (!Left)
{
   byte again = 2;
   Wait_Event (Monitor_Session_Server_Allowed);
end_wait:
   do
#ifndef MUTANT_ADMITTED_WHILE_STOPPING
   :: /*: Session.State.Begin_Active */
      atomic { again > 0 && Stage == Free && !Stopping ->
               again--; Stage = Active }
#else
   :: atomic { again > 0 && Stage == Free && !Stopping -> again-- };
      Stage = Active
#endif
   od
}

/* Th_Move: while a monitor is in command, its movements go out */
active proctype Th_Move () provided (!Left && Failed != Of_Move)
{
end_wait:
   do
   :: atomic { Stage == Active && !Refused && !Moves ->
               Line_Open = true; Moves = true }
   :: atomic { Stage == Closing && Line_Open ->
               Moves = false; Line_Open = false }
   od
}

active proctype Th_Com_Mon_Perdue () provided (!Left && Failed != Of_Lost)
{
end_wait:
   do
   :: atomic { Stage == Active -> Stage = Closing };
      Put_Line ();
      !Line_Open;
      Stage = Free
   od
}

#define Session_Over  (Stage == Free && !Line_Open)

active proctype Th_Stop () provided (!Left && Failed != Of_Stop)
{
   mtype:signal kind = None;
   /*: whole */
end_wait:
   /*: Process.Signals.Wait */
   atomic { Pending != None -> kind = Pending; Pending = None;
            Orderly = (kind == Stop_Request && !Fault) };
   if
   :: kind == Failure ->
#ifndef MUTANT_WAITING_ORDERS_CARRIED_OUT
      Refuse_Orders ();
#endif
      Stop_Blindly ()
   :: else
   fi;
   Put_Line ();
   /*: Session.State.Stop */
   Stopping = true;
   /*: Connection.Shut_Down in session */
   /* Wait_Session_End: as long as it takes, or, where a task has failed or
      the line hangs, until the limit */
   /*: Session.State.Get, Line.Grant.Get_Status, Vision.State.Store.Get_Idle */
   if
   :: Session_Over
   :: Fault
   :: /*: delay, Session.State.Get, Line.Grant.Get_Status,
          Vision.State.Store.Get_Idle + */
      (Session_Over || Fault)
   fi;
   /*: Line.Grant.Get_Status */
   if
   :: Line_Open -> Stop_Blindly ()
   :: else
   fi;
   Put_Line ();
   /* Wait_Console */
   /*: Journal.Get_Waiting */
   if
   :: Journal_Buffer.Count == 0 && !Journal_Buffer.Writing
   :: Console_Stuck
   :: Fault
   :: /*: delay, Journal.Get_Waiting + */
      (Journal_Buffer.Count == 0 && !Journal_Buffer.Writing
       || Console_Stuck || Fault)
   fi;
   /*: Process.Leave */
   atomic { assert (!Moves); Left = true }
}

ltl ends_when_told
   { [] ((Pending != None || Fault) -> <> Left) }
ltl log_is_written
   { [] (Journal_Buffer.Count > 0 -> <> (Journal_Buffer.Count == 0 || Console_Stuck || Left)) }
