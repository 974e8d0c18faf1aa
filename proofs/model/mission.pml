/* SPDX-License-Identifier: GPL-3.0-or-later
   A mission beside the hand: the one place of the missions, th_mission as a
   user of the robot's line, orders of the hand, the loss of robot and
   camera, the end of the session and the next one. */

#include "common.pml"

#ifndef COMMANDS
#define COMMANDS  3      /* in the first session */
#endif
#ifndef LATER
#define LATER     1      /* in the second one; 0: there is none */
#endif
#ifndef STEPS
#define STEPS     2      /* requests of a mission before its stop, at most */
#endif
#ifdef ASKS
#define IS_LOST   0      /* the monitor, at any time; else it stays */
#else
#define IS_LOST   1
#endif
#define CAPACITY  2      /* that may wait for their answers */
#define STOPS     (CAPACITY + 1)
#define STOP_TRIES  2    /* the code's 3 */

#define NUMBERS   (COMMANDS + LATER + 1)
#define Limit     (In_First -> COMMANDS : LATER)
bool In_First = true;   /* session */

/* Monitor.Outbox, as far as missions need it: see outbox.pml */
bool Monitor_Outbox_Open = false;
byte First         = 1;      /* number of the session's first command */
byte Next          = 1;      /* of the next command */
byte Waiting       = 0;      /* commands without answer, in the session */
bool Unanswered [NUMBERS] = false;
byte End_Waits     = 0;      /* the MEND that waits to be sent: its mission */

/* Ghosts */
byte Ends_Owed     = 0;      /* the mission acknowledged, its MEND not sent */

