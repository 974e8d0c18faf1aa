/* SPDX-License-Identifier: GPL-3.0-or-later
   The vision: camera, periodic images and arena search, over the end of a
   session into the next, with a camera that may fail or hang. */

#include "common.pml"

#ifndef SESSIONS
#define SESSIONS  2
#endif
#ifndef COMMANDS
#define COMMANDS  3      /* in each session */
#endif
#define LATER     1      /* in the second one */
#define CAPACITY  2      /* that may wait for their answers */
#define SLOTS     6

mtype:order = { Open_Camera, Close_Camera, Ask_Position,
                Ask_Arena, Decide_Arena };

#define NUMBERS   (COMMANDS + LATER + 1)
#define Limit     (In_First -> COMMANDS : LATER)
bool In_First = true;   /* session */

/* Monitor.Outbox, as far as the vision needs it: see session.pml */
bool Monitor_Outbox_Open = false;
byte First       = 1;      /* number of the session's first command */
byte Next        = 1;      /* of the next command */
byte Waiting     = 0;      /* commands without answer, in the session */
bool Unanswered [NUMBERS] = false;
bool Image_For_Arena = false;     /* Arena_Length > 0 */
bool Made_Is_Now     = false;     /* th_capture_img's generation */
bool Images_Stopped  = false;     /* none may come: ghost */
bool Reads           = false;     /* the monitor takes what it is sent */
EVENT (Monitor_Outbox_Arena_Room);

bool In_Command = false;
bool Patient    = false;
bool All_Sent   = false;          /* the session's commands */
bool Ended      = false;          /* no session any more */

inline Answer (its_number) {
   d_step {
      if
      :: its_number >= First ->
         assert (Unanswered [its_number]);
         Unanswered [its_number] = false;
         Waiting--
      :: else
      fi
   }
}

inline Stop_Images (ghost) {
   /*: Box.Stop_Images */
   atomic {
#ifndef MUTANT_LATE_IMAGE_PASSES
      Made_Is_Now = false;
#endif
      Images_Stopped = Images_Stopped || ghost
   }
}

/* Vision.State: the mode, and the request to the camera's owner */

mtype:stage = { Closed, Opening, Streaming, Searching, Deciding };
typedef Vision_State_Store_Type {
   byte First;
   mtype:stage Stage = Closed;
   bool Pending;
   byte Opener;
   bool Idle = true;
   bool Outcome
};
PROTECTED (Vision_State_Store);
EVENT (Vision_State_Asked);
EVENT (Vision_State_Answered);
EVENT (Vision_State_Images_Begin);
#define VS  Vision_State_Store
#define Is_Open \
   (VS.Stage == Streaming || VS.Stage == Searching || VS.Stage == Deciding)

#ifdef MUTANT_CAMERA_KEPT_FOR_NOBODY
#define Is_Wanted(request)  (request == VS.Opener)
#else
#define Is_Wanted(request)  (VS.Stage != Closed && request == VS.Opener)
#endif

/* Vision.Frames */

typedef Vision_Frames_Store_Type {
   bool Newest;
   bool Delivering;
   bool Waits;            /* th_capture_img, for the next image */
   byte Claimed
};
PROTECTED (Vision_Frames_Store);
EVENT (Vision_Frames_Changed);
EVENT (Vision_Frames_Look);
#define FS  Vision_Frames_Store

bool Camera_Open    = false;   /* the device */
bool Camera_Hangs   = false;   /* in its driver */
bool Control_Waits  = false;   /* for the camera */

/* Vision.Turns: the orders, and whether one is carried out */

typedef Vision_Turns_Line_Type {
   chan Items = [CAPACITY] of { byte, mtype:order };
   bool In_Use
};
PROTECTED (Vision_Turns_Line);
EVENT (Vision_Turns_Control_Turn);
EVENT (Vision_Turns_Arena_Turn);
#define VT  Vision_Turns_Line

#define Is_For_Arena(order)  (order == Ask_Arena || order == Decide_Arena)

hidden byte first;
hidden mtype:order head;

/* Of one task, two protected operations are one step only where nobody else
   can make a difference between them. */

bool Free = true;         /* the session: see session.pml */
EVENT (Monitor_Session_Receive_Begins);
EVENT (Monitor_Session_Receive_Ended);
EVENT (Monitor_Session_Watch_Begins);

