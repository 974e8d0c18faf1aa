/* SPDX-License-Identifier: GPL-3.0-or-later
   The session with the monitor: admission, the loss of the monitor, the way
   back to the initial state, and who may use the connection meanwhile. What
   is received and sent is in outbox.pml. */

#include "common.pml"

#ifndef MONITORS
#define MONITORS  2   /* that come, at any time, also at the same time */
#endif

/* The network: one connection for each monitor, 0 is none */

mtype:peer      = { Away, Present, Gone, Silent };
mtype:admission = { Not_Met, Admitted, Rejected };

mtype:peer      Peer [MONITORS + 1] = Away;
mtype:admission Met  [MONITORS + 1] = Not_Met;
bool Shut [MONITORS + 1] = false;      /* by the supervisor */
byte Current = 0;                      /* the monitor's in command */
bool Waker   = false;                  /* Wake_Server */
chan Backlog  = [MONITORS] of { byte };
chan Entitled = [MONITORS] of { byte }; /* Admission: to be admitted, or told why not */
byte Waits    = 0;                     /* so many */

bool In_Receive = false;
bool In_Send    = false;
bool In_Watch   = false;

#define Over(c)  (Shut [c] || Peer [c] == Gone)

inline Shut_Down (own) {
   /*: Connection.Shut_Down */
   /* frees Receive, Send and Watch; must not hit the next monitor */
   atomic { assert (Current == own); Shut [Current] = true }
}

mtype:stage = { Free, Active, Closing };
typedef Monitor_Session_State_Type { mtype:stage Current = Free };
PROTECTED (Monitor_Session_State);
EVENT (Monitor_Session_Server_Allowed);
EVENT (Monitor_Session_Listening);
EVENT (Monitor_Session_Receive_Begins);
EVENT (Monitor_Session_Receive_Ended);
EVENT (Monitor_Session_Watch_Begins);
#define Stage  Monitor_Session_State.Current

bool Monitor_Outbox_Open = false;    /* of Monitor.Outbox.Box: see outbox.pml */
bool Monitor_Outbox_Busy = false;
EVENT (Monitor_Outbox_Sender_Left);

active proctype Supervisor ()
{
   /* see ending.pml */
   Set_Event (Monitor_Session_Server_Allowed);
   Wait_Event (Monitor_Session_Listening)
}

active proctype Th_Server ()
{
   byte peer;
   mtype:stage known = Free;
   /*: whole */
   Wait_Event (Monitor_Session_Server_Allowed);
   Set_Event (Monitor_Session_Listening);
   do
   ::
   /*: delay */
   known = Free;
end_wait:
   /*: Monitor.Sockets.Poll */
   if
   :: atomic { Waker -> Waker = false }
   :: atomic {
         !Waker && len (Backlog) > 0 -> Backlog ? peer;
         /* whose address or token is not right, or does not come in time,
            is turned away; meanwhile it holds up nobody */
         if
         :: Entitled ! peer; Waits++
         :: Met [peer] = Rejected
         fi;
         peer = 0
      }
   fi;
   /* Settle: of one after the other */
   do
   :: atomic { Waits == 0 -> break }
   :: Waits > 0 ->
      /*: Session.State.Get */
#ifndef MUTANT_NEWCOMER_FORGOTTEN
      known = Stage;
#endif
      if
      :: atomic { known == Active ->
                  Entitled ? peer; Waits--; Met [peer] = Rejected; peer = 0;
                  goto next }
      :: known == Closing -> break
      :: known == Free
      fi;
      /*: Session.State.Begin_Active */
      atomic {
         Entitled ? peer;
         Waits--;
         if
         :: Stage = Active
         :: Met [peer] = Rejected;      /* it is stopping: see ending.pml */
            peer = 0;
            goto next
         fi
      };
      /*: Connection.Take_Over */
      atomic { assert (Current == 0); Current = peer };
      /*: Box.Open_Session */
      Monitor_Outbox_Open = true;
      Met [peer] = Admitted;
      Set_Event (Monitor_Session_Receive_Begins);
      atomic { peer = 0; Set_Event (Monitor_Session_Watch_Begins) };
next: skip
   od
   od
}

active proctype Th_Receive_From_Mon ()
{
   byte own;
   do
   :: atomic { Wait_For_Work (Monitor_Session_Receive_Begins);
               own = Current; In_Receive = true };
      if
      :: Over (own)
      :: !Monitor_Outbox_Open          /* found in Monitor.Outbox.Reserve */
      fi;
      Shut_Down (own);
      atomic { In_Receive = false; own = 0 };
      Set_Event (Monitor_Session_Receive_Ended)
   od
}

