--  SPDX-License-Identifier: GPL-3.0-or-later
--  Whatever the monitor sends becomes lines.

package Monitor.Protocol.Proof with SPARK_Mode, Ghost is

   procedure Prove_Reading (Text : String)
   with
     Pre => Text'First = 1
       and then Text'Last < Integer'Last
       and then (for all C of Text => C not in Line_Feed | Telnet_Mark);
   --  Any other characters and a line feed make one line: these characters
   --  without a final carriage return, or an empty line if there are more than
   --  Max_Line. Asserted in the body. Parse accepts any line.

end Monitor.Protocol.Proof;
