--  SPDX-License-Identifier: GPL-3.0-or-later
--  Signals that end the program.

with Ada.Interrupts.Names; use Ada.Interrupts.Names;

package body Interruptions is

   pragma Unreserve_All_Interrupts;
   --  Otherwise the run time handles SIGINT itself

   protected Signals is
      entry Await;
   private
      procedure Note
      with Attach_Handler => SIGINT;
      procedure Note_Termination
      with Attach_Handler => SIGTERM;
      Come : Boolean := False;
   end Signals;

   protected body Signals is

      entry Await when Come is
      begin
         Come := False;
      end Await;

      procedure Note is
      begin
         Come := True;
      end Note;

      procedure Note_Termination is
      begin
         Come := True;
      end Note_Termination;

   end Signals;

   procedure Await is
   begin
      Signals.Await;
   end Await;

end Interruptions;
