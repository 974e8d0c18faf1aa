/* SPDX-License-Identifier: GPL-3.0-or-later
   What all models share: events as src/process/event.ads has them,
   and how tasks, protected objects and events are declared, so that `check`
   finds their names and compares them with the Ada code's.

   task              proctype Th_...
   protected object  PROTECTED (Package_Object), of type Package_Object_Type
   event             EVENT (Package_Object), an instance of Event
   events of a package   EVENTS (Package, number), each with its index

   A protected operation is one atomic step; whatever lies between two of
   them, the setting of an event too, may be interleaved with every other
   task: several processors, no priorities. */

#define EVENT(name)         byte name = 0
#define EVENTS(name, n)     byte name [n] = 0
#define PROTECTED(name)     name##_Type name

/* An event counter of the kernel, as Event uses it: set once or several times
   before its task goes on is the same.

   0  not set      1  set      2  not set, and its task waits */

#define Set_Event(event)   event = 1
#define Is_Set(event)      (event == 1)

/* Where the environment begins only when the tasks wait for it: a set that
   comes before the wait comes later in the run, too */
#define Is_Awaited(event)  (event == 2)

/* One task only waits for it: GNATprove refuses a second one */
#define Await_Event(event, until) \
   atomic { \
      assert (event != 2); \
      if \
      :: event == 1 \
      :: event == 0 -> event = 2; until event == 1 \
      fi; \
      event = 0 \
   }

#define Wait_Event(event)  Await_Event (event, )

/* A task that waits for work is at a label end_...: only there may it be
   when nothing can happen any more */
#define Wait_For_Work(event)  Await_Event (event, end_for_work:)

/* The same up to a time, which may always have come */
#define Wait_Until(event)  event = 0

/* The same up to a time that has come where due is true */
#define Wait_Until_Due(event, due) \
   atomic { \
      assert (event != 2); \
      if \
      :: event == 1 \
      :: event == 0 -> event = 2; end_for_work: (event == 1 || (due)) \
      fi; \
      was_set = (event == 1); \
      event = 0 \
   }

/* What the code does at a place is said there, where it is neither an event
   nor an inline that says it, and `steps` compares the order with the code's:

   [*: Box.Take *]             a protected operation, or a call of a driver
   [*: A, B *]                 one after the other;  A | B: one of the two
   [*: A, B + *]               once or more
   [*: A in outbox *]          is modelled there, and here is its place
   [*: whole *]                this proctype has all operations of its task
   [*: is A, B *]              a proctype for one of these subprograms

   with / for [ and ] at its two ends. A name is as much of the code's as says
   which one is meant. */
