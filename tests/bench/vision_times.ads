--  SPDX-License-Identifier: GPL-3.0-or-later
--  What the stages of an image's way take, and the searches in it: measured
--  by a program of its own, bin/image_times, in the supervisor's language.

package Vision_Times is

   procedure Report_Images;
   procedure Report_Search;
   --  The measurement, which both share, is made once

end Vision_Times;
