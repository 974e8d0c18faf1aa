/* SPDX-License-Identifier: GPL-3.0-or-later
   The owner of the robot's line and its requests, for orders.pml,
   periodic.pml and mission.pml (which says MISSION): Robot.Line,
   Robot.Session, Robot.Exchange, Th_Line. */

#define MAX_FAILURES  2   /* in a row, and the line is lost; the code's 4
                             and the figure itself are proved by contract */
#define LEAVE_TRIES   1   /* the code's 3: one less than MAX_FAILURES */

/* Robot.Line.Client, in the order of the code */
#define CLIENTS                       12
#define Robot_Clients_Safe_State       0   /* instance */
#define Stop_Order                     1
#define Robot_Clients_Reload           2   /* instance */
#define Robot_Clients_Move             3   /* instance */
#define Robot_Clients_Mission          4   /* instance */
#define Robot_Clients_Battery          5   /* instance */
#define Robot_Clients_Open             6   /* instance */
#define Robot_Clients_Start            7   /* instance */
#define Robot_Clients_Start_Watchdog   8   /* instance */
#define Robot_Clients_Reset            9   /* instance */
#define Robot_Clients_Query           10   /* instance */
#define Robot_Clients_Keep_Alive      11   /* instance */

mtype:request = { Open_Line, Close_Line, Start, Start_Watchdog, Reset,
                  Drive, Stop, Reload, Query, Keep_Alive };
                  /* Query: ping, battery, state; Reset: power off too */
mtype:verdict = { Carry_Out, Overtaken, Out_Of_Date, Late };
mtype:outcome = { Done, Refused, Failed };
mtype:mode    = { Not_Started, Started, Started_With_Watchdog };
mtype:reply   = { Accepted, Denied, Silence };
mtype:due     = { Far, Near, Past };

typedef Robot_Line_Line_Type {
   bool          Pending [CLIENTS];
   mtype:request Kind    [CLIENTS];
   byte          Number  [CLIENTS];
   byte          Rank    [CLIENTS];
   byte          After   [CLIENTS];
   byte Last_Stop;
   byte Session = 1;
   byte Completed;
   byte Changed;
   mtype:due  Reload_Due = Far;  /* Near: in the quiet time around it */
   bool Open;
   mtype:mode Mode = Not_Started;
#ifdef MISSION
   byte Last_Hand;
   byte Last_Mission;            /* that has made a request */
   bool Too_Old;                 /* the mission's request, by now */
#endif
   bool New_Epoch [CLIENTS]      /* a start since this client has looked */
};
PROTECTED (Robot_Line_Line);
EVENT (Robot_Line_Work);
EVENTS (Robot_Line_Clients_Finished, CLIENTS);
chan Stops = [STOPS] of { byte };

#define L  Robot_Line_Line

#define Changes_Session(k) \
   (k == Open_Line || k == Close_Line || k == Start \
    || k == Start_Watchdog || k == Reset)
#define Is_Old(c)  (L.Number [c] != 0 && L.Number [c] < L.Session)
#define In_Turn(c) \
   (L.Number [c] == 0 || Is_Old (c) \
    || (Changes_Session (L.Kind [c]) \
        -> L.Completed + 1 == L.Rank [c] \
        : L.After [c] <= \
             (c == Robot_Clients_Mission -> L.Completed : L.Changed)))
#define Quiet \
   (L.Mode == Started_With_Watchdog && L.Reload_Due == Near)

#ifdef MUTANT_STOP_TOO_LATE
#define Can_Be_Late(kind)  true
#else
#define Can_Be_Late(kind)  (kind != Stop)
#endif

hidden byte k;

inline Put_It (who, what, its_number, its_rank, its_after) {
   L.Pending [who] = true;
   d_step {
      L.Kind   [who] = what;
      L.Number [who] = its_number;
      L.Rank   [who] = its_rank;
      L.After  [who] = its_after
   }
}

inline Put (who, what, its_number, its_rank, its_after) {
#ifdef MUTANT_WORK_BEFORE_PUT
   Set_Event (Robot_Line_Work);
#endif
   /*: Line.Line.Put */
   atomic { Put_It (who, what, its_number, its_rank, its_after) }
}

/* The other half of Ask, in an atomic step with what the caller does next:
   whether the request has been carried out when the wait begins makes no
   difference, as there is one only */
inline Wait (who) {
#ifndef MUTANT_WORK_BEFORE_PUT
   Set_Event (Robot_Line_Work);
#endif
   Wait_Event (Robot_Line_Clients_Finished [who])
}

inline Put_Stop (its_number) {
   /*: Line.Line.Put_Stop */
   d_step {
      assert (len (Stops) < STOPS);
      Stops ! its_number;
      L.Last_Stop = its_number
   }
#ifndef MUTANT_STOP_WITHOUT_EVENT
   Set_Event (Robot_Line_Work)
#else
   skip
#endif
}

