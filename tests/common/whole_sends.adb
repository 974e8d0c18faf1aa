--  SPDX-License-Identifier: GPL-3.0-or-later

package body Whole_Sends is

   use Ada.Streams;

   procedure Send
     (To : GNAT.Sockets.Socket_Type; Data : Stream_Element_Array)
   is
      First : Stream_Element_Offset := Data'First;
      Last  : Stream_Element_Offset;
   begin
      while First <= Data'Last loop
         GNAT.Sockets.Send_Socket (To, Data (First .. Data'Last), Last);
         if Last < First then
            raise GNAT.Sockets.Socket_Error with "nothing taken";
         end if;
         First := Last + 1;
      end loop;
   end Send;

   procedure Send (To : GNAT.Sockets.Socket_Type; Text : String) is
      Data : Stream_Element_Array (1 .. Text'Length)
        with Import, Address => Text'Address;
   begin
      Send (To, Data);
   end Send;

end Whole_Sends;
