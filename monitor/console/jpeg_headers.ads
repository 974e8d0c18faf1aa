--  SPDX-License-Identifier: GPL-3.0-or-later
--  The size of an image, from the frame header of its JPEG.

with Bytes;

package Jpeg_Headers is

   procedure Get_Size
     (Image  : Bytes.Byte_Array;
      Width  : out Natural;
      Height : out Natural);
   --  In pixels (ITU-T T.81, B.2.2: frame header). Both are 0 if Image is no
   --  JPEG, or ends before its frame header.

end Jpeg_Headers;
