// SPDX-License-Identifier: GPL-3.0-or-later
/* Textures: pictures that are repeated over a surface, with smaller copies
 * (mip maps) for the distance. They are made of noise and of cells, or are
 * photographs from packages (photographs.txt), none of which is part of this
 * repository. */
#ifndef JUDGE_TEXTURE_HPP
#define JUDGE_TEXTURE_HPP

#include "random.hpp"

#include <memory>
#include <vector>

class Texture {
 public:
  //  PICTURE: 32-bit BGR, linear; repeated as tiles, or MIRRORED, so that
  //  they have no seams
  explicit Texture(const cv::Mat &picture, bool mirrored = false);

  //  At (U, V), 0 .. 1 across one tile, averaged over FOOTPRINT of it
  cv::Vec3f at(double u, double v, double footprint) const;

  double aspect() const;  //  height over width

 private:
  std::vector<cv::Mat> levels_;  //  each with a border of one texel
  bool mirrored_;
};

using TexturePtr = std::shared_ptr<const Texture>;

//  How a floor looks: the texture's mean is about 1 in each channel
struct Floor {
  TexturePtr texture;
  double size;  //  of one tile, centimetres
};

//  A floor or a table top, from a stock that is made once
Floor pick_floor(Random &random);

//  Faint unevenness of paper, paint and felt
Floor pick_grain(Random &random);

//  Reads all photographs below FOLDER; how many there are
int read_photographs(const std::string &folder);

int photograph_count();

//  One as a texture whose mean is about 1
TexturePtr pick_photograph(Random &random);

//  Photograph NUMBER, or a part of it, as an image of a camera
cv::Mat photograph_view(int number, Random &random);

#endif
