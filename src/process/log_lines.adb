--  SPDX-License-Identifier: GPL-3.0-or-later

package body Log_Lines with SPARK_Mode is

   procedure Put (S : in out State; Item : Line) is
   begin
      if not Queues.Is_Full (S.Kept) then
         Queues.Put (S.Kept, Item);
      elsif S.Not_Kept < Natural'Last then
         S.Not_Kept := S.Not_Kept + 1;
      end if;
   end Put;

   procedure Take
     (S       : in out State;
      Item    : out Line;
      Found   : out Boolean;
      Missing : out Natural) is
   begin
      if Queues.Length (S.Kept) > 0 and then S.Not_Kept > 0 then
         Found := True;
         Missing := S.Not_Kept;
         Item :=
           (Level  => Options.Warning,
            Time   => Queues.Element_At (S.Kept, 1).Time,
            others => <>);
         S.Not_Kept := 0;
      else
         Queues.Take (S.Kept, Item, Found);
         Missing := 0;
      end if;
      S.Writing := Found;
   end Take;

   procedure Written (S : in out State) is
   begin
      S.Writing := False;
   end Written;

end Log_Lines;