/* What has been written to the robot */
bool Stop_Owed  = false;  /* a movement, and no stop since */
bool Stop_Due   = false;  /* a stop of the monitor in command waits */
bool Nobody     = false;  /* the session's end has been carried out */
bool Reloaded   = false;  /* since the reload became due last */

#ifdef MISSION
/* Any session begins with a robot that has been started */
bool State_Open;
mtype:mode State_Mode = Not_Started;

byte Hand   = 0;      /* the last order by hand that has been dispatched */
byte Drove  = 0;      /* the last mission with a movement on the line */
bool Drives = false;  /* that movement is the last that the robot got */

inline Wrote (what) {
   if
   :: from == Robot_Clients_Mission && (what == Drive || what == Stop) ->
      /* never after an order of the hand has been dispatched */
      assert (number > Hand);
      Drove = number;
      Drives = (what == Drive)
   :: from == Robot_Clients_Move && what == Drive ->
      /* nor does a movement of the hand from before the mission go out when
         the mission drives */
      assert (number > Drove);
      Drives = false
   :: what == Stop && from != Robot_Clients_Mission -> Drives = false
   :: else
   fi
}

/* When an order of the hand has been carried out, nothing is left of what the
   mission ordered */
inline Carried_Out () {
   assert (!(Drives && verdict == Carry_Out && result == Done
             && number == L.Last_Hand && from != Robot_Clients_Mission
             && number != 0))
}
#endif

inline Write (what) {
#ifdef MISSION
   Wrote (what);
#endif
   if
   :: what == Drive ->
      assert (State_Mode != Not_Started);
      assert (!Nobody);
      assert (number == 0 || number > L.Last_Stop ||
              L.Last_Stop == 0 || number < L.Session ||
              len (Stops) > 0);
      Stop_Owed = true
   :: what == Stop -> Stop_Owed = false
   :: what == Reload ->
      /* never one of the run before */
      assert (!L.New_Epoch [Robot_Clients_Reload]);
      Reloaded = true
   :: else
   fi
}

inline Fail () {
   Failures++;
   reply = Silence
}

/* Robot.Session.Begin_Exchange and what follows. Whether the robot
   answers, refuses or is silent is free at each exchange. */
inline Exchange (what) {
   reply = Accepted;
   if
   :: Failures > 0 ->
      if
      :: what == Stop && !blind -> Write (Stop); blind = true
      :: else
      fi;
      if
      :: Failures = 0            /* the probe is answered */
      :: Fail ()
      fi
   :: else
   fi;
   if
   :: reply != Silence ->
      Write (what);
      if
      :: !(what == Start || what == Start_Watchdog) ||
         State_Mode == Not_Started -> reply = Accepted
      :: reply = Denied
      :: Fail ()
      fi
   :: else
   fi
}

#define Is_Lost  (Failures == MAX_FAILURES)

inline Close_Device () {
   State_Open = false;
   State_Mode = Not_Started;
   Failures = 0
}

inline Carry_Out_Request () {
   /*: Robot.Exchange.Carry_Out */
   /* no order of a session that has ended, but for a stop */
   assert (number == 0 || number >= L.Session || kind == Stop);
   blind = false;
   result = Done;
   if
   :: kind == Open_Line && !State_Open ->
      if
      :: State_Open = true; Exchange (Reset)
      :: result = Failed
      fi
   :: kind == Close_Line && !State_Open
   :: kind != Open_Line && kind != Close_Line && !State_Open ->
      result = Failed
   :: kind == Drive && State_Open && State_Mode == Not_Started ->
      result = Refused
   :: kind == Reload && State_Open && State_Mode != Started_With_Watchdog
   :: else ->
      if
#ifndef MUTANT_NO_STOP_ON_LEAVING
      :: (kind == Close_Line || kind == Reset) &&
         State_Mode != Not_Started ->
         Exchange (Stop);
         if
         :: reply == Silence && !Is_Lost -> Exchange (Stop)
         :: else
         fi
#endif
      :: else
      fi;
      if
      :: Is_Lost
      :: !Is_Lost && kind == Close_Line -> Close_Device ()
      :: !Is_Lost && kind != Close_Line ->
         Exchange (kind);
         if
         :: reply == Silence -> result = Failed
         :: reply == Accepted && kind == Start -> State_Mode = Started
         :: reply == Accepted && kind == Start_Watchdog ->
            State_Mode = Started_With_Watchdog
         :: reply != Silence && kind == Reset ->
            State_Mode = Not_Started;
            result = (reply == Accepted -> Done : Refused)
         :: reply == Denied && kind == Reload ->
            result = Refused;
            Exchange (Query);                    /* does it move? */
            if
            :: reply == Silence -> result = Failed
            :: reply == Accepted                 /* yes */
            :: reply != Silence ->               /* no: does it run? */
               Exchange (Stop);
               if
               :: reply == Denied -> State_Mode = Not_Started
               :: reply == Silence -> result = Failed
               :: else
               fi
            fi
         :: reply == Denied && (kind == Drive || kind == Stop) &&
            State_Mode != Not_Started ->
            Exchange (Stop);                     /* does it run? */
            if
            :: reply == Denied -> State_Mode = Not_Started; result = Refused
            :: reply == Silence -> result = Failed
            :: else -> result = (kind == Stop -> Done : Refused)
            fi
         :: else -> result = (reply == Accepted -> Done : Refused)
         fi
      fi;
      if
      :: Is_Lost ->
#ifndef MUTANT_NO_STOP_ON_LOST_LINE
         Write (Stop);
#endif
         Close_Device ();
         result = Failed
      :: else
      fi
   fi;
   reply = Accepted;
   blind = false
}

