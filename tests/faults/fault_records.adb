--  SPDX-License-Identifier: GPL-3.0-or-later
--  The record of a run.

with Ada.Containers.Indefinite_Hashed_Maps;
with Ada.Directories;
with Ada.Exceptions;      use Ada.Exceptions;
with Ada.IO_Exceptions;
with Ada.Streams;         use Ada.Streams;
with Ada.Streams.Stream_IO;
with Ada.Strings;         use Ada.Strings;
with Ada.Strings.Fixed;   use Ada.Strings.Fixed;
with Ada.Strings.Hash;
with Ada.Text_IO;         use Ada.Text_IO;
with GNAT.SHA256;

with Programs;

package body Fault_Records is

   package Result_Maps is new Ada.Containers.Indefinite_Hashed_Maps
     (String, String, Ada.Strings.Hash, "=");

   Results : Result_Maps.Map;
   File    : Ada.Text_IO.File_Type;

   Gap : constant String := ": ";
   --  between an injection and its result

   function Fingerprint (Path : String) return String is
      Source  : Stream_IO.File_Type;
      Context : GNAT.SHA256.Context := GNAT.SHA256.Initial_Context;
      Block   : Stream_Element_Array (1 .. 65_536);
      Last    : Stream_Element_Offset;
   begin
      Stream_IO.Open (Source, Stream_IO.In_File, Path);
      loop
         Stream_IO.Read (Source, Block, Last);
         exit when Last < Block'First;
         GNAT.SHA256.Update (Context, Block (Block'First .. Last));
      end loop;
      Stream_IO.Close (Source);
      return GNAT.SHA256.Digest (Context);
   end Fingerprint;

   function Head (Seed : Natural) return String is
     ("seed" & Seed'Image
      & " " & Fingerprint (Programs.Supervisor)
      & " " & Fingerprint (Programs.Vision_Library)
      & " " & Fingerprint (Programs.Emulator));

   procedure Open (Path : String; Seed : Natural) is
      Place : Natural;
   begin
      if Ada.Directories.Exists (Path) then
         Open (File, In_File, Path);
         if End_Of_File (File) or else Get_Line (File) /= Head (Seed) then
            raise Wrong_Record with
              Path & " is of another seed or of other programs";
         end if;
         while not End_Of_File (File) loop
            declare
               Line : constant String := Get_Line (File);
            begin
               Place := Index (Line, Gap);
               if Place = 0 then
                  raise Wrong_Record with Path & ": not a record: " & Line;
               end if;
               Results.Include
                 (Line (Line'First .. Place - 1),
                  Line (Place + Gap'Length .. Line'Last));
            end;
         end loop;
         Close (File);
         Open (File, Append_File, Path);
      else
         Create (File, Out_File, Path);
         Put_Line (File, Head (Seed));
         Flush (File);
      end if;
   exception
      when Occurrence : Ada.IO_Exceptions.Name_Error
        | Ada.IO_Exceptions.Use_Error | Ada.IO_Exceptions.Device_Error =>
         raise Wrong_Record with Exception_Message (Occurrence);
   end Open;

   function Result_Of (Key : String) return String is
     (if Results.Contains (Key) then Results (Key) else "");

   procedure Write (Key, Result : String) is
   begin
      if Is_Open (File) then
         Put_Line (File, Key & Gap & Result);
         Flush (File);
      end if;
   exception
      when Occurrence : Ada.IO_Exceptions.Device_Error
        | Ada.IO_Exceptions.Use_Error =>
         raise Wrong_Record with Exception_Message (Occurrence);
   end Write;

end Fault_Records;
