--  SPDX-License-Identifier: GPL-3.0-or-later
--  All fuzz targets of the pure packages.

with Ada.Exceptions;
with Ada.Text_IO; use Ada.Text_IO;
with Admission_Targets;
with Bytes;
with Robot_Targets;
with Text_Targets;

package body Logic_Targets is

   procedure Crash
   with Import, Convention => C, External_Name => "fuzz_crash", No_Return;

   procedure Give
     (Target : Interfaces.C.int;
      Data   : System.Address;
      Size   : Interfaces.C.size_t)
   is
      Input : Bytes.Byte_Array (1 .. Natural (Size))
      with Import, Address => Data;
   begin
      case Target_Kind'Val (Target) is
         when Lines     => Text_Targets.Lines (Input);
         when Frames    => Robot_Targets.Frames (Input);
         when Sessions  => Robot_Targets.Sessions (Input);
         when Networks  => Admission_Targets.Network_Lists (Input);
         when Tokens    => Admission_Targets.Tokens (Input);
         when Arguments => Text_Targets.Arguments (Input);
      end case;
   exception
      when Occurrence : others =>
         Put_Line
           (Standard_Error, Ada.Exceptions.Exception_Information (Occurrence));
         Crash;
   end Give;

end Logic_Targets;
