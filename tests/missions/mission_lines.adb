--  SPDX-License-Identifier: GPL-3.0-or-later
--  Results of missions as JSON.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Json_Texts;            use Json_Texts;
with Plain_Numbers;         use Plain_Numbers;

package body Mission_Lines is

   function Beginning (Kind : String; P : Plan) return String is
     ("{""kind"": " & Quoted (Kind) & ", ""number"": " & Image (P.Number)
      & ", ""faults"": " & (if P.Faulty then "true" else "false")
      & ", ""speed"": " & Image (P.Wheels.Speed)
      & ", ""turn_speed"": " & Image (P.Wheels.Turn_Speed)
      & ", ""overshoot"": " & Image (P.Wheels.Overshoot)
      & ", ""pull"": " & Image (P.Wheels.Pull)
      & ", ""points"": " & Image (P.Count));

   function Line
     (Kind : String; P : Plan; V : Verdict; Repeated : Natural := 0)
      return String
   is
     (Beginning (Kind, P)
      & ", ""end"": "
      & Quoted (if V.Done then "done" else To_String (V.Reason))
      & ", ""time"": " & Rounded (Float (V.Time), 3)
      & ", ""exact"": " & Rounded (Float (V.Exact), 3)
      & ", ""passed"": " & Image (V.Passed)
      & ", ""pass"": "
      & (if V.Pass > 1_000.0 then "null" else Rounded (Float (V.Pass), 1))
      & ", ""clearance"": " & Rounded (Float (V.Clearance), 1)
      & ", ""blind"": " & Rounded (Float (V.Blind) * 1_000.0, 0)
      & ", ""orders"": " & Image (V.Orders)
      & ", ""repeated"": " & Image (Repeated)
      & ", ""wrong"": " & Quoted (To_String (V.Wrong)) & "}");

   function Line (Kind : String; P : Plan; Failure : String) return String is
     (Beginning (Kind, P) & ", ""wrong"": " & Quoted (Failure) & "}");

end Mission_Lines;
