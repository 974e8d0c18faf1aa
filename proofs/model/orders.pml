/* SPDX-License-Identifier: GPL-3.0-or-later
   The monitor's orders to the robot: from their ports to the line and back
   to their answers, over the end of a session into the next. */

#include "common.pml"

#ifndef SESSIONS
#define SESSIONS  2
#endif
#ifndef COMMANDS
#define COMMANDS  3      /* in each session */
#endif
#define LATER     1      /* in the second one */
#define CAPACITY  2      /* that may wait for their answers */
#define STOPS     (CAPACITY + 1)

#define NUMBERS   (COMMANDS + LATER + 1)
#define Limit     (In_First -> COMMANDS : LATER)
bool In_First = true;   /* session */

/* Monitor.Outbox, as far as robot orders need it: see session.pml */
bool Monitor_Outbox_Open   = false;
byte First         = 1;    /* number of the session's first command */
byte Next          = 1;    /* of the next command */
byte Waiting       = 0;    /* commands without answer, in the session */
bool Unanswered [NUMBERS] = false;

inline Monitor_Outbox_Answer (its_number) {
   d_step {
      if
      :: its_number >= First ->
         /* no command is answered twice */
         assert (Unanswered [its_number]);
         Unanswered [its_number] = false;
         Waiting--
      :: else
      fi
   }
}

#if SESSIONS > 1
#define BEGINS_STARTED         /* as if opened and started before */
#endif
inline Tell_Of_Start () { skip }    /* see periodic.pml */
#include "line.pml"

/* Task_Ports */
#define PORTS                            8
#define Task_Ports_Open_Robot            0   /* instance */
#define Task_Ports_Start_Robot           1   /* instance */
#define Task_Ports_Start_Robot_Watchdog  2   /* instance */
#define Task_Ports_Reset_Robot           3   /* instance */
#define Task_Ports_Move                  4   /* instance */
#define Task_Ports_Query                 5   /* instance */

typedef Order_Ports_Port_Type {
   chan Items = [CAPACITY] of { byte, mtype:request, byte, byte }
};
Order_Ports_Port_Type Order_Ports_Port [6];
EVENTS (Order_Ports_Arrived, 6);

#define Port(p)  Order_Ports_Port [p].Items

/* More waits: the task wakes itself, for it waits for its event before it
   takes. Nobody else looks at that event, so to set it is no step of its
   own. */
inline Take (p) {
   if
   :: len (Port (p)) > 0 -> Port (p) ? number, kind, rank, after
   :: else -> goto end_wait
   fi;
#ifndef MUTANT_MORE_ORDERS_FORGOTTEN
   if
   :: len (Port (p)) > 0 -> Set_True (Order_Ports_Arrived [p])
   :: else
   fi
#endif
}

/* What each of these tasks does: Order_Ports.Wait and Robot.Line.Clients.Ask. The
   owner of the line answers. */
inline Serve (p, client) {
   atomic {
      Order_Ports_Arrived [p] -> Order_Ports_Arrived [p] = false;
      Take (p)
   };
   Ask (client, kind, number, rank, after);
   atomic {
      Finished (client);
      number = 0; kind = 0; rank = 0; after = 0;
      goto end_wait
   }
}

#define ORDER  byte number, rank, after; mtype:request kind

active proctype Th_Open_Com_Robot ()
{
   ORDER;
end_wait:
   Serve (Task_Ports_Open_Robot, Robot_Clients_Open)
}

active proctype Th_Start_Robot ()
{
   ORDER;
end_wait:
   Serve (Task_Ports_Start_Robot, Robot_Clients_Start)
}

active proctype Th_Start_Robot_WD ()
{
   ORDER;
end_wait:
   Serve (Task_Ports_Start_Robot_Watchdog, Robot_Clients_Start_Watchdog)
}

active proctype Th_Reset_Robot ()
{
   ORDER;
end_wait:
   Serve (Task_Ports_Reset_Robot, Robot_Clients_Reset)
}

