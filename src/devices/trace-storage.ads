--  SPDX-License-Identifier: GPL-3.0-or-later
--  The recorder's file: the events at its far end, in rounds, while the tasks
--  work; the text at its beginning at the end. For Trace only.

with Interfaces;   use Interfaces;
with Interfaces.C; use Interfaces.C;
with System;
with Trace_Json;

private package Trace.Storage with SPARK_Mode => Off is
   --  Off: addresses, and the calls of the C library

   Buffer_Bytes : constant := 24_576;

   type File is limited private;

   --  Reasons are the C library's numbers of errors, 0 where there is none

   procedure Try (Path : String; Reason : out Integer);
   --  Whether Open would find a file that it can use; leaves all as it was

   procedure Open (F : in out File; Path : String; Reason : out Integer);
   --  Of a file with places, which a pipe or a terminal has not. Its contents
   --  stay until Empty

   procedure Set_Up
     (F : in out File; Where : System.Address; Capacity : Unsigned_64);
   --  With Buffer_Bytes of zeros at Where, and room for Capacity events, the
   --  newest. Before anything that follows

   procedure Empty (F : in out File);
   --  The first time: the former contents are gone. Can take longer than
   --  Open

   --  The events. They have numbers, 0 and on

   function Next_Event (F : File) return Unsigned_64;
   --  That Put takes, or Pass

   procedure Put
     (F : in out File; Item : Trace_Json.Event; Found : Boolean);
   --  Takes the next event, not Found: one that was lost. It is in the file
   --  after Save, or before

   procedure Save (F : in out File);
   --  All that have been put. After a failure no more is put or saved

   procedure Pass (F : in out File; Next : Unsigned_64);
   --  Nothing is put of the events below Next. After Save

   function Save_Reason (F : File) return Integer;
   --  Why events are not saved any more

   procedure Get
     (F      : in out File;
      Number : Unsigned_64;
      Item   : out Trace_Json.Event;
      Found  : out Boolean);
   --  One that was saved, where it still is. When nothing is put any more

   --  The text

   procedure Write (F : in out File; Text : String);
   --  Nothing after a failure

   procedure End_Text (F : in out File);
   --  The file ends behind what has been written

   function Write_Reason (F : File) return Integer;
   --  Why not all the text is in the file

private

   type File is limited record
      Descriptor  : int := -1;
      Emptied     : Boolean := False;
      Capacity    : Unsigned_64 := 1;
      Batch_At    : System.Address := System.Null_Address;
      Put_Length  : Unsigned_64 := 0;
      --  events that are there and not in the file
      Saved       : Unsigned_64 := 0;
      --  events below this are in the file, but those that were passed
      Save_Reason : Integer := 0;
      Batch_First : Unsigned_64 := Unsigned_64'Last;
      --  for Get the batch begins with this one, if that is an event
      Chunk_At    : System.Address := System.Null_Address;
      Chunk_Last  : Natural := 0;
      --  what is to be written next of the text
      Written     : Natural := 0;
      --  bytes before
      Write_Reason : Integer := 0;
   end record;

   function Next_Event (F : File) return Unsigned_64 is
     (F.Saved + F.Put_Length);

   function Save_Reason (F : File) return Integer is (F.Save_Reason);

   function Write_Reason (F : File) return Integer is (F.Write_Reason);

end Trace.Storage;