/* The task whose turn it is, if it is one's */
inline Choose () {
   turn = 0;
   if
   :: len (VT.Items) > 0 && !VT.In_Use ->
      VT.Items ? <first, head>;
      turn = (Is_For_Arena (head) -> Ask_Arena : Open_Camera);
      first = 0;
      head = 0
   :: else
   fi
}

inline Wake () {
   if
   :: turn == Ask_Arena -> turn = 0; Set_Event (Vision_Turns_Arena_Turn)
   :: turn == Open_Camera -> turn = 0; Set_Event (Vision_Turns_Control_Turn)
   :: else
   fi
}

/* A task that is woken, and whose turn it is not, waits again */
inline Take (mine) {
   /*: Turns.Line.Take */
   d_step {
      Choose ();
      if
      :: turn == mine -> VT.Items ? number, kind; VT.In_Use = true
      :: else
      fi;
      turn = 0
   }
   if
   :: number == 0 -> goto wait
   :: else
   fi
}

inline Finish () {
   /* the event as a step of its own: see orders.pml */
   atomic {
   /*: Turns.Line.Finish */
   d_step {
      number = 0; kind = 0;
      VT.In_Use = false;
      Choose ();
#ifdef MUTANT_NEXT_ORDER_FORGOTTEN
      turn = 0
#endif
   }
   Wake ();
   goto wait
   }
}

inline Tell_If (awaited) {
   if
   :: awaited -> awaited = false; Set_Event (Vision_Frames_Look)
   :: else
   fi
}

inline End_Delivery () {
   /*: Frames.Store.End_Delivery */
   atomic {
      FS.Newest = false;
      FS.Delivering = false;
#ifndef MUTANT_END_WITHOUT_LOOK
      awaited = FS.Waits;
      FS.Waits = false
#endif
   };
#ifndef MUTANT_END_WITHOUT_EVENT
   Set_Event (Vision_Frames_Changed);
#endif
   Tell_If (awaited)
}

/* Nothing new for so long that the camera has failed */
#ifdef MUTANT_SILENCE_UNNOTICED
#define SILENT  false
#else
#define SILENT  (Camera_Hangs || !FS.Delivering)
#endif

/* Once in the period of the link: what th_capture_img waits for does not
   come */
inline Look_At_Silence () {
   /*: Frames.Store.Look_At_Silence */
   atomic {
#ifdef MUTANT_SILENCE_WITHOUT_LOOK
      0 &&
#endif
      FS.Waits && SILENT -> FS.Waits = false; awaited = true
   };
   Tell_If (awaited)
}

/* The camera delivers no more: close it, once */
inline Camera_Failed () {
   /*: State.Store.Give_Up */
   atomic {
      was_open = Is_Open;
      VS.Stage = Closed;
      if
      :: was_open
      :: else -> goto closed
      fi
   };
   atomic {
      was_open = false;
      Stop_Images (false)
   };
   End_Delivery ();
   /*: Monitor.Outbox.Put in outbox */
   skip;
closed:
   skip
}

active proctype Th_Camera_Control ()
{
   byte number;
   mtype:order kind, turn;
   bool success;
   /*: whole */
wait:
   atomic {
      Wait_For_Work (Vision_Turns_Control_Turn);
      Take (Open_Camera);
      if
      :: kind == Open_Camera ->
         /*: State.Store.Ask_Open */
         if
         :: number >= VS.First && VS.Stage == Closed ->
            VS.Stage = Opening;                         /* needed */
            VS.Opener = number;
            VS.Pending = true;
            Control_Waits = true
         :: else -> goto answer
         fi
      :: kind == Close_Camera ->
         /*: State.Store.Change */
         if
         :: number >= VS.First -> VS.Stage = Closed; goto close
         :: else -> goto answer
         fi
      :: kind == Ask_Position ->
         /* positions are sent at any time, as if they were asked for */
         /*: State.Store.Change */
         goto answer
      fi
   };
   atomic {
#ifndef MUTANT_CAMERA_NOT_ASKED
      Set_Event (Vision_State_Asked);
#endif
      Wait_Event (Vision_State_Answered);
      Control_Waits = false;
      /*: State.Store.Opened */
      if
      :: number >= VS.First && VS.Stage == Opening && VS.Outcome ->
         VS.Stage = Streaming;
         Images_Stopped = false;
         success = true;
         goto opened
      :: number >= VS.First && VS.Stage == Opening && !VS.Outcome ->
         VS.Stage = Closed
      :: !(number >= VS.First && VS.Stage == Opening) ->
#ifdef MUTANT_FAILED_CAMERA_ACKNOWLEDGED
         success = VS.Outcome
#endif
      fi;
      /* acknowledged only if it is open now */
      assert (!success);
      goto answer
   };
opened:
   Set_Event (Vision_State_Images_Begin);
   goto answer;
close:
   Stop_Images (true);
answer:
   /*: Monitor.Outbox.Answer in outbox */
   atomic { success = false; Answer (number) };
   Finish ()
}

