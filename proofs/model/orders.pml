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
   /*: Monitor.Outbox.Answer in outbox */
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
inline Tell_Of_Start () {
   /*: Robot.Events.Started in periodic */
   skip
}
inline Tell_Of () {
   if
   :: /*: Monitor.Outbox.Put in outbox */ skip
   :: /*: Monitor.Outbox.Put in outbox, Monitor.Outbox.Put in outbox */ skip
   :: skip
   fi
}
#define Whole_Line  /*: whole */
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
   /*: Port.Take [p] */
   if
   :: len (Port (p)) > 0 -> Port (p) ? number, kind, rank, after
   :: else -> goto wait
   fi;
#ifndef MUTANT_MORE_ORDERS_FORGOTTEN
   if
   :: len (Port (p)) > 0 -> Set_Event (Order_Ports_Arrived [p])
   :: else
   fi
#endif
}

/* What each of these tasks does: Order_Ports.Wait and Robot.Line.Clients.Ask. The
   owner of the line answers. */
inline Serve (p, client) {
   /*: whole */
   atomic {
      Wait_For_Work (Order_Ports_Arrived [p]);
      Take (p)
   };
   Put (client, kind, number, rank, after);
   atomic {
      Wait (client);
      number = 0; kind = 0; rank = 0; after = 0;
      goto wait
   }
}

#define ORDER  byte number, rank, after; mtype:request kind

active proctype Th_Open_Com_Robot ()
{
   ORDER;
wait:
   Serve (Task_Ports_Open_Robot, Robot_Clients_Open)
}

active proctype Th_Start_Robot ()
{
   ORDER;
wait:
   Serve (Task_Ports_Start_Robot, Robot_Clients_Start)
}

active proctype Th_Start_Robot_WD ()
{
   ORDER;
wait:
   Serve (Task_Ports_Start_Robot_Watchdog, Robot_Clients_Start_Watchdog)
}

active proctype Th_Reset_Robot ()
{
   ORDER;
wait:
   Serve (Task_Ports_Reset_Robot, Robot_Clients_Reset)
}

active proctype Th_Move ()
{
   ORDER;
wait:
   Serve (Task_Ports_Move, Robot_Clients_Move)
}

active proctype Th_Query ()
{
   ORDER;
wait:
   Serve (Task_Ports_Query, Robot_Clients_Query)
}

inline Clear (p) {
   /*: Port.Clear [p] */
   do
   :: Port (p) ? _, _, _, _
   :: len (Port (p)) == 0 -> break
   od
}

bool Free = true;         /* the session: see session.pml */
EVENT (Monitor_Session_Receive_Begins);
EVENT (Monitor_Session_Receive_Ended);
EVENT (Monitor_Session_Watch_Begins);

active proctype Th_Receive_From_Mon ()
{
   byte number, rank, after, sent, port;
   mtype:request kind;
   do
   :: Wait_For_Work (Monitor_Session_Receive_Begins);
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
#if COMMANDS == 1
            :: kind = Close_Line;     port = Task_Ports_Open_Robot
            :: kind = Start_Watchdog; port = Task_Ports_Start_Robot_Watchdog
#endif
#if SESSIONS == 1 || COMMANDS == 1
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
            /*: Port.Put [port] */
            atomic {
               assert (len (Port (port)) < CAPACITY);
               Port (port) ! number, kind, rank, after;
               if
               :: Changes_Session (kind) -> after = rank
               :: else
               fi
            };
#ifndef MUTANT_ORDER_WITHOUT_EVENT
            Set_Event (Order_Ports_Arrived [port])
#endif
         fi;
         d_step { number = 0; kind = 0; port = 0 }
      od;
      atomic { rank = 0; after = 0; sent = 0 };
      Set_Event (Monitor_Session_Receive_Ended)
   od
}

bool In_Command = false;
bool Patient    = false;

active proctype Th_Server ()
{
   byte session;
   (Is_Awaited (Monitor_Session_Watch_Begins)
    && Is_Awaited (Monitor_Session_Receive_Begins)
    && Is_Awaited (Robot_Line_Work)
    && Is_Awaited (Order_Ports_Arrived [Task_Ports_Open_Robot])
    && Is_Awaited (Order_Ports_Arrived [Task_Ports_Start_Robot])
    && Is_Awaited (Order_Ports_Arrived [Task_Ports_Start_Robot_Watchdog])
    && Is_Awaited (Order_Ports_Arrived [Task_Ports_Reset_Robot])
    && Is_Awaited (Order_Ports_Arrived [Task_Ports_Move])
    && Is_Awaited (Order_Ports_Arrived [Task_Ports_Query]));
   do
   :: session < SESSIONS ->
      /* Begin_Active, Admit: see session.pml */
      /*: Box.Open_Session */
      d_step {
         Free -> Free = false;
         In_First = (session == 0);
         session++;
         Monitor_Outbox_Open = true;
         In_Command = true;
         Nobody = false
      }
      /* one after the other in session.pml */
      atomic {
         Set_Event (Monitor_Session_Receive_Begins);
         Set_Event (Monitor_Session_Watch_Begins)
      }
   :: else -> break
   od
}

active proctype Th_Com_Mon_Perdue ()
{
   do
   :: Wait_For_Work (Monitor_Session_Watch_Begins);
      /* Wait_Loss: at any time, or when all has been answered */
      if
      :: true
      :: Patient = true;
         atomic { Waiting == 0 -> Patient = false }
      fi;
      /* Bring_Back */
      /*: Box.Close_Session */
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
      /*: Line.Line.Begin_Session */
      d_step {
         L.Session = First;
         do :: Stops ? _ :: len (Stops) == 0 -> break od;
         L.Last_Stop = 0;
         L.Completed = 0;
         L.Changed = 0
      }
      Set_Event (Robot_Line_Work);
#endif
#ifndef MUTANT_NO_SAFE_STATE
      Put (Robot_Clients_Safe_State, Close_Line, 0, 0, 0);
      atomic { Wait (Robot_Clients_Safe_State) };
      /*: Line.Line.Collect */
#endif
      Nobody = true;
      Wait_Event (Monitor_Session_Receive_Ended);
      /* nobody puts an order meanwhile: one step */
      atomic {
         /*: Queue.Queue.Clear in vision */
         Clear (Task_Ports_Open_Robot);
         Clear (Task_Ports_Start_Robot);
         Clear (Task_Ports_Start_Robot_Watchdog);
         Clear (Task_Ports_Reset_Robot);
         Clear (Task_Ports_Move);
         Clear (Task_Ports_Query)
      };
      assert (!Stop_Owed);
      Free = true
   od
}

ltl stop_when_nobody_in_command
   { [] (!In_Command -> <> (In_Command || !Stop_Owed)) }
ltl every_order_answered
   { [] (Patient -> <> !Patient) }
