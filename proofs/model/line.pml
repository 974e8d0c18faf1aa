/* SPDX-License-Identifier: GPL-3.0-or-later
   The robot's line, its requests and the task that has it, for orders.pml,
   periodic.pml and mission.pml (which says MISSION): Robot.Line,
   Robot.Session, Robot.Exchange, Robot.Service. */

#define MAX_FAILURES  2   /* in a row, and the line is lost; the code's 4
                             and the figure itself are proved by contract */
#define LEAVE_TRIES   1   /* the code's 3: one less than MAX_FAILURES */

/* The events of the tasks that use the line */
#define Robot_Line_Monitor_Lost   0   /* event */
#define Robot_Line_Start_WD       1   /* event */
#define Robot_Line_Move           2   /* event */
#define Robot_Line_Mission        3   /* event */
#define Robot_Line_Battery        4   /* event */
#define Robot_Line_Open_Com       5   /* event */
#define Robot_Line_Start          6   /* event */
#define Robot_Line_Reset          7   /* event */
#define NOBODY                     8
EVENTS (Robot_Line, NOBODY);
#define Granted(who)  Robot_Line [who]

mtype:source  = { Of_End, Of_Stop, Of_Reload, Of_Movement, Of_Mission,
                  Of_Battery, Of_Order, Of_Ping };
mtype:request = { Open_Line, Close_Line, Start, Start_Watchdog, Reset,
                  Drive, Stop, Reload, Query, Keep_Alive };
                  /* Query: ping, battery, state; Reset: power off too */
mtype:verdict = { Carry_Out, Overtaken, Out_Of_Date, Late };
mtype:outcome = { Done, Refused, Failed };
mtype:mode    = { Not_Started, Started, Started_With_Watchdog };
mtype:reply   = { Accepted, Denied, Silence };
mtype:due     = { Far, Near, Past };

/* The requests, and the known state of the robot */
typedef Robot_Line_Grant_Type {
   byte Has = NOBODY;            /* the task that has the line */
   bool Ends;                    /* the request of the session's end */
   bool After_Stop;              /* the last one was a monitor's stop */
   byte Last_Stop;
   byte Last_Change;
   byte Session = 1;
   mtype:due Reload_Due = Far;   /* Near: in the quiet time before it */
   bool Battery_Due;
   bool Ping_Due;
   bool Open;
   mtype:mode Mode = Not_Started;
#ifdef MISSION
   bool Asks;                    /* the mission */
   mtype:request Asked;          /* what for */
   byte Last_Mission;            /* that has made a request */
   byte Last_Hand;
   bool Too_Old;                 /* the mission's request, by now */
#endif
   /* the dialogue, in the hands of who has the line: line and robot */
#ifdef BEGINS_STARTED
   bool Is_Open = true;
   mtype:mode Runs = Started;
#else
   bool Is_Open;
   mtype:mode Runs = Not_Started;
#endif
   byte Failures;
   /* and the request that is carried out */
   mtype:source  From;
   mtype:request Kind;
   byte Number;
   mtype:verdict Verdict = Carry_Out;
   mtype:outcome Result = Done
};
PROTECTED (Robot_Line_Grant);
#define L  Robot_Line_Grant

/* The monitor's orders */
chan Stops  = [STOPS] of { byte };
chan Moves  = [STOPS] of { byte, byte };            /* number, after */
chan Others = [STOPS] of { byte, mtype:request };

#define Changes_Session(k) \
   (k == Open_Line || k == Close_Line || k == Start \
    || k == Start_Watchdog || k == Reset)

#ifdef MUTANT_STOP_TOO_LATE
#define Can_Be_Late(kind)  true
#else
#define Can_Be_Late(kind)  (kind != Stop)
#endif

/* Within one step only */
hidden byte k;
hidden byte move;
hidden byte after;
hidden byte other;
hidden mtype:request change;
hidden mtype:source best;

