--  SPDX-License-Identifier: GPL-3.0-or-later
--  Blocklists: who floods, and who only connects now and then.

with AUnit.Assertions;     use AUnit.Assertions;

with Admission.Blocklists; use Admission.Blocklists;
with Admission.Networks;
with Interfaces;           use Interfaces;

package body Blocklists_Tests is

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   Monitor : constant Admission.Networks.Source :=
     Admission.Networks.IPv4_Sources + 1;

   procedure Test_One (T : in out Any_Test);
   procedure Test_Many (T : in out Any_Test);
   procedure Test_Too_Many (T : in out Any_Test);
   procedure Test_Forgets (T : in out Any_Test);

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Admission.Blocklists"));

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_One'Access, "one floods");
      Register_Routine (T, Test_Many'Access, "as many as there is room for");
      Register_Routine (T, Test_Too_Many'Access, "too many to tell apart");
      Register_Routine (T, Test_Forgets'Access, "what is long ago");
   end Register_Tests;

   procedure Test_Forgets (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Many (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_One (T : in out Any_Test) is
      pragma Unreferenced (T);
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

   procedure Test_Too_Many (T : in out Any_Test) is
      pragma Unreferenced (T);
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

end Blocklists_Tests;
