--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces.C; use Interfaces.C;
with Linux;        use Linux;

package body Console.Calls with
  SPARK_Mode    => Off,
  Refined_State => (Streams => null)
is
   --  Off: addresses are passed to C

   procedure Write (To : Stream; Text : String; Result : out Outcome) is
   begin
      Result := Outcome_Of
        (Ssize'Min
           (Linux.Write
              (1 + Stream'Pos (To), Text'Address, Text'Length),
            Text'Length));
   end Write;

   Found : int;

begin
   loop
      Found := Open_File (To_C ("/dev/null"), 2);  --  O_RDWR
      exit when Found not in 0 .. 2;
   end loop;
   if Found > 2 then
      Linux.Close (Found);
   end if;
end Console.Calls;