inline Choose (who) {
   from = who;
   kind = L.Kind [who];
   number = L.Number [who];
   rank = L.Rank [who];
   verdict = (Is_Old (who) -> Out_Of_Date :
             (who == Robot_Clients_Move && number < L.Last_Stop &&
              number != 0 -> Overtaken : Carry_Out));
#ifdef MISSION
#ifndef MUTANT_OLD_MOVEMENT_CARRIED_OUT
   verdict = (who == Robot_Clients_Move && verdict == Carry_Out
              && number < L.Last_Mission -> Overtaken : verdict);
#endif
#ifndef MUTANT_MISSION_NOT_OVERTAKEN
   verdict = (who == Robot_Clients_Mission && verdict == Carry_Out
              && number < L.Last_Hand -> Overtaken : verdict);
#endif
   verdict = (who == Robot_Clients_Mission && verdict == Carry_Out
              && L.Too_Old && Can_Be_Late (kind) -> Late : verdict);
   L.Too_Old = false;
#endif
#ifdef MUTANT_OLD_ORDER_CARRIED_OUT
   verdict = (verdict == Out_Of_Date -> Carry_Out : verdict);
#endif
#ifdef MUTANT_OVERTAKEN_CARRIED_OUT
   verdict = (verdict == Overtaken -> Carry_Out : verdict);
#endif
   L.Pending [who] = false;
   L.Number [who] = 0;
   L.Rank [who] = 0;
   L.After [who] = 0;
   L.Kind [who] = 0;
   found = true
}

#define May(c)  (L.Pending [c] && In_Turn (c))

inline Choose_Of_The_Rest () {
   best = CLIENTS;
   k = Robot_Clients_Open;
   do
   :: k <= Robot_Clients_Query ->
      if
      :: May (k) &&
         (best == CLIENTS || L.Number [k] < L.Number [best]) ->
         best = k
      :: else
      fi;
      k++
   :: else -> break
   od;
   k = 0;
   if
   :: best < CLIENTS -> Choose (best)
   :: best == CLIENTS && L.Pending [Robot_Clients_Keep_Alive] ->
      Choose (Robot_Clients_Keep_Alive)
   :: else
   fi;
   best = 0
}

/* A stop behind a stop changes nothing: a reload that waits goes between */
#if defined (MUTANT_STOPS_STARVE_RELOAD) || defined (MUTANT_RELOAD_LAST)
#define Reload_First  false
#else
#define Reload_First  (after_stop && L.Pending [Robot_Clients_Reload])
#endif

inline Take_Job () {
   found = false;
   if
   :: L.Pending [Robot_Clients_Safe_State] ->
      Choose (Robot_Clients_Safe_State)
   :: else ->
      if
      :: len (Stops) > 0 && !Reload_First ->
         Stops ? number;
         from = Stop_Order;
         kind = Stop;
         verdict = Carry_Out;
         found = true
#ifndef MUTANT_RELOAD_LAST
      :: (len (Stops) == 0 && L.Pending [Robot_Clients_Reload]) ||
         Reload_First ->
         Choose (Robot_Clients_Reload)
      :: len (Stops) == 0 && !L.Pending [Robot_Clients_Reload] &&
         May (Robot_Clients_Move) ->
         Choose (Robot_Clients_Move)
#ifdef MISSION
      :: len (Stops) == 0 && !L.Pending [Robot_Clients_Reload] &&
         !May (Robot_Clients_Move) && May (Robot_Clients_Mission) &&
         (!Quiet || L.Kind [Robot_Clients_Mission] == Stop) ->
         Choose (Robot_Clients_Mission)
#endif
#else
      :: len (Stops) == 0 && May (Robot_Clients_Move) ->
         Choose (Robot_Clients_Move)
      :: len (Stops) == 0 && !May (Robot_Clients_Move) &&
         !May (Robot_Clients_Reset) && !May (Robot_Clients_Start_Watchdog) &&
         L.Pending [Robot_Clients_Reload] ->
         Choose (Robot_Clients_Reload)
#endif
      :: else ->
         if
         :: Quiet
         :: !Quiet && L.Pending [Robot_Clients_Battery] ->
            Choose (Robot_Clients_Battery)
         :: !Quiet && !L.Pending [Robot_Clients_Battery] ->
            Choose_Of_The_Rest ()
         fi
      fi
   fi;
   if
   :: found -> after_stop = (from == Stop_Order)
   :: else
   fi
}

