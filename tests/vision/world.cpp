// SPDX-License-Identifier: GPL-3.0-or-later
/* The ray caster, by tiles of the image: one that a single plain surface
 * fills takes one ray a pixel; others are divided, the least take sixteen. */
#include "world.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

constexpr int largest = 16, smallest = 4;  //  tiles, pixels a side
constexpr int rays = 16;                   //  a pixel

struct Placed {
  const Surface *surface;
  double c, s;      //  of its angle
  cv::Rect2d seen;  //  in the image
};

cv::Point2d own_point(const Placed &placed, const cv::Vec3d &eye,
                      const cv::Vec3d &ray) {
  const Surface &surface = *placed.surface;
  const double t = (-surface.height - eye[2]) / ray[2];
  const double x = eye[0] + t * ray[0] - surface.centre.x;
  const double y = eye[1] + t * ray[1] - surface.centre.y;
  return {placed.c * x + placed.s * y, placed.c * y - placed.s * x};
}

bool within(const Surface &surface, const cv::Point2d &own) {
  return surface.endless || (std::abs(own.x) < surface.half.x &&
                             std::abs(own.y) < surface.half.y);
}

cv::Rect2d seen_by(const Camera &camera, const Surface &surface) {
  if (surface.endless)
    return {-1e6, -1e6, 2e6, 2e6};
  std::vector<cv::Point2d> points;
  for (const cv::Point2d &own : sides(surface.half, 4))
    points.push_back(camera.project(surface.world(own)));
  const cv::Rect2d box = box_around(points);
  //  Room for the bend of a side between two points
  const double room = 2 + 0.02 * std::max(box.width, box.height);
  return {box.x - room, box.y - room, box.width + 2 * room,
          box.height + 2 * room};
}

//  Sixteen places of a pixel, no two in one column or line: bit reversal
//  scatters the lines over the columns
const std::array<cv::Point2d, rays> &pattern() {
  static const std::array<cv::Point2d, rays> places = [] {
    std::array<cv::Point2d, rays> made;
    for (int i = 0; i < rays; ++i) {
      const int turned = ((i & 1) << 3) | ((i & 2) << 1) | ((i & 4) >> 1) |
                         ((i & 8) >> 3);
      made[std::size_t(i)] = {(i + 0.5) / rays - 0.5,
                              (turned + 0.5) / rays - 0.5};
    }
    return made;
  }();
  return places;
}

//  A surface over a tile: its own point is linear enough in so few pixels
struct Piece {
  const Placed *placed;
  cv::Point2d corner[4];

  cv::Point2d at(double a, double b) const {
    return (1 - b) * ((1 - a) * corner[0] + a * corner[1]) +
           b * ((1 - a) * corner[2] + a * corner[3]);
  }
  bool all_within() const {
    for (const cv::Point2d &own : corner)
      if (!within(*placed->surface, own))
        return false;
    return true;
  }
  bool empty() const {
    const Surface &surface = *placed->surface;
    if (surface.endless)
      return false;
    int beyond[4] = {0, 0, 0, 0};
    for (const cv::Point2d &own : corner) {
      beyond[0] += own.x > surface.half.x;
      beyond[1] += own.x < -surface.half.x;
      beyond[2] += own.y > surface.half.y;
      beyond[3] += own.y < -surface.half.y;
    }
    if (*std::max_element(beyond, beyond + 4) == 4)
      return true;
    const cv::Point2d middle = at(0.5, 0.5);
    double reach = 0;
    for (const cv::Point2d &own : corner)
      reach = std::max(reach, cv::norm(own - middle));
    const auto &empty = surface.paint->empty;
    return empty && empty(middle.x, middle.y, reach);
  }
};

class Caster {
 public:
  Caster(const Camera &camera, cv::Mat &image)
      : camera_(camera), image_(image),
        pixel_(camera.distance / camera.focal) {}

  //  CANDIDATES: what may be in sight, the nearest first
  void tile(int left, int top, int side,
            const std::vector<const Placed *> &candidates) {
    if (left >= image_.cols || top >= image_.rows)
      return;
    //  The outer edges of its pixels
    const cv::Rect2d area(left - 0.5, top - 0.5, side, side);
    cv::Vec3d ray[4];
    for (int i = 0; i < 4; ++i)
      ray[i] = camera_.ray(area.x + (i % 2) * side, area.y + (i / 2) * side);
    std::vector<Piece> pieces;
    bool filled = false;
    for (const Placed *placed : candidates) {
      if ((placed->seen & area).area() <= 0)
        continue;
      Piece piece;
      piece.placed = placed;
      for (int i = 0; i < 4; ++i)
        piece.corner[i] = own_point(*placed, camera_.position, ray[i]);
      if (piece.empty())
        continue;
      pieces.push_back(piece);
      filled = placed->surface->solid && piece.all_within();
      if (filled)
        break;
    }
    const bool one = filled && pieces.size() == 1 &&
                     !pieces[0].placed->surface->paint->detailed;
    if (one || side == smallest) {
      shade(left, top, side, pieces, one);
      return;
    }
    std::vector<const Placed *> rest;
    for (const Piece &piece : pieces)
      rest.push_back(piece.placed);
    for (int i = 0; i < 4; ++i)
      tile(left + (i % 2) * side / 2, top + (i / 2) * side / 2, side / 2,
           rest);
  }

