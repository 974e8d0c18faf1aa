--  SPDX-License-Identifier: GPL-3.0-or-later
--  The vision: its mode, the search areas, the times of the images, the camera
--  and its library, the images in transit, and the tasks that process them.

package Vision with SPARK_Mode, Pure is

end Vision;
