--  SPDX-License-Identifier: GPL-3.0-or-later
--  The recorder's file: the events are stored at its end while the tasks work;
--  the final text is written at its beginning. For Trace only.

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with System;
with Trace_Json;

private package Trace.Storage with SPARK_Mode => Off is
   --  Off: addresses, and C library functions

   Buffer_Bytes : constant := 24_576;

   type File is limited private;

   --  Reason: an errno value, 0 for none

   procedure Try (Path : String; Reason : out Integer);
   --  Whether Open would succeed; changes nothing

   procedure Open (F : in out File; Path : String; Reason : out Integer);
   --  For a seekable file, so not a pipe or a terminal. Its contents remain
   --  until Empty

   procedure Set_Up
     (F : in out File; Where : System.Address; Capacity : Unsigned_64);
   --  With a buffer of Buffer_Bytes zeroed bytes at Where, and room for the
   --  newest Capacity events. To be called before all that follows

   procedure Empty (F : in out File);
   --  At the first call: removes the former contents. May take longer than
   --  Open

   --  The events, numbered from 0

   function Next_Event (F : File) return Unsigned_64;
   --  The event number that Put or Pass takes next

   procedure Put
     (F : in out File; Item : Trace_Json.Event; Found : Boolean);
   --  Takes the next event, or records a lost one (not Found). It is in the
   --  file after Save at the latest

   procedure Save (F : in out File);
   --  Saves the events put so far. After a failure nothing more is saved

   procedure Pass (F : in out File; Next : Unsigned_64);
   --  Skips the events below Next. After Save

   function Save_Reason (F : File) return Integer;
   --  The error that stopped the saving of events

   procedure Get
     (F      : in out File;
      Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean);
   --  A saved event, if not overwritten. After the last Put

   --  The text

   procedure Write (F : in out File; Text : String);
   --  No effect after a failure

   procedure End_Text (F : in out File);
   --  Truncates the file after the text

   function Write_Reason (F : File) return Integer;
   --  The error that stopped the writing of the text

private

   type File is limited record
      Descriptor  : int := -1;
      Emptied     : Boolean := False;
      Capacity    : Unsigned_64 := 1;
      Batch_At    : System.Address := System.Null_Address;
      Put_Length  : Unsigned_64 := 0;
      --  buffered events that are not in the file
      Saved       : Unsigned_64 := 0;
      --  events below this are in the file, except skipped ones
      Save_Reason : Integer := 0;
      Batch_First : Unsigned_64 := Unsigned_64'Last;
      --  first event in Get's batch, if it is an event number
      Chunk_At    : System.Address := System.Null_Address;
      Chunk_Last  : Natural := 0;
      --  text to be written next
      Written     : Natural := 0;
      --  bytes of text written so far
      Write_Reason : Integer := 0;
   end record;

   function Next_Event (F : File) return Unsigned_64 is
     (F.Saved + F.Put_Length);

   function Save_Reason (F : File) return Integer is (F.Save_Reason);

   function Write_Reason (F : File) return Integer is (F.Write_Reason);

end Trace.Storage;
