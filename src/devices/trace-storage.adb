--  SPDX-License-Identifier: GPL-3.0-or-later

with Interfaces; use Interfaces;

package body Trace.Storage with SPARK_Mode is

   Max_Interruptions : constant := 1_000;
   --  Of one call's work by signals; then it has failed

   procedure Judge
     (Result : Outcome;
      Tries  : in out Natural;
      Count  : out Natural;
      Error  : out Error_Number)
   with
     Post => Count = Integer'Max (0, Result)
       and then (if Count > 0 then Error = 0 and then Tries = Tries'Old
                 elsif Error = 0 then Tries < Tries'Old);
   --  What a call that writes has achieved: it has written Count bytes, or it
   --  is repeated after a signal, or Error stops the writing

   procedure Open_Seekable
     (Path  : Texts.Text;
      Flags : Open_Flags;
      File  : out Descriptor;
      Error : out Error_Number)
   with
     Global => (In_Out => Calls.System_State),
     Post   => (File = None) = (Error > 0);

   procedure Write_Chunk (To : in out Writer; File : Descriptor)
   with
     Global => (In_Out => Calls.System_State),
     Pre    => Size (To) <= Text_Limit,
     Post   => To.Written <= Size (To)'Old and then To.Last = 0;

   procedure End_Text (To : in out Writer; File : Descriptor) is
   begin
      Write_Chunk (To, File);
      Calls.Truncate (File, To.Written);
   end End_Text;

   procedure Get
     (Reader : in out Batch_Reader;
      File   : Descriptor;
      Number : Event_Number;
      Item   : out Trace_Json.Event;
      Found  : out Boolean)
   is
      First : constant Event_Number := Batch_Start (Number);
      Index : constant Batch_Index := Batch_Index (Number - First);
   begin
      if not Reader.Is_Read or else Reader.First /= First then
         Reader.Is_Read := True;
         Reader.First := First;
         Calls.Read_Events (File, Reader.Data, Offset_Of (Place_Of (First)));
         --  what could not be read has the numbers of other events
      end if;
      Found := Holds (Reader.Data (Index), Number);
      Item := (if Found then Event_Of (Reader.Data (Index), Number)
               else (others => <>));
   end Get;

   procedure Judge
     (Result : Outcome;
      Tries  : in out Natural;
      Count  : out Natural;
      Error  : out Error_Number) is
   begin
      Count := Integer'Max (0, Result);
      Error := 0;
      if Result = -Calls.Interrupted and then Tries > 0 then
         Tries := Tries - 1;
      elsif Result < 0 then
         Error := -Result;
      elsif Result = 0 then
         Error := Calls.Io_Failure;
      end if;
   end Judge;

   procedure Open
     (Path : Texts.Text; File : out Descriptor; Error : out Error_Number) is
   begin
      Open_Seekable (Path, Calls.New_Also, File, Error);
   end Open;

   procedure Open_Seekable
     (Path  : Texts.Text;
      Flags : Open_Flags;
      File  : out Descriptor;
      Error : out Error_Number)
   is
      Opened : Outcome;
      Sought : Outcome;
   begin
      File := None;
      Error := 0;
      Calls.Open (Path, Flags, Opened);
      if Opened < 0 then
         Error := -Opened;
      else
         Calls.Seek_Start (Opened, Sought);
         if Sought < 0 then
            Error := -Sought;
            Calls.Close (Opened);
         else
            File := Opened;
         end if;
      end if;
   end Open_Seekable;

   procedure Put (To : in out Writer; File : Descriptor; Line : Texts.Text) is
   begin
      if To.Last > Chunk_Size - Line.Length then
         Write_Chunk (To, File);
      end if;
      To.Data (To.Last + 1 .. To.Last + Line.Length) :=
        Line.Data (1 .. Line.Length);
      To.Last := To.Last + Line.Length;
   end Put;

   procedure Save
     (File   : Descriptor;
      Data   : Batch;
      Length : Batch_Count;
      Place  : Event_Place;
      Error  : out Error_Number)
   is
      Bytes  : constant Natural := Length * Event_Bytes;
      Done   : Natural := 0;
      Tries  : Natural := Max_Interruptions;
      Count  : Natural;
      Result : Outcome;
   begin
      Error := 0;
      while Error = 0 and then Done < Bytes loop
         pragma Loop_Invariant (Done < Bytes);
         pragma Loop_Variant (Increases => Done, Decreases => Tries);
         Calls.Write_Events
           (File, Data, Done, Bytes - Done, Offset_Of (Place) + Done,
            Result);
         Judge (Result, Tries, Count, Error);
         Done := Done + Count;
      end loop;
   end Save;

   procedure Try (Path : Texts.Text; Error : out Error_Number) is
      File : Descriptor;
   begin
      Open_Seekable (Path, Calls.Existing, File, Error);
      if Error = Calls.Not_Found then
         Open_Seekable (Path, Calls.New_Only, File, Error);
         if Error = 0 then
            Calls.Remove (Path);
         end if;
      end if;
      if Error = 0 then
         Calls.Close (File);
      end if;
   end Try;

   procedure Write_Chunk (To : in out Writer; File : Descriptor) is
      Done   : Chunk_Length := 0;
      Tries  : Natural := Max_Interruptions;
      Count  : Natural;
      Result : Outcome;
   begin
      while To.Error = 0 and then Done < To.Last loop
         pragma Loop_Invariant
           (Done < To.Last
            and then To.Last = To.Last'Loop_Entry
            and then To.Written = To.Written'Loop_Entry + Done);
         pragma Loop_Variant (Increases => Done, Decreases => Tries);
         Calls.Write (File, To.Data (Done + 1 .. To.Last), Result);
         Judge (Result, Tries, Count, To.Error);
         Done := Done + Count;
         To.Written := To.Written + Count;
      end loop;
      To.Last := 0;
   end Write_Chunk;

end Trace.Storage;
