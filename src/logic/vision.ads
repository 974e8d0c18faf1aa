--  SPDX-License-Identifier: GPL-3.0-or-later
--  The vision: its mode, where robots are searched for, when an image is sent;
--  and, in the rooms above, the camera with the library for its images, the
--  images on their way, and the tasks that work on them. Each is a child.

package Vision with SPARK_Mode, Pure is

end Vision;
