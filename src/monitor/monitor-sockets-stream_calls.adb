--  SPDX-License-Identifier: GPL-3.0-or-later

with GNAT.OS_Lib;
with Linux; use Linux;
with System;

package body Monitor.Sockets.Stream_Calls with
  SPARK_Mode    => Off,
  Refined_State => (Kernel => null)
is
   --  Off: addresses are passed to C

   Error_Option : constant := 4;   --  SO_ERROR
   Info_Option  : constant := 11;  --  TCP_INFO

   function Get_Option
     (S : Socket; Level, Name : int; Value, Size : System.Address) return int
   with Import, Convention => C, External_Name => "getsockopt";

   procedure Close (S : Socket) is
   begin
      Linux.Close (int (S));
   end Close;

   procedure Get_Error (S : Socket; Error : out Integer) is
      Size    : unsigned := Error'Size / 8;
      Ignored : int;
      pragma Unreferenced (Ignored);
   begin
      Error := 0;
      Ignored := Get_Option
        (S, Level_Socket, Error_Option, Error'Address, Size'Address);
   end Get_Error;

   procedure Get_Info
     (S : Socket; Info : out Monitor.Link.Tcp_Info; Filled : out Natural)
   is
      Size : unsigned := Info'Size / 8;
   begin
      Filled :=
        (if Get_Option
           (S, Level_Tcp, Info_Option, Info'Address, Size'Address) = 0
         then Natural (Size) else 0);
   end Get_Info;

   procedure Poll (Entries : in out Watch_Array; Wait_Ms : int) is
      Ignored : constant int :=
        Linux.Poll (Entries'Address, Entries'Length, Wait_Ms);
      pragma Unreferenced (Ignored);
   begin
      null;
   end Poll;

   procedure Receive
     (From  : Socket;
      Flags : int;
      Data  : in out String;
      Got   : out Outcome;
      Error : out Integer)
   is
      function C_Receive
        (From : Socket; Data : System.Address; Length : size_t; Flags : int)
         return Ssize
      with Import, Convention => C, External_Name => "recv";
   begin
      Got := Outcome
        (Ssize'Min (C_Receive (From, Data'Address, Data'Length, Flags),
                    Data'Length));
      Error := GNAT.OS_Lib.Errno;
   end Receive;

   procedure Send
     (To    : Socket;
      Flags : int;
      Data  : String;
      Put   : out Outcome;
      Error : out Integer)
   is
      function C_Send
        (To : Socket; Data : System.Address; Length : size_t; Flags : int)
         return Ssize
      with Import, Convention => C, External_Name => "send";
   begin
      Put := Outcome
        (Ssize'Min (C_Send (To, Data'Address, Data'Length, Flags),
                    Data'Length));
      Error := GNAT.OS_Lib.Errno;
   end Send;

   procedure Set_Number (S : Socket; Level, Name, Value : int) is
      procedure Set_Option
        (S : Socket; Level, Name : int; Value : System.Address; Size : int)
      with Import, Convention => C, External_Name => "setsockopt";
   begin
      Set_Option (S, Level, Name, Value'Address, Value'Size / 8);
   end Set_Number;

   procedure Shut_Down (S : Socket; How : int) is
      procedure C_Shutdown (S : Socket; How : int)
      with Import, Convention => C, External_Name => "shutdown";
   begin
      C_Shutdown (S, How);
   end Shut_Down;

end Monitor.Sockets.Stream_Calls;
