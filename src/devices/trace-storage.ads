--  SPDX-License-Identifier: GPL-3.0-or-later
--  The recorder's file: the events are stored at its end while the tasks work;
--  the final text is written at its beginning. For Trace only.

with Texts;
with Trace.Calls;  use Trace.Calls;
with Trace_Json;
with Trace_Layout; use Trace_Layout;

private package Trace.Storage with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Trace.Storage);

   procedure Try (Path : Texts.Text; Error : out Error_Number)
   with Global => (In_Out => Calls.System_State);
   --  Whether Open would succeed; changes nothing

   procedure Open
     (Path : Texts.Text; File : out Descriptor; Error : out Error_Number)
   with
     Global => (In_Out => Calls.System_State),
     Post   => (File = None) = (Error > 0);
   --  For a seekable file, so not a pipe or a terminal. Its contents remain

   procedure Save
     (File   : Descriptor;
      Data   : Batch;
      Length : Batch_Count;
      Place  : Event_Place;
      Error  : out Error_Number)
   with
     Global => (In_Out => Calls.System_State),
     Pre    => Place + Length <= Trace_Layout.Capacity;
   --  Saves the first Length events of Data from Place on

   type Batch_Reader is private;
   --  Initially without events

   procedure Get
     (Reader : in out Batch_Reader;
      File   : Descriptor;
      Number : Event_Number;
      Item   : out Trace_Json.Event;
      Found  : out Boolean)
   with Global => (In_Out => Calls.System_State);
   --  A saved event, if not overwritten. After the last Save

   type Writer is private;
   --  Writes the text. Initially empty, without error

   function Size (To : Writer) return Natural;
   --  Length of the text so far. After an error less

   function Error_Of (To : Writer) return Error_Number;
   --  The error that stopped the writing

   procedure Put (To : in out Writer; File : Descriptor; Line : Texts.Text)
   with
     Global => (In_Out => Calls.System_State),
     Pre    => Size (To) <= Text_Limit - Line.Length,
     Post   => Size (To) <= Size (To)'Old + Line.Length;
   --  No effect after an error

   procedure End_Text (To : in out Writer; File : Descriptor)
   with
     Global => (In_Out => Calls.System_State),
     Pre    => Size (To) <= Text_Limit;
   --  Writes the last of the text, and truncates the file after it

private

   type Batch_Reader is record
      Is_Read : Boolean := False;
      First   : Event_Number := 0;
      Data    : Batch := (others => No_Event);
   end record;
   --  If Is_Read, Data has the events from First on that are in the file

   Chunk_Size : constant := 8_192;

   subtype Chunk_Length is Natural range 0 .. Chunk_Size;

   type Writer is record
      Data    : String (1 .. Chunk_Size) := (others => ' ');
      Last    : Chunk_Length := 0;                --  of the text in Data
      Written : Natural range 0 .. Text_Limit := 0;
      --  bytes of the text before Data
      Error   : Error_Number := 0;
   end record;

   function Size (To : Writer) return Natural is (To.Written + To.Last);

   function Error_Of (To : Writer) return Error_Number is (To.Error);

end Trace.Storage;
