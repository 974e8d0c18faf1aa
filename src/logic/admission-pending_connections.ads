--  SPDX-License-Identifier: GPL-3.0-or-later
--  Connections that are neither admitted nor refused: whose turn it is, and
--  who makes room, so that no source of them keeps the others out.

with Admission.Networks;
with Interfaces;

package Admission.Pending_Connections with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Admission.Pending_Connections);
   --  A claim that GNATprove checks: every subprogram ends

   use type Admission.Networks.Source;

   Capacity : constant := 32;

   Share : constant := 8;
   --  Of one source, at most. A monitor that waits for the user's token is
   --  not shut out by another one, nor by seven that do not answer

   subtype Place is Positive range 1 .. Capacity;

   No_Place : constant := 0;

   subtype Place_Choice is Natural range No_Place .. Capacity;

   subtype Place_Count is Natural range 0 .. Capacity;

   type Place_Set is array (Place) of Boolean;

   type Table is private;
   --  Initially empty

   function Is_Taken (T : Table; P : Place) return Boolean;

   function Is_Kept (T : Table; P : Place) return Boolean
   with Post => (if Is_Kept'Result then Is_Taken (T, P));
   --  It has shown its right to be admitted, and makes room for nobody

   function Is_Waiting (T : Table; P : Place) return Boolean is
     (Is_Taken (T, P) and then not Is_Kept (T, P));

   function Source_Of (T : Table; P : Place) return Admission.Networks.Source;

   function Came_First (T : Table; P, Q : Place) return Boolean;
   --  P came no later than Q

   function Is_Before (T : Table; P, Q : Place) return Boolean;
   --  P's turn is no later than that of Q: the source of P has waited longer
   --  for its turn, or they are of one source and P itself has

   function Is_Consistent (T : Table) return Boolean with Ghost;
   --  All connections of a source have waited for its turn equally long

   function Are_Of_One_Source (T : Table; P, Q : Place) return Boolean is
     (Is_Taken (T, P)
      and then Is_Taken (T, Q)
      and then Source_Of (T, P) = Source_Of (T, Q));

   function Has_Sibling (T : Table; P : Place) return Boolean is
     (for some Q in Place => Q /= P and then Are_Of_One_Source (T, P, Q));
   --  There is another one of its source

   function Has_Free_Place (T : Table) return Boolean is
     (for some P in Place => not Is_Taken (T, P));

   function Count_Of
     (T : Table; S : Admission.Networks.Source) return Place_Count;
   --  How many there are of this source

   function Is_Same_But (A, B : Table; P : Place) return Boolean is
     (for all Q in Place =>
        (if Q /= P then
            Is_Taken (A, Q) = Is_Taken (B, Q)
            and then Is_Kept (A, Q) = Is_Kept (B, Q)
            and then Source_Of (A, Q) = Source_Of (B, Q)))
   with Ghost;

   function Is_Same (A, B : Table) return Boolean is
     (for all Q in Place =>
        Is_Taken (A, Q) = Is_Taken (B, Q)
        and then Is_Kept (A, Q) = Is_Kept (B, Q)
        and then Source_Of (A, Q) = Source_Of (B, Q))
   with Ghost;

   --  Coming and going

   function Free_Place (T : Table) return Place_Choice
   with
     Post =>
       (if Has_Free_Place (T) then
           Free_Place'Result in Place
           and then not Is_Taken (T, Free_Place'Result)
        else Free_Place'Result = No_Place);

   procedure Enter (T : in out Table; P : Place; S : Admission.Networks.Source)
   with
     Pre  => Is_Consistent (T) and then not Is_Taken (T, P),
     Post => Is_Consistent (T)
       and then Is_Waiting (T, P)
       and then Source_Of (T, P) = S
       and then Is_Same_But (T, T'Old, P);

   procedure Keep (T : in out Table; P : Place)
   with
     Pre  => Is_Consistent (T) and then Is_Taken (T, P),
     Post => Is_Consistent (T)
       and then Is_Kept (T, P)
       and then Source_Of (T, P) = Source_Of (T'Old, P)
       and then Is_Same_But (T, T'Old, P);

   procedure Leave (T : in out Table; P : Place)
   with
     Pre  => Is_Consistent (T) and then Is_Taken (T, P),
     Post => Is_Consistent (T)
       and then not Is_Taken (T, P)
       and then Is_Same_But (T, T'Old, P);

   --  Decisions

   function First_Kept (T : Table) return Place_Choice
   with
     Post =>
       (if First_Kept'Result in Place then
           Is_Kept (T, First_Kept'Result)
           and then (for all P in Place =>
                       (if Is_Kept (T, P) then
                           Came_First (T, First_Kept'Result, P)))
        else (for all P in Place => not Is_Kept (T, P)));
   --  Who came first of those that are to be admitted

   function Next (T : Table; Due : Place_Set) return Place_Choice
   with
     Post =>
       (if Next'Result in Place then
           Due (Next'Result)
           and then Is_Waiting (T, Next'Result)
           and then (for all P in Place =>
                       (if Due (P) and then Is_Waiting (T, P) then
                           Is_Before (T, Next'Result, P)))
        else (for all P in Place =>
                not (Due (P) and then Is_Waiting (T, P))));
   --  Whose turn it is, of those that wait and are Due: each source in turn

   procedure Serve (T : in out Table; P : Place)
   with
     Pre  => Is_Consistent (T) and then Is_Taken (T, P),
     Post => Is_Consistent (T) and then Is_Same (T, T'Old);
   --  P has had its turn, and so has its source

   function Surplus (T : Table; P : Place) return Place_Choice
   with
     Pre  => Is_Taken (T, P),
     Post =>
       (if Surplus'Result = No_Place then
           Count_Of (T, Source_Of (T, P)) <= Share
           and then Has_Free_Place (T)
        elsif Surplus'Result /= P then
           Is_Waiting (T, Surplus'Result)
           and then Has_Sibling (T, Surplus'Result));
   --  Who must go now that P has come, so that no source has more than its
   --  Share and the next has a place: of the source of P, or else of the one
   --  that has most, who has waited longest. Never the only one of a source,
   --  but P itself where all are

private

   subtype Order is Interfaces.Unsigned_64;
   --  2 ** 64 steps are not taken

   type Connection is record
      Taken  : Boolean := False;
      Kept   : Boolean := False;
      Source : Admission.Networks.Source := 0;
      Came   : Order := 0;
      Served : Order := 0;  --  when its source had its turn
      Heard  : Order := 0;  --  when it had its turn itself, or came
   end record;

   type Connection_Array is array (Place) of Connection;

   type Table is record
      Items : Connection_Array;
      Steps : Order := 0;
   end record;

   function Is_Taken (T : Table; P : Place) return Boolean is
     (T.Items (P).Taken);

   function Is_Kept (T : Table; P : Place) return Boolean is
     (T.Items (P).Taken and then T.Items (P).Kept);

   function Source_Of
     (T : Table; P : Place) return Admission.Networks.Source is
     (T.Items (P).Source);

   function Came_First (T : Table; P, Q : Place) return Boolean is
     (T.Items (P).Came <= T.Items (Q).Came);

   function Is_Before (T : Table; P, Q : Place) return Boolean is
     (T.Items (P).Served < T.Items (Q).Served
      or else (T.Items (P).Served = T.Items (Q).Served
               and then T.Items (P).Heard <= T.Items (Q).Heard));

   function Is_Consistent (T : Table) return Boolean is
     (for all P in Place =>
        (for all Q in Place =>
           (if Are_Of_One_Source (T, P, Q) then
               T.Items (P).Served = T.Items (Q).Served)));

end Admission.Pending_Connections;
