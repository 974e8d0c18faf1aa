--  SPDX-License-Identifier: GPL-3.0-or-later
--  All fuzz targets of the pure packages, by their names, in the form in
--  which fuzz_engine.h calls them.

with Ada.Exceptions;
with Ada.Text_IO; use Ada.Text_IO;
with Admission_Targets;
with Bytes;
with Monitor_Targets;
with Robot_Targets;
with Text_Targets;

package body Logic_Targets is

   Chosen : Target_Kind := Lines;

   procedure Run (Data : Bytes.Byte_Array) is
   begin
      case Chosen is
         when Lines     => Monitor_Targets.Lines (Data);
         when Frames    => Robot_Targets.Frames (Data);
         when Commands  => Robot_Targets.Commands (Data);
         when Sessions  => Robot_Targets.Sessions (Data);
         when Networks  => Admission_Targets.Network_Lists (Data);
         when Tokens    => Admission_Targets.Tokens (Data);
         when Arguments => Text_Targets.Arguments (Data);
         when Base64    => Text_Targets.Base64_Texts (Data);
      end case;
   end Run;

   procedure Crash
   with Import, Convention => C, External_Name => "fuzz_crash", No_Return;

   procedure Choose (Target : Target_Kind) is
   begin
      Chosen := Target;
   end Choose;

   procedure Give (Data : System.Address; Size : Interfaces.C.size_t) is
      Input : Bytes.Byte_Array (1 .. Natural (Size))
      with Import, Address => Data;
   begin
      Run (Input);
   exception
      when Occurrence : others =>
         Put_Line
           (Standard_Error, Ada.Exceptions.Exception_Information (Occurrence));
         Crash;
   end Give;

end Logic_Targets;
