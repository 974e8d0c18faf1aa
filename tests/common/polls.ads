--  SPDX-License-Identifier: GPL-3.0-or-later
--  Waiting for descriptors, to the nanosecond.

with Interfaces.C;

with Libc;

package Polls is

   procedure Wait (Files : in out Libc.Poll_Array; Span : Duration);
   --  Until something is ready or Span has passed; at once where Span is not
   --  positive. A failure or a signal looks like nothing ready.

   function Is_Readable
     (File : Interfaces.C.int; Span : Duration) return Boolean;
   --  Or at its end; waits Span at most

end Polls;
