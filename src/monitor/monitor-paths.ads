--  SPDX-License-Identifier: GPL-3.0-or-later
--  Reads the points of a mission from a line of the monitor: x;y;x;y;...

with Decimals;
with Missions; use Missions;

package Monitor.Paths with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Paths);

   Field_Separator : constant Character := ';';
   --  Between any two coordinates

   --  Used in the contracts

   package Numbers is new Decimals (Character, String);

   subtype Fraction_Digits is Natural range 0 .. 6;

   function Scale (Count : Fraction_Digits) return Millionths is
     (case Count is
         when 0 => 1_000_000,
         when 1 => 100_000,
         when 2 => 10_000,
         when 3 => 1_000,
         when 4 => 100,
         when 5 => 10,
         when 6 => 1);
   --  Millionths in a unit of the last of Count digits after the point

   function Field_End (Line : String; First : Positive) return Natural
   with
     Pre  => Line'Last < Integer'Last
       and then First in Line'First .. Line'Last,
     Post => Field_End'Result in First - 1 .. Line'Last
       and then (for all I in First .. Field_End'Result =>
                   Line (I) /= Field_Separator)
       and then (if Field_End'Result < Line'Last then
                    Line (Field_End'Result + 1) = Field_Separator);
   --  The last character of the field that begins at First

   function Whole_First (Line : String; First : Positive) return Positive is
     (if Line (First) = '-' then First + 1 else First)
   with Pre => Line'Last < Integer'Last and then First in Line'Range;
   --  The first digit

   function Whole_End
     (Line : String; First : Positive; Last : Natural) return Natural
   with
     Pre  => Line'Last < Integer'Last
       and then First >= Line'First
       and then Last <= Line'Last
       and then First <= Last + 1,
     Post => Whole_End'Result in First - 1 .. Last
       and then Numbers.Are_Digits (Line, First, Whole_End'Result)
       and then (if Whole_End'Result < Last then
                    not Numbers.Is_Digit (Line (Whole_End'Result + 1)));
   --  The last of the digits that begin at First; First - 1: none

   Max_Whole : constant := 7;
   --  Digits before the point

   function Are_Whole
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (Last >= First
       and then Last - First < Max_Whole
       and then Numbers.Are_Digits (Line, First, Last))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last;

   function Are_Fraction
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (Last >= First
       and then Last - First < Fraction_Digits'Last
       and then Numbers.Are_Digits (Line, First, Last))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last;

   function Is_Size
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (Are_Whole (Line, First, Whole_End (Line, First, Last))
       and then
         (Whole_End (Line, First, Last) = Last
          or else
            (Line (Whole_End (Line, First, Last) + 1) = '.'
             and then Are_Fraction
               (Line, Whole_End (Line, First, Last) + 2, Last))))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last
     and then First <= Last + 1;
   --  One to seven digits; then nothing, or a point and one to six digits

   function Size_Value
     (Line : String; First : Positive; Last : Natural) return Millionths
   is (Millionths
         (Numbers.Value (Line, First, Whole_End (Line, First, Last)))
       * 1_000_000
       + (if Whole_End (Line, First, Last) = Last then 0
          else Millionths
            (Numbers.Value (Line, Whole_End (Line, First, Last) + 2, Last))
            * Scale (Last - Whole_End (Line, First, Last) - 1)))
   with
     Pre  => Line'Last < Integer'Last
       and then First >= Line'First
       and then Last in First .. Line'Last
       and then Is_Size (Line, First, Last),
     Post => Size_Value'Result >= 0;

   function Is_Coordinate
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (First <= Last
       and then Is_Size (Line, Whole_First (Line, First), Last))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last;
   --  A size with an optional minus sign before it

   function Coordinate
     (Line : String; First : Positive; Last : Natural) return Millionths
   is ((if Line (First) = '-' then -1 else 1)
       * Size_Value (Line, Whole_First (Line, First), Last))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Last <= Line'Last
     and then Is_Coordinate (Line, First, Last);

   function Y_First (Line : String; First : Positive) return Positive is
     (Field_End (Line, First) + 2)
   with Pre => Line'Last < Integer'Last
     and then First in Line'Range
     and then Field_End (Line, First) < Line'Last;
   --  Where the second coordinate of a point begins

   function Is_Point (Line : String; First : Positive) return Boolean is
     (First <= Line'Last
      and then Field_End (Line, First) < Line'Last
      and then Is_Coordinate (Line, First, Field_End (Line, First))
      and then Y_First (Line, First) <= Line'Last
      and then Is_Coordinate
        (Line, Y_First (Line, First),
         Field_End (Line, Y_First (Line, First))))
   with Pre => Line'Last < Integer'Last and then First >= Line'First;
   --  Two coordinates

   function Point_End (Line : String; First : Positive) return Natural is
     (Field_End (Line, Y_First (Line, First)))
   with
     Pre  => Line'Last < Integer'Last
       and then First >= Line'First
       and then Is_Point (Line, First),
     Post => Point_End'Result in First .. Line'Last;

   function Point_At (Line : String; First : Positive) return Point is
     ((X => Coordinate (Line, First, Field_End (Line, First)),
       Y => Coordinate
         (Line, Y_First (Line, First), Point_End (Line, First))))
   with Pre => Line'Last < Integer'Last
     and then First >= Line'First
     and then Is_Point (Line, First);

   type Start_Array is array (Point_Number) of Positive;

   type Cut is record
      Count  : Point_Count := 0;
      Starts : Start_Array := (others => 1);
      Whole  : Boolean     := False;
   end record;
   --  The points with which a text begins, Max_Points at most, and where each
   --  begins. Whole: it consists of them, and has at least one

   function Cut_At (Line : String; First : Positive) return Cut
   with
     Pre  => Line'Last < Integer'Last and then First >= Line'First,
     Post =>
       (for all I in 1 .. Cut_At'Result.Count =>
          Cut_At'Result.Starts (I) >= First
          and then Is_Point (Line, Cut_At'Result.Starts (I))
          and then (if I = 1 then Cut_At'Result.Starts (I) = First)
          and then
            (if I < Cut_At'Result.Count then
                Point_End (Line, Cut_At'Result.Starts (I)) < Line'Last
                and then Cut_At'Result.Starts (I + 1) =
                  Point_End (Line, Cut_At'Result.Starts (I)) + 2))
       and then
         (case Cut_At'Result.Count is
             when 0 =>
               not Cut_At'Result.Whole and then not Is_Point (Line, First),
             when others =>
               Cut_At'Result.Whole =
                 (Point_End
                    (Line, Cut_At'Result.Starts (Cut_At'Result.Count))
                  = Line'Last)
               and then
                 (if not Cut_At'Result.Whole
                    and then Cut_At'Result.Count < Max_Points
                  then not Is_Point
                    (Line,
                     Point_End
                       (Line, Cut_At'Result.Starts (Cut_At'Result.Count))
                     + 2)));
   --  Cuts Line (First .. Line'Last) into points

   function Is_Path
     (Line : String; First : Positive; Single : Boolean) return Boolean
   is (Cut_At (Line, First).Whole
       and then (if Single then Cut_At (Line, First).Count = 1))
   with
     Pre  => Line'Last < Integer'Last and then First >= Line'First,
     Post => (if Is_Path'Result then Cut_At (Line, First).Count > 0);
   --  Line (First .. Line'Last) is 1 to Max_Points points, or a single one

   function Are_Points (Line : String; C : Cut; P : Path) return Boolean is
     (P.Count = C.Count
      and then
        (for all I in 1 .. C.Count =>
           C.Starts (I) >= Line'First
           and then Is_Point (Line, C.Starts (I))
           and then P.Points (I) = Point_At (Line, C.Starts (I))))
   with Pre => Line'Last < Integer'Last;
   --  P has the points of Line that begin at those of C

   procedure Parse
     (Line    : String;
      First   : Positive;
      Measure : Unit;
      Single  : Boolean;
      P       : out Path;
      Valid   : out Boolean)
   with
     Pre  => Line'Last < Integer'Last and then First >= Line'First,
     Post => Valid = Is_Path (Line, First, Single)
       and then P.Measure = Measure
       and then
         (if Valid then
             P.Count in Point_Number
             and then (if Single then P.Count = 1)
             and then Are_Points (Line, Cut_At (Line, First), P)
          else P.Count = 0);
   --  The points in Line (First .. Line'Last)

end Monitor.Paths;
