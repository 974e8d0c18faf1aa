--  SPDX-License-Identifier: GPL-3.0-or-later

package body Admission.Pending_Connections with SPARK_Mode is

   function Oldest_Waiting
     (T : Table; S : Admission.Networks.Source) return Place_Choice
   with
     Post =>
       (if Oldest_Waiting'Result in Place then
           Is_Waiting (T, Oldest_Waiting'Result)
           and then Source_Of (T, Oldest_Waiting'Result) = S);
   --  The connection of this source that has waited longest

   function Of_Most (T : Table) return Place_Choice
   with
     Post => (if Of_Most'Result in Place then
                 Is_Waiting (T, Of_Most'Result));
   --  The connection that has waited longest, of the sources with most
   --  connections; none if no source has two

   function Count_Of
     (T : Table; S : Admission.Networks.Source) return Place_Count is
      Result : Place_Count := 0;
   begin
      for P in Place loop
         if T.Items (P).Taken and then T.Items (P).Source = S then
            Result := Result + 1;
         end if;
         pragma Loop_Invariant (Result <= P);
      end loop;
      return Result;
   end Count_Of;

   procedure Enter
     (T : in out Table; P : Place; S : Admission.Networks.Source) is
      Served : Order;
   begin
      T.Steps := T.Steps + 1;
      Served := T.Steps;
      for Q in Place loop
         if T.Items (Q).Taken and then T.Items (Q).Source = S then
            Served := T.Items (Q).Served;
         end if;
         pragma Loop_Invariant
           (for all R in 1 .. Q =>
              (if T.Items (R).Taken and then T.Items (R).Source = S then
                  Served = T.Items (R).Served));
      end loop;
      T.Items (P) :=
        (Taken => True, Kept => False, Source => S, Came => T.Steps,
         Served => Served, Heard => T.Steps);
   end Enter;

   function First_Kept (T : Table) return Place_Choice is
      Result : Place_Choice := No_Place;
   begin
      for P in Place loop
         if Is_Kept (T, P)
           and then (Result = No_Place
                     or else not Came_First (T, Result, P))
         then
            Result := P;
         end if;
         pragma Loop_Invariant
           (if Result in Place then
               Result <= P
               and then Is_Kept (T, Result)
               and then (for all Q in 1 .. P =>
                           (if Is_Kept (T, Q) then
                               Came_First (T, Result, Q)))
            else (for all Q in 1 .. P => not Is_Kept (T, Q)));
      end loop;
      return Result;
   end First_Kept;

   function Free_Place (T : Table) return Place_Choice is
   begin
      for P in Place loop
         if not Is_Taken (T, P) then
            return P;
         end if;
         pragma Loop_Invariant (for all Q in 1 .. P => Is_Taken (T, Q));
      end loop;
      return No_Place;
   end Free_Place;

   procedure Keep (T : in out Table; P : Place) is
   begin
      T.Items (P).Kept := True;
   end Keep;

   procedure Leave (T : in out Table; P : Place) is
   begin
      T.Items (P) := (others => <>);
   end Leave;

   function Next (T : Table; Due : Place_Set) return Place_Choice is
      Result : Place_Choice := No_Place;
   begin
      for P in Place loop
         if Due (P)
           and then Is_Waiting (T, P)
           and then (Result = No_Place or else not Is_Before (T, Result, P))
         then
            Result := P;
         end if;
         pragma Loop_Invariant
           (if Result in Place then
               Result <= P
               and then Due (Result)
               and then Is_Waiting (T, Result)
               and then (for all Q in 1 .. P =>
                           (if Due (Q) and then Is_Waiting (T, Q) then
                               Is_Before (T, Result, Q)))
            else (for all Q in 1 .. P =>
                    not (Due (Q) and then Is_Waiting (T, Q))));
      end loop;
      return Result;
   end Next;

   function Of_Most (T : Table) return Place_Choice is
      Result : Place_Choice := No_Place;
      Most   : Place_Count  := 1;
      Count  : Place_Count;
   begin
      for P in Place loop
         if Is_Waiting (T, P) then
            Count := Count_Of (T, T.Items (P).Source);
            if Count > Most
              or else (Result in Place
                       and then Count = Most
                       and then not Came_First (T, Result, P))
            then
               Result := P;
               Most := Count;
            end if;
         end if;
         pragma Loop_Invariant
           (if Result in Place then Is_Waiting (T, Result));
      end loop;
      return Result;
   end Of_Most;

   function Oldest_Waiting
     (T : Table; S : Admission.Networks.Source) return Place_Choice
   is
      Result : Place_Choice := No_Place;
   begin
      for P in Place loop
         if Is_Waiting (T, P)
           and then T.Items (P).Source = S
           and then (Result = No_Place
                     or else not Came_First (T, Result, P))
         then
            Result := P;
         end if;
         pragma Loop_Invariant
           (if Result in Place then
               Is_Waiting (T, Result)
               and then Source_Of (T, Result) = S);
      end loop;
      return Result;
   end Oldest_Waiting;

   procedure Serve (T : in out Table; P : Place) is
      S : constant Admission.Networks.Source := T.Items (P).Source;
   begin
      T.Steps := T.Steps + 1;
      T.Items (P).Heard := T.Steps;
      for Q in Place loop
         if T.Items (Q).Taken and then T.Items (Q).Source = S then
            T.Items (Q).Served := T.Steps;
         end if;
         pragma Loop_Invariant (Is_Same (T, T'Loop_Entry));
         pragma Loop_Invariant
           (for all R in Place =>
              T.Items (R).Served =
                (if R <= Q
                   and then T.Items (R).Taken
                   and then T.Items (R).Source = S
                 then T.Steps
                 else T'Loop_Entry.Items (R).Served));
         pragma Loop_Invariant (T.Steps = T'Loop_Entry.Steps);
      end loop;
   end Serve;

   function Surplus (T : Table; P : Place) return Place_Choice is
      S      : constant Admission.Networks.Source := T.Items (P).Source;
      Chosen : Place_Choice;
   begin
      if Count_Of (T, S) > Share then
         Chosen := Oldest_Waiting (T, S);
      elsif Has_Free_Place (T) then
         return No_Place;
      else
         Chosen := Of_Most (T);
      end if;
      return
        (if Chosen in Place and then Has_Sibling (T, Chosen) then Chosen
         else P);
   end Surplus;

end Admission.Pending_Connections;