active proctype Th_Move ()
{
   ORDER;
end_wait:
   Serve (Task_Ports_Move, Robot_Clients_Move)
}

active proctype Th_Query ()
{
   ORDER;
end_wait:
   Serve (Task_Ports_Query, Robot_Clients_Query)
}

EVENT (Monitor_Session_Receive_Begins);
EVENT (Monitor_Session_Receive_Ended);

active proctype Th_Receive_From_Mon ()
{
   byte number, rank, after, sent, port;
   mtype:request kind;
end_wait:
   do
   :: Suspend_Until_True (Monitor_Session_Receive_Begins);
      do
      :: atomic { !Monitor_Outbox_Open -> break }
      :: atomic {
            Monitor_Outbox_Open && sent < Limit && Waiting < CAPACITY ->
            sent++;
            number = Next;
            Next++;
            Unanswered [number] = true;
            Waiting++;
            if
            :: kind = Open_Line;      port = Task_Ports_Open_Robot
            :: kind = Drive;          port = Task_Ports_Move
            :: kind = Stop
#if SESSIONS == 1
            :: kind = Start;          port = Task_Ports_Start_Robot
            :: kind = Reset;          port = Task_Ports_Reset_Robot
            :: kind = Query;          port = Task_Ports_Query
#endif
            fi;
            if
            :: kind != Stop -> rank++
            :: else
            fi
         };
         if
         :: kind == Stop -> Put_Stop (number)
         :: else ->
            atomic {
               assert (len (Port (port)) < CAPACITY);
               Port (port) ! number, kind, rank, after;
               if
               :: Changes_Session (kind) -> after = rank
               :: else
               fi
            };
#ifndef MUTANT_ORDER_WITHOUT_EVENT
            Set_True (Order_Ports_Arrived [port])
#endif
         fi;
         d_step { number = 0; kind = 0; port = 0 }
      od;
      atomic { rank = 0; after = 0; sent = 0 };
      Set_True (Monitor_Session_Receive_Ended)
   od
}

bool In_Command = false;
bool Patient    = false;

active proctype Th_Com_Mon_Perdue ()
{
   byte session, p;
   do
   :: session < SESSIONS ->
      /* Begin_Active */
      d_step {
         In_First = (session == 0);
         session++;
         Monitor_Outbox_Open = true;
         In_Command = true;
         Nobody = false
      }
      Set_True (Monitor_Session_Receive_Begins);
      /* Wait_Loss: at any time, or when all has been answered */
      if
      :: true
      :: Patient = true;
         atomic { Waiting == 0 -> Patient = false }
      fi;
      /* Bring_Back */
      d_step {
         In_Command = false;
         Monitor_Outbox_Open = false;
         First = Next;
         Waiting = 0;
         k = 1;
         do
         :: k < NUMBERS -> Unanswered [k] = false; k++
         :: else -> break
         od;
         k = 0
      }
#ifndef MUTANT_SESSION_NOT_BEGUN
      d_step {
         L.Session = First;
         do :: Stops ? _ :: len (Stops) == 0 -> break od;
         L.Last_Stop = 0;
         L.Completed = 0;
         L.Changed = 0
      }
      Set_True (Robot_Line_Work);
#endif
#ifndef MUTANT_NO_SAFE_STATE
      Ask (Robot_Clients_Safe_State, Close_Line, 0, 0, 0);
      atomic { Finished (Robot_Clients_Safe_State) };
#endif
      Nobody = true;
      Suspend_Until_True (Monitor_Session_Receive_Ended);
      /* Task_Ports.Clear */
      atomic {
         do
         :: p < 6 ->
            do
            :: Port (p) ? _, _, _, _
            :: len (Port (p)) == 0 -> break
            od;
            p++
         :: else -> break
         od;
         p = 0
      };
      assert (!Stop_Owed)
   :: else -> break
   od
}

ltl stop_when_nobody_in_command
   { [] (!In_Command -> <> (In_Command || !Stop_Owed)) }
ltl every_order_answered
   { [] (Patient -> <> !Patient) }
