--  SPDX-License-Identifier: GPL-3.0-or-later

package body Admission.Networks with SPARK_Mode is

   procedure Read_Number
     (Text  : String;
      Next  : in out Positive;
      Most  : Natural;
      Value : out Natural;
      Found : out Boolean)
   with
     Pre  => Text'First = 1
       and then Text'Last in 0 .. Positive'Last - 1
       and then Next <= Text'Last + 1,
     Post => Next in Next'Old .. Text'Last + 1
       and then (if Found then Value <= Most)
   is
      --  The number, of up to three digits, that begins at Next; moves Next
      --  behind it
      First : constant Positive := Next;
   begin
      Value := 0;
      for I in First .. Text'Last loop
         exit when Text (I) not in '0' .. '9' or else I - First = 3;
         Value := 10 * Value
           + (Character'Pos (Text (I)) - Character'Pos ('0'));
         Next := I + 1;
         pragma Loop_Invariant (Next = I + 1 and then I - First <= 2);
         pragma Loop_Invariant
           (Value <= (if I = First then 9 elsif I = First + 1 then 99
                      else 999));
      end loop;
      Found := Next > First
        and then Value <= Most
        and then (Next = First + 1 or else Text (First) /= '0');
   end Read_Number;

   procedure Parse (Text : String; N : out Network; V : out Verdict) is
      Next  : Positive := 1;
      Part  : Natural;
      Found : Boolean;
   begin
      N := (Start => 0, Length => 32);
      V := No_Address;
      for Octet in 1 .. 4 loop
         if Octet > 1 then
            if Next > Text'Last or else Text (Next) /= '.' then
               return;
            end if;
            Next := Next + 1;
         end if;
         Read_Number (Text, Next, 255, Part, Found);
         if not Found then
            return;
         end if;
         N.Start := N.Start * 256 + Address (Part);
         pragma Loop_Invariant (Next <= Text'Last + 1);
         pragma Loop_Invariant (N.Length = 32);
      end loop;
      if Next <= Text'Last then
         if Text (Next) /= '/' then
            return;
         end if;
         Next := Next + 1;
         Read_Number (Text, Next, 32, Part, Found);
         if not Found or else Next <= Text'Last then
            V := No_Length;
            return;
         end if;
         N.Length := Part;
      end if;
      V := (if Is_Network (N) then Good else Not_Clean);
   end Parse;

end Admission.Networks;
