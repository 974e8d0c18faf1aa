--  SPDX-License-Identifier: GPL-3.0-or-later
--  The calls for a file that holds a secret: each returns what the system
--  says, and decides nothing.

private package Admission.Secret_Files.Calls with
  SPARK_Mode,
  Abstract_State =>
    (System_Files with
       Synchronous, External => (Async_Readers, Async_Writers),
       Part_Of => Files),
  Initializes => System_Files
is

   subtype Outcome is Integer range -Integer'Last .. Integer'Last;
   --  What a call returns, or, if it fails, its error (errno), negative

   procedure Open (Path : String; Result : out Outcome)
   with Global => (In_Out => System_Files);
   --  Result: the descriptor, for reading, which does not wait

   procedure Get_Status
     (File   : Outcome;
      Mode   : out Admission.Authentication.File_Mode;
      Owner  : out Admission.Authentication.User_Number;
      Result : out Outcome)
   with Global => (In_Out => System_Files);

   procedure Read
     (File : Outcome; Data : in out String; Result : out Outcome)
   with
     Global => (In_Out => System_Files),
     Post   => Result <= Data'Length;
   --  Into the first characters of Data. Result: their number

   procedure Close (File : Outcome) with Global => (In_Out => System_Files);

end Admission.Secret_Files.Calls;
