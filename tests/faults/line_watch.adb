--  SPDX-License-Identifier: GPL-3.0-or-later
--  Measures the delay of the kernel's pseudo-terminals.

with Interfaces.C; use Interfaces.C;

with Libc;
with Own_Process;
with Polls;
with Pseudo_Terminals;

package body Line_Watch is

   Pause  : constant Duration := 0.02;
   --  Between two bytes

   type Passage is record
      Sent    : Instant := Never;
      Arrived : Instant := Never;
      --  Never while it is on its way
   end record;

   Most : constant := 3_000;

   type Passages is array (0 .. Most - 1) of Passage;

   protected Record_Of is
      procedure Begin_Once (First : out Boolean);
      procedure End_All;
      function Is_Ended return Boolean;
      procedure Send (Time : Instant);
      procedure Arrive (Time : Instant);
      function Worst (From, To : Instant) return Duration;
   private
      Begun  : Boolean := False;
      Ended  : Boolean := False;
      Bytes  : Passages;
      Newest : Natural := 0;
   end Record_Of;

   task Runner is
      entry Start;
      entry Stop;
      --  in place of Start
   end Runner;

   protected body Record_Of is

      procedure Begin_Once (First : out Boolean) is
      begin
         First := not Begun;
         Begun := True;
      end Begin_Once;

      procedure End_All is
      begin
         Ended := True;
      end End_All;

      function Is_Ended return Boolean is (Ended);

      procedure Send (Time : Instant) is
      begin
         Newest := (Newest + 1) mod Most;
         Bytes (Newest) := (Sent => Time, Arrived => Never);
      end Send;

      procedure Arrive (Time : Instant) is
      begin
         Bytes (Newest).Arrived := Time;
      end Arrive;

      function Worst (From, To : Instant) return Duration is
         Result  : Duration := 0.0;
         Arrival : Instant;
      begin
         for P of Bytes loop
            Arrival := (if P.Arrived = Never then Now else P.Arrived);
            if P.Sent /= Never and then P.Sent <= To and then Arrival >= From
            then
               Result := Duration'Max (Result, Arrival - P.Sent);
            end if;
         end loop;
         return Result;
      end Worst;

   end Record_Of;

   task body Runner is
      Line : Pseudo_Terminals.Line;
      Open : Boolean := False;
      Byte : aliased unsigned_char := 0;
      Done : long;
   begin
      select
         accept Start;
         Own_Process.Prefer_Real_Time (True);
         Pseudo_Terminals.Open (Line, Open);
      or
         accept Stop;
      or
         terminate;
      end select;
      while Open and then not Record_Of.Is_Ended loop
         Record_Of.Send (Now);
         Done := Libc.Write
           (Pseudo_Terminals.Robot_End (Line), Byte'Address, 1);
         exit when Done /= 1;
         loop
            if Polls.Is_Readable (Pseudo_Terminals.Device_End (Line), 1.0)
            then
               Done := Libc.Read
                 (Pseudo_Terminals.Device_End (Line), Byte'Address, 1);
               exit;
            end if;
            exit when Record_Of.Is_Ended;
         end loop;
         Record_Of.Arrive (Now);
         delay Pause;
      end loop;
      if Open then
         Pseudo_Terminals.Close (Line);
      end if;
   end Runner;

   procedure Start is
      First : Boolean;
   begin
      Record_Of.Begin_Once (First);
      if First then
         Runner.Start;
      end if;
   end Start;

   procedure Stop is
      First : Boolean;
   begin
      Record_Of.Begin_Once (First);
      Record_Of.End_All;
      if First then
         Runner.Stop;
      end if;
   end Stop;

   function Worst (From, To : Instant) return Duration is
     (Record_Of.Worst (From, To));

end Line_Watch;
