/* SPDX-License-Identifier: GPL-3.0-or-later
   The periodic tasks of the robot, which a start sets going: reload of the
   watchdog, battery, keep-alive; while orders come without end. */

#include "common.pml"

/* Checked in parts: with -DRELOAD the watchdog's reload against stops
   without end, or with -DMOVES against movements without end, or with -DCALM
   against neither; else one of the companions of a run, battery or, with
   -DKEEP_ALIVE, keep-alive, with both ways to start. */

#define STOPS  1         /* that wait at a time */

EVENT (Robot_Events_For_Reload);
EVENT (Robot_Events_For_Battery);
EVENT (Robot_Events_For_Keep_Alive);

/* Th_Line's, before it answers the start */
inline Tell_Of_Start () {
   if
#if defined (RELOAD) && !defined (MUTANT_RELOAD_NOT_BEGUN)
   :: kind == Start_Watchdog -> Set_Event (Robot_Events_For_Reload)
#else
   :: kind == Start_Watchdog ->
      /*: Set_Event (Robot.Events.For_Reload) in periodic */
      skip
#endif
   :: else
   fi;
#if defined (RELOAD) || defined (KEEP_ALIVE)
   /*: Set_Event (Robot.Events.For_Battery) in periodic */
#elif !defined (MUTANT_BATTERY_NOT_BEGUN)
   Set_Event (Robot_Events_For_Battery);
#endif
#ifdef KEEP_ALIVE
   Set_Event (Robot_Events_For_Keep_Alive)
#else
   /*: Set_Event (Robot.Events.For_Keep_Alive) in periodic */
   skip
#endif
}

inline Tell_Of () { skip }
#define Whole_Line
#define EVENTS_AT_ONCE
#include "line.pml"

#define In_Watchdog_Mode  (L.Mode == Started_With_Watchdog)
#define Same_Run(c)       (L.Mode != Not_Started && !L.New_Epoch [c])

/* Orders, at any time, of any kind: they carry no number, as if each were
   in turn; orders.pml has the numbers */

active proctype Th_Start_Robot_WD ()
{
end_wait:
   do
   :: Put (Robot_Clients_Start_Watchdog, Start_Watchdog, 0, 0, 0);
      atomic { Wait (Robot_Clients_Start_Watchdog) }
   od
}

#ifndef RELOAD
active proctype Th_Start_Robot ()
{
end_wait:
   do
   :: Put (Robot_Clients_Start, Start, 0, 0, 0);
      atomic { Wait (Robot_Clients_Start) }
   od
}
#endif

active proctype Th_Reset_Robot ()
{
end_wait:
   do
   :: if
      :: Put (Robot_Clients_Reset, Open_Line, 0, 0, 0)
      :: Put (Robot_Clients_Reset, Reset, 0, 0, 0)
      fi;
      atomic { Wait (Robot_Clients_Reset) }
   od
}

#ifdef MOVES
active proctype Th_Move ()
{
end_wait:
   do
   :: Put (Robot_Clients_Move, Drive, 0, 0, 0);
      atomic { Wait (Robot_Clients_Move) }
   od
}

#endif

#ifdef RELOAD
#if !defined (MOVES) && !defined (CALM)
active proctype Stop_Source ()
{
end_wait:
   do
   :: atomic { len (Stops) < STOPS -> Put_Stop (1) }
   od
}
#endif

active proctype Th_Reload_WD ()
{
   bool goes_on, same;
   /*: whole */
wait:
   atomic {
      Wait_For_Work (Robot_Events_For_Reload);
      /*: Line.Line.Get_Status */
      L.New_Epoch [Robot_Clients_Reload] = false;
      goes_on = In_Watchdog_Mode
   };
next:
   atomic {
      if
      :: goes_on -> goes_on = false
      :: else -> goto wait
      fi;
      /*: Line.Line.Set_Reload_Due */
      L.Reload_Due = Far;
      Reloaded = false;
#ifndef CALM
   };
   atomic {
#endif
#ifndef MUTANT_DUE_WITHOUT_EVENT
      Set_Event (Robot_Line_Work)
#endif
   };
   atomic {
      /*: delay */
      L.Reload_Due != Far || L.New_Epoch [Robot_Clients_Reload]
   };
   atomic {
      /* for the run that it has seen begin */
      /*: Line.Line.Put_In_Run */
      if
#ifdef MUTANT_RELOAD_WITHOUT_LOOK
      :: true ->
#else
      :: Same_Run (Robot_Clients_Reload) ->
#endif
         Put_It (Robot_Clients_Reload, Reload, 0, 0, 0); same = true
      :: else
      fi
   };
   Set_Event (Robot_Line_Work);
   if
   :: same ->
      atomic {
         same = false;
         Wait_Event (Robot_Line_Clients_Finished [Robot_Clients_Reload]);
         /*: Line.Line.Collect */
         skip
      }
   :: else
   fi;
   atomic {
      /*: Line.Line.Get_Status */
      goes_on = Same_Run (Robot_Clients_Reload) && In_Watchdog_Mode;
      goto next
   }
}

