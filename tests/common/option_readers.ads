--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line, an argument after the other: options, with values
--  behind a blank or behind "=", and other words.

package Option_Readers is

   Bad_Usage : exception;
   --  The message says what is wrong with which argument

   function Next return Boolean;
   --  Goes on to the next option or word; False where there is none. Raises
   --  Bad_Usage if the option before was given a value that nobody took.

   function Name return String;
   --  The option or word

   function Value return String;
   --  Of the option, which has one. Raises Bad_Usage where it is missing.

   function Number
     (Low : Integer := 1; High : Integer := Integer'Last) return Integer;
   --  Its value, in decimal. Raises Bad_Usage where it is none in Low .. High.

   procedure Refuse with No_Return;
   --  Raises Bad_Usage: there is no such option or word

end Option_Readers;
