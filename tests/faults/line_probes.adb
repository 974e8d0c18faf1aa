--  SPDX-License-Identifier: GPL-3.0-or-later
--  How late the kernel's pseudo-terminals are just now.

with Interfaces.C; use Interfaces.C;
with Interfaces.C.Strings;
with Libc;

package body Line_Probes is

   Period : constant Duration := 0.05;

   Patience : constant := 5_000;
   --  milliseconds for one byte

   type Probe is record
      Sent    : Instant := Never;
      Arrived : Instant := Never;
      --  Never while it is under way
   end record;

   Most : constant := 600;

   type Probe_List is array (0 .. Most - 1) of Probe;

   protected Memory is
      procedure Send (Time : Instant);
      procedure Arrive (Time : Instant);
      procedure Set_Leaving;
      function Leaving return Boolean;
      function Worst (From, To : Instant) return Duration;
   private
      Probes     : Probe_List;
      Newest     : Natural := 0;
      Is_Leaving : Boolean := False;
   end Memory;

   task Prober is
      entry Start;
   end Prober;

   Started : Boolean := False;

   function Open_Terminal (Flags : int) return int
   with Import, Convention => C, External_Name => "posix_openpt";

   function Grant (File : int) return int
   with Import, Convention => C, External_Name => "grantpt";

   function Unlock (File : int) return int
   with Import, Convention => C, External_Name => "unlockpt";

   function Name_Of (File : int) return Strings.chars_ptr
   with Import, Convention => C, External_Name => "ptsname";

   ------------
   -- Memory --
   ------------

   protected body Memory is

      procedure Send (Time : Instant) is
      begin
         Newest := (Newest + 1) mod Most;
         Probes (Newest) := (Sent => Time, Arrived => Never);
      end Send;

      procedure Arrive (Time : Instant) is
      begin
         Probes (Newest).Arrived := Time;
      end Arrive;

      procedure Set_Leaving is
      begin
         Is_Leaving := True;
      end Set_Leaving;

      function Leaving return Boolean is (Is_Leaving);

      function Worst (From, To : Instant) return Duration is
         Result  : Duration := 0.0;
         Arrival : Instant;
      begin
         for P of Probes loop
            Arrival := (if P.Arrived = Never then Now else P.Arrived);
            if P.Sent /= Never and then P.Sent <= To and then Arrival >= From
            then
               Result := Duration'Max (Result, Arrival - P.Sent);
            end if;
         end loop;
         return Result;
      end Worst;

   end Memory;

   ------------
   -- Prober --
   ------------

   task body Prober is
      Read_Write : constant int := 8#2#;
      Not_Mine   : constant int := 8#400#;
      --  O_NOCTTY
      Flags      : constant int := Read_Write + Not_Mine + Libc.O_Cloexec;
      Far, Near  : int := -1;
      Param      : aliased Libc.Sched_Param :=
        (Priority => Libc.Above_Supervisor);
      Byte       : aliased Character := 'x';
      File       : aliased Libc.Poll_Descriptor;
      Moved      : long;
      Unused     : int;
   begin
      select
         accept Start;
      or
         terminate;
      end select;
      Far := Open_Terminal (Flags);
      if Far >= 0 and then Grant (Far) = 0 and then Unlock (Far) = 0 then
         Near := Libc.Open
           (To_C (Strings.Value (Name_Of (Far))), Flags);
      end if;
      Unused := Libc.Sched_Setscheduler (0, Libc.Sched_Fifo, Param'Access);
      while Near >= 0 and then not Memory.Leaving loop
         Memory.Send (Now);
         Moved := Libc.Write (Near, Byte'Address, 1);
         File := (Far, Libc.Poll_In, 0);
         exit when Moved /= 1
           or else Libc.Poll (File'Access, 1, Patience) <= 0;
         Moved := Libc.Read (Far, Byte'Address, 1);
         Memory.Arrive (Now);
         delay Period;
      end loop;
      Unused := Libc.Close (Near);
      Unused := Libc.Close (Far);
   end Prober;

   -----------
   -- Start --
   -----------

   procedure Start is
   begin
      if not Started then
         Started := True;
         Prober.Start;
      end if;
   end Start;

   ----------
   -- Stop --
   ----------

   procedure Stop is
   begin
      Memory.Set_Leaving;
   end Stop;

   function Worst (From, To : Instant) return Duration is
     (Memory.Worst (From, To));

end Line_Probes;
