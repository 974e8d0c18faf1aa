--  SPDX-License-Identifier: GPL-3.0-or-later
--  When an image is sent, and which of those waiting (F15): at the instants of
--  a periodic grid, which is shifted where the source requires it.

with Ada.Real_Time; use Ada.Real_Time;

package Vision.Image_Grid with SPARK_Mode is

   pragma Annotate (GNATprove, Terminating, Vision.Image_Grid);  --  proved

   type Microseconds is range 0 .. 10_000_000;

   function Elapsed (First, Last : Time) return Microseconds;
   --  From First to Last, within the range of the type; 0 if Last is earlier

   subtype Period_Time is Microseconds range 10_000 .. 1_000_000;
   --  Period of the images: 1 to 100 per second

   --  The newest image is sent at each instant of the grid. If none is newer
   --  than the last one sent, the next image is sent on arrival, and the grid
   --  is shifted to that time. So for a source as fast as the grid, the grid
   --  follows its latest arrivals, whatever their jitter.
   --
   --  A source that is slightly faster overtakes the grid from time to time:
   --  two images wait, and one would be dropped. If the newer one has only
   --  just arrived, its successor may come too late. Then the older one is
   --  sent, and the newer one is kept in reserve. The delay that the grid
   --  accumulates by waiting is made up in small steps, as soon as images are
   --  available earlier.

   function Reserve (Period : Period_Time) return Microseconds is
     (Period * 12 / 100);
   --  Largest age of an image kept in reserve. The older image is sent up to
   --  this much later than a period after its arrival: of the 20 ms beyond the
   --  period that F15 allows, 8 ms remain for the image processing

   function Early (Period : Period_Time) return Microseconds is
     (Period / 5);
   --  An image that has waited this long could have been sent earlier

   function Most_Made_Up (Period : Period_Time) return Microseconds is
     (Period / 10);
   --  Per step

   function Shortest (Period : Period_Time) return Microseconds is
     (Period - Most_Made_Up (Period));
   --  Between two instants of the grid

   function Sends_Older
     (Newest_Age, Older_Age : Microseconds; Period : Period_Time)
      return Boolean
   is (Newest_Age < Reserve (Period)
       and then Older_Age <= Period + Reserve (Period)
       and then Older_Age > Newest_Age + Period / 2);
   --  Of two images waiting at an instant of the grid, given their ages. Of a
   --  source that is more than twice as fast as the grid, the next image comes
   --  in time, and the newest is sent

   Enough_Early : constant := 12;
   --  So many early images in a row are no coincidence

   subtype Early_Count is Natural range 0 .. Enough_Early;

   type State is record
      Begun : Boolean      := False;
      --  an image has been sent
      Lost  : Microseconds := 0;
      --  delay of the grid that has not been made up
      Early : Early_Count  := 0;
      --  images in a row that could have been sent earlier
   end record;

   Initial : constant State := (others => <>);

   function Most_Lost (Period : Period_Time) return Microseconds is
     (Period / 2);
   --  A pause of the source must not make many images early afterwards

   procedure Wait_Ended
     (S : in out State; Late : Microseconds; Period : Period_Time)
   with
     Post => S.Lost <= S.Lost'Old + Late
       and then S.Lost <= Microseconds'Max (S.Lost'Old, Most_Lost (Period));
   --  No image waited at an instant of the grid: one came Late after it. The
   --  wait for the first image is no delay

   procedure Step
     (S           : in out State;
      Age         : Microseconds;
      Has_Reserve : Boolean;
      Period      : Period_Time;
      Length      : out Microseconds)
   with
     Post => Length in Shortest (Period) .. Period
       and then S.Lost = S.Lost'Old - (Period - Length);
   --  An image of this Age is sent; Has_Reserve: a newer one waits. The next
   --  instant is Length after this one

end Vision.Image_Grid;
