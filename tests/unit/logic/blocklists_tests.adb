--  SPDX-License-Identifier: GPL-3.0-or-later
--  Blocklists: who floods, and who only connects now and then.

with AUnit.Assertions;     use AUnit.Assertions;

with Admission.Blocklists; use Admission.Blocklists;
with Admission.Networks;
with Interfaces;           use Interfaces;
with Unit_Runs; use Unit_Runs;

package body Blocklists_Tests is

   Monitor : constant Admission.Networks.Source :=
     Admission.Networks.IPv4_Sources + 1;

   procedure Test_Forgets is
      H     : History;
      L     : List;
      Grown : Boolean;
   begin
      for Number in 1 .. Threshold loop
         Note (H, Monitor);
      end loop;
      for Number in 1 .. Max_Arrivals - Threshold + 1 loop
         Assert (Count_Of (H, Monitor) = Threshold, "forgotten too soon");
         Note (H, 7);
      end loop;
      Assert (Count_Of (H, Monitor) = Threshold - 1, "never forgotten");
      Extend (L, H, Grown);
      Assert
        (Grown and then L.Count = 1 and then Contains (L, 7), "who is now");
      Clear (H);
      Assert
        (Count_Of (H, Monitor) = 0 and then Count_Of (H, 7) = 0,
         "not cleared");
      Extend (L, H, Grown);
      Assert (not Grown and then L.Count = 1, "nobody has come since");
   end Test_Forgets;

   procedure Test_Many is
      H     : History;
      L     : List;
      Grown : Boolean;
   begin
      for Round in 1 .. Threshold loop
         for S in 1 .. Max_Sources loop
            Note (H, Admission.Networks.Source (S));
         end loop;
      end loop;
      Extend (L, H, Grown);
      Assert (Grown and then L.Count = Max_Sources, "not all");
      Assert
        ((for all S in 1 .. Max_Sources =>
            Contains (L, Admission.Networks.Source (S))),
         "somebody else");
      for Number in 1 .. Max_Arrivals loop
         Note (H, 100);
      end loop;
      Extend (L, H, Grown);
      Assert (not Grown and then not Contains (L, 100), "no more room");
   end Test_Many;

   procedure Test_One is
      H     : History;
      L     : List;
      Grown : Boolean;
   begin
      Extend (L, H, Grown);
      Assert (not Grown and then L.Count = 0, "nobody has come");
      Note (H, Monitor);
      for Number in 1 .. Threshold - 1 loop
         Note (H, 7);
         Extend (L, H, Grown);
         Assert (not Grown, "some connections are no flood");
      end loop;
      Note (H, 7);
      Extend (L, H, Grown);
      Assert (Grown and then L.Count = 1 and then Contains (L, 7), "a flood");
      Assert (not Contains (L, Monitor), "the monitor");
      Note (H, 7);
      Extend (L, H, Grown);
      Assert (not Grown and then L.Count = 1, "twice in the list");
   end Test_One;

   procedure Test_Released is
      --  The oldest first; the others stay, in their order
      H     : History;
      L     : List := (Items => (7, 8, 9, others => 0), Count => 3);
      Grown : Boolean;
   begin
      Remove_Oldest (L);
      Assert
        (L.Count = 2 and then L.Items (1 .. 2) = (8, 9), "somebody else");
      for Number in 1 .. Threshold loop
         Note (H, 7);
      end loop;
      Extend (L, H, Grown);
      Assert
        (Grown and then L.Items (1 .. L.Count) = (8, 9, 7),
         "who floods again is the last to be released");
      for Number in 1 .. 3 loop
         Remove_Oldest (L);
      end loop;
      Assert (L.Count = 0, "some are left");
   end Test_Released;

   procedure Test_Too_Many is
      --  Then no source is blocked: it could be the monitor
      H     : History;
      L     : List;
      Grown : Boolean;
   begin
      for Number in 1 .. 5 * Max_Arrivals loop
         Note (H, Admission.Networks.Source (Number mod (2 * Max_Sources)));
      end loop;
      Extend (L, H, Grown);
      Assert (not Grown and then L.Count = 0, "somebody is blocked");
   end Test_Too_Many;

   procedure Add_Tests is
   begin
      Add_Test ("one floods", Test_One'Access);
      Add_Test ("as many as there is room for", Test_Many'Access);
      Add_Test ("too many to tell apart", Test_Too_Many'Access);
      Add_Test ("what is long ago", Test_Forgets'Access);
      Add_Test ("one after the other is released", Test_Released'Access);
   end Add_Tests;

end Blocklists_Tests;