inline May_Be_Sent () {
   assert (!(Monitor_Outbox_Open && Made_Is_Now && Images_Stopped))
}

active proctype Th_Capture_Img ()
{
   bool fails, looks, found, coming, was_open, awaited;
   /*: whole */
wait:
   Wait_For_Work (Vision_State_Images_Begin);
   do
   :: /*: Box.Get */
      Made_Is_Now = true;           /* before the mode */
      /*: State.Store.Get, Frames.Store.Get_Silent */
      atomic {
         if
         :: VS.Stage == Closed || VS.Stage == Opening ->
            Made_Is_Now = false;
            goto wait
         :: SILENT && Is_Open -> fails = true
         :: !SILENT && VS.Stage == Streaming -> looks = true
         :: !SILENT && Is_Open && VS.Stage != Streaming
         fi;
         Made_Is_Now = Made_Is_Now && looks
      };
      if
      :: fails -> fails = false; Camera_Failed ()
      :: looks ->
         /*: Frames.Store.Claim_Due */
         atomic {
            looks = false;
            if
            :: FS.Newest -> FS.Newest = false; FS.Claimed++; found = true
            :: else ->
               coming = FS.Delivering;
               FS.Waits = coming;
               Made_Is_Now = false
            fi
         };
         if
         :: found ->                /* it is made */
            atomic {
               found = false;
               if
               :: /*: Vision.State.Put in mission */ skip
               :: skip
               fi;
               if
               :: /*: Outbox.Put_Image in outbox */ May_Be_Sent ()
               :: skip
               fi;
               /*: Frames.Store.Release */
               FS.Claimed--
            };
            atomic {
               if
               :: /*: Monitor.Outbox.Put in outbox */ May_Be_Sent ()
               :: skip
               fi;
               Made_Is_Now = false
            }
         :: else
         fi
      :: else
      fi;
      atomic {
         if
         :: coming -> coming = false; Wait_Event (Vision_Frames_Look)
         :: else -> /*: delay */ skip
         fi
      }
   od
}

active proctype Th_Arene ()
{
   byte number;
   mtype:order kind, turn;
   bool found;
   /*: whole */
wait:
   atomic {
      Wait_For_Work (Vision_Turns_Arena_Turn);
      Take (Ask_Arena);
      if
      :: kind == Decide_Arena ->
         /*: State.Store.Change */
         if
         :: number >= VS.First && VS.Stage == Deciding ->
            VS.Stage = Streaming;
            Images_Stopped = false
         :: else
         fi;
         goto answer_nothing
      :: kind == Ask_Arena ->
         /*: State.Store.Change */
         if
         :: number >= VS.First && Is_Open -> VS.Stage = Searching
         :: else -> goto answer
         fi
      :: kind == Ask_Arena ->
         /* or for its ground */
         /*: State.Store.Get */
         goto answer
      fi
   };
   Stop_Images (true);
   /* Wait_Newest */
newest:
   /*: Frames.Store.Claim_Newest */
   atomic {
      if
      :: FS.Newest -> FS.Newest = false; FS.Claimed++; found = true;
         goto search
      :: !FS.Newest && !FS.Delivering -> goto search
      :: !FS.Newest && FS.Delivering
      fi
   };
   atomic { Wait_Event (Vision_Frames_Changed); goto newest };
search:
   atomic {
      if
      :: found ->
         /*: Frames.Store.Release */
         FS.Claimed--;
         if :: found = true :: found = false fi
      :: else
      fi
   };
   /*: State.Store.Change */
   atomic {
      if
      :: number >= VS.First && VS.Stage == Searching && found ->
         found = false;
         VS.Stage = Deciding
      :: number >= VS.First && VS.Stage == Searching && !found ->
         VS.Stage = Streaming;
         Images_Stopped = false;
         goto answer
      :: else -> found = false; goto answer
      fi
   };
put_image:
   /*: Box.Answer_With_Image */
   atomic {
      if
      :: number < First -> goto done
      :: number >= First && !Image_For_Arena ->
         Image_For_Arena = true;
         Answer (number);
         goto done
      :: number >= First && Image_For_Arena
      fi
   };
   atomic { Wait_Event (Monitor_Outbox_Arena_Room); goto put_image };
answer:
   /*: Monitor.Outbox.Answer in outbox */
   Answer (number);
   goto next;
answer_nothing:
   /*: Monitor.Outbox.Answer in outbox */
   Answer (number);
   goto next;
done:
   /*: Set_Event (Outbox.Work) in outbox */
   skip;
next:
   Finish ()
}

