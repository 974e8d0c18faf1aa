--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls for a file that holds a secret.

private package Admission.Secret_Files.Calls with
  SPARK_Mode,
  Abstract_State =>
    (System_Files with
       Synchronous, External => (Async_Readers, Async_Writers),
       Part_Of => Files),
  Initializes => System_Files
is

   procedure Read
     (Path   : String;
      Data   : in out String;
      Mode   : out File_Mode;
      Owner  : out User_Number;
      Result : out Integer)
   with
     Global => (In_Out => System_Files),
     Post   => Result in -Integer'Last .. Data'Length;
   --  Into the first characters of Data, without waiting. Mode and Owner: of
   --  the file that was read. Result: the number of characters, or, if a call
   --  fails, its error (errno), negative

end Admission.Secret_Files.Calls;