inline Answer (its_number) {
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

inline Monitor_Outbox_Answer (its_number) {
   /*: Monitor.Outbox.Answer in outbox */
   Answer (its_number)
}

#define MISSION

#define EVENTS_AT_ONCE         /* as separate steps: see orders.pml */
#include "line.pml"

/* Checked in parts: orders of the hand are stops and movements; with
   -DCHANGES, stops and what changes the robot's session; with -DASKS movements
   and questions, which are no orders of the hand */

#if defined (CHANGES) || defined (ASKS)
active proctype Th_Open_Com_Robot ()
{
   TIMED_USER;
wait:
   Serve_Or_Look (Robot_Line_Open_Com, false, false)
}

#endif
active proctype Th_Move ()
{
   USER;
wait:
   Serve (Robot_Line_Move)
}

/* Missions.Requests: the one place of a mission, that waits or is under way */

typedef Missions_Requests_Place_Type {
   byte Mission;         /* that waits or is under way, 0: none */
   bool Waits            /* th_mission has not taken it */
};
PROTECTED (Missions_Requests_Place);
EVENT (Missions_Requests_Arrived);
EVENT (Vision_State_Searched);
#define MR         Missions_Requests_Place
#define Is_Started  (L.Mode != Not_Started)

typedef Vision_State_Store_Type { bool Watched };
PROTECTED (Vision_State_Store);

/* Images come at any time, or no more. As a time ends the wait for the next,
   too, they make no difference: with -DIMAGES only */
#ifdef IMAGES
active proctype Th_Capture_Img ()
{
   bool awaited;
end_wait:
   do
   :: Vision_State_Store.Watched;
      do
      :: /*: State.Store.Put */
         awaited = Vision_State_Store.Watched;
         if
         :: awaited -> Set_Event (Vision_State_Searched)
         :: else -> skip
         fi
      :: !Vision_State_Store.Watched -> break
      od;
      awaited = false
   od
}
#endif

/* By hand, or the session is over: it sends no more */
#define Overridden(m)  (m < L.Last_Hand || m < L.Session)

/* Whether the request waits too long is free */
inline Ask (what) {
   /*: Line.Grant.Put */
   if
   :: L.Too_Old = true
   :: L.Too_Old = false
   fi;
   d_step {
      L.Asks = true;
      L.Asked = what;
      L.Last_Mission = mission;
      Choose ();
      best = 0
   }
   Wake ()
}

#if defined (MUTANT_END_TO_NEXT_SESSION)
#define Goes_Out(m)  Monitor_Outbox_Open
#elif defined (MUTANT_END_NOT_TOLD)     /* of a robot that is lost */
#define Goes_Out(m)  (m >= First && Monitor_Outbox_Open && Is_Started)
#else
#define Goes_Out(m)  (m >= First && Monitor_Outbox_Open)
#endif

inline Release () {
   /*: Place.Release */
   MR.Mission = 0
}

/* There is room for the next before the monitor is told */
inline Refuse () {
#ifdef MUTANT_REFUSED_BEFORE_RELEASE
   Monitor_Outbox_Answer (mission);
   Release ()
#else
   Release ();
   Monitor_Outbox_Answer (mission)
#endif
}

active proctype Th_Mission ()
{
   byte mission, left;
   bool ended;
   mtype:request what;
   USER;
   /*: whole */
wait:
   atomic {
      Wait_For_Work (Missions_Requests_Arrived);
      /*: Place.Take */
      if
      :: !MR.Waits -> goto wait
      :: else -> MR.Waits = false; mission = MR.Mission
      fi;
      /*: Box.Get, Line.Grant.Get_Rights */
      if
#ifdef MUTANT_UNTOLD_END_IGNORED
      :: mission < L.Session -> goto refuse
#else
      :: End_Waits != 0 || mission < L.Session -> goto refuse
#endif
      :: else
      fi
   };
   /* what stands against it: the robot; or the camera, its positions, the
      arena, the points, at any time */
   /*: Line.Grant.Get_Status, State.Store.Get, State.Store.Get_Sighting */
   atomic {
      if
      :: L.Mode == Not_Started -> goto deny
      :: L.Mode != Not_Started -> goto deny
      :: L.Mode != Not_Started
      fi
   };
   atomic {
      if
      :: mission >= First ->
         assert (Ends_Owed == 0);
         Ends_Owed = mission
      :: else
      fi;
      Monitor_Outbox_Answer (mission);
      /*: State.Store.Watch */
      Vision_State_Store.Watched = true;
      left = STEPS
   };
look:
   /* it goes on while nobody and nothing ends it */
   /*: Line.Grant.Get_Status, State.Store.Get, State.Store.Get_Sighting,
       Line.Grant.Get_Rights */
   atomic {
      if
      :: !ended && Overridden (mission) -> goto leave
      :: ended -> goto leave
      :: ended && left > 0 -> left--              /* the stop once more */
      :: !ended && !Overridden (mission) ->
         ended = true; what = Stop; left = STOP_TRIES - 1
#ifdef MUTANT_END_WITHOUT_STOP
      :: !ended && !Overridden (mission) -> goto leave
#endif
      :: !ended && !Overridden (mission) && Is_Started && left > 0 ->
         what = Drive; left--
#ifdef IMAGES
      :: !ended && !Overridden (mission) && Is_Started && left > 0 ->
         what = 0; left--
#endif
      fi
   };
   atomic {
      if
      :: /*: Monitor.Outbox.Put in outbox */ skip
      :: skip
      fi;
      if
      :: what != 0 -> Ask (what)
      :: else -> goto next
      fi
   };
turn:
   atomic {
      Wait_Event (Robot_Line [Robot_Line_Mission]);
      Take_Up (Robot_Line_Mission)
   };
   Give_Back (Robot_Line_Mission);
not_mine:
   if :: L.Asks -> goto turn :: else fi;
next:
   atomic { Wait_Until (Vision_State_Searched); goto look };
leave:
   atomic {
      /* the last thing that it sent was a stop */
      assert (!Drives || Overridden (mission));
      /*: State.Store.Watch */
      Vision_State_Store.Watched = false;
      ended = false; left = 0; what = 0;
#if !defined (MUTANT_RELEASED_AFTER_END) && !defined (MUTANT_NOT_RELEASED)
      Release ()
#endif
   };
   /*: Monitor.Outbox.Put in outbox */
   atomic {
      if
      :: Goes_Out (mission) ->
         assert (End_Waits == 0);
         End_Waits = mission
      :: else
      fi;
#ifndef MUTANT_RELEASED_AFTER_END
      mission = 0;
      goto wait
#endif
   };
#ifdef MUTANT_RELEASED_AFTER_END
   atomic { Release (); mission = 0; goto wait };
#endif
refuse:
   Refuse ();
   atomic { mission = 0; goto wait };
deny:
   Refuse ();
   atomic {
      mission = 0;
      /*: Monitor.Outbox.Put in outbox */
      goto wait
   }
}

/* Sends the MEND, when its turn comes */

active proctype Th_Send_To_Mon ()
{
end_wait:
   do
   :: atomic {
         End_Waits != 0 && Monitor_Outbox_Open ->
         /* the one MEND of the mission acknowledged, in its session */
         assert (End_Waits >= First && End_Waits == Ends_Owed);
         Ends_Owed = 0;
         End_Waits = 0
      }
   od
}

bool Free = true;         /* the session: see session.pml */
EVENT (Monitor_Session_Receive_Begins);
EVENT (Monitor_Session_Receive_Ended);
EVENT (Monitor_Session_Watch_Begins);

mtype:command = { Mission_Asked, Stop_Asked, Act_Asked, Other_Asked };

/* What an order of the hand asks for, and a robot order that is none: a line
   that is open stays so when it is opened */
#ifdef CHANGES
#define ACT    Close_Line
#define OTHER  Open_Line
#else
#define ACT    Drive
#define OTHER  Query
#endif

/* With the mutant, whatever the order is */
#ifdef MUTANT_OPENING_IS_BY_HAND
#define By_Hand  (command != Mission_Asked)
#else
#define By_Hand  (command == Stop_Asked || command == Act_Asked)
#endif

active proctype Th_Receive_From_Mon ()
{
   byte number, sent, to = NOBODY;
   mtype:command command;
   do
   :: Wait_For_Work (Monitor_Session_Receive_Begins);
end_receive:
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
            :: command = Mission_Asked
            :: command = Act_Asked
#ifndef ASKS
            :: command = Stop_Asked
#endif
#if defined (ASKS) || defined (CHANGES)
            :: command = Other_Asked
#endif
            fi
         };
         if
         :: atomic {
               command == Mission_Asked ->
               /*: Place.Put */
               if
               :: MR.Mission != 0 ->
                  /* never one that has been refused, or its end sent */
                  assert (MR.Mission < First || Unanswered [MR.Mission]
                          || Ends_Owed == MR.Mission);
                  Answer (number);
                  goto handled
               :: else ->
                  MR.Mission = number;
                  MR.Waits = true
               fi
            };
#ifndef MUTANT_REQUEST_WITHOUT_EVENT
            Set_Event (Missions_Requests_Arrived)
#else
            skip
#endif
         :: atomic {
               command != Mission_Asked ->
               /*: Line.Grant.Put */
               d_step {
                  if
                  :: command == Stop_Asked ->
                     Stops ! number; L.Last_Stop = number
                  :: command == Act_Asked && ACT == Drive ->
                     Moves ! number, L.Last_Change
                  :: else ->
                     Others ! number,
                        (command == Act_Asked -> ACT : OTHER);
                     if
                     :: Changes_Session (OTHER) -> L.Last_Change = number
                     :: else
                     fi
                  fi;
#ifndef MUTANT_HAND_NOT_NOTED
                  L.Last_Hand = (By_Hand -> number : L.Last_Hand);
#endif
                  Hand = (By_Hand -> number : Hand);
                  Choose ();
                  best = 0
               }
               Wake ()
            }
         fi;
handled: atomic { number = 0; command = 0 }
      od;
      sent = 0;
      Set_Event (Monitor_Session_Receive_Ended)
   od
}

