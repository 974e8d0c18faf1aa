// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzz targets of vision_c. What a call gives back is checked against what
// vision.h says; anything else ends the process with abort.

#ifndef VISION_TARGETS_HPP
#define VISION_TARGETS_HPP

#include <cstddef>

// Any calls in any order: small images of any pixels, and arguments that
// vision.h does not allow.
void calls(const unsigned char *data, std::size_t size);

// An arena with robots as the camera shows it, spoilt in places; then what
// the supervisor does with an image.
void scenes(const unsigned char *data, std::size_t size);

// The bytes of a still image in a file: JPEG, PNG or what else OpenCV reads.
void files(const unsigned char *data, std::size_t size);

#endif
