--  SPDX-License-Identifier: GPL-3.0-or-later
--  Pending connections, neither admitted nor rejected: whose turn is next, and
--  which one must make room, so that no source keeps the others out.

with Admission.Networks;
with Interfaces;

package Admission.Pending_Connections with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Admission.Pending_Connections);

   use type Admission.Networks.Source;

   Capacity : constant := 32;

   Share : constant := 8;
   --  Connections per source, at most. A monitor that waits for its user's
   --  token is not displaced by another one, nor by seven that do not answer

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
   --  It may be admitted, and is never displaced

   function Is_Waiting (T : Table; P : Place) return Boolean is
     (Is_Taken (T, P) and then not Is_Kept (T, P));

   function Source_Of (T : Table; P : Place) return Admission.Networks.Source;

   function Came_First (T : Table; P, Q : Place) return Boolean;
   --  P did not come later than Q

   function Is_Before (T : Table; P, Q : Place) return Boolean;
   --  P's turn is not later than Q's: the source of P has waited longer, or
   --  they have the same source and P has waited longer

   function Is_Consistent (T : Table) return Boolean with Ghost;
   --  All connections of a source have the same time of its last turn

   function Are_Of_One_Source (T : Table; P, Q : Place) return Boolean is
     (Is_Taken (T, P)
      and then Is_Taken (T, Q)
      and then Source_Of (T, P) = Source_Of (T, Q));

   function Has_Sibling (T : Table; P : Place) return Boolean is
     (for some Q in Place => Q /= P and then Are_Of_One_Source (T, P, Q));
   --  Another connection has the same source

   function Has_Free_Place (T : Table) return Boolean is
     (for some P in Place => not Is_Taken (T, P));

   function Count_Of
     (T : Table; S : Admission.Networks.Source) return Place_Count;
   --  Number of connections of this source

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

   --  Adding and removing

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
   --  The oldest of those that may be admitted

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
   --  The next of those that wait and are Due; the sources take turns

   procedure Serve (T : in out Table; P : Place)
   with
     Pre  => Is_Consistent (T) and then Is_Taken (T, P),
     Post => Is_Consistent (T) and then Is_Same (T, T'Old);
   --  P and its source have had their turn

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
   --  Which one must leave after P has come, so that no source exceeds its
   --  Share and the next connection finds a place: of the source of P, or else
   --  of the source with most connections, the one that has waited longest. P
   --  itself if every source has only one

private

   subtype Order is Interfaces.Unsigned_64;
   --  2 ** 64 steps are never reached

   type Connection is record
      Taken  : Boolean := False;
      Kept   : Boolean := False;
      Source : Admission.Networks.Source := 0;
      Came   : Order := 0;
      Served : Order := 0;  --  last turn of its source
      Heard  : Order := 0;  --  its own last turn, or its arrival
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
