--  SPDX-License-Identifier: GPL-3.0-or-later
--  When an image is sent, and which of those that wait (F15): a grid of
--  instants, one period apart, that moves with the source where it must.

package Vision.Image_Grid with SPARK_Mode, Pure is

   pragma Annotate (GNATprove, Terminating, Vision.Image_Grid);
   --  A claim that GNATprove checks: every subprogram ends

   type Microseconds is range 0 .. 10_000_000;

   subtype Period_Time is Microseconds range 10_000 .. 1_000_000;
   --  Between two images: 1 to 100 a second

   --  At each instant of the grid the newest image goes out. Where none is
   --  newer than the last one sent, the next goes out as it arrives, and the
   --  grid goes on from there: so it comes to lie behind the latest images of
   --  a source that is as fast as the grid, whatever their jitter.
   --
   --  A source that is a little faster overtakes the grid from time to time:
   --  two images wait, and one is left out. If the newer has only just come,
   --  the one after it may come too late. So then the older one goes out, and
   --  the newer is kept in reserve. What the grid has lost by waiting it makes
   --  up for in small steps, as soon as there are images to be had earlier.

   function Reserve (Period : Period_Time) return Microseconds is
     (Period * 12 / 100);
   --  How new an image is at most that is kept in reserve. The one before it
   --  is sent up to so much later than a period after its arrival: with 20 ms
   --  beyond that of F15 in mind, 8 ms remain for the image's own work

   function Early (Period : Period_Time) return Microseconds is
     (Period / 5);
   --  An image that has waited so long could have been sent earlier

   Enough_Early : constant := 12;
   --  So many of them one after the other: it is no chance

   function Most_Made_Up (Period : Period_Time) return Microseconds is
     (Period / 10);
   --  In one step

   function Shortest (Period : Period_Time) return Microseconds is
     (Period - Most_Made_Up (Period));
   --  Between two instants of the grid

   function Sends_Older
     (Newest_Age, Older_Age : Microseconds; Period : Period_Time)
      return Boolean
   is (Newest_Age < Reserve (Period)
       and then Older_Age <= Period + Reserve (Period));
   --  Of two images that wait at an instant of the grid, with the time since
   --  each arrived

   type State is private;

   Initial : constant State;
   --  No image has gone out, nothing is lost

   function Has_Begun (S : State) return Boolean;
   --  An image has gone out

   function Lost (S : State) return Microseconds;
   --  What the grid has lost and not made up for

   function Most_Lost (Period : Period_Time) return Microseconds is
     (Period / 2);
   --  A source that pauses does not make many images come early afterwards

   function Early_Images (S : State) return Natural;
   --  Those one after the other that could have been sent earlier

   procedure Wait_Ended
     (S : in out State; Late : Microseconds; Period : Period_Time)
   with
     Post => Lost (S) =
       (if Has_Begun (S'Old)
        then Microseconds'Min (Most_Lost (Period), Lost (S'Old) + Late)
        else Lost (S'Old))
       and then Has_Begun (S) = Has_Begun (S'Old)
       and then Early_Images (S) = 0;
   --  There was no image at an instant of the grid: one came Late after it.
   --  What is waited for the first image is not lost

   procedure Step
     (S           : in out State;
      Age         : Microseconds;
      Has_Reserve : Boolean;
      Period      : Period_Time;
      Length      : out Microseconds)
   with
     Post => Has_Begun (S)
       and then Length in Shortest (Period) .. Period
       and then Lost (S) = Lost (S'Old) - (Period - Length)
       and then
         (if Age < Early (Period) then Early_Images (S) = 0
          else Early_Images (S) =
            Natural'Min (Enough_Early, Early_Images (S'Old) + 1))
       and then
         (if not Has_Reserve and then Early_Images (S) < Enough_Early
          then Length = Period);
   --  An image goes out, Age after it arrived; Has_Reserve: a newer one waits.
   --  The next instant is Length after this one

private

   subtype Early_Count is Natural range 0 .. Enough_Early;

   type State is record
      Begun : Boolean      := False;
      Lost  : Microseconds := 0;
      Early : Early_Count  := 0;
   end record;

   Initial : constant State := (others => <>);

   function Has_Begun (S : State) return Boolean is (S.Begun);

   function Lost (S : State) return Microseconds is (S.Lost);

   function Early_Images (S : State) return Natural is (S.Early);

end Vision.Image_Grid;
