--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Message_Holds with SPARK_Mode is

   procedure Begin_Hold
     (H : in out Hold; New_Command : Boolean; Now : Time) is
   begin
      if not H.On then
         H.First := Now;
      end if;
      if not H.On or else New_Command then
         H.Since := Now;
      end if;
      H.On := True;
   end Begin_Hold;

end Monitor.Message_Holds;