/* In periodic.pml orders have no numbers, as if each were in turn */
#ifdef UNNUMBERED
#define Up_To(number, other)  false
#else
#define Up_To(number, other)  (number <= other)
#endif

#define Is_Quiet       (L.Mode == Started_With_Watchdog && L.Reload_Due != Far)
#ifdef MUTANT_RELOAD_LAST
#define Reload_Goes    (L.Mode == Started_With_Watchdog \
                        && L.Reload_Due == Past && !Move_Goes && !Other_Goes)
#else
#define Reload_Goes    (L.Mode == Started_With_Watchdog \
                        && L.Reload_Due == Past)
#endif
/* A stop behind a stop changes nothing: a reload that waits goes between */
#ifdef MUTANT_STOPS_STARVE_RELOAD
#define Stop_Goes      (len (Stops) > 0)
#else
#define Stop_Goes      (len (Stops) > 0 && !(L.After_Stop && Reload_Goes))
#endif
#define Move_Goes      (move > 0 && !(other > 0 && Up_To (other, after)))
#define Mission_Goes   (L.Asks && (!Is_Quiet || L.Asked == Stop) \
                        && !(move > 0 && Up_To (move, L.Last_Mission)) \
                        && !(other > 0 && Up_To (other, L.Last_Mission)))
#define Other_Goes     (other > 0 && !Is_Quiet \
                        && !(Changes_Session (change) && move > 0 \
                             && Up_To (move, other)))

/* The most urgent request that may start, and its task; to stays NOBODY
   where there is none */
inline Choose () {
   move = 0; after = 0; other = 0; change = Query;
   if :: len (Moves) > 0 -> Moves ? <move, after> :: else fi;
   if :: len (Others) > 0 -> Others ? <other, change> :: else fi;
   if
#ifdef MUTANT_TWO_WITH_THE_LINE
   :: false
#else
   :: L.Has != NOBODY
#endif
   :: else ->
      if
      :: L.Ends -> best = Of_End; to = Robot_Line_Monitor_Lost
      :: else ->
         if
         :: Stop_Goes -> best = Of_Stop; to = Robot_Line_Move
         :: !Stop_Goes && Reload_Goes ->
            best = Of_Reload; to = Robot_Line_Start_WD
         :: !Stop_Goes && !Reload_Goes && Move_Goes ->
            best = Of_Movement; to = Robot_Line_Move
         :: else ->
            if
#ifdef MISSION
            :: Mission_Goes -> best = Of_Mission; to = Robot_Line_Mission
            :: !Mission_Goes && Other_Goes ->
#else
            :: L.Battery_Due && !Is_Quiet ->
               best = Of_Battery; to = Robot_Line_Battery
            :: !(L.Battery_Due && !Is_Quiet) && Other_Goes ->
#endif
               best = Of_Order;
               to = (change == Start -> Robot_Line_Start :
                    (change == Start_Watchdog -> Robot_Line_Start_WD :
                    (change == Reset -> Robot_Line_Reset :
                     Robot_Line_Open_Com)))
#ifndef MISSION
            :: !(L.Battery_Due && !Is_Quiet) && !Other_Goes &&
               L.Ping_Due && !Is_Quiet ->
               best = Of_Ping; to = Robot_Line_Open_Com
#endif
            :: else
            fi
         fi
      fi
   fi;
   move = 0; after = 0; other = 0; change = Query
}

/* What has been written to the robot */
bool Stop_Owed  = false;  /* a movement, and no stop since */
bool Nobody     = false;  /* the session's end has been carried out */
bool Is_Due     = false;  /* the reload of this run */
bool Reloaded   = false;  /* since it became due last */

#ifdef MISSION
byte Hand   = 0;      /* the last order by hand that has been dispatched */
byte Drove  = 0;      /* the last mission with a movement on the line */
bool Drives = false;  /* that movement is the last that the robot got */

