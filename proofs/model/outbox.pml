/* SPDX-License-Identifier: GPL-3.0-or-later
   Commands and answers, the unasked messages and their hold, up to the end
   of a session and into the next. */

#include "common.pml"

#ifndef SESSIONS
#define SESSIONS  2
#endif
#ifndef COMMANDS
#define COMMANDS  2   /* in each session */
#endif
#ifndef CAPACITY
#define CAPACITY  1   /* commands that may wait for their answers */
#endif
#ifndef UNASKED
#define UNASKED   1   /* unasked messages, in all */
#endif

bool Shut      = false;   /* the connection, in either direction */
bool Reads     = false;   /* the monitor takes what it is sent */
bool Patient   = false;   /* it sends no more and waits for its answers */
bool Handling  = false;   /* a command has been received */
byte Owed      = 0;       /* answers that it has not got */

mtype:message = { Nothing, An_Answer, An_Unasked };
mtype:place   = { Awaited, Ready_Text, Ready_Nothing };
typedef Monitor_Outbox_Box_Type {
   bool Open;
   bool Busy;       /* what was taken last is being sent */
   mtype:place Places [CAPACITY] = Awaited;  /* the first is the oldest */
#if CAPACITY > 1
   byte Whose [CAPACITY];                    /* command's answer: ghost */
#endif
   byte Count;
   byte Head = 1;
   bool Unasked;    /* one that waits */
   bool Released;
   bool Answered;
   bool Holding;    /* Hold.On */
   bool Renewed     /* its end is later than the sender has seen */
};
PROTECTED (Monitor_Outbox_Box);
EVENT (Monitor_Outbox_Room);
EVENT (Monitor_Outbox_Work);

#define Box           Monitor_Outbox_Box
#define Answer_Waits  (Box.Count > 0 && Box.Places [0] != Awaited)

/* Monitor.Mailboxes.Next */
#define May_Answer \
   (Box.Open && Answer_Waits \
    && !(Box.Unasked && Box.Released && Box.Answered))
#define May_Tell \
   (Box.Open && Box.Unasked && (Box.Count == 0 || Box.Released))

inline Next_Place () {
#if CAPACITY > 1
   Box.Places [0] = Box.Places [1];
   Box.Whose [0] = Box.Whose [1];
#endif
#if CAPACITY > 2
   Box.Places [1] = Box.Places [2];
   Box.Whose [1] = Box.Whose [2];
#endif
#if CAPACITY > 1
   Box.Whose [CAPACITY - 1] = 0;
#endif
   Box.Places [CAPACITY - 1] = Awaited;
   Box.Count--;
   Box.Head++
}

inline Skip_Nothing () {
   do
   :: Box.Count > 0 && Box.Places [0] == Ready_Nothing -> Next_Place ()
   :: else -> break
   od
}

inline End_Quiet_Hold () {
   Box.Released = Box.Released && Box.Unasked;
   Box.Holding = Box.Holding && Box.Unasked;
   Box.Renewed = Box.Renewed && Box.Holding
}

/* a command or a message has just come, and the other waits */
inline Begin_Hold () {
   if
   :: Box.Unasked && Box.Count > 0 && !Box.Holding ->
      Box.Holding = true;
      Box.Renewed = true
   :: else
   fi
}

#if CAPACITY > 1
#define PLACE(at, number, item) \
   Box.Places [at] = item; Box.Whose [at] = number
#else
#define PLACE(at, number, item)  Box.Places [at] = item
#endif

inline Answer (number, item) {
#ifdef MUTANT_EVENT_BEFORE_STATE
   Set_Event (Monitor_Outbox_Work);
   Set_Event (Monitor_Outbox_Room);
#endif
   d_step {
      was_full = Box.Count == CAPACITY;
      if
      :: number >= Box.Head && number - Box.Head < Box.Count ->
         /* no command is answered twice */
         assert (Box.Places [number - Box.Head] == Awaited);
#ifdef MUTANT_ANSWERED_AS_DONE
         if
         :: Box.Places [0] == Awaited -> PLACE (0, number, item)
         :: else -> PLACE (1, number, item)
         fi;
#else
         PLACE (number - Box.Head, number, item);
#endif
         Skip_Nothing ()
      :: else
      fi
   }
#ifndef MUTANT_EVENT_BEFORE_STATE
#ifndef MUTANT_ANSWER_WITHOUT_EVENT
   Set_Event (Monitor_Outbox_Work);
#endif
   d_step {
      if
      :: was_full -> was_full = false; Set_Event (Monitor_Outbox_Room)
      :: else
      fi
   }
#endif
}

