/* SPDX-License-Identifier: GPL-3.0-or-later
   What all models share: events as Ada.Synchronous_Task_Control has them,
   and how tasks, protected objects and events are declared, so that `check`
   finds their names and compares them with the Ada code's.

   task              proctype Th_...
   protected object  PROTECTED (Package_Object), of type Package_Object_Type
   event             EVENT (Package_Object), a suspension object
   generic instance  INSTANCE (Package_Instance, index)

   A protected operation is one atomic step; whatever lies between two of
   them, the setting of an event too, may be interleaved with every other
   task: several processors, no priorities. */

#define EVENT(name)         bool name = false
#define EVENTS(name, n)     bool name [n] = false
#define PROTECTED(name)     name##_Type name
#define INSTANCE(name, n)

#define Set_True(event)            event = true
#define Set_False(event)           event = false
#define Suspend_Until_True(event)  atomic { event -> event = false }

/* A task that waits for work is at a label end_...: only there may it be
   when nothing can happen any more. */