inline Wrote (what) {
   if
   :: L.From == Of_Mission && (what == Drive || what == Stop) ->
      /* never after an order of the hand has been dispatched */
      assert (L.Number > Hand);
      Drove = L.Number;
      Drives = (what == Drive)
   :: L.From == Of_Movement && what == Drive ->
      /* nor does a movement of the hand from before the mission go out when
         the mission drives */
      assert (L.Number > Drove);
      /* or waits for it */
      assert (L.Number > L.Last_Mission);
      Drives = false
   :: what == Stop && L.From != Of_Mission -> Drives = false
   :: else
   fi
}

/* When an order of the hand has been carried out, nothing is left of what the
   mission ordered */
inline Carried_Out () {
   assert (!(Drives && L.Verdict == Carry_Out && L.Result == Done
             && L.Number == L.Last_Hand && L.From != Of_Mission
             && L.Number != 0))
}
#endif

inline Write (what) {
#ifdef MISSION
   Wrote (what);
#endif
   if
   :: what == Drive ->
      assert (L.Runs != Not_Started);
      assert (!Nobody);
      assert (L.Number > L.Last_Stop || L.Last_Stop == 0
              || L.Number < L.Session || len (Stops) > 0);
      Stop_Owed = true
   :: what == Stop -> Stop_Owed = false
   :: what == Reload ->
      /* never one of the run before */
      assert (Is_Due);
      Is_Due = false;
      Reloaded = true
   :: else
   fi
}

mtype:reply reply = Accepted;
bool blind = false;

inline Fail () {
   L.Failures++;
   reply = Silence
}

/* Robot.Session.Begin_Exchange and what follows. Whether the robot
   answers, refuses or is silent is free at each exchange. */
inline Exchange (what) {
   reply = Accepted;
   if
   :: L.Failures > 0 ->
      if
      :: what == Stop && !blind -> Write (Stop); blind = true
      :: else
      fi;
      if
      :: L.Failures = 0            /* the probe is answered */
      :: Fail ()
      fi
   :: else
   fi;
   if
   :: reply != Silence ->
      Write (what);
      if
      :: !(what == Start || what == Start_Watchdog) ||
         L.Runs == Not_Started -> reply = Accepted
      :: reply = Denied
      :: Fail ()
      fi
   :: else
   fi
}

#define Is_Lost  (L.Failures == MAX_FAILURES)

inline Close_Device () {
   L.Is_Open = false;
   L.Runs = Not_Started;
   L.Failures = 0
}

inline Carry_Out_Request () {
   /*: Robot.Exchange.Carry_Out */
   /* no order of a session that has ended, but for a stop */
   assert (L.Number == 0 || L.Number >= L.Session || L.Kind == Stop);
   blind = false;
   L.Result = Done;
   if
   :: L.Kind == Open_Line && !L.Is_Open ->
      if
      :: L.Is_Open = true; Exchange (Reset)
      :: L.Result = Failed
      fi
   :: L.Kind == Close_Line && !L.Is_Open
   :: L.Kind != Open_Line && L.Kind != Close_Line && !L.Is_Open ->
      L.Result = Failed
   :: L.Kind == Drive && L.Is_Open && L.Runs == Not_Started ->
      L.Result = Refused
   :: L.Kind == Reload && L.Is_Open && L.Runs != Started_With_Watchdog
   :: else ->
      if
#ifndef MUTANT_NO_STOP_ON_LEAVING
      :: (L.Kind == Close_Line || L.Kind == Reset) &&
         L.Runs != Not_Started ->
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
      :: !Is_Lost && L.Kind == Close_Line -> Close_Device ()
      :: !Is_Lost && L.Kind != Close_Line ->
         Exchange (L.Kind);
         if
         :: reply == Silence -> L.Result = Failed
         :: reply == Accepted && L.Kind == Start -> L.Runs = Started
         :: reply == Accepted && L.Kind == Start_Watchdog ->
            L.Runs = Started_With_Watchdog
         :: reply != Silence && L.Kind == Reset ->
            L.Runs = Not_Started;
            L.Result = (reply == Accepted -> Done : Refused)
         :: reply == Denied && L.Kind == Reload ->
            L.Result = Refused;
            Exchange (Query);                    /* does it move? */
            if
            :: reply == Silence -> L.Result = Failed
            :: reply == Accepted                 /* yes */
            :: reply != Silence ->               /* no: does it run? */
               Exchange (Stop);
               if
               :: reply == Denied -> L.Runs = Not_Started
               :: reply == Silence -> L.Result = Failed
               :: else
               fi
            fi
         :: reply == Denied && (L.Kind == Drive || L.Kind == Stop) &&
            L.Runs != Not_Started ->
            Exchange (Stop);                     /* does it run? */
            if
            :: reply == Denied -> L.Runs = Not_Started; L.Result = Refused
            :: reply == Silence -> L.Result = Failed
            :: else -> L.Result = (L.Kind == Stop -> Done : Refused)
            fi
         :: else -> L.Result = (reply == Accepted -> Done : Refused)
         fi
      fi;
      if
      :: Is_Lost ->
#ifndef MUTANT_NO_STOP_ON_LOST_LINE
         Write (Stop);
#endif
         Close_Device ();
         L.Result = Failed
      :: else
      fi
   fi;
   reply = Accepted;
   blind = false
}