active proctype Th_Server ()
{
   byte session;
   (Is_Awaited (Monitor_Session_Watch_Begins)
    && Is_Awaited (Monitor_Session_Receive_Begins)
    && Is_Awaited (Missions_Requests_Arrived)
#if defined (CHANGES) || defined (ASKS)
    && Is_Awaited (Robot_Line [Robot_Line_Open_Com])
#endif
    && Is_Awaited (Robot_Line [Robot_Line_Move]));
end_server:
   do
   :: session >= 1 + (LATER > 0) -> break
   :: /* Begin_Active, Admit: see session.pml */
      /*: Box.Open_Session */
      d_step {
         session < 1 + (LATER > 0) && Free ->
         Free = false;
         In_First = (session == 0);
         session++;
         Monitor_Outbox_Open = true;
         /* as if opened and started before */
         L.Is_Open = true;
         L.Runs = Started;
         L.Open = true;
         L.Mode = Started;
         Nobody = false
      }
      /* one after the other in session.pml */
      atomic {
         Set_Event (Monitor_Session_Receive_Begins);
         Set_Event (Monitor_Session_Watch_Begins)
      }
   od
}

active proctype Th_Com_Mon_Perdue ()
{
   USER;
   do
   :: Wait_For_Work (Monitor_Session_Watch_Begins);
      /* Wait_Loss: at any time, or never: then all is answered and told */
      if
      :: IS_LOST == 1
      :: true ->
         Waiting == 0 && MR.Mission == 0 && Ends_Owed == 0;
end_stays:
         false
      fi;
      /* Bring_Back */
      /*: Box.Close_Session */
      d_step {
         Monitor_Outbox_Open = false;
         First = Next;
         Waiting = 0;
         End_Waits = 0;
         Ends_Owed = 0;
         k = 1;
         do
         :: k < NUMBERS -> Unanswered [k] = false; k++
         :: else -> break
         od;
         k = 0
      }
      /*: Line.Grant.Begin_Session */
      d_step {
         L.Session = First;
         do :: Stops ? _ :: len (Stops) == 0 -> break od;
         do :: Moves ? _, _ :: len (Moves) == 0 -> break od;
         do :: Others ? _, _ :: len (Others) == 0 -> break od;
         L.Last_Stop = 0;
         L.Last_Hand = 0;
         L.Last_Change = 0
      }
      /*: Line.Grant.Put */
      d_step { L.Ends = true; Choose (); best = 0 }
      Wake ();
turn: atomic {
         Wait_Event (Robot_Line [Robot_Line_Monitor_Lost]);
         Take_Up (Robot_Line_Monitor_Lost)
      };
      Give_Back (Robot_Line_Monitor_Lost);
not_mine: if :: L.Ends -> goto turn :: else fi;
      Nobody = true;
      Wait_Event (Monitor_Session_Receive_Ended);
      assert (!Stop_Owed);
      Free = true
   od
}

/* every mission acknowledged is told its end, or the session ends */
ltl every_mission_ends
   { [] (Ends_Owed != 0 -> <> (Ends_Owed == 0)) }
/* the place of the mission becomes free again */
ltl place_free_again
   { [] (MR.Mission != 0 -> <> (MR.Mission == 0)) }
