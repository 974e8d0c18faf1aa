--  SPDX-License-Identifier: GPL-3.0-or-later
--  Cameras of any rate: one task each.

with Ada.Directories;
with Ada.Exceptions;
with Ada.Numerics.Float_Random; use Ada.Numerics.Float_Random;
with Ada.Streams;               use Ada.Streams;
with Ada.Streams.Stream_IO;
with Ada.Strings.Fixed;         use Ada.Strings.Fixed;
with Ada.Unchecked_Deallocation;
with GNAT.Sockets;              use GNAT.Sockets;

with Expectations;              use Expectations;
with Own_Process;
with Plain_Numbers;             use Plain_Numbers;
with Whole_Sends;               use Whole_Sends;

package body Paced_Cameras is

   --  The mark stands in a comment behind the beginning of the JPEG:
   --  2 bytes, the comment's marker and length, 4 bytes, and the text. So the
   --  text begins with a group of base64 and ends with one.

   Digits_Of_Number : constant := 9;
   Digits_Of_Time   : constant := 21;
   Mark_Length      : constant := Digits_Of_Number + Digits_Of_Time;
   Before_Mark      : constant := 6;

   Line_End : constant String := (ASCII.CR, ASCII.LF);

   type Data_Access is access Stream_Element_Array;

   procedure Free is new Ada.Unchecked_Deallocation
     (Stream_Element_Array, Data_Access);

   task type Server (Inner : not null access Parts);

   type Server_Access is access Server;

   type Parts is limited record
      Listener : Socket_Type := No_Socket;
      Client   : Socket_Type := No_Socket;
      Port     : Port_Type;
      Image    : Data_Access;
      Jitter   : Duration := 0.0;
      Rate     : Float := 1.0 with Atomic;
      Stopping : Boolean := False with Atomic;
      Running  : Server_Access;
   end record;

   procedure Free is new Ada.Unchecked_Deallocation (Parts, Parts_Access);
   procedure Free is new Ada.Unchecked_Deallocation (Server, Server_Access);

   function Padded (Value : Long_Long_Integer; Length : Positive)
     return String
   is (Tail (Trim (Value'Image, Ada.Strings.Left), Length, '0'));

   function Value_Of (Letter : Character) return Natural is
     (case Letter is
         when 'A' .. 'Z' => Character'Pos (Letter) - Character'Pos ('A'),
         when 'a' .. 'z' => Character'Pos (Letter) - Character'Pos ('a') + 26,
         when '0' .. '9' => Character'Pos (Letter) - Character'Pos ('0') + 52,
         when '+'        => 62,
         when '/'        => 63,
         when others     => raise Failed with "no base64");
   --  Of base64

   function Mark_Of (Text : String) return Mark is
      First  : constant Positive := Text'First + Before_Mark / 3 * 4;
      Result : String (1 .. Mark_Length);
      Bits   : Natural;
   begin
      Check (Text'Length >= (Before_Mark + Mark_Length) / 3 * 4,
             "an image without a mark");
      for Group in 0 .. Mark_Length / 3 - 1 loop
         Bits := 0;
         for K in First + 4 * Group .. First + 4 * Group + 3 loop
            Bits := 64 * Bits + Value_Of (Text (K));
         end loop;
         for K in reverse 1 .. 3 loop
            Result (3 * Group + K) := Character'Val (Bits mod 256);
            Bits := Bits / 256;
         end loop;
      end loop;
      return
        (Number => Natural'Value (Result (1 .. Digits_Of_Number)),
         Time   => Instant'Value
           (Result (Digits_Of_Number + 1 .. Mark_Length)));
   exception
      when Constraint_Error =>
         raise Failed with "an image that is none of this camera";
   end Mark_Of;

   task body Server is
      Address : Sock_Addr_Type;
      Request : Stream_Element_Array (1 .. 4_096);
      Last    : Stream_Element_Offset;
      Nominal : Instant;
      Number  : Natural := 0;
      Chance  : Generator;

      Comment : constant String :=
        (Character'Val (16#FF#), Character'Val (16#FE#), ASCII.NUL,
         Character'Val (Mark_Length + 2));

   begin
      Own_Process.Prefer_Real_Time (True);
      Reset (Chance, 1);
      Accept_Socket (Inner.Listener, Inner.Client, Address);
      Set_Socket_Option
        (Inner.Client, IP_Protocol_For_TCP_Level, (No_Delay, True));
      Receive_Socket (Inner.Client, Request, Last);
      Send (Inner.Client, "HTTP/1.0 200 OK" & Line_End
            & "Content-Type: multipart/x-mixed-replace; boundary=frame"
            & Line_End & Line_End);
      Nominal := Now;
      while not Inner.Stopping loop
         Nominal := Nominal + Duration (1.0 / Inner.Rate);
         delay (Nominal - Now)
           + Inner.Jitter * Duration (2.0 * Random (Chance) - 1.0);
         Number := Number + 1;
         Send (Inner.Client,
               "--frame" & Line_End & "Content-Type: image/jpeg" & Line_End
               & "Content-Length:"
               & Integer'Image (Inner.Image'Length + Mark_Length + 4)
               & Line_End & Line_End);
         Send (Inner.Client, Inner.Image (1 .. 2));
         Send (Inner.Client, Comment
               & Padded (Long_Long_Integer (Number), Digits_Of_Number)
               & Padded (Long_Long_Integer (Now), Digits_Of_Time));
         Send (Inner.Client, Inner.Image (3 .. Inner.Image'Last));
         Send (Inner.Client, Line_End);
      end loop;
   exception
      when Socket_Error =>
         --  the viewer has gone, or nobody came
         if not Inner.Stopping then
            Note ("a camera's viewer has gone");
         end if;
      when Failure : others =>
         Note ("a camera failed: "
               & Ada.Exceptions.Exception_Information (Failure));
   end Server;

   procedure Start
     (Object : in out Camera;
      Image  : String;
      Rate   : Float;
      Jitter : Duration := 0.0)
   is
      use Ada.Streams.Stream_IO;
      File : Ada.Streams.Stream_IO.File_Type;
      Last : Stream_Element_Offset;
   begin
      Object.Inner := new Parts;
      Object.Inner.Image := new Stream_Element_Array
        (1 .. Stream_Element_Offset (Ada.Directories.Size (Image)));
      Open (File, In_File, Image);
      Read (File, Object.Inner.Image.all, Last);
      Close (File);
      Object.Inner.Jitter := Jitter;
      Object.Inner.Rate := Rate;
      Create_Socket (Object.Inner.Listener);
      Bind_Socket
        (Object.Inner.Listener, (Family_Inet, Inet_Addr ("127.0.0.1"), 0));
      Listen_Socket (Object.Inner.Listener);
      Object.Inner.Port := Get_Socket_Name (Object.Inner.Listener).Port;
      Object.Inner.Running := new Server (Object.Inner);
   end Start;

   function Url (Object : Camera) return String is
     ("http://127.0.0.1:" & Image (Integer (Object.Inner.Port))
      & "/stream.mjpg");

   procedure Set_Rate (Object : Camera; Rate : Float) is
   begin
      Object.Inner.Rate := Rate;
   end Set_Rate;

   procedure Stop (Object : in out Camera) is

      procedure End_Of (Socket : Socket_Type) is
      begin
         if Socket /= No_Socket then
            Shutdown_Socket (Socket);
         end if;
      exception
         when Socket_Error =>
            null;  --  the other end has gone before
      end End_Of;

   begin
      if Object.Inner /= null then
         Object.Inner.Stopping := True;
         End_Of (Object.Inner.Listener);
         End_Of (Object.Inner.Client);
         while not Object.Inner.Running'Terminated loop
            delay 0.01;
         end loop;
         Close_Socket (Object.Inner.Listener);
         if Object.Inner.Client /= No_Socket then
            Close_Socket (Object.Inner.Client);
         end if;
         Free (Object.Inner.Running);
         Free (Object.Inner.Image);
         Free (Object.Inner);
      end if;
   end Stop;

end Paced_Cameras;
