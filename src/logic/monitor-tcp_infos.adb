--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Tcp_Infos with SPARK_Mode is

   procedure Get_Queue
     (Info          : Tcp_Info;
      Filled        : Natural;
      Usual_Limit   : Natural;
      Length, Limit : out Natural) is
   begin
      if Filled < Queue_Bytes then
         Length := 0;
         Limit := Usual_Limit;
      else
         Length := To_Natural (Interfaces.Unsigned_64 (Info.Unacked));
         Limit := To_Natural (Interfaces.Unsigned_64 (Info.Selected));
      end if;
   end Get_Queue;

end Monitor.Tcp_Infos;
