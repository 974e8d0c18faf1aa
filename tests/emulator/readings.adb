--  SPDX-License-Identifier: GPL-3.0-or-later
--  Numbers, words and poses as a person writes them.

with Ada.Strings.Fixed;
with Ada.Strings.Maps;

with Answer_Faults;

package body Readings is

   use type Robot_Motion.Micro;

   subtype Micro is Robot_Motion.Micro;

   subtype Digit is Character range '0' .. '9';

   function Scaled (Text : String; Decimals : Natural) return Micro is
      --  A decimal number times 10 ** Decimals; more decimals are cut off.
      --  Bad_Value where it is none or above a million.
      Limit    : constant := 1_000_000;

      Value    : Micro := 0;
      Left     : Integer := -1;
      --  Decimals still to come; negative before the point
      Seen     : Boolean := False;
      Negative : constant Boolean :=
        Text'Length > 0 and then Text (Text'First) = '-';
   begin
      for K in Text'Range loop
         if K = Text'First and then Negative then
            null;
         elsif Text (K) = '.' and then Left < 0 then
            Left := Decimals;
         elsif Text (K) in Digit and then Value <= Limit * 10 ** 6 then
            Seen := True;
            if Left /= 0 then
               Value := Value * 10
                 + Character'Pos (Text (K)) - Character'Pos ('0');
               Left := Integer'Max (Left - 1, -1);
            end if;
         else
            Seen := False;
            exit;
         end if;
      end loop;

      if Seen then
         if Left < 0 then
            Left := Decimals;
         end if;
         Value := Value * 10 ** Left;
      end if;
      if not Seen or else Value > Limit * 10 ** Decimals then
         raise Bad_Value with "'" & Text & "' is not a number";
      end if;
      return (if Negative then -Value else Value);
   end Scaled;

   function Plain (Value : Integer) return String is
     (Ada.Strings.Fixed.Trim (Value'Image, Ada.Strings.Left));

   function Battery (Text : String) return Robot_Core.Centivolts is
      Volts : Float;
   begin
      for Level in Robot_Core.Battery_Level loop
         if Text = (case Level is
                       when Robot_Core.Critical => "critical",
                       when Robot_Core.Empty    => "0",
                       when Robot_Core.Low      => "1",
                       when Robot_Core.Full     => "2")
         then
            return Robot_Core.Typical (Level);
         end if;
      end loop;
      Volts := Float'Value (Text);
      if Volts in 2.5 .. 5.0 then
         return Robot_Core.Centivolts (100.0 * Volts);
      end if;
      raise Constraint_Error;
   exception
      when Constraint_Error =>
         raise Bad_Value with
           "a battery level is 0, 1, 2 or critical, or 2.5 to 5.0 V, not '"
           & Text & "'";
   end Battery;

   function Bytes (Text : String) return Robot_Core.Octets is
      Result : Robot_Core.Octets (1 .. Data_Length'Last);
      Last   : Natural := 0;
      Next   : Positive := Text'First;

      procedure Put (Byte : Robot_Core.Octet) is
      begin
         if Last = Result'Last then
            raise Bad_Value with "more than 256 bytes";
         end if;
         Last := Last + 1;
         Result (Last) := Byte;
      end Put;

   begin
      while Next <= Text'Last loop
         if Text (Next) /= '\' then
            Put (Character'Pos (Text (Next)));
            Next := Next + 1;
         elsif Next = Text'Last then
            raise Bad_Value with "a backslash at the end";
         elsif Text (Next + 1) = 'x' and then Next + 3 <= Text'Last then
            begin
               Put (Robot_Core.Octet'Value
                      ("16#" & Text (Next + 2 .. Next + 3) & "#"));
            exception
               when Constraint_Error =>
                  raise Bad_Value with
                    "'" & Text (Next .. Next + 3) & "' is not \xHH";
            end;
            Next := Next + 4;
         else
            case Text (Next + 1) is
               when 'r' =>
                  Put (16#0D#);
               when 'n' =>
                  Put (16#0A#);
               when '\' =>
                  Put (Character'Pos ('\'));
               when others =>
                  raise Bad_Value with
                    "after a backslash comes r, n, \ or xHH";
            end case;
            Next := Next + 2;
         end if;
      end loop;
      return Result (1 .. Last);
   end Bytes;

   function Image (Value : Micro; Unit : Positive) return String is
      Thousandths : constant Micro := abs Value * 1_000 / Micro (Unit);
      Part : constant String := Micro'Image (1_000 + Thousandths mod 1_000);
      --  With a leading 1 that keeps the zeros
   begin
      return (if Value < 0 then "-" else "")
        & Plain (Integer (Thousandths / 1_000))
        & '.' & Part (Part'Last - 2 .. Part'Last);
   end Image;

   function Is_Word_Of (Text : String; Kind : Robot_Bench.Fault_Kind)
     return Boolean
   is (Text = Ada.Strings.Fixed.Translate
                (Kind'Image, Ada.Strings.Maps.To_Mapping
                   ("_ABCDEFGHIJKLMNOPQRSTUVWXYZ",
                    "-abcdefghijklmnopqrstuvwxyz")));

   function Fault_Value (Kind : Robot_Bench.Fault_Command; Text : String)
     return Natural
   is
      use all type Robot_Bench.Fault_Kind;
      Most  : constant Natural :=
        (case Kind is
            when Radio_Losses .. Radio_Retries => 100,
            when Lose_Every | Drop_Every      => 1_000,
            when Pile                         => Answer_Faults.Max_Pile,
            when others                       =>
               Answer_Faults.Remaining'Last);
      Value : constant Natural :=
        (if Kind in Silent | Endless then Boolean'Pos (On_Or_Off (Text))
         else Whole (Text, 0, Most));
   begin
      if Value = 1 and then Kind in Lose_Every | Drop_Every then
         raise Bad_Value with "0, or 2 to 1000 is expected";
      end if;
      return Value;
   end Fault_Value;

   function On_Or_Off (Text : String) return Boolean is
   begin
      if Text = "on" then
         return True;
      elsif Text = "off" then
         return False;
      end if;
      raise Bad_Value with "on or off is expected, not '" & Text & "'";
   end On_Or_Off;

   function Pose (X, Y, Angle : String) return Robot_Motion.Pose is
      use Robot_Motion;

      In_X    : constant Micro := Scaled (X, Decimals => 4);
      In_Y    : constant Micro := Scaled (Y, Decimals => 4);
      Degrees : constant Micro := Scaled (Angle, Decimals => 6);
   begin
      if In_X not in X_Position or else In_Y not in Y_Position then
         raise Bad_Value with
           "the robot's centre can be at "
           & Image (X_Position'First, 10_000) & " .. "
           & Image (X_Position'Last, 10_000) & ", "
           & Image (Y_Position'First, 10_000) & " .. "
           & Image (Y_Position'Last, 10_000) & " cm";
      end if;
      return (In_X, In_Y, Degrees mod Full_Turn);
   end Pose;

   procedure Size
     (Text   : String;
      Width  : out Arena_Camera.Frame_Width;
      Height : out Arena_Camera.Frame_Height)
   is
      use Arena_Camera;
      Cross : constant Natural := Ada.Strings.Fixed.Index (Text, "x");
   begin
      if Cross = 0 then
         raise Bad_Value with "WIDTHxHEIGHT is expected";
      end if;
      Width := Whole (Text (Text'First .. Cross - 1),
                      Frame_Width'First, Frame_Width'Last);
      Height := Whole (Text (Cross + 1 .. Text'Last),
                       Frame_Height'First, Frame_Height'Last);
   end Size;

   function Whole (Text : String; Low, High : Integer) return Integer is
      Value : Integer;
   begin
      if Text'Length = 0
        or else (for some C of Text => C not in Digit | '-')
      then
         raise Constraint_Error;
      end if;
      Value := Integer'Value (Text);
      if Value not in Low .. High then
         raise Constraint_Error;
      end if;
      return Value;
   exception
      when Constraint_Error =>
         raise Bad_Value with
           "a number from " & Plain (Low) & " to " & Plain (High)
           & " is expected, not '" & Text & "'";
   end Whole;

end Readings;
