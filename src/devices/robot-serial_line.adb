--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Real_Time; use Ada.Real_Time;
with GNAT.OS_Lib;
with GNAT.Serial_Communications; use GNAT.Serial_Communications;
with Interfaces.C;  use Interfaces.C;
with Linux;
with System;

package body Robot.Serial_Line with
  SPARK_Mode    => Off,
  Refined_State => (Device => Descriptor)
is

   use type Linux.Ssize;

   Closed     : constant int := -1;
   Descriptor : int := Closed with Atomic;

   function Fcntl (Fd : int; Command : int; Argument : int) return int
   with Import, Convention => C_Variadic_2, External_Name => "fcntl";

   function Is_Terminal (Fd : int) return int
   with Import, Convention => C, External_Name => "isatty";

   function Tc_Flush (Fd : int; Queue : int) return int
   with Import, Convention => C, External_Name => "tcflush";

   Set_Flags   : constant := 4;      --  F_SETFL
   Non_Block   : constant := 8#4000#;
   Input_Queue : constant := 0;      --  TCIFLUSH

   Longest_Poll : constant Time_Span := Milliseconds (900);
   --  in nanoseconds alone, fewer than 1.0E9

   procedure Put (Item : Robot.Protocol.Frame; Success : out Boolean);

   procedure Open
     (Path : Texts.Text; Success : out Boolean; Reason : out Texts.Text)
   is
      Port : Serial_Port;
   begin
      Close;
      Texts.Set (Reason, "");
      Open (Port, Port_Name (Texts.Image (Path)));
      Descriptor := int (To_C (Port));
      if Is_Terminal (Descriptor) = 0 then
         Texts.Set (Reason, "not a serial line");
         Close;
         Success := False;
         return;
      end if;
      --  Blocking: with a time-out GNAT 12 turns the echo on
      Set (Port, B9600, CS8, One, None,
           Block => True, Local => True, Flow => None, Timeout => 0.0);
      Success := Fcntl (Descriptor, Set_Flags, Non_Block) >= 0;
      Discard_Input;
   exception
      when others =>
         Texts.Set (Reason, GNAT.OS_Lib.Errno_Message);
         Close;
         Success := False;
   end Open;

   procedure Close is
      Fd : constant int := Descriptor;
   begin
      if Fd /= Closed then
         Descriptor := Closed;
         Linux.Close (Fd);
      end if;
   end Close;

   procedure Discard_Input is
      Ignored : int;
   begin
      Ignored := Tc_Flush (Descriptor, Input_Queue);
   end Discard_Input;

   procedure Put (Item : Robot.Protocol.Frame; Success : out Boolean) is
   begin
      Success :=
        Linux.Write (Descriptor, Item.Data'Address, size_t (Item.Length))
        = Linux.Ssize (Item.Length);
   end Put;

   procedure Write (Item : Robot.Protocol.Frame; Success : out Boolean) is
   begin
      Put (Item, Success);
      Written := (Written.Count + 1, Robot.Protocol.Decoded (Item));
   end Write;

   procedure Read
     (Data    : out Bytes.Byte_Array;
      Length  : out Natural;
      Until_Time : Ada.Real_Time.Time;
      Success : out Boolean)
   is
      Entries : Linux.Poll_Array (1 .. 1) :=
        (1 => (Descriptor, Linux.Poll_In, 0));
      Count   : int := 1;
      Got     : Linux.Ssize;
      Left    : Time_Span;
      Wait    : Linux.Time_Spec;
   begin
      Data := (others => 0);
      Length := 0;
      loop
         Left := Until_Time - Clock;
         exit when Count = 0 and then Left <= Time_Span_Zero;
         if Left < Time_Span_Zero then
            Left := Time_Span_Zero;
         elsif Left > Longest_Poll then
            Left := Longest_Poll;
         end if;
         Wait := (0, long (Left / Nanoseconds (1)));
         Count := Linux.Precise_Poll
           (Entries'Address, 1, Wait'Address, System.Null_Address);
         exit when Count > 0
           or else (Count < 0 and then GNAT.OS_Lib.Errno /= Linux.EINTR);
      end loop;
      Success := Count >= 0;
      if Count > 0 then
         Got := Linux.Read (Descriptor, Data'Address, Data'Length);
         if Got > 0 then
            Length := Natural (Got);
         else
            Success := Got < 0 and then GNAT.OS_Lib.Errno = Linux.EAGAIN;
         end if;
      end if;
   end Read;

   procedure Stop_Blindly is
      Frame   : Robot.Protocol.Frame;
      Ignored : Boolean;
   begin
      Robot.Protocol.Encode (Robot.Protocol.Stop, Frame);
      Put (Frame, Ignored);
   end Stop_Blindly;

end Robot.Serial_Line;
