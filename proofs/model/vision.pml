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
   atomic {
#ifndef MUTANT_LATE_IMAGE_PASSES
      Made_Is_Now = false;
#endif
      Images_Stopped = Images_Stopped || ghost
   }
}

/* Vision.State */

mtype:stage = { Closed, Opening, Streaming, Searching, Deciding };
typedef Vision_State_Store_Type {
   byte First;
   mtype:stage Stage = Closed
};
PROTECTED (Vision_State_Store);
#define VS  Vision_State_Store
#define Is_Open \
   (VS.Stage == Streaming || VS.Stage == Searching || VS.Stage == Deciding)

/* Vision.Camera_Requests */

typedef Vision_Camera_Requests_Requests_Type {
   bool Pending;
   bool Wanted;
   byte Current;
   bool Idle = true;
   bool Opened
};
PROTECTED (Vision_Camera_Requests_Requests);
EVENT (Vision_Camera_Requests_Asked);
EVENT (Vision_Camera_Requests_Answered);
#define CR  Vision_Camera_Requests_Requests

EVENT (Vision_Camera_Events_Images_Begin);

/* Vision.Frame_Store */

typedef Vision_Frame_Store_Store_Type {
   bool Newest;
   bool Delivering;
   bool Waits;            /* th_capture_img, for the next image */
   byte Claimed
};
PROTECTED (Vision_Frame_Store_Store);
EVENT (Vision_Frame_Store_Changed);
EVENT (Vision_Frame_Store_Look);
#define FS  Vision_Frame_Store_Store

bool Camera_Open    = false;   /* the device */
bool Camera_Hangs   = false;   /* in its driver */
bool Control_Waits  = false;   /* for the camera */

/* Vision.Queue and the two ports */

typedef Vision_Queue_Queue_Type {
   chan Items = [CAPACITY] of { byte, mtype:order };
   bool Busy
};
PROTECTED (Vision_Queue_Queue);
#define VQ  Vision_Queue_Queue

#define Task_Ports_Camera_Control  0   /* instance */
#define Task_Ports_Arena           1   /* instance */
typedef Order_Ports_Port_Type {
   chan Items = [CAPACITY] of { byte, mtype:order }
};
Order_Ports_Port_Type Order_Ports_Port [2];
EVENTS (Order_Ports_Arrived, 2);
#define Port(p)  Order_Ports_Port [p].Items

/* The steps of this model: what a task does between two points at which
   another could see a difference is one step. That an event is set only
   after what it announces, as a step of its own, is in orders.pml and
   outbox.pml, for the same packages. */

inline To_Vision (its_number, its_kind) {
   if
   :: its_kind == Ask_Arena || its_kind == Decide_Arena ->
      Port (Task_Ports_Arena) ! its_number, its_kind;
      Set_True (Order_Ports_Arrived [Task_Ports_Arena])
   :: else ->
      Port (Task_Ports_Camera_Control) ! its_number, its_kind;
      Set_True (Order_Ports_Arrived [Task_Ports_Camera_Control])
   fi
}

inline Take (p) {
   if
   :: len (Port (p)) > 0 -> Port (p) ? number, kind
   :: else -> goto end_wait
   fi;
   /* the queue lets one order go at a time: there is never more */
   assert (len (Port (p)) == 0)
}

inline Vision_Done () {
   number = 0; kind = 0;
#ifndef MUTANT_NEXT_ORDER_FORGOTTEN
   if
   :: VQ.Items ? number, kind -> To_Vision (number, kind)
   :: len (VQ.Items) == 0 -> VQ.Busy = false
   fi;
   number = 0; kind = 0;
#endif
   goto end_wait
}

inline Tell_If_Awaited () {
   if
   :: FS.Waits -> FS.Waits = false; Set_True (Vision_Frame_Store_Look)
   :: else
   fi
}

inline End_Delivery () {
   FS.Newest = false;
   FS.Delivering = false;
#ifndef MUTANT_END_WITHOUT_EVENT
   Set_True (Vision_Frame_Store_Changed);
#endif
#ifndef MUTANT_END_WITHOUT_LOOK
   Tell_If_Awaited ()
#endif
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
   atomic {
#ifdef MUTANT_SILENCE_WITHOUT_LOOK
      false ->
#endif
      FS.Waits && SILENT -> Tell_If_Awaited ()
   }
}

/* The camera delivers no more: close it, once; else go on at not_open */
inline Camera_Failed () {
   atomic {
      if
      :: Is_Open -> VS.Stage = Closed
      :: else -> VS.Stage = Closed; goto not_open
      fi
   };
   atomic { Stop_Images (false); CR.Wanted = false };
   atomic { End_Delivery () }
}

