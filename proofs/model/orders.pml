/* SPDX-License-Identifier: GPL-3.0-or-later
   The monitor's orders to the robot: to the line and back to their answers,
   over the end of a session into the next. */

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
#include "line.pml"

active proctype Th_Open_Com_Robot ()
{
   TIMED_USER;
   /*: whole */
wait:
   Serve_Or_Look (Robot_Line_Open_Com, false, false)
}

active proctype Th_Start_Robot ()
{
   USER;
   /*: whole */
wait:
   Serve (Robot_Line_Start)
}

active proctype Th_Start_Robot_WD ()
{
   TIMED_USER;
   /*: whole */
wait:
   Serve_Or_Look (Robot_Line_Start_WD, false, false)
}

active proctype Th_Reset_Robot ()
{
   USER;
   /*: whole */
wait:
   Serve (Robot_Line_Reset)
}

active proctype Th_Move ()
{
   USER;
   /*: whole */
wait:
   Serve (Robot_Line_Move)
}

bool Free = true;         /* the session: see session.pml */
EVENT (Monitor_Session_Receive_Begins);
EVENT (Monitor_Session_Receive_Ended);
EVENT (Monitor_Session_Watch_Begins);

active proctype Th_Receive_From_Mon ()
{
   byte number, sent, to = NOBODY;
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
            :: kind = Open_Line
            :: kind = Drive
            :: kind = Stop
#if COMMANDS == 1
            :: kind = Close_Line
            :: kind = Start_Watchdog
#endif
#if SESSIONS == 1 || COMMANDS == 1
            :: kind = Start
            :: kind = Reset
            :: kind = Query
#endif
            fi
         };
#ifdef MUTANT_EVENT_BEFORE_PUT
         Set_Event (Robot_Line [Robot_Line_Move]);
#endif
         /*: Line.Grant.Put */
         d_step {
            if
            :: kind == Stop -> Stops ! number; L.Last_Stop = number
            :: kind == Drive -> Moves ! number, L.Last_Change
            :: else ->
               Others ! number, kind;
               L.Last_Change =
                  (Changes_Session (kind) -> number : L.Last_Change)
            fi;
            Choose ();
            best = 0;
#if defined (MUTANT_ORDER_WITHOUT_EVENT) || defined (MUTANT_EVENT_BEFORE_PUT)
            to = NOBODY;
#endif
            number = 0; kind = 0
         }
         Wake ()
      od;
      sent = 0;
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
    && Is_Awaited (Robot_Line [Robot_Line_Open_Com])
    && Is_Awaited (Robot_Line [Robot_Line_Start])
    && Is_Awaited (Robot_Line [Robot_Line_Start_WD])
    && Is_Awaited (Robot_Line [Robot_Line_Reset])
    && Is_Awaited (Robot_Line [Robot_Line_Move]));
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
   USER;
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
      /*: Line.Grant.Begin_Session */
      d_step {
         L.Session = First;
         do :: Stops ? _ :: len (Stops) == 0 -> break od;
         do :: Moves ? _, _ :: len (Moves) == 0 -> break od;
         do :: Others ? _, _ :: len (Others) == 0 -> break od;
         L.Last_Stop = 0;
         L.Last_Change = 0
      }
#endif
#ifndef MUTANT_NO_SAFE_STATE
      /*: Line.Grant.Put */
      d_step { L.Ends = true; Choose (); best = 0 }
      Wake ();
turn: atomic {
         Wait_Event (Robot_Line [Robot_Line_Monitor_Lost]);
         Take_Up (Robot_Line_Monitor_Lost)
      };
      Give_Back (Robot_Line_Monitor_Lost);
not_mine: if :: L.Ends -> goto turn :: else fi;
#endif
      Nobody = true;
      Wait_Event (Monitor_Session_Receive_Ended);
      assert (!Stop_Owed);
      assert (L.Session == First);
      Free = true
   od
}

ltl stop_when_nobody_in_command
   { [] (!In_Command -> <> (In_Command || !Stop_Owed)) }
ltl every_order_answered
   { [] (Patient -> <> !Patient) }
