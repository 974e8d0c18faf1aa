--  SPDX-License-Identifier: GPL-3.0-or-later
--  A camera that sends one image again and again.

with Ada.Directories;
with Ada.Real_Time;    use Ada.Real_Time;
with Ada.Streams;      use Ada.Streams;
with Ada.Streams.Stream_IO;
with Ada.Unchecked_Deallocation;
with GNAT.Sockets;     use GNAT.Sockets;

package body Still_Cameras is

   type Data_Access is access Stream_Element_Array;

   procedure Free is new Ada.Unchecked_Deallocation
     (Stream_Element_Array, Data_Access);

   Line_End : constant String := (ASCII.CR, ASCII.LF);

   Listener : Socket_Type;
   Part     : Data_Access;  --  an image, as it is sent each time

   function Octets (Text : String) return Stream_Element_Array;

   task type Server (Rate : Positive);
   type Server_Access is access Server;

   procedure Free is new Ada.Unchecked_Deallocation (Server, Server_Access);

   Running : Server_Access;

   ------------
   -- Octets --
   ------------

   function Octets (Text : String) return Stream_Element_Array is
      Result : Stream_Element_Array (1 .. Text'Length);
   begin
      for I in Result'Range loop
         Result (I) := Character'Pos (Text (Text'First + Integer (I) - 1));
      end loop;
      return Result;
   end Octets;

   ------------
   -- Server --
   ------------

   task body Server is
      Client  : Socket_Type;
      Address : Sock_Addr_Type;
      Request : Stream_Element_Array (1 .. 4_096);
      Last    : Stream_Element_Offset;
      Next    : Time;

      procedure Send (Data : Stream_Element_Array);
      --  All of it

      procedure Send (Data : Stream_Element_Array) is
         First : Stream_Element_Offset := Data'First;
      begin
         while First <= Data'Last loop
            Send_Socket (Client, Data (First .. Data'Last), Last);
            if Last < First then
               raise Socket_Error;
            end if;
            First := Last + 1;
         end loop;
      end Send;

   begin
      Accept_Socket (Listener, Client, Address);
      Receive_Socket (Client, Request, Last);
      Send (Octets
        ("HTTP/1.0 200 OK" & Line_End
         & "Content-Type: multipart/x-mixed-replace; boundary=frame"
         & Line_End & Line_End));
      Next := Clock;
      loop
         Send (Part.all);
         Next := Next + Seconds (1) / Rate;
         delay until Next;
      end loop;
   exception
      when Socket_Error =>
         --  the client has gone, or nobody came
         if Client /= No_Socket then
            Close_Socket (Client);
         end if;
   end Server;

   -----------
   -- Start --
   -----------

   procedure Start (Path : String; Rate : Positive; Port : out Positive) is
      use Ada.Streams.Stream_IO;
      File  : Ada.Streams.Stream_IO.File_Type;
      Image : Stream_Element_Array
        (1 .. Stream_Element_Offset (Ada.Directories.Size (Path)));
      Last  : Stream_Element_Offset;
   begin
      Open (File, In_File, Path);
      Read (File, Image, Last);
      Close (File);
      Part := new Stream_Element_Array'
        (Octets ("--frame" & Line_End & "Content-Type: image/jpeg" & Line_End
                 & "Content-Length:" & Last'Image & Line_End & Line_End)
         & Image & Octets (Line_End));
      Create_Socket (Listener);
      Bind_Socket (Listener, (Family_Inet, Inet_Addr ("127.0.0.1"), 0));
      Listen_Socket (Listener);
      Port := Positive (Get_Socket_Name (Listener).Port);
      Running := new Server (Rate);
   end Start;

   ----------
   -- Stop --
   ----------

   procedure Stop is
   begin
      --  frees it where it still waits for a client
      Shutdown_Socket (Listener);
      Close_Socket (Listener);
      while not Running'Terminated loop
         delay 0.01;
      end loop;
      Free (Running);
      Free (Part);
   end Stop;

end Still_Cameras;
