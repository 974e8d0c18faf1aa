// SPDX-License-Identifier: GPL-3.0-or-later
/* Photographs from packages (photographs.txt), where they were unpacked:
 * none of them is part of this repository. */
#ifndef JUDGE_PHOTOGRAPHS_HPP
#define JUDGE_PHOTOGRAPHS_HPP

#include "random.hpp"
#include "texture.hpp"

#include <opencv2/core.hpp>

#include <string>

//  Reads all images below FOLDER; how many there are
int read_photographs(const std::string &folder);

int photograph_count();

//  One as a texture whose mean is about 1
TexturePtr pick_photograph(Random &random);

//  Photograph NUMBER, or a part of it, as an image of a camera
cv::Mat photograph_view(int number, Random &random);

#endif