/* The time at which the reload is due comes near, and passes. Where nothing
   but this keeps orders waiting, it does not come near before the owner of
   the line has looked: there is nearly a second. */

#ifdef CALM
#define Comes_Near  (L.Reload_Due == Far && !Is_Set (Robot_Line_Work))
#else
#define Comes_Near  (L.Reload_Due == Far)
#endif

active proctype Clock ()
{
end_wait:
   do
   :: atomic { Comes_Near -> L.Reload_Due = Near }
   :: atomic { L.Reload_Due == Near -> L.Reload_Due = Past }
   od
}

#else

/* Battery and keep-alive: from a start on, as long as the same run lasts */

inline Begin_Run (begun, client) {
   atomic {
      Wait_For_Work (begun);
      /*: Line.Line.Get_Status */
      L.New_Epoch [client] = false;
      goes_on = Same_Run (client)
   }
}

inline Look_Again (client) {
   /*: Line.Line.Get_Status */
   goes_on = Same_Run (client)
}

#ifndef KEEP_ALIVE
active proctype Th_Battery_Level ()
{
   bool goes_on;
   /*: whole */
   do
   :: Begin_Run (Robot_Events_For_Battery, Robot_Clients_Battery);
      do
      :: goes_on ->
         /*: delay */
         Look_Again (Robot_Clients_Battery);
         if
         :: goes_on ->
            Put (Robot_Clients_Battery, Query, 0, 0, 0);
            atomic {
               Wait (Robot_Clients_Battery);
               /*: Line.Line.Collect */
               Look_Again (Robot_Clients_Battery)
            };
            if
            :: goes_on ->
               /*: Monitor.Outbox.Put in outbox */
               skip
            :: else
            fi
         :: else
         fi
      :: else -> break
      od
   od
}

#else
active proctype Th_Keep_Alive ()
{
   bool goes_on;
   /*: whole */
   do
   :: atomic {
         Wait_Until (Robot_Events_For_Keep_Alive);
         /*: Line.Line.Get_Status */
         L.New_Epoch [Robot_Clients_Keep_Alive] = false;
         goes_on = Same_Run (Robot_Clients_Keep_Alive)
      };
      if
      :: L.Open && L.Mode == Not_Started ->
         Put (Robot_Clients_Keep_Alive, Keep_Alive, 0, 0, 0);
         atomic {
            Wait (Robot_Clients_Keep_Alive);
            /*: Line.Line.Collect */
            skip
         }
      :: true                      /* closed, or the robot is off */
      fi;
      do
      :: goes_on ->
         /*: delay */
         Look_Again (Robot_Clients_Keep_Alive);
         if
         :: goes_on ->
            Put (Robot_Clients_Keep_Alive, Keep_Alive, 0, 0, 0);
            atomic {
               Wait (Robot_Clients_Keep_Alive);
               /*: Line.Line.Collect */
               skip
            }
         :: else                     /* or the line is not idle */
         fi
      :: else -> break
      od
   od
}
#endif

#endif

#ifdef RELOAD
ltl reload_never_starves
   { [] (L.Pending [Robot_Clients_Reload] -> <> !L.Pending [Robot_Clients_Reload]) }
ltl reload_as_long_as_it_runs
   { []<> (!In_Watchdog_Mode || Reloaded) && []<> (!In_Watchdog_Mode || !Reloaded) }
#ifdef CALM
#define Order_Waits  L.Pending [Robot_Clients_Start_Watchdog]
ltl orders_go_after_the_reload
   { [] (Order_Waits -> <> !Order_Waits) }
#endif
#else
#ifndef KEEP_ALIVE
ltl battery_as_long_as_it_runs
   { []<> (L.Mode == Not_Started || L.Pending [Robot_Clients_Battery]) }
#else
ltl line_kept_alive_as_long_as_it_runs
   { []<> (L.Mode == Not_Started || L.Pending [Robot_Clients_Keep_Alive]) }
#endif
#endif
