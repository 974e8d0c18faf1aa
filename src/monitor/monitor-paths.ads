--  SPDX-License-Identifier: GPL-3.0-or-later
--  Reads the points of a mission from a line of the monitor: x;y;x;y;...

with Decimals;
with Missions; use Missions;

package Monitor.Paths with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Monitor.Paths);

   pragma Assertion_Policy (Subprogram_Variant => Ignore);
   --  Proved; GNAT 12 cannot compile the run-time check.

   Field_Separator : constant Character := ';';
   --  Between any two coordinates

   package Numbers is new Decimals (Character, String);

   function Is_Slice
     (Line : String; First : Positive; Last : Integer) return Boolean is
     (Line'Last < Integer'Last
      and then First >= Line'First
      and then Last <= Line'Last
      and then First <= Last + 1);
   --  Line (First .. Last) is a part of Line, perhaps empty

   --  A coordinate: an optional minus sign, one to seven digits, then nothing,
   --  or a point and one to six digits

   function Place_Of
     (Mark : Character; Line : String; First : Positive; Last : Natural)
      return Positive
   with
     Pre  => Is_Slice (Line, First, Last),
     Post => Place_Of'Result in First .. Last + 1
       and then (for all I in First .. Place_Of'Result - 1 => Line (I) /= Mark)
       and then (if Place_Of'Result <= Last then
                    Line (Place_Of'Result) = Mark);
   --  The first place of Mark in Line (First .. Last); Last + 1: there is none

   function Are_Digits
     (Line : String; First : Positive; Last : Natural; Most : Positive)
      return Boolean
   is (Last >= First
       and then Last - First < Most
       and then Numbers.Are_Digits (Line, First, Last))
   with Pre => Is_Slice (Line, First, Last);

   function Is_Size
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (Are_Digits (Line, First, Place_Of ('.', Line, First, Last) - 1, 7)
       and then
         (Place_Of ('.', Line, First, Last) > Last
          or else Are_Digits
            (Line, Place_Of ('.', Line, First, Last) + 1, Last, 6)))
   with Pre => Is_Slice (Line, First, Last);

   subtype Fraction_Digits is Positive range 1 .. 6;

   function Scale (Count : Fraction_Digits) return Millionths is
     (case Count is
         when 1 => 100_000,
         when 2 => 10_000,
         when 3 => 1_000,
         when 4 => 100,
         when 5 => 10,
         when 6 => 1);
   --  Millionths in a unit of the last of Count digits after the point

   function Size_Value
     (Line : String; First : Positive; Last : Natural) return Millionths
   is (Millionths
         (Numbers.Value (Line, First, Place_Of ('.', Line, First, Last) - 1))
       * 1_000_000
       + (if Place_Of ('.', Line, First, Last) > Last then 0
          else Millionths
            (Numbers.Value (Line, Place_Of ('.', Line, First, Last) + 1, Last))
            * Scale (Last - Place_Of ('.', Line, First, Last))))
   with
     Pre  => Is_Slice (Line, First, Last) and then Is_Size (Line, First, Last),
     Post => Size_Value'Result >= 0;

   function Is_Coordinate
     (Line : String; First : Positive; Last : Natural) return Boolean
   is (First <= Last
       and then Is_Size
         (Line, (if Line (First) = '-' then First + 1 else First), Last))
   with Pre => Is_Slice (Line, First, Last);

   function Coordinate
     (Line : String; First : Positive; Last : Natural) return Millionths
   is (if Line (First) = '-' then -Size_Value (Line, First + 1, Last)
       else Size_Value (Line, First, Last))
   with Pre => Is_Slice (Line, First, Last)
     and then Is_Coordinate (Line, First, Last);

   --  A point: two coordinates

   function Field_End (Line : String; First : Positive) return Natural is
     (Place_Of (Field_Separator, Line, First, Line'Last) - 1)
   with Pre => Is_Slice (Line, First, Line'Last);

   function Is_Point (Line : String; First : Positive) return Boolean is
     (Field_End (Line, First) < Line'Last
      and then Is_Coordinate (Line, First, Field_End (Line, First))
      and then Is_Coordinate
        (Line, Field_End (Line, First) + 2,
         Field_End (Line, Field_End (Line, First) + 2)))
   with Pre => Is_Slice (Line, First, Line'Last);

   function Point_End (Line : String; First : Positive) return Natural is
     (Field_End (Line, Field_End (Line, First) + 2))
   with
     Pre  => Is_Slice (Line, First, Line'Last) and then Is_Point (Line, First),
     Post => Point_End'Result in First .. Line'Last;

   function Point_At (Line : String; First : Positive) return Point is
     ((X => Coordinate (Line, First, Field_End (Line, First)),
       Y => Coordinate
         (Line, Field_End (Line, First) + 2, Point_End (Line, First))))
   with Pre => Is_Slice (Line, First, Line'Last)
     and then Is_Point (Line, First);

   --  A path: some points, Max_Points at most

   function Is_Path
     (Line : String; First : Positive; Most : Point_Count) return Boolean
   is (Most > 0
       and then Is_Point (Line, First)
       and then
         (Point_End (Line, First) = Line'Last
          or else Is_Path (Line, Point_End (Line, First) + 2, Most - 1)))
   with
     Pre => Is_Slice (Line, First, Line'Last),
     Subprogram_Variant => (Decreases => Most);
   --  Line (First .. Line'Last) is 1 to Most points

   procedure Parse
     (Line    : String;
      First   : Positive;
      Measure : Unit;
      Most    : Point_Number;
      P       : out Path;
      Valid   : out Boolean)
   with
     Pre  => Is_Slice (Line, First, Line'Last),
     Post => Valid = Is_Path (Line, First, Most)
       and then P.Measure = Measure
       and then (if Valid then P.Count in 1 .. Most else P.Count = 0);
   --  The points in Line (First .. Line'Last), each by Point_At

end Monitor.Paths;
