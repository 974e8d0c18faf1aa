--  SPDX-License-Identifier: GPL-3.0-or-later
--  How late the kernel's pseudo-terminals are.

with Interfaces.C; use Interfaces.C;

with Libc;
with Own_Priority;

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

   Closed : constant int := -1;

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

   procedure Open (Master, Slave : out int);
   --  Closed where it cannot be had

   ----------
   -- Open --
   ----------

   procedure Open (Master, Slave : out int) is

      Read_Write : constant int := 8#2#;
      No_Control : constant int := 8#400#;
      Flags      : constant int := Read_Write + No_Control + Libc.O_Cloexec;

      function Open_Master (Flags : int) return int
        with Import, Convention => C, External_Name => "posix_openpt";
      function Grant (Master : int) return int
        with Import, Convention => C, External_Name => "grantpt";
      function Unlock (Master : int) return int
        with Import, Convention => C, External_Name => "unlockpt";
      function Slave_Name
        (Master : int; Name : in out char_array; Size : size_t) return int
        with Import, Convention => C, External_Name => "ptsname_r";

      type Settings is array (1 .. 64) of aliased unsigned_char
        with Convention => C;
      --  struct termios: 60 bytes on Linux

      procedure Make_Raw (Values : in out Settings)
        with Import, Convention => C, External_Name => "cfmakeraw";
      function Get_Attributes (File : int; Values : out Settings) return int
        with Import, Convention => C, External_Name => "tcgetattr";
      function Set_Attributes
        (File, Action : int; Values : Settings) return int
        with Import, Convention => C, External_Name => "tcsetattr";

      Size   : constant := 64;
      Name   : char_array (1 .. Size) := (others => nul);
      Values : Settings := (others => 0);
      Unused : int;
   begin
      Slave := Closed;
      Master := Open_Master (Flags);
      if Master /= Closed
        and then Grant (Master) = 0
        and then Unlock (Master) = 0
        and then Slave_Name (Master, Name, Size) = 0
      then
         Slave := Libc.Open (Name, Flags);
         if Slave /= Closed and then Get_Attributes (Slave, Values) = 0 then
            Make_Raw (Values);
            Unused := Set_Attributes (Slave, 0, Values);
         end if;
      end if;
   end Open;

   ---------------
   -- Record_Of --
   ---------------

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

   ------------
   -- Runner --
   ------------

   task body Runner is
      Master : int := Closed;
      Slave  : int := Closed;
      Byte   : aliased unsigned_char := 0;
      Ready  : aliased Libc.Poll_Descriptor;
      Done   : long;
      Unused : int;
   begin
      select
         accept Start;
         Own_Priority.Prefer_Real_Time (True);
         Open (Master, Slave);
      or
         accept Stop;
      or
         terminate;
      end select;
      while Slave /= Closed and then not Record_Of.Is_Ended loop
         Record_Of.Send (Now);
         Done := Libc.Write (Master, Byte'Address, 1);
         exit when Done /= 1;
         loop
            Ready := (File => Slave, Events => Libc.Poll_In, Returned => 0);
            exit when Libc.Poll (Ready'Access, 1, 1_000) /= 0
              or else Record_Of.Is_Ended;
         end loop;
         if Ready.Returned /= 0 then
            Done := Libc.Read (Slave, Byte'Address, 1);
         end if;
         Record_Of.Arrive (Now);
         delay Pause;
      end loop;
      if Slave /= Closed then
         Unused := Libc.Close (Slave);
      end if;
      if Master /= Closed then
         Unused := Libc.Close (Master);
      end if;
   end Runner;

   -----------
   -- Start --
   -----------

   procedure Start is
      First : Boolean;
   begin
      Record_Of.Begin_Once (First);
      if First then
         Runner.Start;
      end if;
   end Start;

   ----------
   -- Stop --
   ----------

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
