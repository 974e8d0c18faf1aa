--  SPDX-License-Identifier: GPL-3.0-or-later
--  Answers to the commands of a monitor, in the order of the commands: each
--  has its place from the arrival of its command.

with Bounded_Queues;
with Monitor.Protocol;
with Orders;

package Monitor.Answer_Queues with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Answer_Queues);

   use type Orders.Ticket;

   type State_Kind is
     (Awaited,       --  not answered yet
      Ready_Text,
      Ready_Image,
      Ready_Nothing);  --  there is nothing to send

   type Answer is record
      State : State_Kind := Awaited;
      Line  : Monitor.Protocol.Short_Text;
      --  of Ready_Text
   end record;

   package Answers is new Bounded_Queues (Answer, Orders.Capacity);

   type Queue is private;
   --  Initially empty, before command number 1

   function Places (Q : Queue) return Answers.Queue
   with Ghost;

   function Length (Q : Queue) return Orders.Order_Count
   with Post => Length'Result = Answers.Length (Places (Q));
   --  Commands that wait for their answers

   function First_Number (Q : Queue) return Orders.Ticket;
   --  The number of the command at the first place

   function Next_Number (Q : Queue) return Orders.Ticket is
     (First_Number (Q) + Orders.Ticket (Length (Q)));
   --  The number of the next command

   function Holds (Q : Queue; Number : Orders.Ticket) return Boolean is
     (Number >= First_Number (Q)
      and then Number - First_Number (Q) < Orders.Ticket (Length (Q)));
   --  The command waits for its answer

   function Place_Of (Q : Queue; Number : Orders.Ticket) return Answers.Place
   is (Positive (Number - First_Number (Q) + 1))
   with
     Pre  => Holds (Q, Number),
     Post => Place_Of'Result <= Length (Q);

   function Is_Awaited (Q : Queue; Number : Orders.Ticket) return Boolean
   with
     Post => Is_Awaited'Result =
       (Holds (Q, Number)
        and then Answers.Element_At
          (Places (Q), Place_Of (Q, Number)).State = Awaited);

   function First_Answer (Q : Queue) return Answer
   with
     Pre  => Length (Q) > 0,
     Post => First_Answer'Result = Answers.Element_At (Places (Q), 1);

   function First_Is_Ready (Q : Queue) return Boolean is
     (Length (Q) > 0 and then First_Answer (Q).State /= Awaited);
   --  The next answer to be sent is available

   procedure Clear (Q : in out Queue)
   with
     Post => Length (Q) = 0
       and then First_Number (Q) = Next_Number (Q'Old)
       and then Next_Number (Q) = Next_Number (Q'Old);
   --  Empties the queue. No number is used twice

   procedure Reserve (Q : in out Queue)
   with
     Pre  => Length (Q) < Orders.Capacity,
     Post => Answers.Begins_With (Places (Q), Places (Q'Old))
       and then Length (Q) = Length (Q'Old) + 1
       and then Answers.Element_At (Places (Q), Length (Q)).State = Awaited
       and then First_Number (Q) = First_Number (Q'Old)
       and then Next_Number (Q) = Next_Number (Q'Old) + 1;
   --  Appends a place for the answer to command Next_Number

   procedure Put (Q : in out Queue; Number : Orders.Ticket; Item : Answer)
   with
     Post => Length (Q) = Length (Q'Old)
       and then First_Number (Q) = First_Number (Q'Old)
       and then
         (if Is_Awaited (Q'Old, Number) then
             Answers.Element_At (Places (Q), Place_Of (Q, Number)) = Item
             and then
               (for all I in 1 .. Length (Q) =>
                  (if I /= Place_Of (Q, Number) then
                      Answers.Element_At (Places (Q), I) =
                        Answers.Element_At (Places (Q'Old), I)))
          else Answers.Is_Same (Places (Q), Places (Q'Old)));
   --  Item is the answer to the command. No effect if it has one already or no
   --  longer waits: each command is answered once

   procedure Remove_First (Q : in out Queue)
   with
     Pre  => Length (Q) > 0,
     Post => Answers.Is_Without_First (Places (Q), Places (Q'Old))
       and then First_Number (Q) = First_Number (Q'Old) + 1
       and then Next_Number (Q) = Next_Number (Q'Old);

   procedure Skip_Nothing (Q : in out Queue)
   with
     Post => Length (Q) <= Length (Q'Old)
       and then Next_Number (Q) = Next_Number (Q'Old)
       and then
         (Length (Q) = 0
          or else First_Answer (Q).State /= Ready_Nothing)
       and then
         (for all I in 1 .. Length (Q'Old) - Length (Q) =>
            Answers.Element_At (Places (Q'Old), I).State = Ready_Nothing)
       and then
         (for all I in 1 .. Length (Q) =>
            Answers.Element_At (Places (Q), I) =
              Answers.Element_At
                (Places (Q'Old), I + (Length (Q'Old) - Length (Q))));
   --  Removes the places at the front that have nothing to send, and no others

private

   type Queue is record
      Items : Answers.Queue;
      First : Orders.Ticket := 1;
   end record;

   function Places (Q : Queue) return Answers.Queue is (Q.Items);

   function Length (Q : Queue) return Orders.Order_Count is
     (Answers.Length (Q.Items));

   function First_Number (Q : Queue) return Orders.Ticket is (Q.First);

   function Is_Awaited (Q : Queue; Number : Orders.Ticket) return Boolean is
     (Holds (Q, Number)
      and then Answers.Element_At
        (Q.Items, Place_Of (Q, Number)).State = Awaited);

   function First_Answer (Q : Queue) return Answer is
     (Answers.Element_At (Q.Items, 1));

end Monitor.Answer_Queues;
