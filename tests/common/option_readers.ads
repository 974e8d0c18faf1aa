--  SPDX-License-Identifier: GPL-3.0-or-later
--  The command line, argument by argument: options, with values after a blank
--  or "=", and other words.

package Option_Readers is

   Bad_Usage : exception;
   --  The message names the argument and the error

   function Next return Boolean;
   --  Advances to the next option or word; False if there is none. Raises
   --  Bad_Usage if the option before had a value that was not read.

   function Name return String;
   --  The option or word

   function Value return String;
   --  The option's value. Raises Bad_Usage if it is missing.

   function Number
     (Low : Integer := 1; High : Integer := Integer'Last) return Integer;
   --  Its decimal value. Raises Bad_Usage if it is not in Low .. High.

   procedure Refuse with No_Return;
   --  Raises Bad_Usage: there is no such option or word

end Option_Readers;
