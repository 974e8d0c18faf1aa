// SPDX-License-Identifier: GPL-3.0-or-later
/* The frame slots of vision_c, numbered as in vision.h, for the tests: images
 * that come from no source.
 */
#ifndef SLOTS_H
#define SLOTS_H

#include "vision.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Stores an image: 8-bit BGR, rows of WIDTH * 3 bytes without padding. */
void slot_load(int slot, const unsigned char *bgr, int width, int height);

/* Stores a JPEG, as vision_grab does, to be fitted to WIDTH x HEIGHT.
 * VISION_NO_IMAGE if it is damaged; the slot is unchanged then. */
vision_status slot_load_jpeg(int slot, const unsigned char *jpeg, int length,
                             int width, int height);

/* The size of the image in SLOT, which must hold one. */
void slot_size(int slot, int *width, int *height);

#ifdef __cplusplus
}
#endif

#endif
