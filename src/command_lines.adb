--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line: read once, before the server begins.

with Ada.Exceptions;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;
with Ada.Strings.Fixed;
with GNAT.Command_Line;     use GNAT.Command_Line;
with Texts;

package body Command_Lines is

   Usage_Error : exception;

   Why : Unbounded_String;

   function Number
     (Name : String; Value : String; First, Last : Integer) return Integer;
   --  Value in First .. Last, or Usage_Error

   function Given (Name : String; Value : String) return Texts.Text;
   --  Value, not empty and not too long, or Usage_Error

   procedure Fail (Message : String) with No_Return;

   procedure Set_Size (Value : String; Chosen : in out Options.Values);

   ----------
   -- Fail --
   ----------

   procedure Fail (Message : String) is
   begin
      raise Usage_Error with Message;
   end Fail;

   -----------
   -- Given --
   -----------

   function Given (Name : String; Value : String) return Texts.Text is
   begin
      if Value = "" or else Value'Length > Texts.Max_Length then
         Fail (Name & ": 1 .." & Texts.Max_Length'Image
               & " characters expected");
      end if;
      return Texts.To_Text (Value);
   end Given;

   ------------
   -- Number --
   ------------

   function Number
     (Name : String; Value : String; First, Last : Integer) return Integer
   is
      Result : Integer := Integer'First;
   begin
      if Value'Length in 1 .. 9
        and then (for all C of Value => C in '0' .. '9')
      then
         Result := Integer'Value (Value);
      end if;
      if Result not in First .. Last then
         Fail (Name & ": '" & Value & "' is not a number in"
               & First'Image & " .." & Last'Image);
      end if;
      return Result;
   end Number;

   --------------
   -- Set_Size --
   --------------

   procedure Set_Size (Value : String; Chosen : in out Options.Values) is
      Cross : constant Natural := Ada.Strings.Fixed.Index (Value, "x");
   begin
      if Cross = 0 then
         Fail ("--frame-size: '" & Value & "' is not WIDTHxHEIGHT");
      end if;
      Chosen.Width := Number
        ("--frame-size", Value (Value'First .. Cross - 1),
         Options.Pixel_Count'First, Options.Pixel_Count'Last);
      Chosen.Height := Number
        ("--frame-size", Value (Cross + 1 .. Value'Last),
         Options.Pixel_Count'First, Options.Pixel_Count'Last);
   end Set_Size;

   ----------
   -- Read --
   ----------

   procedure Read
     (Request : out Request_Kind; Chosen : out Options.Values)
   is
   begin
      Request := Run;
      Chosen := (others => <>);
      loop
         case Getopt ("-port: -bind: -serial: -camera: -frame-size: -fps: "
                      & "-jpeg-quality: -marker: -message-gap: -log-level: "
                      & "-check -version -help h") is
            when ASCII.NUL =>
               exit;
            when 'h' =>
               Request := Show_Help;
               return;
            when '-' =>
               declare
                  Name  : constant String := "-" & Full_Switch;
                  Value : constant String := Parameter;
               begin
                  if Name = "--port" then
                     Chosen.Port := Number (Name, Value, 0, 65_535);
                  elsif Name = "--bind" then
                     Chosen.Bind := Given (Name, Value);
                  elsif Name = "--serial" then
                     Chosen.Serial := Given (Name, Value);
                  elsif Name = "--camera" then
                     Chosen.Camera := Given (Name, Value);
                  elsif Name = "--frame-size" then
                     Set_Size (Value, Chosen);
                  elsif Name = "--fps" then
                     Chosen.Frame_Rate := Number (Name, Value, 1, 100);
                  elsif Name = "--jpeg-quality" then
                     Chosen.Quality := Number (Name, Value, 1, 100);
                  elsif Name = "--marker" then
                     if Value not in "aruco" | "triangle" then
                        Fail ("--marker: '" & Value
                              & "' is neither aruco nor triangle");
                     end if;
                     Chosen.Marker := Options.Marker_Kind'Value (Value);
                  elsif Name = "--message-gap" then
                     Chosen.Message_Gap := Number (Name, Value, 0, 1_000);
                  elsif Name = "--log-level" then
                     if Value not in "error" | "warning" | "info" | "debug"
                     then
                        Fail ("--log-level: '" & Value
                              & "' is no level of the log");
                     end if;
                     Chosen.Log_Level := Options.Level'Value (Value);
                  elsif Name = "--check" then
                     Request := Check;
                  elsif Name = "--version" then
                     Request := Show_Version;
                     return;
                  elsif Name = "--help" then
                     Request := Show_Help;
                     return;
                  end if;
               end;
            when others =>
               Fail ("unknown option " & Full_Switch);
         end case;
      end loop;
      declare
         Rest : constant String := Get_Argument;
      begin
         if Rest /= "" then
            Fail ("unexpected argument '" & Rest & "'");
         end if;
      end;
   exception
      when Invalid_Switch =>
         Why := To_Unbounded_String ("unknown option " & Full_Switch);
         Request := Wrong;
      when Invalid_Parameter =>
         Why := To_Unbounded_String
           ("a value is missing after -" & Full_Switch);
         Request := Wrong;
      when E : Usage_Error =>
         Why := To_Unbounded_String (Ada.Exceptions.Exception_Message (E));
         Request := Wrong;
   end Read;

   ------------
   -- Reason --
   ------------

   function Reason return String is (To_String (Why));

end Command_Lines;
