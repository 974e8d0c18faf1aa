--  SPDX-License-Identifier: GPL-3.0-or-later
--  Waiting for descriptors, with nanosecond resolution.

with Interfaces.C;

with Libc;

package Polls is

   procedure Wait (Files : in out Libc.Poll_Array; Span : Duration);
   --  Waits until something is ready or Span has passed; returns at once
   --  unless Span is positive. A failure or a signal is reported as nothing
   --  ready.

   function Is_Readable
     (File : Interfaces.C.int; Span : Duration) return Boolean;
   --  Or at its end; waits Span at most

end Polls;
