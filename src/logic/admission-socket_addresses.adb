--  SPDX-License-Identifier: GPL-3.0-or-later

package body Admission.Socket_Addresses with SPARK_Mode is

   procedure Set_Name
     (Name : out Texts.Text; A : Socket_Address; Host : Host_Text)
   is
      Length : Natural := 0;
   begin
      for I in Host'Range loop
         exit when Host (I) = ASCII.NUL;
         Length := I;
         pragma Loop_Invariant (Length = I);
      end loop;
      Texts.Set (Name, (if Is_IPv4 (A) then "" else "["));
      Texts.Append (Name, Host (1 .. Length));
      Texts.Append (Name, (if Is_IPv4 (A) then ":" else "]:"));
      Texts.Append (Name, Port_Of (A));
   end Set_Name;

end Admission.Socket_Addresses;
