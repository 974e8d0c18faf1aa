// SPDX-License-Identifier: GPL-3.0-or-later
/* Paints: plain, pictures, shapes, boards, text and codes. */
#include "print.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace {

PaintPtr paint(Paint made) { return std::make_shared<Paint>(std::move(made)); }

bool is_ink(const Code &code, double u, double v) {
  const int n = code.modules;
  if (u < 0 || v < 0 || u >= n || v >= n)
    return false;
  return !code.white[std::size_t(int(v) * n + int(u))];
}

//  Ink spreads over the edges of what is white
bool is_black(const Code &code, double u, double v) {
  const double g = code.gain;
  return is_ink(code, u, v) ||
         (g > 0 && (is_ink(code, u - g, v) || is_ink(code, u + g, v) ||
                    is_ink(code, u, v - g) || is_ink(code, u, v + g)));
}

}  // namespace

PaintPtr plain_paint(const cv::Vec3f &tint, const Floor &floor) {
  return picture_paint(floor.texture, floor.size, floor.size, tint);
}

PaintPtr picture_paint(TexturePtr picture, double width, double height,
                       const cv::Vec3f &tint) {
  return paint({[=](double x, double y, double footprint, cv::Vec3f &colour) {
                  colour = tint.mul(picture->at(x / width + 0.5,
                                                y / height + 0.5,
                                                footprint / width));
                  return true;
                },
                false});
}

PaintPtr polygon_paint(std::vector<cv::Point2f> corners, double scale,
                       const cv::Vec3f &ink) {
  return paint({[=](double x, double y, double, cv::Vec3f &colour) {
    colour = ink;
    return cv::pointPolygonTest(corners, cv::Point2d(x, y) / scale, false) > 0;
  }});
}

PaintPtr board_paint(int columns, int rows, double size, double margin,
                     const cv::Vec3f &light, const cv::Vec3f &dark) {
  return paint({[=](double x, double y, double, cv::Vec3f &colour) {
    const double u = x / size + columns / 2.0, v = y / size + rows / 2.0;
    const double m = margin / size;
    if (u < -m || v < -m || u > columns + m || v > rows + m)
      return false;
    const bool field = u >= 0 && v >= 0 && u < columns && v < rows;
    colour = field && (int(u) + int(v)) % 2 == 0 ? dark : light;
    return true;
  }});
}

PaintPtr text_paint(double width, double height, double line,
                    const cv::Vec3f &paper, const cv::Vec3f &ink,
                    Random &random) {
  constexpr int fine = 4;  //  texels of a line, and of half of one along it
  const int rows = int(height / line), columns = int(width * 2 / line);
  cv::Mat picture(rows * fine, columns * fine, CV_32FC3, cv::Scalar(paper));
  for (int row = rows / 10; row < rows * 9 / 10; ++row)
    for (int cell = columns / 10;
         cell < (row % 9 == 8 ? columns / 2 : columns * 9 / 10); ++cell)
      if (random.chance(0.83))
        picture(cv::Rect(cell * fine, row * fine + 1, fine, 2)) =
            cv::Scalar(paper + (ink - paper) * random.in(0.3, 1));
  return picture_paint(std::make_shared<const Texture>(picture), width, height,
                       {1, 1, 1});
}

PaintPtr code_paint(const Code &code) {
  return paint({[=](double x, double y, double footprint, cv::Vec3f &colour) {
    const double half = code.modules / 2.0;
    const double u = x / code.module + half, v = y / code.module + half;
    if (std::max(std::abs(u - half), std::abs(v - half)) > half + code.margin)
      return false;
    colour = is_black(code, u, v) ? code.ink : code.paper;
    for (const Blot &blot : code.blots) {
      const cv::Point2d away = cv::Point2d(x, y) / code.module - blot.centre;
      //  Not a disc: a drop with lobes
      const double angle = std::atan2(away.y, away.x);
      const double lobes = 1 + 0.12 * std::sin(3 * angle + blot.radius * 40) +
                           0.08 * std::sin(7 * angle);
      if (cv::norm(away) < blot.radius * lobes)
        colour = blot.colour;
    }
    if (code.creased) {
      const double across = (u - half) * std::cos(code.crease_angle) +
                            (v - half) * std::sin(code.crease_angle) -
                            code.crease_at;
      if (std::abs(across) < 0.15)
        colour *= across > 0 ? 1.15f : 0.8f;
    }
    const double size = code.grain.size;
    colour = colour.mul(
        code.grain.texture->at(x / size, y / size, footprint / size));
    return true;
  }});
}
