/* SPDX-License-Identifier: GPL-3.0-or-later
   What the tasks of the robot do by the clock: reload of the watchdog, battery,
   keep-alive; while orders come without end. */

#include "common.pml"

/* Checked in parts: with -DRELOAD the watchdog's reload against stops
   without end, or with -DMOVES against movements without end, or with -DCALM
   against neither; else one of the companions of a run, battery or, with
   -DKEEP_ALIVE, keep-alive, with both ways to start. */

#define STOPS  1         /* that wait at a time, of each kind of order */
#define UNNUMBERED       /* orders.pml has the numbers */
#define EVENTS_AT_ONCE

inline Monitor_Outbox_Answer (its_number) {
   /*: Monitor.Outbox.Answer in outbox */ skip
}
#include "line.pml"

#define In_Watchdog_Mode  (L.Mode == Started_With_Watchdog)

/* The clock. The time at which the reload is due comes near, and passes. Where
   nothing but this keeps orders waiting, it does not come near before these
   have gone: there is nearly a second. */

#ifdef CALM
#define Comes_Near  (L.Reload_Due == Far && len (Others) == 0)
#else
#define Comes_Near  (L.Reload_Due == Far)
#endif

active proctype Clock ()
{
end_clock:
   do
#ifdef RELOAD
   :: atomic {
         In_Watchdog_Mode && Comes_Near ->
         L.Reload_Due = Near; Reloaded = false
      }
   :: atomic {
         In_Watchdog_Mode && L.Reload_Due == Near ->
         L.Reload_Due = Past; Is_Due = true
      }
#elif defined (KEEP_ALIVE)
   :: atomic { L.Open && !L.Ping_Due -> L.Ping_Due = true }
#else
   :: atomic {
         L.Mode != Not_Started && !L.Battery_Due -> L.Battery_Due = true
      }
#endif
   od
}

/* Orders, at any time, of any kind */

active proctype Th_Receive_From_Mon ()
{
   byte to = NOBODY;
end_receive:
   do
   :: /*: Line.Grant.Put */
      atomic {
         if
         :: len (Others) == 0 -> Others ! 1, Start_Watchdog
         :: len (Others) == 0 -> Others ! 1, Open_Line
         :: len (Others) == 0 -> Others ! 1, Reset
#ifdef RELOAD
#ifdef MOVES
         :: len (Moves) == 0 -> Moves ! 1, 0
#elif !defined (CALM)
         :: len (Stops) == 0 -> Stops ! 1
#endif
#else
         :: len (Others) == 0 -> Others ! 1, Start
#endif
         fi;
         d_step { Choose (); best = 0 }
         Wake ()
      }
#ifdef KEEP_ALIVE
   :: break               /* none come any more: only a ping uses the line */
#endif
   od
}

active proctype Th_Start_Robot_WD ()
{
   TIMED_USER;
wait:
   Serve_Or_Look (Robot_Line_Start_WD, L.Reload_Due == Past, In_Watchdog_Mode)
}

active proctype Th_Open_Com_Robot ()
{
   TIMED_USER;
wait:
   Serve_Or_Look (Robot_Line_Open_Com, L.Ping_Due, L.Open)
}

active proctype Th_Reset_Robot ()
{
   USER;
wait:
   Serve (Robot_Line_Reset)
}

#ifdef RELOAD
#ifndef CALM
active proctype Th_Move ()
{
   USER;
wait:
   Serve (Robot_Line_Move)
}
#endif
#else
active proctype Th_Start_Robot ()
{
   USER;
wait:
   Serve (Robot_Line_Start)
}

#ifndef KEEP_ALIVE
active proctype Th_Battery_Level ()
{
   TIMED_USER;
   /*: whole */
wait:
   Serve_Or_Look (Robot_Line_Battery, L.Battery_Due, L.Mode != Not_Started)
}
#endif
#endif

#ifdef RELOAD
#define Reload_Waits  (In_Watchdog_Mode && L.Reload_Due == Past)
ltl reload_never_starves
   { [] (Reload_Waits -> <> !Reload_Waits) }
ltl reload_as_long_as_it_runs
   { []<> (!In_Watchdog_Mode || Reloaded) && []<> (!In_Watchdog_Mode || !Reloaded) }
#ifdef CALM
#define Order_Waits  (len (Others) > 0)
ltl orders_go_after_the_reload
   { [] (Order_Waits -> <> !Order_Waits) }
#endif
#else
#ifndef KEEP_ALIVE
ltl battery_as_long_as_it_runs
   { []<> (L.Mode == Not_Started || L.From == Of_Battery) }
#else
ltl line_kept_alive_as_long_as_it_runs
   { []<> (L.Mode == Not_Started || L.Has != NOBODY) }
#endif
#endif
