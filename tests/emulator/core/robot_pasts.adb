--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the robot was a while ago: the newest events in a ring.

package body Robot_Pasts with SPARK_Mode is

   procedure Add (P : in out Past; R : Robot) is
   begin
      P.Last := (if P.Last = Capacity then 1 else P.Last + 1);
      P.Item (P.Last) := R;
      P.Length := Natural'Min (P.Length + 1, Capacity);
   end Add;

   function Robot_At (P : Past; Time : Robot_Core.Time_Point) return Robot
   is
      Found  : Place := P.Last;
      Result : Robot;
   begin
      for K in 2 .. P.Length loop
         exit when Clock (P.Item (Found)) <= Time;
         Found := (if Found = 1 then Capacity else Found - 1);
      end loop;
      Result := P.Item (Found);
      Advance_To (Result, Time);
      return Result;
   end Robot_At;

end Robot_Pasts;
