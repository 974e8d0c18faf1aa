--  SPDX-License-Identifier: GPL-3.0-or-later
--  What a network and those who use it can do to the supervisor.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Faults;                use Faults;
with Worlds;                use Worlds;

package body Network_Faults is

   --  The monitor leaves

   type Departure is new Fault with record
      How : Manner := Orderly;
   end record;

   overriding procedure Inject (F : in out Departure; W : in out World);

   ------------
   -- Inject --
   ------------

   overriding procedure Inject (F : in out Departure; W : in out World) is
   begin
      W.Lose (F.How);
   end Inject;

   --------------
   -- Register --
   --------------

   procedure Register is
   begin
      Add (new Departure'
             (Name   => To_Unbounded_String ("orderly close"),
              Ends   => Session_Ends,
              How    => Orderly,
              others => <>));
   end Register;

end Network_Faults;