/* Orders on their way to the tasks that carry them out: see orders.pml and
   vision.pml. Here tasks that take any time, in any order. */

chan Dispatched = [CAPACITY] of { byte };

active [CAPACITY] proctype Executor ()
{
   byte number;
   bool was_full;
   /*: is Monitor.Outbox.Answer */
end_wait:
   do
   :: Dispatched ? number;
#ifdef STUCK
end_stuck:
      0;                  /* as an opening may that waits for its camera */
#endif
      /*: Box.Answer */
      Answer (number, Ready_Text);
      number = 0
   od
}

bool Free = true;         /* the session: see session.pml */
EVENT (Monitor_Session_Receive_Begins);
EVENT (Monitor_Session_Receive_Ended);
EVENT (Monitor_Session_Watch_Begins);

inline Ask_For_Mission () {
   /*: Place.Put in mission */
   if
   :: /*: Set_Event (Missions.Requests.Arrived) in mission */ skip
   :: skip
   fi
}

active proctype Th_Receive_From_Mon ()
{
   byte number, sent;
   bool open = true;
   bool was_full;
   /*: whole */
   do
   :: Wait_For_Work (Monitor_Session_Receive_Begins);
receive:
      /*: Connection.Receive + */
line: do
      :: atomic { Shut || !open -> break }
      :: atomic { !Patient && sent < COMMANDS && open ->
                  sent++; Handling = true };
reserve: /*: Box.Reserve */
         atomic {
            if
            :: !Box.Open -> open = false; goto reserved
            :: Box.Open && Box.Count < CAPACITY ->
               number = Box.Head + Box.Count;
               Box.Places [Box.Count] = Awaited;
               Box.Count++;
               Begin_Hold ();
               /* a hold that was on begins anew for this command */
               Box.Renewed = Box.Renewed || (Box.Holding && Box.Count == 1);
               goto reserved
            :: Box.Open && Box.Count == CAPACITY
            fi
         };
         atomic { Wait_Event (Monitor_Outbox_Room); goto reserve };
reserved:
         if
         :: !open
         :: open ->                                     /* Log_Message */
            /*: Box.Answer */
            Answer (number, Ready_Nothing)
         :: atomic {                        /* Malformed, or one mission too many */
               open -> Owed++;
               if
               :: Ask_For_Mission ()
               :: skip
               fi
            };
            /*: Box.Answer */
            Answer (number, Ready_Text)
         :: atomic {                                    /* Dispatch */
               open -> Owed++;
               assert (len (Dispatched) < CAPACITY);
               Dispatched ! number;
               if
               :: Ask_For_Mission ()
               :: /*: Vision.Turns.Put in vision */ skip
               :: /*: Robot.Line.Put in orders */ skip
               fi
            }
         fi;
         atomic {
            number = 0;
            Handling = false;
            if
            :: goto receive
            :: goto line
            fi
         }
      od;
      /*: Connection.Shut_Down in session */
      atomic { sent = 0; open = true };
      Set_Event (Monitor_Session_Receive_Ended)
   od
}

