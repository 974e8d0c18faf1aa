// SPDX-License-Identifier: GPL-3.0-or-later
/* Textures: mip maps, floors of several kinds, photographs. */
#include "texture.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace {

constexpr int side = 512;

//  A floor: cells with joints, each of its own tone, under noise
struct Kind {
  double size;                   //  of one tile, centimetres
  cv::Vec3f colour{1, 1, 1};
  int columns = 1, rows = 1;     //  of cells
  double shift = 0;              //  of each row against that above, cells
  double gap_u = 0, gap_v = 0;   //  joints, shares of a cell
  float joint = 1, spread = 0;   //  tone of joints; difference of cells
  bool two_tones = false;        //  cells of these by turns
  cv::Size grain{8, 8};          //  noise of one size
  float grain_share = 0;
  int cloud = 4, octaves = 0;    //  noise of many sizes, from CLOUD lumps
  float cloud_share = 0;
};

const Kind floors[] = {
    //  Planks with gaps and grain
    {60, {0.62f, 0.92f, 1.2f}, 1, 4, 0.37, 0.006, 0.03, 0.35f, 0.18f, false,
     {6, 96}, 0.15f},
    {60, {0.62f, 0.92f, 1.2f}, 1, 6, 0.37, 0.006, 0.03, 0.35f, 0.18f, false,
     {6, 96}, 0.15f},
    {60, {0.62f, 0.92f, 1.2f}, 1, 8, 0.37, 0.006, 0.03, 0.35f, 0.18f, false,
     {20, 256}, 0.12f},
    //  Tiles with light or dark joints
    {60, {1.02f, 1, 0.97f}, 2, 2, 0, 0.03, 0.03, 1.6f, 0.1f, false, {8, 8}, 0,
     8, 4, 0.07f},
    {60, {1.02f, 1, 0.97f}, 3, 3, 0, 0.03, 0.03, 0.4f, 0.1f, false, {8, 8}, 0,
     8, 4, 0.07f},
    {60, {1.02f, 1, 0.97f}, 4, 4, 0, 0.03, 0.03, 1.6f, 0.1f, false, {8, 8}, 0,
     8, 4, 0.07f},
    //  Carpet
    {40, {0.95f, 1, 1.05f}, .grain = {256, 256}, .grain_share = 0.3f,
     .octaves = 3, .cloud_share = 0.1f},
    {40, {1.3f, 1, 0.75f}, .grain = {200, 200}, .grain_share = 0.3f,
     .octaves = 3, .cloud_share = 0.1f},
    //  Concrete, linoleum, a plain table top
    {90, .cloud = 3, .octaves = 7, .cloud_share = 0.15f},
    {50, .grain = {200, 200}, .grain_share = 0.35f, .octaves = 4,
     .cloud_share = 0.05f},
    {120, {0.95f, 1, 1.04f}, .cloud = 3, .octaves = 4, .cloud_share = 0.03f},
    //  Cloth with stripes, squares of two tones, bricks
    {50, {1, 0.92f, 1.1f}, .columns = 12, .spread = 0.2f, .two_tones = true,
     .grain = {240, 240}, .grain_share = 0.1f},
    {80, .columns = 4, .rows = 4, .spread = 0.33f, .two_tones = true,
     .cloud = 8, .octaves = 4, .cloud_share = 0.06f},
    {90, {0.55f, 0.75f, 1.2f}, 8, 16, 0.5, 0.04, 0.09, 1.5f, 0.25f, false,
     {8, 8}, 0, 32, 3, 0.1f}};

const Kind grains[] = {
    {20, .grain = {200, 200}, .grain_share = 0.02f, .cloud = 6, .octaves = 4,
     .cloud_share = 0.02f},
    {70, .cloud = 3, .octaves = 6, .cloud_share = 0.04f},
    {50, .octaves = 3, .cloud_share = 0.015f}};

//  LUMPS over the whole, which goes on at the other side; -1 .. 1
cv::Mat noise(Random &random, cv::Size lumps) {
  cv::Mat values(lumps, CV_32F), map;
  random.fill(values, cv::RNG::UNIFORM, -1, 1);
  cv::resize(cv::repeat(values, 2, 2), map, {2 * side, 2 * side}, 0, 0,
             cv::INTER_CUBIC);
  return map(cv::Rect(side / 2, side / 2, side, side));
}

Floor make(const Kind &kind, Random &random) {
  cv::Mat tones = 1 + kind.grain_share * noise(random, kind.grain);
  float share = kind.cloud_share;
  for (int octave = 0; octave < kind.octaves; ++octave, share /= 2)
    tones += share * noise(random, cv::Size(kind.cloud, kind.cloud) *
                                       (1 << octave));
  cv::Mat cells(kind.rows, kind.columns, CV_32F);
  random.fill(cells, cv::RNG::UNIFORM, -kind.spread, kind.spread);
  cv::Mat picture(side, side, CV_32FC3);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double v = (y + 0.5) / side * kind.rows;
      const int row = int(v);
      const double u = (x + 0.5) / side * kind.columns + kind.shift * row;
      const int column = int(u);
      const float own = kind.two_tones
                            ? ((row + column) % 2 ? kind.spread : -kind.spread)
                            : cells.at<float>(row, column % kind.columns);
      const bool joint = u - column < kind.gap_u || v - row < kind.gap_v;
      picture.at<cv::Vec3f>(y, x) =
          kind.colour *
          (joint ? kind.joint
                 : std::max(0.02f, tones.at<float>(y, x) + own));
    }
  return {std::make_shared<const Texture>(picture), kind.size};
}