active proctype Th_Camera_Control ()
{
   byte number;
   mtype:order kind;
   bool success;
end_wait:
   atomic {
      Order_Ports_Arrived [Task_Ports_Camera_Control] ->
      Order_Ports_Arrived [Task_Ports_Camera_Control] = false;
      Take (Task_Ports_Camera_Control);
      if
      :: kind == Open_Camera && number >= VS.First && Is_Open ->
         goto answer                                 /* it is open */
      :: kind == Open_Camera && number < VS.First -> goto answer
      :: kind == Close_Camera && number < VS.First -> goto answer
      :: kind == Close_Camera && number >= VS.First ->
         VS.Stage = Closed; goto close
      :: kind == Open_Camera && number >= VS.First && !Is_Open ->
         assert (VS.Stage == Closed);
         VS.Stage = Opening                          /* needed */
      fi
   };
   /* Vision.Camera_Requests.Open */
   atomic {
      CR.Current++;
      CR.Wanted = true;
      CR.Pending = true;
      Control_Waits = true;
#ifndef MUTANT_CAMERA_NOT_ASKED
      Set_True (Vision_Camera_Requests_Asked)
#endif
   };
   atomic {
      Vision_Camera_Requests_Answered -> Vision_Camera_Requests_Answered = false;
      Control_Waits = false;
      /* Vision.State.Opened */
      if
      :: number >= VS.First && VS.Stage == Opening && CR.Opened ->
         VS.Stage = Streaming;
         Images_Stopped = false;
         success = true;
         goto opened
      :: number >= VS.First && VS.Stage == Opening && !CR.Opened ->
         VS.Stage = Closed
      :: !(number >= VS.First && VS.Stage == Opening) ->
#ifdef MUTANT_FAILED_CAMERA_ACKNOWLEDGED
         success = CR.Opened
#endif
      fi;
      /* acknowledged only if it is open now */
      assert (!success)
   };
#ifndef MUTANT_CAMERA_KEPT_FOR_NOBODY
   CR.Wanted = false;
#endif
   goto answer;
opened:
   Set_True (Vision_Camera_Events_Images_Begin);
   goto answer;
close:
   Stop_Images (true);
   CR.Wanted = false;
answer:
   atomic { success = false; Answer (number); Vision_Done () }
}

active proctype Th_Capture_Img ()
{
end_wait:
   Suspend_Until_True (Vision_Camera_Events_Images_Begin);
   do
   :: Made_Is_Now = true;           /* Get_Generation, before the mode */
      atomic {
         if
         :: VS.Stage == Closed || VS.Stage == Opening ->
            Made_Is_Now = false;
            goto end_wait
         :: SILENT && Is_Open
         :: VS.Stage == Streaming && FS.Newest ->
            FS.Newest = false; FS.Claimed++; goto image
         :: VS.Stage == Streaming && !FS.Newest && !SILENT ->
            FS.Waits = true;
            Made_Is_Now = false; goto wait_look
         :: Is_Open && VS.Stage != Streaming && !SILENT ->
            Made_Is_Now = false; goto pause
         fi
      };
      Camera_Failed ();
not_open:
      Made_Is_Now = false;
      goto pause;
image:                              /* is made; Put_Image, Release */
      atomic {
         FS.Claimed--;
         assert (!(Monitor_Outbox_Open && Made_Is_Now && Images_Stopped));
         Made_Is_Now = false
      };
      goto pause;
wait_look:
      Suspend_Until_True (Vision_Frame_Store_Look);
pause:                              /* delay until Next */
      skip
   od
}

active proctype Th_Arene ()
{
   byte number;
   mtype:order kind;
   bool found, delivering;
end_wait:
   atomic {
      Order_Ports_Arrived [Task_Ports_Arena] ->
      Order_Ports_Arrived [Task_Ports_Arena] = false;
      Take (Task_Ports_Arena);
      if
      :: kind == Decide_Arena ->
         if
         :: number >= VS.First && VS.Stage == Deciding ->
            VS.Stage = Streaming;
            Images_Stopped = false
         :: else
         fi;
         goto answer
      :: kind == Ask_Arena && !(number >= VS.First && Is_Open) ->
         goto answer
      :: kind == Ask_Arena && number >= VS.First && Is_Open ->
         VS.Stage = Searching
      fi
   };
   Stop_Images (true);
   /* Wait_Newest */
newest:
   delivering = FS.Delivering;
   atomic {
      if
      :: FS.Newest -> FS.Newest = false; FS.Claimed++; goto search
      :: !FS.Newest && !delivering -> goto searched
      :: !FS.Newest && delivering -> delivering = false
      fi
   };
   atomic { Vision_Frame_Store_Changed -> Vision_Frame_Store_Changed = false;
            goto newest };
search:
   atomic {
      delivering = false;
      FS.Claimed--;
      if :: found = true :: found = false fi
   };
searched:
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
   /* Answer_With_Image */
put_image:
   atomic {
      if
      :: number < First -> goto answer
      :: number >= First && !Image_For_Arena ->
         Image_For_Arena = true;
         goto answer
      :: number >= First && Image_For_Arena
      fi
   };
   atomic { Monitor_Outbox_Arena_Room -> Monitor_Outbox_Arena_Room = false;
            goto put_image };
answer:
   atomic { Answer (number); Vision_Done () }
}

