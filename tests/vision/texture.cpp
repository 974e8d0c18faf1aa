// SPDX-License-Identifier: GPL-3.0-or-later
/* Textures: value noise, floors of several kinds, and mip maps. */
#include "texture.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace {

constexpr int side = 512;

float lattice(int x, int y, unsigned salt) {
  unsigned h = unsigned(x) * 0x8DA6B343u ^ unsigned(y) * 0xD8163841u ^
               salt * 0xCB1AB31Fu;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return float((h ^ (h >> 15)) & 0xFFFFFF) / float(0x800000) - 1;
}

//  Value noise, repeated after NX by NY cells, -1 .. 1
float noise(double u, double v, int nx, int ny, unsigned salt) {
  const double x = u * nx, y = v * ny;
  const int i = int(std::floor(x)), j = int(std::floor(y));
  double a = x - i, b = y - j;
  a = a * a * (3 - 2 * a);
  b = b * b * (3 - 2 * b);
  const auto wrap = [](int k, int n) { return ((k % n) + n) % n; };
  const int i0 = wrap(i, nx), i1 = wrap(i + 1, nx);
  const int j0 = wrap(j, ny), j1 = wrap(j + 1, ny);
  return float((1 - b) * ((1 - a) * lattice(i0, j0, salt) +
                          a * lattice(i1, j0, salt)) +
               b * ((1 - a) * lattice(i0, j1, salt) +
                    a * lattice(i1, j1, salt)));
}

float cloud(double u, double v, int cells, int octaves, unsigned salt) {
  float sum = 0, weight = 1;
  for (int o = 0; o < octaves; ++o, weight *= 0.5f)
    sum += weight * noise(u, v, cells << o, cells << o, salt + unsigned(o));
  return sum;
}

using Pattern = std::function<cv::Vec3f(double, double)>;

TexturePtr make(const Pattern &pattern) {
  cv::Mat picture(side, side, CV_32FC3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const cv::Vec3f c = pattern((x + 0.5) / side, (y + 0.5) / side);
      picture.at<cv::Vec3f>(y, x) = {std::max(0.02f, c[0]),
                                     std::max(0.02f, c[1]),
                                     std::max(0.02f, c[2])};
    }
  return std::make_shared<const Texture>(picture);
}

cv::Vec3f grey(float value) { return {value, value, value}; }

std::vector<Floor> make_floors() {
  std::vector<Floor> floors;
  //  Planks, each of its own tone, with gaps and grain
  for (unsigned kind = 0; kind < 3; ++kind)
    floors.push_back(
        {make([kind](double u, double v) {
           const int planks = 4 + int(kind) * 2;
           const int plank = int(v * planks);
           const double shift = 0.37 * plank;
           const double across = v * planks - plank;
           const double along = u + shift - std::floor(u + shift);
           const float grain =
               0.10f * noise(u + shift, v, 6, 96, 7 + kind) +
               0.06f * noise(u + shift, v, 20, 256, 11 + kind);
           float tone = 1 + 0.18f * lattice(plank, int(kind), 3) + grain;
           if (across < 0.03 || along < 0.006)
             tone *= 0.35f;
           return cv::Vec3f(tone * 0.62f, tone * 0.92f, tone * 1.2f);
         }),
         60.0});
  //  Tiles with light or dark joints
  for (unsigned kind = 0; kind < 3; ++kind)
    floors.push_back({make([kind](double u, double v) {
                        const int n = 2 + int(kind);
                        const double a = u * n - std::floor(u * n);
                        const double b = v * n - std::floor(v * n);
                        const bool joint = a < 0.03 || b < 0.03;
                        const float tone =
                            joint ? (kind == 1 ? 0.4f : 1.6f)
                                  : 1 + 0.1f * lattice(int(u * n), int(v * n),
                                                       kind) +
                                        0.07f * cloud(u, v, 8, 4, kind + 20);
                        return cv::Vec3f(tone * 1.02f, tone, tone * 0.97f);
                      }),
                      60.0});
  //  Carpet
  for (unsigned kind = 0; kind < 2; ++kind)
    floors.push_back({make([kind](double u, double v) {
                        const float tone =
                            1 + 0.25f * noise(u, v, 256, 256, 31 + kind) +
                            0.15f * noise(u, v, 128, 128, 33 + kind) +
                            0.1f * cloud(u, v, 4, 3, 35 + kind);
                        return cv::Vec3f(tone * (kind ? 1.3f : 0.95f), tone,
                                         tone * (kind ? 0.75f : 1.05f));
                      }),
                      40.0});
  //  Concrete, and linoleum with speckles
  floors.push_back({make([](double u, double v) {
                      return grey(1 + 0.15f * cloud(u, v, 3, 7, 41));
                    }),
                    90.0});
  floors.push_back({make([](double u, double v) {
                      const float speck = noise(u, v, 200, 200, 43);
                      return grey(1 + 0.05f * cloud(u, v, 4, 4, 44) +
                                  (speck > 0.7f    ? 0.5f
                                   : speck < -0.7f ? -0.4f
                                                   : 0.0f));
                    }),
                    50.0});
  //  A plain table top
  floors.push_back({make([](double u, double v) {
                      const float tone = 1 + 0.03f * cloud(u, v, 3, 4, 47);
                      return cv::Vec3f(tone * 0.95f, tone, tone * 1.04f);
                    }),
                    120.0});
  //  Cloth: a weave with stripes
  floors.push_back({make([](double u, double v) {
                      const float weave =
                          0.1f * float(std::sin(u * 2 * M_PI * 120) *
                                       std::sin(v * 2 * M_PI * 120));
                      const bool stripe = int(u * 12) % 3 == 0;
                      const float tone = (stripe ? 0.7f : 1.1f) + weave;
                      return cv::Vec3f(tone, tone * 0.9f,
                                       stripe ? tone * 1.2f : tone);
                    }),
                    50.0});
  //  Squares of two tones
  floors.push_back({make([](double u, double v) {
                      const bool dark = (int(u * 4) + int(v * 4)) % 2;
                      return grey((dark ? 0.65f : 1.3f) +
                                  0.06f * cloud(u, v, 8, 4, 51));
                    }),
                    80.0});
  //  Bricks
  floors.push_back({make([](double u, double v) {
                      const int row = int(v * 16);
                      const double along = u * 8 + (row % 2) * 0.5;
                      const double a = along - std::floor(along);
                      const double b = v * 16 - row;
                      if (a < 0.04 || b < 0.09)
                        return grey(1.5f);
                      const float tone =
                          0.9f + 0.25f * lattice(int(along), row, 5) +
                          0.1f * cloud(u, v, 32, 3, 53);
                      return cv::Vec3f(tone * 0.6f, tone * 0.8f,
                                       tone * 1.3f);
                    }),
                    90.0});
  return floors;
}

}  // namespace

