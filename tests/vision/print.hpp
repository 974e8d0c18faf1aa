// SPDX-License-Identifier: GPL-3.0-or-later
/* What a surface looks like: paper, ink, tape, wood, photographs. A paint
 * answers for one point in the surface's own centimetres, (0, 0) its middle;
 * colours are linear BGR, 1 the brightest that the camera shows. */
#ifndef JUDGE_PRINT_HPP
#define JUDGE_PRINT_HPP

#include "texture.hpp"

#include <opencv2/core.hpp>

#include <functional>
#include <memory>
#include <vector>

struct Paint {
  //  False where the surface has a hole. FOOTPRINT: centimetres a sample
  std::function<bool(double x, double y, double footprint, cv::Vec3f &colour)>
      at;
  //  Has edges of its own, so that one sample a pixel is not enough
  bool detailed = true;
};

using PaintPtr = std::shared_ptr<const Paint>;

//  One colour times a texture; fills its surface
PaintPtr plain_paint(const cv::Vec3f &colour, const Floor &texture);

//  A picture stretched to WIDTH x HEIGHT
PaintPtr picture_paint(TexturePtr picture, double width, double height,
                       const cv::Vec3f &tint);

//  One colour within a polygon, of which CORNERS times SCALE are the corners
PaintPtr polygon_paint(std::vector<cv::Point2f> corners, double scale,
                       const cv::Vec3f &colour);

//  COLUMNS x ROWS fields of SIZE from the surface's middle, in two colours,
//  with MARGIN of the first around
PaintPtr board_paint(int columns, int rows, double size, double margin,
                     const cv::Vec3f &light, const cv::Vec3f &dark);

//  Rows of printed words: what text looks like from afar
PaintPtr text_paint(double width, double height, double line,
                    const cv::Vec3f &paper, const cv::Vec3f &ink,
                    Random &random);

struct Blot {
  cv::Point2d centre;
  double radius;
  cv::Vec3f colour;
};

//  A square code of black and white modules on paper: what is printed,
//  and what happened to the print
struct Code {
  int modules = 6;          //  a side, the black frame included
  std::vector<bool> white;  //  row by row
  double module = 1;        //  centimetres
  double margin = 1;        //  of white around, in modules
  cv::Vec3f paper, ink;
  double gain = 0;          //  how far ink spread, in modules
  std::vector<Blot> blots;
  bool creased = false;
  double crease_at = 0, crease_angle = 0;  //  modules, radians
  Floor grain;
};

PaintPtr code_paint(const Code &code);

#endif