active proctype Th_Camera ()
{
   byte request;
   bool success, was_open, awaited;
   /*: whole */
look:
   atomic {
      /*: State.Store.Take */
      if
      :: VS.Pending ->
         request = VS.Opener; VS.Pending = false; VS.Idle = false;
         goto open
      :: else
      fi
   };
   atomic { Wait_For_Work (Vision_State_Asked); goto look };
open:
   /*: Vision.Library.Open, State.Store.Get_Wanted */
   atomic {
      if
      :: Camera_Open = true; success = Is_Wanted (request)
      :: success = false
      fi
   };
   if
   :: !success ->
      /*: State.Store.Report */
      atomic {
         VS.Outcome = false;
         Set_Event (Vision_State_Answered);
         goto close
      }
   :: success ->
      /*: Frames.Store.Begin_Delivery */
      atomic { FS.Newest = false; FS.Delivering = true; success = false };
      /*: State.Store.Report */
      atomic {
         VS.Outcome = true;
         Set_Event (Vision_State_Answered)
      }
   fi;
   do
   :: /*: Frames.Store.Claim_Empty, Vision.Library.Grab */
      atomic {
         /* with the image before the newest */
         assert (FS.Claimed + 2 * FS.Newest < SLOTS);
         if
         :: success = true; goto grabbed
         :: goto grabbed
         :: Camera_Hangs = true
         fi
      };
      /* until nobody is in command, or an opening waits for it */
      atomic { !In_Command || Control_Waits -> Camera_Hangs = false };
grabbed:
      if
      :: success ->
         /*: Frames.Store.Publish */
         atomic {
            FS.Newest = FS.Newest || FS.Delivering;
            awaited = FS.Waits;
            FS.Waits = false;
            Set_Event (Vision_Frames_Changed);
            Tell_If (awaited)
         }
      :: else ->
         /*: Frames.Store.Release */
         skip
      fi;
      /*: State.Store.Get_Wanted */
      atomic {
         if
         :: !Is_Wanted (request) -> success = false; break
         :: Is_Wanted (request) && !success
         :: Is_Wanted (request) && success ->
            success = false; goto more
         fi
      };
      Camera_Failed ();
      break;
more: skip
   od;
   End_Delivery ();
close:
   /*: Vision.Library.Close */
   atomic { request = 0; Camera_Open = false };
   /*: State.Store.Released */
   atomic {
#ifndef MUTANT_CAMERA_NOT_RELEASED
      VS.Idle = true;
#endif
      goto look
   }
}

/* Sends the arena's image, when its turn comes */

active proctype Th_Send_To_Mon ()
{
end_wait:
   do
   :: atomic { Image_For_Arena && Reads && Monitor_Outbox_Open ->
               Image_For_Arena = false;
               Set_Event (Monitor_Outbox_Arena_Room) }
   od
}

