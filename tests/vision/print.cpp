// SPDX-License-Identifier: GPL-3.0-or-later
/* Paints: plain, pictures, shapes, boards, text and codes. */
#include "print.hpp"

#include "peers.hpp"

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
  return paint({[=](double x, double y, double footprint, cv::Vec3f &colour) {
                  colour = tint.mul(floor.texture->at(
                      x / floor.size, y / floor.size, footprint / floor.size));
                  return true;
                },
                false});
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

PaintPtr polygon_paint(std::vector<cv::Point2d> corners,
                       const cv::Vec3f &ink) {
  return paint({[=](double x, double y, double, cv::Vec3f &colour) {
    bool inside = false;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size();
         j = i++) {
      const cv::Point2d &a = corners[i], &b = corners[j];
      if ((a.y > y) != (b.y > y) &&
          x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x)
        inside = !inside;
    }
    colour = ink;
    return inside;
  }});
}

PaintPtr stroke_paint(std::vector<cv::Point2d> points, double thickness,
                      const cv::Vec3f &ink) {
  const double radius = thickness / 2;
  const auto gap = [=](double x, double y) {
    double least = 1e9;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const cv::Point2d along = points[i] - points[i - 1];
      const cv::Point2d to = cv::Point2d(x, y) - points[i - 1];
      const double share = std::clamp(
          to.dot(along) / std::max(1e-9, along.dot(along)), 0.0, 1.0);
      least = std::min(least, cv::norm(to - share * along));
    }
    return least;
  };
  return paint({[=](double x, double y, double, cv::Vec3f &colour) {
                  const double away = gap(x, y);
                  //  Round: brighter along its middle
                  colour = ink * float(1.25 - 0.6 * away / radius);
                  return away < radius;
                },
                true,
                [=](double x, double y, double reach) {
                  return gap(x, y) > radius + reach;
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

PaintPtr frame_paint(double width, double height, double border,
                     const cv::Vec3f &ink) {
  const auto out = [=](double x, double y) {
    return std::max(std::abs(x) - width / 2, std::abs(y) - height / 2);
  };
  return paint({[=](double x, double y, double, cv::Vec3f &colour) {
                  colour = ink;
                  return out(x, y) < 0 && out(x, y) > -border;
                },
                true,
                [=](double x, double y, double reach) {
                  return out(x, y) > reach || out(x, y) < -border - reach;
                }});
}

PaintPtr text_paint(double width, double height, double line,
                    const cv::Vec3f &paper, const cv::Vec3f &ink,
                    std::uint64_t seed) {
  Random random(seed);
  const int rows = int(height * 0.8 / line);
  const int columns = std::max(1, int(width * 2 / line));
  std::vector<float> ink_at;
  for (int row = 0; row < rows; ++row)
    for (int cell = 0; cell < columns; ++cell) {
      const int last = row % 9 == 8 ? columns / 2 : columns;
      ink_at.push_back(
          row % 9 < 8 + (row / 9) % 2 && cell < last
              ? float(random.chance(0.17) ? 0 : random.in(0.3, 1))
              : 0.0f);
    }
  return paint({[=](double x, double y, double, cv::Vec3f &colour) {
    colour = paper;
    const double u = (x / width + 0.5 - 0.1) / 0.8;
    const double v = (y + 0.4 * height) / line;
    if (u < 0 || u >= 1 || v < 0)
      return true;
    const std::size_t cell = std::size_t(v) * std::size_t(columns) +
                             std::size_t(u * columns);
    const double within = v - std::floor(v);
    if (cell < ink_at.size() && within > 0.25 && within < 0.75)
      colour += (ink - paper) * ink_at[cell];
    return true;
  }});
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