active proctype Th_Camera ()
{
   byte request;
   bool success;
end_wait:
   /* Wait_Open */
   atomic {
      Vision_Camera_Requests_Asked -> Vision_Camera_Requests_Asked = false;
look: if
      :: CR.Pending ->
         request = CR.Current; CR.Pending = false; CR.Idle = false
      :: else -> goto end_wait
      fi
   };
   /* Vision.Library.Open, Get_Wanted, Begin_Delivery, Report */
   atomic {
      if
      :: Camera_Open = true; success = CR.Wanted && request == CR.Current
      :: success = false
      fi;
      CR.Opened = success;
      Set_True (Vision_Camera_Requests_Answered);
      if
      :: !success -> goto close
      :: else -> FS.Newest = false; FS.Delivering = true; success = false
      fi
   };
   do
   :: /* Vision.Library.Grab, Publish */
      atomic {
         /* with the image before the newest */
         assert (FS.Claimed + 2 * FS.Newest < SLOTS);
         if
         :: success = true;
            FS.Newest = FS.Newest || FS.Delivering;
            Set_True (Vision_Frame_Store_Changed);
            Tell_If_Awaited ();
            goto wanted
         :: goto wanted
         :: Camera_Hangs = true
         fi
      };
      /* until nobody is in command, or an opening waits for it */
      atomic { !In_Command || Control_Waits -> Camera_Hangs = false };
wanted:
      atomic {
         if
         :: !(CR.Wanted && request == CR.Current) ->
            success = false; goto not_open
         :: CR.Wanted && request == CR.Current && !success -> break
         :: CR.Wanted && request == CR.Current && success ->
            success = false
         fi
      }
   od;
   Camera_Failed ();
not_open:
   atomic { End_Delivery () };
close:
   atomic { request = 0; Camera_Open = false };
   atomic {
#ifndef MUTANT_CAMERA_NOT_RELEASED
      CR.Idle = true;
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
               Set_True (Monitor_Outbox_Arena_Room) }
   od
}

/* The session: commands at any time, its end at any time, or when all have
   been answered; then Bring_Back */

active proctype Th_Com_Mon_Perdue ()
{
   byte session, sent, i;
   mtype:order kind;
   do
   :: session < SESSIONS ->
      atomic {
         In_First = (session == 0);
         session++;
         Monitor_Outbox_Open = true;
         In_Command = true;
         if :: Reads = true :: Reads = false fi
      };
      do
      :: atomic {
            sent < Limit && Waiting < CAPACITY ->
            sent++;
            if
            :: kind = Open_Camera
            :: kind = Close_Camera
            :: kind = Ask_Arena
            :: kind = Decide_Arena
            fi;
            Unanswered [Next] = true;
            Waiting++;
            /* Dispatch */
            if
            :: VQ.Busy -> VQ.Items ! Next, kind
            :: else -> VQ.Busy = true; To_Vision (Next, kind)
            fi;
            Next++;
            kind = 0
         }
      :: atomic { Reads && sent == Limit && !Patient -> Patient = true };
         do
         :: atomic { Waiting == 0 -> Patient = false; break }
         :: Look_At_Silence ()
         od;
         break
      :: Look_At_Silence ()
      :: break
      od;
      /* Close_Session */
      atomic {
         sent = 0;
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
#ifndef MUTANT_CLOSE_WITHOUT_ARENA_ROOM
         Set_True (Monitor_Outbox_Arena_Room)
#endif
      };
      atomic { VS.Stage = Closed; VS.First = First };
#ifndef MUTANT_CAMERA_LEFT_OPEN
      CR.Wanted = false;
#endif
#ifndef MUTANT_SEARCH_OUTLIVES_SESSION
      atomic { End_Delivery () };
#endif
      atomic { do :: VQ.Items ? _, _ :: len (VQ.Items) == 0 -> break od };
      /* a camera that hangs is not waited for */
      atomic { (CR.Idle && !CR.Pending) || Camera_Hangs ->
               In_Command = false }
   :: else -> break
   od;
   Ended = true
}

ltl every_vision_order_answered { [] (Patient -> <> !Patient) }
ltl initial_state_again
   { [] (!Monitor_Outbox_Open && In_Command -> <> (!In_Command)) }
ltl camera_released_in_the_end { [] (Ended -> <> [] !Camera_Open) }
