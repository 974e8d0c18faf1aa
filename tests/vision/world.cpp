// SPDX-License-Identifier: GPL-3.0-or-later
/* The camera, and the ray caster, by tiles of the image: one that a single
 * plain surface fills takes one ray a pixel; others are divided, the least
 * take sixteen. */
#include "world.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

cv::Matx33d about_axis(double x, double y, double z, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
  return {t * x * x + c,     t * x * y - s * z, t * x * z + s * y,
          t * x * y + s * z, t * y * y + c,     t * y * z - s * x,
          t * x * z - s * y, t * y * z + s * x, t * z * z + c};
}

//  Undistorted over distorted radius, by the square of the distorted
double correction(const Lens &lens, double r2) {
  return lens.model == Lens::brown ? 1 - r2 * (lens.k1 + r2 * lens.k2)
                                   : 1 / (1 + lens.k1 * r2);
}

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
  bool beside() const {
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
    return *std::max_element(beyond, beyond + 4) == 4;
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
      if (piece.beside())
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

Camera::Camera(cv::Size image, double focal_length, cv::Point2d middle,
               const Lens &lens)
    : size(image), focal(focal_length), middle_(middle), lens_(lens) {}

void Camera::stand(cv::Point2d aim, double away, double tilt, double azimuth,
                   double roll) {
  turn_ = about_axis(0, 0, 1, roll) *
          about_axis(-std::sin(azimuth), std::cos(azimuth), 0, -tilt);
  distance = away;
  const cv::Vec3d axis = turn_.t() * cv::Vec3d(0, 0, 1);
  position = cv::Vec3d(aim.x, aim.y, 0) - away * axis;
}

cv::Point2d Camera::project(const cv::Point3d &point) const {
  const cv::Vec3d seen =
      turn_ * (cv::Vec3d(point.x, point.y, point.z) - position);
  if (seen[2] < 1e-3)
    return {1e6, 1e6};
  const double x = seen[0] / seen[2], y = seen[1] / seen[2];
  //  The distorted radius, by bisection
  const double wanted = std::hypot(x, y);
  double low = 0, high = 2;
  for (int step = 0; step < 50; ++step) {
    const double r = (low + high) / 2;
    (r * correction(lens_, r * r) < wanted ? low : high) = r;
  }
  const double scale = wanted > 0 ? focal * low / wanted : focal;
  return {middle_.x + x * scale, middle_.y + y * scale};
}

cv::Vec3d Camera::ray(double px, double py) const {
  const double x = (px - middle_.x) / focal, y = (py - middle_.y) / focal;
  const double scale = correction(lens_, x * x + y * y);
  return turn_.t() * cv::Vec3d(x * scale, y * scale, 1);
}

std::vector<cv::Point2d> sides(cv::Point2d half, int count) {
  std::vector<cv::Point2d> points;
  for (int i = -count; i <= count; ++i)
    for (const double end : {-1.0, 1.0}) {
      const double part = double(i) / count;
      points.emplace_back(part * half.x, end * half.y);
      points.emplace_back(end * half.x, part * half.y);
    }
  return points;
}

cv::Rect2d box_around(const std::vector<cv::Point2d> &points) {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  for (const cv::Point2d &point : points) {
    left = std::min(left, point.x);
    right = std::max(right, point.x);
    top = std::min(top, point.y);
    bottom = std::max(bottom, point.y);
  }
  return {left, top, right - left, bottom - top};
}

cv::Point2d turned(cv::Point2d own, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * own.x - s * own.y, s * own.x + c * own.y};
}

cv::Point3d Surface::world(cv::Point2d own) const {
  const cv::Point2d at = centre + turned(own, angle);
  return {at.x, at.y, -height};
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
    const double in = turned(point - shade.through, -shade.angle).y;
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
    const cv::Point2d away = turned(point - glare.at, -glare.angle);
    const double a = away.x / glare.length, b = away.y / glare.width;
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

  //  Light changes slowly: one place in each four by four pixels is enough
  const int step = 4;
  const cv::Size coarse(width / step + 2, height / step + 2);
  cv::Mat on(coarse, CV_32FC3), mirrored(coarse, CV_32FC3);
  for (int j = 0; j < coarse.height; ++j)
    for (int i = 0; i < coarse.width; ++i) {
      const double x = i * step + 1.5, y = j * step + 1.5;
      const cv::Vec3d ray = camera.ray(x, y);
      const cv::Vec3d &eye = camera.position;
      const double t = -eye[2] / ray[2];
      const cv::Point2d point(eye[0] + t * ray[0], eye[1] + t * ray[1]);
      const double out =
          (std::pow(x - width / 2.0, 2) + std::pow(y - height / 2.0, 2)) /
          (0.25 * (double(width) * width + double(height) * height));
      const float lens = float(1 - world.light.vignette * out);
      on.at<cv::Vec3f>(j, i) = cv::Vec3f::all(world.light.on(point) * lens);
      mirrored.at<cv::Vec3f>(j, i) =
          cv::Vec3f::all(world.light.mirrored(point) * lens);
    }
  cv::resize(on, on, coarse * step);
  cv::resize(mirrored, mirrored, coarse * step);
  const cv::Rect whole({}, camera.size);
  return image.mul(on(whole)) + mirrored(whole);
}