inline Set_Verdict () {
   L.Verdict =
      (L.Number != 0 && L.Number < L.Session && L.From != Of_Stop ->
          Out_Of_Date :
      (L.From == Of_Movement && L.Number < L.Last_Stop -> Overtaken :
       Carry_Out));
#ifdef MISSION
#ifndef MUTANT_OLD_MOVEMENT_CARRIED_OUT
   L.Verdict = (L.From == Of_Movement && L.Verdict == Carry_Out
                && L.Number < L.Last_Mission -> Overtaken : L.Verdict);
#endif
#ifndef MUTANT_MISSION_NOT_OVERTAKEN
   L.Verdict = (L.From == Of_Mission && L.Verdict == Carry_Out
                && L.Number < L.Last_Hand -> Overtaken : L.Verdict);
#endif
   L.Verdict = (L.From == Of_Mission && L.Verdict == Carry_Out && L.Too_Old
                && Can_Be_Late (L.Kind) -> Late : L.Verdict);
   L.Too_Old = L.Too_Old && L.From != Of_Mission;
#endif
#ifdef MUTANT_OLD_ORDER_CARRIED_OUT
   L.Verdict = (L.Verdict == Out_Of_Date -> Carry_Out : L.Verdict);
#endif
#ifdef MUTANT_OVERTAKEN_CARRIED_OUT
   L.Verdict = (L.Verdict == Overtaken -> Carry_Out : L.Verdict)
#endif
}

inline Take_Line (who) {
   Choose ();
   if
   :: to == who ->
      /* never two */
      assert (L.Has == NOBODY);
      L.Has = who;
      L.From = best;
      L.After_Stop = (best == Of_Stop);
      found = true;
      if
      :: best == Of_End -> L.Ends = false; L.Kind = Close_Line
      :: best == Of_Stop -> Stops ? L.Number; L.Kind = Stop
      :: best == Of_Movement -> Moves ? L.Number, _; L.Kind = Drive
      :: best == Of_Order -> Others ? L.Number, L.Kind
#ifdef MISSION
      :: best == Of_Mission ->
         L.Asks = false; L.Number = L.Last_Mission; L.Kind = L.Asked
#else
      :: best == Of_Reload -> L.Kind = Reload
      :: best == Of_Battery -> L.Kind = Query
      :: best == Of_Ping -> L.Kind = Keep_Alive
#endif
      fi;
      Set_Verdict ()
   :: else
   fi;
   to = NOBODY;
   best = 0
}

/* The task that is to be woken. A task that is woken, and whose turn it is no
   more, waits again */
inline Wake () {
   if
   :: to != NOBODY -> Set_Event (Robot_Line [to]); to = NOBODY
   :: else
   fi
}

