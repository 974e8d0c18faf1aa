--  SPDX-License-Identifier: GPL-3.0-or-later

package body Monitor.Protocol.Proof with SPARK_Mode is

   procedure Prove_Reading (Text : String) is
      R        : Line_Reader;
      Line     : String (1 .. Max_Line) := (others => ' ');
      Last     : Natural;
      Size     : Natural := 0;
      Complete : Boolean;
   begin
      for I in Text'Range loop
         Accept_Character (R, Text (I), Complete);
         pragma Assert (not Complete);
         Size := (if Text (I) = Carriage_Return then I - 1 else I);
         pragma Loop_Invariant (not R.Finished);
         pragma Loop_Invariant (R.Held = (Text (I) = Carriage_Return));
         pragma Loop_Invariant
           (Size = (if Text (I) = Carriage_Return then I - 1 else I));
         pragma Loop_Invariant (R.Length = Integer'Min (Size, Max_Line));
         pragma Loop_Invariant (R.Too_Long = (Size > Max_Line));
         pragma Loop_Invariant
           (for all J in 1 .. R.Length => R.Data (J) = Text (J));
      end loop;
      Accept_Character (R, Line_Feed, Complete);
      pragma Assert (Complete);
      Get_Line (R, Line, Last);
      pragma Assert
        (Size = (if Text'Length > 0
                   and then Text (Text'Last) = Carriage_Return
                 then Text'Length - 1 else Text'Length));
      pragma Assert (Last = (if Size > Max_Line then 0 else Size));
      pragma Assert (for all I in 1 .. Last => Line (I) = Text (I));
   end Prove_Reading;

end Monitor.Protocol.Proof;