active proctype Th_Send_To_Mon ()
{
   mtype:message kind = Nothing;
   bool was_full;       /* when something was taken */
   bool gap;            /* what was sent last is too near for the next */
   bool held;           /* until when messages are held back is known */
   /*: whole */
wait:
   if
   :: !held -> Wait_For_Work (Monitor_Outbox_Work)
   :: atomic {
         held ->
         if
         :: Is_Set (Monitor_Outbox_Work)
         :: !Is_Set (Monitor_Outbox_Work) ->         /* the time has come */
            Box.Released = Box.Released || (Box.Holding && !Box.Renewed)
         fi;
         Wait_Until (Monitor_Outbox_Work)
      }
   fi;
look:
   /* what was taken before has been sent */
   /*: Box.Take */
   atomic {
      Box.Busy = false;
      was_full = Box.Count == CAPACITY;
      if
      :: Box.Holding -> Box.Released = true   /* the time has come meanwhile */
      :: skip
      fi;
      if
      :: /*: Set_Event (Sender_Left) in session */ skip
      :: skip
      fi;
      Box.Renewed = false;
#ifdef MUTANT_HOLD_WITHOUT_TIME
      held = false;
#else
      held = Box.Holding && !Box.Released;
#endif
      if
      :: !May_Answer && !May_Tell -> gap = false; goto taken
      :: (May_Answer || May_Tell) && gap -> goto taken
      :: May_Answer && !gap ->
         kind = An_Answer;
#if CAPACITY > 1
         /* it is that of the oldest command */
         assert (Box.Whose [0] == Box.Head);
#endif
         Box.Answered = true;
         Next_Place ();
         Skip_Nothing ()
      :: !May_Answer && May_Tell && !gap ->
         kind = An_Unasked;
         Box.Answered = false;
         Box.Unasked = false
      fi;
      Box.Busy = true;
      End_Quiet_Hold ()
   };
taken:
   atomic {
      if
      :: was_full -> was_full = false; Set_Event (Monitor_Outbox_Room)
      :: else
      fi;
      if
      :: /*: Set_Event (Arena_Room) in vision */ skip
      :: skip
      fi;
      if
      :: kind == Nothing && !gap -> goto wait
      :: kind == Nothing && gap ->
         /* until the gap is over */
         /*: delay */
         gap = false;
#ifdef MUTANT_GAP_WITHOUT_LOOK
         goto wait
#else
         goto look
#endif
      :: kind != Nothing
      fi
   };
   /*: Connection.Send */
   atomic {
      if
      :: Reads && !Shut ->
         assert (kind != An_Answer || Owed > 0);
         Owed = Owed - (kind == An_Answer)
      :: Shut
      fi;
      if
      :: /*: Connection.Shut_Down in session */ skip
      :: skip
      fi;
      kind = Nothing;
      if :: gap = true :: gap = false fi;
#ifdef MUTANT_SENT_WITHOUT_LOOK
      goto wait
#else
      goto look
#endif
   }
}

/* Robot and vision have something to say that nobody asked for */

active proctype Unasked_Source ()
{
   byte left = UNASKED;
   /*: is Monitor.Outbox.Put, Monitor.Outbox.Put_Image */
end_wait:
   do
   :: /*: Outbox.Box.Put | Outbox.Box.Put_Image */
      atomic {
         left > 0 && Box.Open -> left--;
         Box.Unasked = true;
#ifndef MUTANT_HOLD_NOT_BEGUN
         Begin_Hold ()
#endif
      };
      Set_Event (Monitor_Outbox_Work)
   od
}

active proctype Th_Server ()
{
   byte session;
   (Is_Awaited (Monitor_Session_Watch_Begins)
    && Is_Awaited (Monitor_Session_Receive_Begins)
    && Is_Awaited (Monitor_Outbox_Work));
   do
   :: session < SESSIONS ->
      /* Begin_Active, Admit: see session.pml */
      /*: Box.Open_Session */
      atomic {
         Free -> Free = false;
         session++;
         Box.Open = true;
         Box.Answered = false;
         Box.Unasked = false;
         End_Quiet_Hold ();
         Shut = false;
         Owed = 0
      };
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
      if
      :: Reads = true;
         if
         :: true
         :: /* exactly one answer each, else it waits for ever */
            Patient = true;
            atomic { Owed == 0 && !Handling -> Patient = false }
         :: /* or it never goes */
end_stays:  false
         fi
      :: Reads = false
      fi;
      /* lost; Bring_Back */
      /*: Connection.Shut_Down */
      atomic { Shut = true; Reads = false };
      /*: Box.Close_Session */
      atomic {
         Box.Open = false;
         Box.Head = Box.Head + Box.Count;
         Box.Count = 0;
         Box.Places [0] = Awaited;
         Box.Places [CAPACITY - 1] = Awaited;
#if CAPACITY > 1
         Box.Whose [0] = 0;
         Box.Whose [1] = 0;
#endif
         Box.Unasked = false;
         End_Quiet_Hold ()
      };
#ifndef MUTANT_CLOSE_WITHOUT_ROOM
      Set_Event (Monitor_Outbox_Room);
#endif
      /*: Robot.Service.Serve in orders + */
      !Box.Busy;                 /* Wait_Sender: see session.pml */
      Wait_Event (Monitor_Session_Receive_Ended);
      /*: Vision.Turns.Clear in vision */
      atomic {
         do
         :: Dispatched ? _
         :: len (Dispatched) == 0 -> break
         od;
         Free = true
      }
   od
}

ltl every_command_answered { [] (Patient -> <> !Patient) }
ltl unasked_not_held_for_ever { [] (Box.Unasked -> <> !Box.Unasked) }