Texture::Texture(const cv::Mat &picture, bool repeated)
    : repeated_(repeated) {
  levels_.push_back(picture);
  while (std::min(levels_.back().cols, levels_.back().rows) > 4) {
    cv::Mat half;
    cv::resize(levels_.back(), half, {}, 0.5, 0.5, cv::INTER_AREA);
    levels_.push_back(half);
  }
}

double Texture::aspect() const {
  return double(levels_[0].rows) / levels_[0].cols;
}

cv::Vec3f Texture::at(double u, double v, double footprint) const {
  std::size_t level = 0;
  double texels = footprint * levels_[0].cols;
  for (; texels > 1.5 && level + 1 < levels_.size(); texels /= 2)
    ++level;
  const cv::Mat &map = levels_[level];
  u -= std::floor(u * 0.5) * 2;
  v -= std::floor(v * 0.5) * 2;
  if (repeated_) {
    u -= u >= 1;
    v -= v >= 1;
  } else {
    u = u > 1 ? 2 - u : u;
    v = v > 1 ? 2 - v : v;
  }
  const float x = float(u * map.cols - 0.5), y = float(v * map.rows - 0.5);
  const int i = int(x + 1) - 1, j = int(y + 1) - 1;
  const float a = x - float(i), b = y - float(j);
  const auto column = [&](int k) {
    return repeated_ ? (k < 0 ? map.cols - 1 : k >= map.cols ? 0 : k)
                     : std::clamp(k, 0, map.cols - 1);
  };
  const auto line = [&](int k) {
    return repeated_ ? (k < 0 ? map.rows - 1 : k >= map.rows ? 0 : k)
                     : std::clamp(k, 0, map.rows - 1);
  };
  const cv::Vec3f *above = map.ptr<cv::Vec3f>(line(j));
  const cv::Vec3f *below = map.ptr<cv::Vec3f>(line(j + 1));
  const int left = column(i), right = column(i + 1);
  return (1 - b) * ((1 - a) * above[left] + a * above[right]) +
         b * ((1 - a) * below[left] + a * below[right]);
}

Floor pick_floor(Random &random) {
  static const std::vector<Floor> floors = make_floors();
  Floor floor = floors[std::size_t(random.pick(int(floors.size())))];
  floor.size *= random.in(0.6, 1.5);
  return floor;
}

Floor pick_grain(Random &random) {
  static const std::vector<Floor> grains = {
      {make([](double u, double v) {
         return grey(1 + 0.02f * noise(u, v, 200, 200, 61) +
                     0.02f * cloud(u, v, 6, 4, 62));
       }),
       20.0},
      {make([](double u, double v) {
         return grey(1 + 0.04f * cloud(u, v, 3, 6, 63));
       }),
       70.0},
      {make([](double u, double v) {
         return grey(1 + 0.015f * cloud(u, v, 4, 3, 64));
       }),
       50.0}};
  return grains[std::size_t(random.pick(int(grains.size())))];
}