active proctype Th_Server ()
{
   byte session;
   (Is_Awaited (Monitor_Session_Watch_Begins)
    && Is_Awaited (Monitor_Session_Receive_Begins)
    && Is_Awaited (Vision_State_Asked)
    && Is_Awaited (Vision_State_Images_Begin)
    && Is_Awaited (Vision_Turns_Arena_Turn)
    && Is_Awaited (Vision_Turns_Control_Turn));
   do
   :: session < SESSIONS ->
      /* Begin_Active, Admit: see session.pml */
      /*: Box.Open_Session */
      atomic {
         Free -> Free = false;
         In_First = (session == 0);
         session++;
         Monitor_Outbox_Open = true;
         In_Command = true;
         if :: Reads = true :: Reads = false fi;
         /* one after the other in session.pml */
         Set_Event (Monitor_Session_Receive_Begins);
         Set_Event (Monitor_Session_Watch_Begins)
      }
   :: else -> break
   od;
   Free;
   Ended = true
}

/* Commands at any time */

active proctype Th_Receive_From_Mon ()
{
   byte number, sent;
   mtype:order kind, turn;
   do
   :: Wait_For_Work (Monitor_Session_Receive_Begins);
      do
      :: atomic { !Monitor_Outbox_Open -> break }
      :: atomic {
            Monitor_Outbox_Open && sent < Limit && Waiting < CAPACITY ->
            sent++;
            if
#ifdef ARENA              /* opened first, then one search after the other */
            :: sent == 1 && In_First -> kind = Open_Camera
            :: sent > 1 || !In_First -> kind = Ask_Arena
            :: sent > 1 || !In_First -> kind = Decide_Arena
#else
            :: kind = Open_Camera
            :: kind = Ask_Arena
            :: kind = Decide_Arena
            :: kind = Close_Camera
            :: kind = Ask_Position
#endif
            fi;
            number = Next;
            Next++;
            Unanswered [number] = true;
            Waiting++;
            All_Sent = (sent == Limit)
         };
         /*: Turns.Line.Put */
         d_step {
            VT.Items ! number, kind;
            Choose ();
            number = 0; kind = 0
         }
         Wake ()
      od;
      atomic { sent = 0; All_Sent = false };
      Set_Event (Monitor_Session_Receive_Ended)
   od
}

/* The session's end at any time, or when all have been answered */

active proctype Th_Com_Mon_Perdue ()
{
   byte i;
   bool awaited;
   do
   :: Wait_For_Work (Monitor_Session_Watch_Begins);
      do
      :: atomic { Reads && All_Sent && !Patient -> Patient = true }
      :: atomic { Patient && Waiting == 0 -> Patient = false; break }
      :: Look_At_Silence ()
      :: !Patient -> break
      od;
      /* Bring_Back */
      /*: Box.Close_Session */
      atomic {
         Reads = false;
         Monitor_Outbox_Open = false;
         First = Next;
         Waiting = 0;
         Image_For_Arena = false;
         Made_Is_Now = false;
         d_step {
            i = 1;
            do
            :: i < NUMBERS -> Unanswered [i] = false; i++
            :: else -> break
            od;
            i = 0
         }
      };
#ifndef MUTANT_CLOSE_WITHOUT_ARENA_ROOM
      Set_Event (Monitor_Outbox_Arena_Room);
#endif
      /*: State.Store.Begin_Session */
      atomic {
#ifndef MUTANT_CAMERA_LEFT_OPEN
         VS.Stage = Closed;
#endif
         VS.First = First
      };
#ifndef MUTANT_SEARCH_OUTLIVES_SESSION
      End_Delivery ();
#endif
      Wait_Event (Monitor_Session_Receive_Ended);
      /*: Turns.Line.Clear */
      atomic { do :: VT.Items ? _, _ :: len (VT.Items) == 0 -> break od };
      /* a camera that hangs is not waited for */
      /*: State.Store.Get_Idle */
      atomic {
         ((VS.Idle && !VS.Pending) || Camera_Hangs);
         if
         :: /*: delay, State.Store.Get_Idle + */ skip
         :: skip
         fi;
         In_Command = false;
         Free = true
      }
   od
}

ltl every_vision_order_answered { [] (Patient -> <> !Patient) }
ltl initial_state_again
   { [] (!Monitor_Outbox_Open && In_Command -> <> (!In_Command)) }
ltl camera_released_in_the_end { [] (Ended -> <> [] !Camera_Open) }