template <std::size_t count>
std::vector<Floor> make_all(const Kind (&kinds)[count]) {
  Random random(1);
  std::vector<Floor> made;
  for (const Kind &kind : kinds)
    made.push_back(make(kind, random));
  return made;
}

struct Photograph {
  cv::Mat picture;
  TexturePtr texture;
};

std::vector<Photograph> stock;

}  // namespace

Texture::Texture(const cv::Mat &picture, bool mirrored)
    : mirrored_(mirrored) {
  cv::Mat level = picture, bordered;
  do {
    cv::copyMakeBorder(level, bordered, 1, 1, 1, 1,
                       mirrored ? cv::BORDER_REPLICATE : cv::BORDER_WRAP);
    levels_.push_back(bordered.clone());
    cv::resize(level, level, {}, 0.5, 0.5, cv::INTER_AREA);
  } while (std::min(level.cols, level.rows) > 2);
}

double Texture::aspect() const {
  return (levels_[0].rows - 2.0) / (levels_[0].cols - 2.0);
}

cv::Vec3f Texture::at(double u, double v, double footprint) const {
  std::size_t level = 0;
  for (double texels = footprint * levels_[0].cols;
       texels > 1.5 && level + 1 < levels_.size(); texels /= 2)
    ++level;
  const cv::Mat &map = levels_[level];
  const auto within = [this](double share) {
    return mirrored_ ? std::abs(share - 2 * std::round(share / 2))
                     : share - std::floor(share);
  };
  const float x = float(within(u) * (map.cols - 2)) + 0.5f;
  const float y = float(within(v) * (map.rows - 2)) + 0.5f;
  const int i = int(x), j = int(y);
  const float a = x - float(i), b = y - float(j);
  const cv::Vec3f *above = map.ptr<cv::Vec3f>(j) + i;
  const cv::Vec3f *below = map.ptr<cv::Vec3f>(j + 1) + i;
  return (1 - b) * ((1 - a) * above[0] + a * above[1]) +
         b * ((1 - a) * below[0] + a * below[1]);
}

Floor pick_floor(Random &random) {
  static const std::vector<Floor> made = make_all(floors);
  Floor floor = made[std::size_t(random.pick(int(made.size())))];
  floor.size *= random.in(0.6, 1.5);
  return floor;
}

Floor pick_grain(Random &random) {
  static const std::vector<Floor> made = make_all(grains);
  return made[std::size_t(random.pick(int(made.size())))];
}

int read_photographs(const std::string &folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto &entry :
       std::filesystem::recursive_directory_iterator(folder, error))
    if (entry.is_regular_file())
      names.push_back(entry.path().string());
  std::sort(names.begin(), names.end());
  for (const std::string &name : names) {
    cv::Mat picture = cv::imread(name, cv::IMREAD_COLOR);
    if (picture.empty() || picture.cols < 300 || picture.rows < 200)
      continue;
    const double scale = 1600.0 / std::max(picture.cols, picture.rows);
    if (scale < 1)
      cv::resize(picture, picture, {}, scale, scale, cv::INTER_AREA);
    cv::Mat light;
    cv::resize(picture, light, {}, 0.5, 0.5, cv::INTER_AREA);
    light.convertTo(light, CV_32F, 1 / 255.0);
    cv::pow(light, 2.2, light);
    const cv::Scalar mean = cv::mean(light);
    light *= 1 / std::max(0.02, (mean[0] + mean[1] + mean[2]) / 3);
    stock.push_back({picture, std::make_shared<const Texture>(light, true)});
  }
  return int(stock.size());
}

int photograph_count() { return int(stock.size()); }

TexturePtr pick_photograph(Random &random) {
  return stock[std::size_t(random.pick(photograph_count()))].texture;
}

cv::Mat photograph_view(int number, Random &random) {
  const cv::Mat &whole =
      stock[std::size_t(number % photograph_count())].picture;
  //  At first all of it, then parts
  const int round = number / photograph_count();
  const double share = round == 0 ? 1 : random.in(0.35, 0.9);
  const cv::Size part(int(whole.cols * share), int(whole.rows * share));
  const cv::Mat cut =
      whole(cv::Rect(random.pick(whole.cols - part.width + 1),
                     random.pick(whole.rows - part.height + 1), part.width,
                     part.height));
  const int widths[] = {640, 800, 1024, 1280};
  const int width = widths[random.pick(4)];
  cv::Mat image;
  cv::resize(cut, image, {width, width * part.height / part.width}, 0, 0,
             width < part.width ? cv::INTER_AREA : cv::INTER_CUBIC);
  if (round > 0 && random.chance(0.3))
    cv::flip(image, image, 1);
  return image;
}
