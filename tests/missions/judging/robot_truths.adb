--  SPDX-License-Identifier: GPL-3.0-or-later
--  The journal of a robot, carried out again.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

package body Robot_Truths is

   use Robot_Motion;

   Millisecond : constant := 1_000_000;

   function Is_Accepted (Item : Note) return Boolean is
     (Length (Item.Answer) > 0 and then Element (Item.Answer, 1) = 'O');

   function Letter (Item : Note) return Character is
     (if Length (Item.Command) = 0 then ' ' else Element (Item.Command, 1));

   function Value (Item : Note) return Amount is
      --  Of a movement
      Text : constant String := To_String (Item.Command);
   begin
      return Integer'Max
        (Amount'First,
         Integer'Min
           (Amount'Last, Integer'Value (Text (Text'First + 2 .. Text'Last))));
   end Value;

   procedure Obey (M : in out Motion; Item : Note; Wheels : Wheel_Errors) is
   begin
      if Is_Accepted (Item) then
         case Letter (Item) is
            when 'M'    => Go (M, Value (Item), Wheels);
            when 'T'    => Turn (M, Value (Item), Wheels);
            when 'r'    => Halt (M);
            when others => null;
         end case;
      end if;
   end Obey;

   procedure Replay
     (Notes    : Emulators.Notes;
      Start    : Robot_Motion.Pose;
      Wheels   : Robot_Motion.Wheel_Errors;
      From, To : Instant;
      See      : not null access procedure
        (Time : Instant; Where : Robot_Motion.Pose; Driving : Boolean))
   is
      M     : Motion;
      Clock : Instant := From;

      procedure Pass (Till : Instant) is
         --  Lets time pass
         Left : Micro := Micro (Till / 1_000) - Micro (Clock / 1_000);
      begin
         while Left > 0 loop
            Advance (M, Micro'Min (Left, Step'Last));
            Left := Left - Micro'Min (Left, Step'Last);
         end loop;
         Clock := Instant'Max (Clock, Till);
      end Pass;

      Next : Instant := From;
   begin
      Place (M, Start);
      for Item of Notes loop
         exit when Item.Last > To;
         while Next <= Item.Last loop
            Pass (Next);
            See (Next, Pose_Of (M), Is_Moving (M));
            Next := Next + Millisecond;
         end loop;
         Pass (Item.Last);
         Obey (M, Item, Wheels);
      end loop;
      while Next <= To loop
         Pass (Next);
         See (Next, Pose_Of (M), Is_Moving (M));
         Next := Next + Millisecond;
      end loop;
   end Replay;

   function Movements (Notes : Emulators.Notes) return Natural is
      Result : Natural := 0;
   begin
      for Item of Notes loop
         if Is_Accepted (Item) and then Letter (Item) in 'M' | 'T'
           and then Value (Item) /= 0
         then
            Result := Result + 1;
         end if;
      end loop;
      return Result;
   end Movements;

end Robot_Truths;
