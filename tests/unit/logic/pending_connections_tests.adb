--  SPDX-License-Identifier: GPL-3.0-or-later
--  Pending connections: turns, room and shares, and that no source keeps
--  another one out, for any sequence.

with Ada.Numerics.Discrete_Random;

with AUnit.Assertions;              use AUnit.Assertions;

with Admission.Networks;            use Admission.Networks;
with Admission.Pending_Connections; use Admission.Pending_Connections;
with Interfaces;                    use Interfaces;
with Unit_Runs; use Unit_Runs;

package body Pending_Connections_Tests is

   All_Due : constant Place_Set := (others => True);

   procedure Enter (T : in out Table; S : Source; P : out Place) is
   begin
      P := Free_Place (T);
      Enter (T, P, S);
   end Enter;

   procedure Enter (T : in out Table; S : Source) is
      --  At a free place
      Unused : Place;
   begin
      Enter (T, S, Unused);
   end Enter;

   procedure Expect_Turn (T : in out Table; S : Source; P : out Place) is
      --  It is the turn of S, at P
      Choice : constant Place_Choice := Next (T, All_Due);
   begin
      Assert (Choice in Place, "nobody's turn");
      P := Choice;
      Assert
        (Source_Of (T, P) = S,
         "the turn of" & Source_Of (T, P)'Image & ", not of" & S'Image);
      Serve (T, P);
   end Expect_Turn;

   function Taken (T : Table) return Natural is
      Result : Natural := 0;
   begin
      for P in Place loop
         if Is_Taken (T, P) then
            Result := Result + 1;
         end if;
      end loop;
      return Result;
   end Taken;

   procedure Test_Due is
      W    : Table;
      P, Q : Place;
      Due  : Place_Set := (others => False);
   begin
      Assert (Next (W, All_Due) = No_Place, "there is nobody");
      Enter (W, 1, P);
      Enter (W, 2, Q);
      Assert (Next (W, Due) = No_Place, "nobody is due");
      Due (Q) := True;
      Assert (Next (W, Due) = Q, "who is due");
      Keep (W, Q);
      Assert (Next (W, Due) = No_Place, "who is kept does not wait");
      Assert (First_Kept (W) = Q, "who is kept");
      Keep (W, P);
      Assert (First_Kept (W) = P, "who came first");
      Leave (W, P);
      Assert (First_Kept (W) = Q, "the next");
   end Test_Due;

   procedure Test_Full is
      W     : Table;
      First : Place;
      P     : Place;
   begin
      --  one has three, all others two
      Enter (W, 7, First);
      Enter (W, 7);
      Enter (W, 7);
      for S in 100 .. 113 loop
         Enter (W, Source (S));
         Enter (W, Source (S), P);
         Assert (Surplus (W, P) = No_Place, "there was room");
      end loop;
      Enter (W, 8, P);
      Assert (not Has_Free_Place (W), "all places are taken");
      Assert (Surplus (W, P) = First, "not the first of three");
      Leave (W, First);
      Assert (Surplus (W, P) = No_Place, "there is room again");
      Enter (W, 9, P);
      Assert
        (Source_Of (W, Surplus (W, P)) = 7 and then Surplus (W, P) /= P,
         "not the first of two");
   end Test_Full;

   procedure Test_Full_Of_Single is
      W : Table;
      P : Place;
   begin
      for S in 1 .. Capacity - 1 loop
         Enter (W, Source (S), P);
         Assert (Surplus (W, P) = No_Place, "there was room");
      end loop;
      Enter (W, 1_000, P);
      Assert (Surplus (W, P) = P, "the only one of a source is to go");
   end Test_Full_Of_Single;

   procedure Test_Kept is
      W     : Table;
      First : Place;
      P     : Place;
   begin
      Enter (W, 3, First);
      Keep (W, First);
      for Number in 2 .. Share loop
         Enter (W, 3, P);
      end loop;
      Enter (W, 3, P);
      Assert
        (Surplus (W, P) in Place and then Surplus (W, P) not in First | P,
         "one that waits, the oldest");
      for Q in Place loop
         if Is_Taken (W, Q) then
            Keep (W, Q);
         end if;
      end loop;
      Assert (Surplus (W, P) = P, "all others are kept");
   end Test_Kept;

   procedure Test_Newcomer_Turn is
      --  Frequent reconnections give no additional turns
      W    : Table;
      P, Q : Place;
   begin
      Enter (W, 1, P);
      Enter (W, 2);
      Expect_Turn (W, 1, P);
      Leave (W, P);
      Enter (W, 1);
      Expect_Turn (W, 2, Q);
      Expect_Turn (W, 1, P);
      Enter (W, 1);
      Expect_Turn (W, 2, Q);
      Expect_Turn (W, 1, Q);
      Assert (Q = P, "who has just come goes ahead of its older one");
   end Test_Newcomer_Turn;

   procedure Test_Random is
      --  Sources 1 to 40 connect, send, are admitted and disconnect in any
      --  order. A source that is due is served after each other source at most
      --  once; no source exceeds its share; the only connection of a source is
      --  removed only if it is the newest of all
      subtype Any_Source is Positive range 1 .. 40;
      subtype Step_Kind is Natural range 0 .. 9;
      package Sources is new Ada.Numerics.Discrete_Random (Any_Source);
      package Steps is new Ada.Numerics.Discrete_Random (Step_Kind);
      package Places is new Ada.Numerics.Discrete_Random (Place);
      Any_S  : Sources.Generator;
      Any_K  : Steps.Generator;
      Any_P  : Places.Generator;
      W      : Table;
      P      : Place;
      Excess : Place_Choice;
      Chosen : Place_Choice;
      Due    : Place_Set := (others => False);
      Missed : array (Any_Source) of Natural := (others => 0);
      --  turns of others since the source began to be due

      function Crowd return Any_Source is
        (if Steps.Random (Any_K) < 6
         then Any_Source'First + Steps.Random (Any_K) mod 2
         else Sources.Random (Any_S));
      --  two of them come most often

      procedure Come (S : Any_Source) is
         Alone : Boolean;
      begin
         Enter (W, Source (S), P);
         Due (P) := False;
         Excess := Surplus (W, P);
         if Excess in Place then
            Alone := Count_Of (W, Source_Of (W, Excess)) = 1;
            Assert
              (not Alone or else (Excess = P and then Taken (W) = Capacity),
               "the only one of a source has to go");
            Assert
              (Count_Of (W, Source (S)) > Share
               or else (for all Q in Place =>
                          not Is_Waiting (W, Q)
                          or else Count_Of (W, Source_Of (W, Q))
                            <= Count_Of (W, Source_Of (W, Excess))),
               "not of those that have most");
            Leave (W, Excess);
         end if;
         Assert (Has_Free_Place (W), "no room for the next");
      end Come;

      procedure Give_Turn is
         Served : Source;
      begin
         Chosen := Next (W, Due);
         if Chosen = No_Place then
            return;
         end if;
         Serve (W, Chosen);
         Due (Chosen) := False;
         Served := Source_Of (W, Chosen);
         for S in Any_Source loop
            if (for some Q in Place =>
                  Due (Q) and then Is_Waiting (W, Q)
                  and then Source_Of (W, Q) = Source (S))
              and then Served /= Source (S)
            then
               Missed (S) := Missed (S) + 1;
               Assert
                 (Missed (S) < Capacity, "source" & S'Image & " is kept out");
            else
               Missed (S) := 0;
            end if;
         end loop;
      end Give_Turn;

   begin
      Sources.Reset (Any_S, 5);
      Steps.Reset (Any_K, 6);
      Places.Reset (Any_P, 7);
      for Step in 1 .. 20_000 loop
         case Steps.Random (Any_K) is
            when 0 .. 3 =>
               Come (Crowd);
            when 4 .. 6 =>
               for Number in 1 .. 4 loop
                  Due (Places.Random (Any_P)) := True;
               end loop;
               Give_Turn;
            when 7 =>
               Give_Turn;
            when 8 =>
               P := Places.Random (Any_P);
               if Is_Taken (W, P) then
                  Leave (W, P);
               end if;
            when 9 =>
               P := Places.Random (Any_P);
               if Is_Waiting (W, P) and then Step mod 4 = 0 then
                  Keep (W, P);
               end if;
         end case;
         for S in Any_Source loop
            Assert
              (Count_Of (W, Source (S)) <= Share, "more than its share");
         end loop;
      end loop;
   end Test_Random;

   procedure Test_Share is
      W     : Table;
      First : Place;
      P     : Place;
   begin
      Enter (W, 5, First);
      for Number in 2 .. Share loop
         Enter (W, 5, P);
         Assert (Surplus (W, P) = No_Place, "within its share");
      end loop;
      Enter (W, 6, P);
      Assert (Surplus (W, P) = No_Place, "another source");
      Enter (W, 5, P);
      Assert (Surplus (W, P) = First, "not its oldest one");
      Leave (W, First);
      Assert (Surplus (W, P) = No_Place, "within its share again");
   end Test_Share;

   procedure Test_Turns is
      W : Table;
      P : Place;
   begin
      for Number in 1 .. Share loop
         Enter (W, 1);
      end loop;
      Enter (W, 2);
      Enter (W, 3);
      Enter (W, 3);
      for Round in 1 .. 5 loop
         Expect_Turn (W, 1, P);
         Expect_Turn (W, 2, P);
         Expect_Turn (W, 3, P);
      end loop;
   end Test_Turns;

   procedure Test_Turns_Within is
      W    : Table;
      Had  : Place_Set := (others => False);
      P    : Place;
   begin
      for Number in 1 .. Share loop
         Enter (W, 1);
      end loop;
      for Number in 1 .. Share loop
         Expect_Turn (W, 1, P);
         Assert (not Had (P), "a second turn before the others' first");
         Had (P) := True;
      end loop;
   end Test_Turns_Within;

   procedure Add_Tests is
   begin
      Add_Test ("each source in turn", Test_Turns'Access);
      Add_Test ("each of a source in turn", Test_Turns_Within'Access);
      Add_Test ("a newcomer does not go ahead", Test_Newcomer_Turn'Access);
      Add_Test ("who is not due has no turn", Test_Due'Access);
      Add_Test ("a source's share", Test_Share'Access);
      Add_Test ("who is kept stays", Test_Kept'Access);
      Add_Test ("who has most makes room", Test_Full'Access);
      Add_Test ("the only one of a source stays", Test_Full_Of_Single'Access);
      Add_Test ("nobody is kept out, whatever comes", Test_Random'Access);
   end Add_Tests;

end Pending_Connections_Tests;