/* More waits that is in turn: the owner wakes itself, for it waits for its
   event before it takes. Nobody else looks at that event, so to set it is no
   step of its own. */
inline Wake_For_More () {
   more = len (Stops) > 0;
   k = 0;
   do
   :: k < CLIENTS -> more = more || May (k); k++
   :: else -> break
   od;
   k = 0;
   if
   :: more -> Set_Event (Robot_Line_Work)
   :: else
   fi;
   more = false
}

/* What has come of it, Collect, is data */
inline Finish_Job () {
   /*: Line.Line.Finish */
   L.Open = State_Open;
   L.Mode = State_Mode;
   if
   :: (kind == Start || kind == Start_Watchdog) &&
      verdict == Carry_Out && result == Done ->
      L.New_Epoch [Robot_Clients_Reload] = true;
      L.New_Epoch [Robot_Clients_Battery] = true;
      L.New_Epoch [Robot_Clients_Keep_Alive] = true;
      L.Reload_Due = Far;
      Reloaded = false;
      started = true
   :: else
   fi;
   if
   :: number >= L.Session && rank > 0 ->
#ifdef MUTANT_OVERTAKEN_NOT_COMPLETED
      if :: verdict == Carry_Out -> L.Completed++ :: else fi;
#else
      L.Completed++;
#endif
      if
      :: Changes_Session (kind) -> L.Changed = rank
      :: else
      fi
   :: else
   fi;
#ifndef MUTANT_MORE_REQUESTS_FORGOTTEN
   Wake_For_More ();
#endif
#ifdef MISSION
   Carried_Out ();
#endif
   /* where the robot has not been started, it has been stopped */
   assert (State_Mode != Not_Started || !Stop_Owed)
}

active proctype Th_Line ()
{
#if defined (BEGINS_STARTED)
   bool State_Open = true;
   mtype:mode State_Mode = Started;
#elif !defined (MISSION)
   bool State_Open;
   mtype:mode State_Mode = Not_Started;
#endif
   bool found, blind, after_stop, started, more;
   byte Failures, from, number, rank, best;
   mtype:request kind;
   mtype:verdict verdict = Carry_Out;
   mtype:outcome result = Done;
   mtype:reply reply = Accepted;
   Whole_Line
wait:
   atomic {
      Wait_For_Work (Robot_Line_Work);
      /* take and carry out: nobody else sees what happens on the line
         meanwhile, and what arrives meanwhile might have come before. A
         wake-up that finds nothing that may go waits again */
      /*: Line.Line.Take */
      d_step { Take_Job () }
      if
      :: !found -> goto wait
      :: found && verdict == Carry_Out -> Carry_Out_Request ()
      :: found && verdict != Carry_Out -> result = Refused
      fi;
      found = false
#ifndef MISSION
   };
#ifdef EVENTS_AT_ONCE
   atomic {
#endif
#else
      ;
#endif
#ifdef EVENTS_AT_ONCE
      d_step { Finish_Job () }
      if
      :: !started -> goto tell
      :: else
      fi
   };
#else
   d_step { Finish_Job () }
#endif
   if
   :: started -> started = false; Tell_Of_Start ()
   :: else
   fi;
tell:
#ifndef EVENTS_AT_ONCE
   if
   :: number > 0 -> Monitor_Outbox_Answer (number)
   :: else
   fi;
#endif
   atomic {
#ifdef MISSION
      if
      :: number > 0 && from != Robot_Clients_Mission ->
         Monitor_Outbox_Answer (number)
      :: else
      fi;
#endif
      if
      :: from == Stop_Order
#ifdef MUTANT_FINISHED_NOT_TOLD
      :: from == Robot_Clients_Reload
#endif
#ifdef MUTANT_ORDER_TASK_NOT_TOLD
      :: number > 0
#endif
      :: else -> Set_Event (Robot_Line_Clients_Finished [from])
      fi;
      Tell_Of ();
      from = 0; kind = 0; number = 0; rank = 0;
      verdict = Carry_Out; result = Done;
      goto wait
   }
}
