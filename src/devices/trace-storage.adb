--  SPDX-License-Identifier: GPL-3.0-or-later

with GNAT.OS_Lib;
with Linux;                   use Linux;
with System.Storage_Elements; use System.Storage_Elements;
with Texts;

package body Trace.Storage with SPARK_Mode => Off is

   type Saved_Event is record
      Mark : Unsigned_64 := 0;      --  event number + 1; 0: none
      Item : Trace_Json.Event;
   end record
   with Size => 32 * 8;

   Event_Bytes  : constant := 32;
   Batch_Length : constant := 512;

   type Batch is array (Unsigned_64 range 0 .. Batch_Length - 1)
     of Saved_Event
   with Component_Size => Event_Bytes * 8;

   Batch_Bytes : constant := Batch_Length * Event_Bytes;

   subtype Chunk_Text is String (1 .. Buffer_Bytes - Batch_Bytes);

   Both_Ways : constant int := 8#2004402#;
   --  O_RDWR, O_CLOEXEC, O_NONBLOCK, O_NOCTTY
   Or_Create : constant int := 8#100#;   --  O_CREAT
   Or_New    : constant int := 8#300#;   --  O_CREAT, O_EXCL
   File_Mode : constant unsigned := 8#644#;
   No_Entry  : constant := 2;            --  ENOENT

   function Open (Path : char_array; Flags : int; Mode : unsigned) return int
   with Import, Convention => C_Variadic_2, External_Name => "open";

   function Open_Places
     (Path : char_array; Flags : int; Mode : unsigned) return int;
   --  The same for a seekable file; -1 for any other file or error

   function Unlink (Path : char_array) return int
   with Import, Convention => C, External_Name => "unlink";

   function Write_Place
     (Descriptor : int; Data : System.Address; Length : size_t; Place : long)
      return Ssize
   with Import, Convention => C, External_Name => "pwrite";

   function Read_Place
     (Descriptor : int; Data : System.Address; Length : size_t; Place : long)
      return Ssize
   with Import, Convention => C, External_Name => "pread";

   function Seek (Descriptor : int; Place : long; From : int) return long
   with Import, Convention => C, External_Name => "lseek";

   function Truncate (Descriptor : int; Length : long) return int
   with Import, Convention => C, External_Name => "ftruncate";

   function Place_Of (F : File; Number : Unsigned_64) return long is
     (long (F.Capacity) * (Texts.Max_Length + 32)
      + Event_Bytes * long (Number mod F.Capacity));
   --  The text never reaches the events; the gap is a hole in the file

   procedure Write_Chunk (F : in out File);

   function Open_Places
     (Path : char_array; Flags : int; Mode : unsigned) return int
   is
      Current : constant int := 1;  --  SEEK_CUR
      Found   : constant int := Open (Path, Flags, Mode);
   begin
      if Found < 0 or else Seek (Found, 0, Current) >= 0 then
         return Found;
      end if;
      Linux.Close (Found);
      return -1;
   end Open_Places;

   procedure Try (Path : String; Reason : out Integer) is
      Name    : constant char_array := To_C (Path);
      Found   : int;
      Ignored : int;
   begin
      Found := Open_Places (Name, Both_Ways, 0);
      if Found < 0 and then GNAT.OS_Lib.Errno = No_Entry then
         Found := Open_Places (Name, Both_Ways + Or_New, File_Mode);
         if Found >= 0 then
            Ignored := Unlink (Name);
         end if;
      end if;
      Reason := (if Found < 0 then GNAT.OS_Lib.Errno else 0);
      if Found >= 0 then
         Linux.Close (Found);
      end if;
   end Try;

   procedure Open (F : in out File; Path : String; Reason : out Integer) is
   begin
      F.Descriptor :=
        Open_Places (To_C (Path), Both_Ways + Or_Create, File_Mode);
      Reason := (if F.Descriptor < 0 then GNAT.OS_Lib.Errno else 0);
   end Open;

   procedure Set_Up
     (F : in out File; Where : System.Address; Capacity : Unsigned_64) is
   begin
      F.Capacity := Capacity;
      F.Batch_At := Where;
      F.Chunk_At := Where + Batch_Bytes;
   end Set_Up;

   procedure Empty (F : in out File) is
      Ignored : int;
      pragma Unreferenced (Ignored);
   begin
      if not F.Emptied then
         Ignored := Truncate (F.Descriptor, 0);
         F.Emptied := True;
      end if;
   end Empty;

   procedure Put
     (F : in out File; Item : Trace_Json.Event; Found : Boolean)
   is
      Next   : Batch with Import, Address => F.Batch_At;
      Number : constant Unsigned_64 := Next_Event (F);
   begin
      if F.Save_Reason = 0 then
         Next (F.Put_Length) := ((if Found then Number + 1 else 0), Item);
         F.Put_Length := F.Put_Length + 1;
         if F.Put_Length = Batch_Length
           or else (Number + 1) mod F.Capacity = 0
         then
            Save (F);
         end if;
      end if;
   end Put;

   procedure Save (F : in out File) is
      Bytes : constant Storage_Count :=
        Storage_Count (F.Put_Length) * Event_Bytes;
      Done  : Storage_Count := 0;
      Taken : Ssize;
   begin
      while F.Save_Reason = 0 and then Done < Bytes loop
         Taken := Write_Place
           (F.Descriptor, F.Batch_At + Done, size_t (Bytes - Done),
            Place_Of (F, F.Saved) + long (Done));
         if Taken > 0 then
            Done := Done + Storage_Count (Taken);
         elsif GNAT.OS_Lib.Errno /= EINTR then
            F.Save_Reason := GNAT.OS_Lib.Errno;
         end if;
      end loop;
      if F.Save_Reason = 0 then
         F.Saved := F.Saved + F.Put_Length;
      end if;
      F.Put_Length := 0;
   end Save;

   procedure Pass (F : in out File; Next : Unsigned_64) is
   begin
      F.Saved := Next;
   end Pass;

   procedure Get
     (F      : in out File;
      Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean)
   is
      Read    : Batch with Import, Address => F.Batch_At;
      Place   : constant Unsigned_64 := Number mod Batch_Length;
      Ignored : Ssize;
      pragma Unreferenced (Ignored);
   begin
      if Number - Place /= F.Batch_First then
         F.Batch_First := Number - Place;
         Ignored := Read_Place
           (F.Descriptor, F.Batch_At, Batch_Bytes,
            Place_Of (F, F.Batch_First));
         --  a slot that was not read has another mark
      end if;
      Item := Read (Place).Item;
      Found := Read (Place).Mark = Number + 1;
   end Get;

   procedure Write_Chunk (F : in out File) is
      Chunk : Chunk_Text with Import, Address => F.Chunk_At;
      Next  : Positive := 1;
      Taken : Ssize;
   begin
      while F.Write_Reason = 0 and then Next <= F.Chunk_Last loop
         Taken := Linux.Write
           (F.Descriptor, Chunk (Next)'Address,
            size_t (F.Chunk_Last - Next + 1));
         if Taken > 0 then
            Next := Next + Positive (Taken);
            F.Written := F.Written + Positive (Taken);
         elsif GNAT.OS_Lib.Errno /= EINTR then
            F.Write_Reason := GNAT.OS_Lib.Errno;
         end if;
      end loop;
      F.Chunk_Last := 0;
   end Write_Chunk;

   procedure Write (F : in out File; Text : String) is
      Chunk : Chunk_Text with Import, Address => F.Chunk_At;
   begin
      if F.Chunk_Last + Text'Length > Chunk'Last then
         Write_Chunk (F);
      end if;
      Chunk (F.Chunk_Last + 1 .. F.Chunk_Last + Text'Length) := Text;
      F.Chunk_Last := F.Chunk_Last + Text'Length;
   end Write;

   procedure End_Text (F : in out File) is
      Ignored : int;
      pragma Unreferenced (Ignored);
   begin
      Write_Chunk (F);
      Ignored := Truncate (F.Descriptor, long (F.Written));
   end End_Text;

end Trace.Storage;