/* Robot.Service.Serve up to the robot's answer. Take and carry out: nobody else
   sees what happens on the line meanwhile, and what arrives meanwhile might
   have come before */
inline Take_Up (who) {
   /*: Line.Grant.Take */
   d_step { Take_Line (who) }
   if
   :: !found -> goto not_mine
   :: found && L.Verdict == Carry_Out -> found = false; Carry_Out_Request ()
   :: found && L.Verdict != Carry_Out -> found = false; L.Result = Refused
   fi
}

inline Finish_Line (who) {
   assert (L.Has == who);
   L.Open = L.Is_Open;
   L.Mode = L.Runs;
#ifdef MISSION
   Carried_Out ();
#endif
   /* where the robot has not been started, it has been stopped */
   assert (L.Runs != Not_Started || !Stop_Owed);
   L.Ping_Due = false;
   if
   :: (L.Kind == Start || L.Kind == Start_Watchdog) &&
      L.Verdict == Carry_Out && L.Result == Done ->
#ifndef MUTANT_RELOAD_OF_OLD_RUN
      L.Reload_Due = Far;
#endif
      L.Battery_Due = false;
      Is_Due = false;
      started = true
   :: L.From == Of_Reload -> L.Reload_Due = Far
   :: L.From == Of_Battery -> L.Battery_Due = false
   :: else
   fi;
   number = (L.From == Of_Mission -> 0 : L.Number);
   L.From = 0; L.Kind = 0; L.Number = 0;
   L.Verdict = Carry_Out; L.Result = Done;
#ifndef MUTANT_LINE_KEPT
   L.Has = NOBODY;
#endif
   Choose ();
   best = 0;
#ifdef MUTANT_NEXT_NOT_WOKEN
   to = NOBODY
#endif
}

/* What a task says of its request. After a start the periodic tasks look */
inline Tell_Of_Start () {
#ifndef MUTANT_BATTERY_NOT_BEGUN
   Set_Event (Robot_Line [Robot_Line_Battery]);
#endif
   Set_Event (Robot_Line [Robot_Line_Open_Com])
}
inline Tell_Level () {
   if
   :: /*: Monitor.Outbox.Put in outbox */ skip
   :: skip
   fi
}
inline Tell_Of () {
   if
   :: /*: Monitor.Outbox.Put in outbox */ skip
   :: /*: Monitor.Outbox.Put in outbox, Monitor.Outbox.Put in outbox */ skip
   :: skip
   fi
}

/* The rest of it */
inline Give_Back (who) {
#ifdef EVENTS_AT_ONCE
   atomic {
#endif
   /*: Line.Grant.Finish */
   d_step { Finish_Line (who) }
   Wake ();
   if
   :: started -> started = false; Tell_Of_Start ()
   :: else
   fi;
   if
   :: number > 0 -> Monitor_Outbox_Answer (number); number = 0
   :: else -> Tell_Level ()
   fi;
   Tell_Of ()
#ifdef EVENTS_AT_ONCE
   }
#endif
}

#define USER        byte number, to = NOBODY; bool found, started
#define TIMED_USER  USER, was_set, timed

/* What each of these tasks does, at its label wait: without the clock, and with
   it. The time comes where due is true; there is one where has_time is */
inline Serve (who) {
   atomic {
      Wait_For_Work (Robot_Line [who]);
      Take_Up (who)
   };
   Give_Back (who);
not_mine:
   goto wait
}

inline Serve_Or_Look (who, due, has_time) {
   atomic {
      Wait_Until_Due (Robot_Line [who], timed && due);
      if
      :: was_set -> was_set = false; Take_Up (who)
      :: else -> goto not_mine
      fi
   };
   Give_Back (who);
not_mine:
   atomic {
      /*: Line.Grant.Look */
      d_step {
         Choose ();
         best = 0;
#ifndef MUTANT_RELOAD_NOT_LOOKED_AT
         timed = has_time
#endif
      }
      Wake ();
      goto wait
   }
}