active proctype Th_Send_To_Mon ()
{
   bool success, left, more;
   byte own;
end_wait:
   /* something to send, at any time */
   /*: Wait_Event (Outbox.Work) in outbox */
   Monitor_Outbox_Open;
take:
   /* what was taken before has been sent; the next goes, if there is one and
      no gap before it */
   /*: Box.Take */
   atomic {
      left = !Monitor_Outbox_Open;
      if
      :: Monitor_Outbox_Open -> more = true; Monitor_Outbox_Busy = true
      :: Monitor_Outbox_Busy = false
      fi
   };
#ifndef MUTANT_LEFT_WITHOUT_EVENT
   if :: left -> Set_Event (Monitor_Outbox_Sender_Left) :: else fi;
#endif
   atomic {
      left = false;
      if
      :: !more -> goto end_wait
      :: !more -> /*: delay in outbox */ goto take
      :: more -> more = false
      fi
   };
   /*: Connection.Send */
   atomic { assert (Current != 0); own = Current; In_Send = true };
   /* a silent monitor, or one that does not read, blocks it */
   if
   :: atomic { !Shut [own] && Peer [own] == Present -> success = true }
   :: atomic { Over (own) -> success = false }
   fi;
   In_Send = false;
#ifdef MUTANT_SENT_BEFORE_SHUT_DOWN
   Monitor_Outbox_Busy = false;
#endif
   if :: !success -> Shut_Down (own) :: else fi;
   atomic { own = 0; success = false; goto take }
}

active proctype Th_Com_Mon_Perdue ()
{
   byte own;
   /*: whole */
   do
   :: atomic { Wait_For_Work (Monitor_Session_Watch_Begins);
               own = Current; In_Watch = true };
      /* Wait_Loss: Watch and Judge */
      do
      :: /*: Connection.Watch, Session.State.Get */
         atomic { Over (own) || Peer [own] == Silent -> In_Watch = false; break }
      :: /*: Connection.Watch, Session.State.Get */
         atomic { !(Over (own) || Peer [own] == Silent) -> skip };
         /*: Vision.Frames.Look_At_Silence in vision */
         Over (own) || Peer [own] == Silent
      od;
      /*: Session.State.Go_On */
      Stage = Closing;
      /* Bring_Back */
#ifdef MUTANT_WAITS_SWAPPED
      Wait_Event (Monitor_Session_Receive_Ended);
#endif
      Shut_Down (own);
      /*: Box.Close_Session */
      Monitor_Outbox_Open = false;
      /*: Set_Event (Outbox.Room) in outbox,
          Set_Event (Outbox.Arena_Room) in vision,
          Line.Grant.Begin_Session in orders, Robot.Line.Ask in orders */
      /*: Wait_Event (Robot_Line [Robot_Line_Monitor_Lost]) in orders,
          Robot.Service.Serve in orders + */
      /*: Vision.State.Store.Begin_Session in vision,
          Vision.Frames.End_Delivery in vision */
      do
      :: /*: Box.Get */
         atomic { !Monitor_Outbox_Busy -> break }
      :: /*: Box.Get */
         atomic { Monitor_Outbox_Busy -> skip };
         Wait_Event (Monitor_Outbox_Sender_Left)
#ifdef MUTANT_SENDER_LOOKED_AT_ONCE
         ; break
#endif
      od;
#ifndef MUTANT_WAITS_SWAPPED
      Wait_Event (Monitor_Session_Receive_Ended);
#endif
      /*: Vision.Turns.Clear in vision */
      atomic {
         /*: Vision.State.Store.Get_Idle in vision */
         if
         :: /*: delay in vision, Vision.State.Store.Get_Idle in vision + */ skip
         :: skip
         fi
      };
#ifdef MUTANT_WOKEN_BEFORE_STATE
      Waker = true;
#endif
      /*: Connection.Close */
      atomic {
         /* what Monitor.Sockets.Connection.Close asks for */
         assert (!In_Receive && !In_Send && !In_Watch);
         Current = 0;
         own = 0
      };
      /*: Session.State.Go_On */
      Stage = Free;
#ifdef MUTANT_WOKEN_BEFORE_STATE
      skip
#elif !defined (MUTANT_SERVER_NOT_WOKEN)
      /*: Event_Counters.Add */
      Waker = true
#endif
   od
}

/* A monitor comes when it likes, and closes, or falls silent (cable out, or
   it reads no more) at any point; also before it has been admitted */

proctype Monitor (byte c)
{
   Peer [c] = Present;
   Backlog ! c;
   if
   :: Peer [c] = Gone
   :: Peer [c] = Silent
   fi
}

init {
   byte c = 1;
   atomic { do :: c <= MONITORS -> run Monitor (c); c++ :: else -> break od }
}

#define Is_Lost  (Stage == Active && Current != 0 && Peer [Current] != Present)

ltl initial_state_again { [] (Is_Lost -> <> (Stage == Free)) }
ltl newcomer_answered { [] (Waits > 0 -> <> (Waits == 0)) }
