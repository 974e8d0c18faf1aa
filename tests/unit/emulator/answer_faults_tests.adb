--  SPDX-License-Identifier: GPL-3.0-or-later
--  What goes wrong with an answer on request.

with AUnit.Assertions; use AUnit.Assertions;

with Answer_Faults;    use Answer_Faults;
with Robot_Core;       use Robot_Core;

package body Answer_Faults_Tests is

   use type Octet;

   subtype Any_Test is AUnit.Test_Cases.Test_Case'Class;

   CR : constant Octet := 16#0D#;

   Ack : constant Answer :=
     (Length => 3, Data => (16#4F#, 16#4F#, CR, others => 0));

   P      : Plan;
   Wire   : Wire_Bytes;
   Effect : Effect_Kind;

   function Sent return Octets is (Wire.Data (1 .. Wire.Length));

   function Is_Good_Frame (Data : Octets) return Boolean;

   procedure Test_None (T : in out Any_Test);
   procedure Test_Silent (T : in out Any_Test);
   procedure Test_Drop (T : in out Any_Test);
   procedure Test_Corrupt (T : in out Any_Test);
   procedure Test_Truncate (T : in out Any_Test);
   procedure Test_Garbage (T : in out Any_Test);
   procedure Test_Order (T : in out Any_Test);
   procedure Test_No_Answer (T : in out Any_Test);

   -------------------
   -- Is_Good_Frame --
   -------------------

   function Is_Good_Frame (Data : Octets) return Boolean is
   begin
      for K in Data'Range loop
         if Data (K) = CR then
            return K >= 3
              and then Data (K - 1) = Checksum (Data (1 .. K - 2));
         end if;
      end loop;
      return False;
   end Is_Good_Frame;

   ----------
   -- Name --
   ----------

   overriding function Name (T : Test_Case) return AUnit.Message_String is
     (AUnit.Format ("Answer_Faults"));

   ------------------
   -- Test_Corrupt --
   ------------------

   procedure Test_Corrupt (T : in out Any_Test) is
      pragma Unreferenced (T);
      Close : constant Answer :=
        (Length => 3, Data => (16#0C#, 16#0C#, CR, others => 0));
   begin
      P := (Corrupt => 2, others => <>);
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = Corrupt and then Sent'Length = 3
              and then Wire.Data (3) = CR
              and then not Is_Good_Frame (Sent), "first");

      --  The wrong checksum does not end the frame: 0x0C is near 0x0D

      Apply (P, Close, Wire, Effect);
      Assert (Effect = Corrupt and then Wire.Data (2) not in 16#0C# | CR,
              "second");
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = None and then Is_Good_Frame (Sent), "third is good");
   end Test_Corrupt;

   ---------------
   -- Test_Drop --
   ---------------

   procedure Test_Drop (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      P := (Drop => 3, others => <>);
      for K in 1 .. 3 loop
         Apply (P, Ack, Wire, Effect);
         Assert (Effect = Dropped and then Sent'Length = 0, "dropped");
      end loop;
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = None and then Sent = Ack.Data (1 .. 3), "sent");
   end Test_Drop;

   ------------------
   -- Test_Garbage --
   ------------------

   procedure Test_Garbage (T : in out Any_Test) is
      pragma Unreferenced (T);
      Ended, Open : Natural := 0;
   begin
      P := (Garbage => 10_000, others => <>);
      for K in 1 .. 10_000 loop
         Apply (P, Ack, Wire, Effect);
         Assert (Effect = Garbage, "effect");
         Assert (not Is_Good_Frame (Sent), "a good frame by chance");
         if Wire.Data (Wire.Length) = CR then
            Ended := Ended + 1;
         else
            Open := Open + 1;
         end if;
      end loop;
      Assert (Ended > 1_000 and then Open > 1_000, "one kind only");
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = None, "over");
   end Test_Garbage;

   --------------------
   -- Test_No_Answer --
   --------------------

   procedure Test_No_Answer (T : in out Any_Test) is
      pragma Unreferenced (T);
      Nothing : constant Answer := (others => <>);
   begin
      P := (Silent => False, Drop => 1, Garbage => 1, Truncate => 1,
            Corrupt => 1, others => <>);
      for K in 1 .. 5 loop
         Apply (P, Nothing, Wire, Effect);
         Assert (Effect = None and then Sent'Length = 0, "something sent");
      end loop;
      Assert (P.Drop = 1 and then P.Garbage = 1 and then P.Truncate = 1
              and then P.Corrupt = 1, "used up");
   end Test_No_Answer;

   ---------------
   -- Test_None --
   ---------------

   procedure Test_None (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      P := (others => <>);
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = None and then Sent = Ack.Data (1 .. 3), "changed");
   end Test_None;

   ----------------
   -- Test_Order --
   ----------------

   procedure Test_Order (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      P := (Drop => 1, Garbage => 1, Truncate => 1, Corrupt => 1,
            others => <>);
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = Dropped, "first");
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = Garbage, "second");
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = Truncated, "third");
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = Corrupt, "fourth");
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = None, "fifth");
   end Test_Order;

   -----------------
   -- Test_Silent --
   -----------------

   procedure Test_Silent (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      P := (Silent => True, Drop => 1, others => <>);
      for K in 1 .. 10 loop
         Apply (P, Ack, Wire, Effect);
         Assert (Effect = Silent and then Sent'Length = 0, "said something");
      end loop;
      Assert (P.Drop = 1, "silence uses up nothing");
   end Test_Silent;

   -------------------
   -- Test_Truncate --
   -------------------

   procedure Test_Truncate (T : in out Any_Test) is
      pragma Unreferenced (T);
   begin
      P := (Truncate => 1, others => <>);
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = Truncated and then Sent = Ack.Data (1 .. 2), "cut");
      Apply (P, Ack, Wire, Effect);
      Assert (Effect = None, "over");
   end Test_Truncate;

   --------------------
   -- Register_Tests --
   --------------------

   overriding procedure Register_Tests (T : in out Test_Case) is
      use AUnit.Test_Cases.Registration;
   begin
      Register_Routine (T, Test_None'Access, "none");
      Register_Routine (T, Test_Silent'Access, "silent");
      Register_Routine (T, Test_Drop'Access, "drop");
      Register_Routine (T, Test_Corrupt'Access, "corrupt");
      Register_Routine (T, Test_Truncate'Access, "truncate");
      Register_Routine (T, Test_Garbage'Access, "garbage");
      Register_Routine (T, Test_Order'Access, "several at once");
      Register_Routine (T, Test_No_Answer'Access, "no answer");
   end Register_Tests;

end Answer_Faults_Tests;