 private:
  void shade(int left, int top, int side, const std::vector<Piece> &pieces,
             bool one) {
    const auto &places = pattern();
    const int right = std::min(left + side, image_.cols);
    const int bottom = std::min(top + side, image_.rows);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) {
        const double a = (x - left + 0.5) / side, b = (y - top + 0.5) / side;
        cv::Vec3f sum(0, 0, 0);
        if (one) {
          const cv::Point2d own = pieces[0].at(a, b);
          pieces[0].placed->surface->paint->at(own.x, own.y, pixel_, sum);
        } else {
          for (const cv::Point2d &place : places) {
            cv::Vec3f colour;
            for (const Piece &piece : pieces) {
              const Surface &surface = *piece.placed->surface;
              const cv::Point2d own =
                  piece.at(a + place.x / side, b + place.y / side);
              if (within(surface, own) &&
                  surface.paint->at(own.x, own.y, pixel_ / 2, colour)) {
                sum += colour;
                break;
              }
            }
          }
          sum *= 1.0f / rays;
        }
        image_.at<cv::Vec3f>(y, x) = sum;
      }
  }

  const Camera &camera_;
  cv::Mat &image_;
  double pixel_;  //  centimetres on the floor
};

}  // namespace

cv::Point3d Surface::world(cv::Point2d own) const {
  const double c = std::cos(angle), s = std::sin(angle);
  return {centre.x + c * own.x - s * own.y, centre.y + s * own.x + c * own.y,
          -height};
}

float Light::on(cv::Point2d point) const {
  float light = float(1 + gradient.dot(point - middle));
  for (const Lamp &lamp : lamps) {
    //  Lambert's law and the distance, relative to right below
    const cv::Point2d away = point - lamp.at;
    const double h2 = lamp.height * lamp.height;
    const double near = h2 / (h2 + away.dot(away));
    light += lamp.strength * float(near * near);
  }
  for (const Shade &shade : shades) {
    const cv::Point2d normal(-std::sin(shade.angle), std::cos(shade.angle));
    const double in = normal.dot(point - shade.through);
    const auto edge = [&](double d) {
      const double a = std::clamp(d / shade.soft + 0.5, 0.0, 1.0);
      return a * a * (3 - 2 * a);
    };
    const double dark =
        shade.width > 0 ? edge(in) * edge(shade.width - in) : edge(in);
    light *= float(1 - (1 - shade.light) * dark);
  }
  return std::max(0.02f, light);
}

float Light::mirrored(cv::Point2d point) const {
  float sum = 0;
  for (const Glare &glare : glares) {
    const cv::Point2d away = point - glare.at;
    const double c = std::cos(glare.angle), s = std::sin(glare.angle);
    const double a = (c * away.x + s * away.y) / glare.length;
    const double b = (c * away.y - s * away.x) / glare.width;
    sum += glare.strength * float(std::exp(-(a * a + b * b)));
  }
  return sum;
}

cv::Mat show(const World &world, const Camera &camera) {
  const int width = camera.size.width, height = camera.size.height;
  std::vector<Placed> order;
  for (const Surface &surface : world.surfaces)
    order.push_back({&surface, std::cos(surface.angle),
                     std::sin(surface.angle), seen_by(camera, surface)});
  std::reverse(order.begin(), order.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const Placed &a, const Placed &b) {
                     return a.surface->height > b.surface->height;
                   });

  cv::Mat image(height, width, CV_32FC3, cv::Scalar::all(0));
  std::vector<const Placed *> all;
  for (const Placed &placed : order)
    all.push_back(&placed);
  Caster caster(camera, image);
  for (int top = 0; top < height; top += largest)
    for (int left = 0; left < width; left += largest)
      caster.tile(left, top, largest, all);

  //  Light changes slowly: every fourth pixel is enough
  const int step = 4;
  const cv::Size coarse(width / step + 2, height / step + 2);
  cv::Mat lit(coarse, CV_32FC2);
  for (int j = 0; j < coarse.height; ++j)
    for (int i = 0; i < coarse.width; ++i) {
      const double x = i * step, y = j * step;
      const cv::Vec3d ray = camera.ray(x, y);
      const cv::Vec3d &eye = camera.position;
      const double t = -eye[2] / ray[2];
      const cv::Point2d point(eye[0] + t * ray[0], eye[1] + t * ray[1]);
      const double out =
          (std::pow(x - width / 2.0, 2) + std::pow(y - height / 2.0, 2)) /
          (0.25 * (double(width) * width + double(height) * height));
      const float lens = float(1 - world.light.vignette * out);
      lit.at<cv::Vec2f>(j, i) = {world.light.on(point) * lens,
                                 world.light.mirrored(point) * lens};
    }
  for (int y = 0; y < height; ++y) {
    const int j = y / step;
    const float b = float(y % step) / step;
    const cv::Vec2f *above = lit.ptr<cv::Vec2f>(j);
    const cv::Vec2f *below = lit.ptr<cv::Vec2f>(j + 1);
    cv::Vec3f *line = image.ptr<cv::Vec3f>(y);
    for (int x = 0; x < width; ++x) {
      const int i = x / step;
      const float a = float(x % step) / step;
      const cv::Vec2f l =
          (1 - b) * ((1 - a) * above[i] + a * above[i + 1]) +
          b * ((1 - a) * below[i] + a * below[i + 1]);
      line[x] = line[x] * l[0] + cv::Vec3f(l[1], l[1], l[1]);
    }
  }
  return image;
}
