--  SPDX-License-Identifier: GPL-3.0-or-later
--  Admission of the monitor: the token that monitors must send if one is
--  required (--token), and the first line of a client, which carries it:
--  AUTH:<token>.

with Interfaces;
with Texts;

package Admission with SPARK_Mode is

   use type Interfaces.Unsigned_32;

   Label : constant String := "AUTH:";

   --  Tokens

   Min_Token : constant := 16;
   Max_Token : constant := 128;
   --  Characters. Fewer could be guessed: nothing bounds the attempts.

   subtype Token_Character is Character range '!' .. '~';
   --  Printable ASCII without the blank.

   subtype Token_Length is Natural range 0 .. Max_Token
   with Static_Predicate => Token_Length in 0 | Min_Token .. Max_Token;

   type Token is record
      Data   : String (1 .. Max_Token) := (others => ' ');
      Length : Token_Length            := 0;
   end record
   with Predicate =>
     (for all I in 1 .. Max_Token =>
        (if I <= Length then Data (I) in Token_Character
         else Data (I) = ' '));
   --  The first Length characters of Data. Length 0: no token is required.

   procedure Read_Token (Text : String; T : out Token)
   with
     Pre  => Text'First = 1,
     Post => (for all I in 1 .. T.Length => T.Data (I) = Text (I))
       and then (if T.Length > 0 and then T.Length < Text'Last then
                    Text (T.Length + 1) = ASCII.LF);
   --  The token in a file that begins with Text: its first line. Length 0: it
   --  holds none

   type File_Mode is mod 2 ** 16;
   --  Type and permissions of a file, as from stat.

   subtype User_Number is Interfaces.Unsigned_32;

   Root : constant User_Number := 0;

   function Is_Kept_Secret
     (Mode : File_Mode; Owner : User_Number) return Boolean
   is ((Mode and 8#026#) = 0
       and then ((Mode and 8#040#) = 0 or else Owner = Root));
   --  Group and others can neither read nor write the file. Exception: a file
   --  of root may be readable by its group. (systemd passes credentials with
   --  an access control list, which stat shows as the group's permission.)

   --  The first line of a client

   Max_Line : constant := 5 + Max_Token + 2;
   --  Of the longest valid line: Label, token, carriage return, line feed

   subtype Line_Count is Natural range 0 .. Max_Line;

   type Reader is record
      Data   : String (1 .. Max_Line) := (others => ' ');
      Length : Line_Count             := 0;
   end record;
   --  The first Length characters that a client has sent, up to the end of its
   --  first line

   function Text_Length (R : Reader) return Line_Count is
     (if R.Length = 0 then 0
      elsif R.Length > 1 and then R.Data (R.Length - 1) = ASCII.CR
      then R.Length - 2
      else R.Length - 1);
   --  Without its line feed, and a carriage return before it

   function Expected (T : Token; I : Positive) return Character is
     (if I <= Label'Length then Label (I) else T.Data (I - Label'Length))
   with Pre => I <= Max_Line - 2;
   --  Character I of the right line, a blank after its end

   function Is_Right (R : Reader; T : Token) return Boolean is
     (R.Length > 0
      and then R.Data (R.Length) = ASCII.LF
      and then Text_Length (R) = Label'Length + T.Length
      and then (for all I in 1 .. Text_Length (R) =>
                  R.Data (I) = Expected (T, I)));

   type Verdict is (Undecided, Right, Wrong);

   function Decision (R : Reader; T : Token) return Verdict
   with Post => (Decision'Result = Right) = Is_Right (R, T);
   --  A line is compared once it is complete, in a time that does not depend
   --  on the number or place of wrong characters

   procedure Append_Shown (To : in out Texts.Text; Line : String)
   with Pre => Line'First > 0 and then Line'Last < Integer'Last;
   --  For the log: Line, with three dots in place of what follows a token
   --  label. No token gets into the log.

end Admission;
