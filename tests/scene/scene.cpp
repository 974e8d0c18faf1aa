// SPDX-License-Identifier: GPL-3.0-or-later
// The synthetic arena: shapes are evaluated analytically and averaged over
// each pixel, so that the truth holds to a few hundredths of a pixel.

#include "scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <jpeglib.h>

#include <opencv2/core.hpp>
#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

namespace {

// The world, in centimetres.
constexpr double field_width = 80.0;
constexpr double field_height = 60.0;
constexpr double border = 3.0;
constexpr double body_radius = 6.2;
constexpr double module = 1.0;  // of the marker: 6 modules, a quiet one around
constexpr double marker_half = 3.0 * module;
constexpr double quiet_half = 4.0 * module;
constexpr double triangle_height = 8.0;
constexpr double triangle_half_base = 2.5;
constexpr double triangle_tip = triangle_height * 2.0 / 3.0;  // from centroid
constexpr double triangle_foot = triangle_height / 3.0;

// Grey levels.
constexpr int floor_grey = 45;
constexpr int field_grey = 120;
constexpr int border_grey = 235;
constexpr int body_grey = 35;
constexpr int black_grey = 15;
constexpr int white_grey = 240;

constexpr int samples = 16;  // in each pixel
constexpr int noise_length = 1 << 16;

// Between pixels and centimetres of the arena.
struct View {
  double scale;  // pixels per centimetre
  double cosine, sine;
  double middle_x, middle_y;

  explicit View(const scene_description &scene) {
    // An image wider than the arena limits the height instead.
    scale = std::min(scene.fill * scene.width / (field_width + 2 * border),
                     0.95 * scene.height / (field_height + 2 * border));
    const double turn = scene.turn * CV_PI / 180.0;
    cosine = std::cos(turn);
    sine = std::sin(turn);
    middle_x = (scene.width - 1) / 2.0;
    middle_y = (scene.height - 1) / 2.0;
  }

  cv::Point2d pixel(double x, double y) const {
    const double u = scale * (x - field_width / 2.0);
    const double v = scale * (field_height / 2.0 - y);
    return {middle_x + cosine * u - sine * v,
            middle_y + sine * u + cosine * v};
  }

  cv::Point2d world(double px, double py) const {
    const double dx = (px - middle_x) / scale;
    const double dy = (py - middle_y) / scale;
    return {field_width / 2.0 + cosine * dx + sine * dy,
            field_height / 2.0 + sine * dx - cosine * dy};
  }

  // One of the places that stand for a pixel: no two in one row or column,
  // so that edges along the image's own axes come out as fine as others.
  cv::Point2d sample(int column, int row, int k) const {
    return world(column - 0.5 + (k + 0.5) / samples,
                 row - 0.5 + (7 * k % samples + 0.5) / samples);
  }
};

bool within(double value, double low, double high) {
  return value >= low && value <= high;  // false for a NaN too
}

bool valid(const scene_description *scene) {
  if (scene == nullptr || scene->width < 1 || scene->width > 8192 ||
      scene->height < 1 || scene->height > 8192 ||
      !within(scene->fill, 0.3, 0.95) || !within(scene->turn, -360.0, 360.0) ||
      !within(scene->noise, 0.0, 30.0) || !within(scene->blur, 0.0, 20.0) ||
      !within(scene->uneven, 0.0, 0.7) ||
      !within(scene->lean_x, -1e-3, 1e-3) ||
      !within(scene->lean_y, -1e-3, 1e-3) || scene->robots < 0 ||
      scene->robots > 4)
    return false;
  for (int n = 0; n < scene->robots; ++n) {
    const scene_robot &robot = scene->robot[n];
    if (robot.marker < 0 || robot.marker > 1 || robot.id < 0 ||
        robot.id > 999 || !within(robot.x, 0.0, field_width) ||
        !within(robot.y, 0.0, field_height) ||
        !within(robot.heading, -1e6, 1e6))
      return false;
  }
  return true;
}

// The part of a scene that does not change from image to image.
struct Backdrop {
  scene_description of = {};  // that scene
  cv::Mat image;  // grey
  cv::Mat light;  // gain, 255 = 1, empty for an even light

  bool fits(const scene_description &scene) const {
    return of.width == scene.width && of.height == scene.height &&
           of.arena == scene.arena && of.fill == scene.fill &&
           of.turn == scene.turn && of.uneven == scene.uneven;
  }

  void draw(const scene_description &scene);
};

void Backdrop::draw(const scene_description &scene) {
  of.width = 0;  // fits nothing while it is being drawn
  const View view(scene);
  const cv::Size size(scene.width, scene.height);

  // Stains and grain, the same in every run.
  cv::RNG random(2021);
  cv::Mat coarse(std::max(2, scene.height / 24), std::max(2, scene.width / 24),
                 CV_8UC1);
  cv::Mat fine(std::max(2, scene.height / 3), std::max(2, scene.width / 3),
               CV_8UC1);
  random.fill(coarse, cv::RNG::NORMAL, 20.0, 7.0);
  random.fill(fine, cv::RNG::NORMAL, 20.0, 4.0);
  cv::Mat stains, grain;
  cv::resize(coarse, stains, size, 0, 0, cv::INTER_CUBIC);
  cv::resize(fine, grain, size, 0, 0, cv::INTER_LINEAR);

  image.create(size, CV_8UC1);
  for (int row = 0; row < scene.height; ++row) {
    for (int column = 0; column < scene.width; ++column) {
      const int texture = stains.at<uchar>(row, column) +
                          grain.at<uchar>(row, column) - 40;
      int in_field = 0, in_border = 0;
      if (scene.arena) {
        for (int k = 0; k < samples; ++k) {
          const cv::Point2d p = view.sample(column, row, k);
          const double beside = std::max(-p.x, p.x - field_width);
          const double beyond = std::max(-p.y, p.y - field_height);
          const double out = std::max(beside, beyond);
          if (out < 0.0)
            ++in_field;
          else if (out < border)
            ++in_border;
        }
      }
      const int in_floor = samples - in_field - in_border;
      const int sum = in_floor * (floor_grey + texture) +
                      in_field * (field_grey + texture / 4) +
                      in_border * border_grey;
      image.at<uchar>(row, column) =
          cv::saturate_cast<uchar>(sum / samples);
    }
  }

  // The light falls off from the top left to the bottom right corner.
  light.release();
  if (scene.uneven > 0.0) {
    light.create(size, CV_8UC1);
    for (int row = 0; row < scene.height; ++row)
      for (int column = 0; column < scene.width; ++column) {
        const double across = 0.5 * (double(column) / scene.width +
                                     double(row) / scene.height);
        light.at<uchar>(row, column) =
            cv::saturate_cast<uchar>(255.0 * (1.0 - scene.uneven * across));
      }
  }

  of = scene;
}

// Normal deviates drawn once; the noise of an image is made of pieces of
// them, as random numbers for every pixel would be slow.
struct Grain {
  cv::Mat deviates = cv::Mat(1, noise_length, CV_32F);
  double sigma = -1.0;
  cv::Mat scaled;  // by SIGMA, 16-bit

  Grain() { cv::RNG(77).fill(deviates, cv::RNG::NORMAL, 0.0, 1.0); }

  void add(cv::Mat &grey, double wanted, unsigned seed) {
    if (wanted != sigma)
      deviates.convertTo(scaled, CV_16S, wanted);
    sigma = wanted;
    std::uint64_t state = seed * 2654435761ULL + 88172645463325252ULL;
    for (int row = 0; row < grey.rows; ++row) {
      state ^= state << 13;
      state ^= state >> 7;
      state ^= state << 17;
      const int start = int(state % (noise_length - grey.cols));
      cv::Mat line = grey.row(row);
      cv::add(line, scaled.colRange(start, start + grey.cols), line,
              cv::noArray(), CV_8U);
    }
  }
};

// The 6 x 6 modules of a marker, black border included.
cv::Mat marker_bits(int id) {
  cv::Mat bits;
  const auto dictionary =
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000);
#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
  cv::aruco::generateImageMarker(dictionary, id, 6, bits, 1);
#else
  cv::aruco::drawMarker(dictionary, id, 6, bits, 1);
#endif
  return bits;
}

// Grey of the robot where it is AHEAD of its centre and LEFT of it (both in
// centimetres, inside the body).
int robot_grey(const scene_robot &robot, const cv::Mat &bits, double ahead,
               double left) {
  if (robot.marker == 0) {
    if (std::max(std::fabs(ahead), std::fabs(left)) >= quiet_half)
      return body_grey;
    const int row = int(std::floor((marker_half - ahead) / module));
    const int column = int(std::floor((marker_half - left) / module));
    if (row < 0 || row >= bits.rows || column < 0 || column >= bits.cols)
      return white_grey;
    return bits.at<uchar>(row, column) ? white_grey : black_grey;
  }
  const double from_tip = triangle_tip - ahead;
  const bool inside =
      ahead >= -triangle_foot && from_tip >= 0.0 &&
      std::fabs(left) <= triangle_half_base * from_tip / triangle_height;
  return inside ? white_grey : body_grey;
}

void draw_robot(const scene_robot &robot, const View &view, cv::Mat &grey) {
  const cv::Mat bits = robot.marker == 0 ? marker_bits(robot.id) : cv::Mat();
  const cv::Point2d centre = view.pixel(robot.x, robot.y);
  const double reach = body_radius * view.scale + 1.0;
  const int left_column = std::max(0, int(std::floor(centre.x - reach)));
  const int right_column =
      std::min(grey.cols - 1, int(std::ceil(centre.x + reach)));
  const int top_row = std::max(0, int(std::floor(centre.y - reach)));
  const int bottom_row =
      std::min(grey.rows - 1, int(std::ceil(centre.y + reach)));
  const double heading = robot.heading * CV_PI / 180.0;
  const double cosine = std::cos(heading), sine = std::sin(heading);

  for (int row = top_row; row <= bottom_row; ++row) {
    uchar *line = grey.ptr<uchar>(row);
    for (int column = left_column; column <= right_column; ++column) {
      int sum = 0;
      for (int k = 0; k < samples; ++k) {
        const cv::Point2d p = view.sample(column, row, k);
        const double dx = p.x - robot.x, dy = p.y - robot.y;
        sum += dx * dx + dy * dy <= body_radius * body_radius
                   ? robot_grey(robot, bits, dx * cosine + dy * sine,
                                dy * cosine - dx * sine)
                   : line[column];
      }
      line[column] = uchar((sum + samples / 2) / samples);
    }
  }
}

// What one thread keeps between images.
struct Studio {
  Backdrop backdrop;
  Grain grain;
  cv::Mat grey, colour;
};

Studio &studio() {
  static thread_local Studio of_this_thread;
  return of_this_thread;
}

void draw(const scene_description &scene, cv::Mat &bgr) {
  cv::setNumThreads(1);
  Studio &here = studio();
  if (!here.backdrop.fits(scene))
    here.backdrop.draw(scene);
  here.backdrop.image.copyTo(here.grey);

  const View view(scene);
  for (int n = 0; n < scene.robots; ++n)
    draw_robot(scene.robot[n], view, here.grey);
  if (!here.backdrop.light.empty())
    cv::multiply(here.grey, here.backdrop.light, here.grey, 1.0 / 255.0);
  if (scene.blur > 0.0)
    cv::GaussianBlur(here.grey, here.grey, cv::Size(), scene.blur);
  if (scene.lean_x != 0.0 || scene.lean_y != 0.0) {
    const double x = view.middle_x, y = view.middle_y;
    cv::warpPerspective(here.grey.clone(), here.grey,
                        cv::Matx33d(1, 0, x, 0, 1, y, 0, 0, 1) *
                            cv::Matx33d(1, 0, 0, 0, 1, 0, scene.lean_x,
                                        scene.lean_y, 1) *
                            cv::Matx33d(1, 0, -x, 0, 1, -y, 0, 0, 1),
                        here.grey.size(), cv::INTER_LINEAR,
                        cv::BORDER_REPLICATE);
  }
  if (scene.noise > 0.0)
    here.grain.add(here.grey, scene.noise, scene.seed);
  cv::cvtColor(here.grey, bgr, cv::COLOR_GRAY2BGR);
}

// Length, or -1. Not by OpenCV: its imgcodecs would load a hundred libraries
// at each start of an emulator.
int encode(const cv::Mat &bgr, int quality, unsigned char *buffer,
           int capacity) {
  jpeg_compress_struct object;
  jpeg_error_mgr errors;
  object.err = jpeg_std_error(&errors);
  jpeg_create_compress(&object);
  unsigned char *place = buffer;
  unsigned long length = static_cast<unsigned long>(capacity);
  jpeg_mem_dest(&object, &place, &length);
  object.image_width = JDIMENSION(bgr.cols);
  object.image_height = JDIMENSION(bgr.rows);
  object.input_components = 3;
  object.in_color_space = JCS_EXT_BGR;
  jpeg_set_defaults(&object);
  jpeg_set_quality(&object, quality, TRUE);
  jpeg_start_compress(&object, TRUE);
  while (object.next_scanline < object.image_height) {
    JSAMPROW row = const_cast<uchar *>(bgr.ptr(int(object.next_scanline)));
    jpeg_write_scanlines(&object, &row, 1);
  }
  jpeg_finish_compress(&object);
  jpeg_destroy_compress(&object);
  if (place == buffer)
    return int(length);
  std::free(place);  // libjpeg's own: the caller's is too small
  return -1;
}

}  // namespace

extern "C" {

scene_description scene_default(void) {
  scene_description scene{};
  scene.width = 640;
  scene.height = 480;
  scene.arena = 1;
  scene.fill = 0.85;
  scene.seed = 1;
  return scene;
}

int scene_draw(const scene_description *scene, unsigned char *bgr) {
  try {
    if (!valid(scene) || bgr == nullptr)
      return -1;
    cv::Mat image(scene->height, scene->width, CV_8UC3, bgr);
    draw(*scene, image);
    return 0;
  } catch (...) {
    return -1;
  }
}

int scene_robot_truth(const scene_description *scene, int n, double *cx,
                      double *cy, double *dx, double *dy) {
  if (!valid(scene) || n < 0 || n >= scene->robots || !cx || !cy || !dx || !dy)
    return -1;
  const View view(*scene);
  const scene_robot &robot = scene->robot[n];
  const double ahead = robot.marker == 0 ? marker_half : triangle_tip;
  const double heading = robot.heading * CV_PI / 180.0;
  const cv::Point2d centre = view.pixel(robot.x, robot.y);
  const cv::Point2d front = view.pixel(robot.x + ahead * std::cos(heading),
                                       robot.y + ahead * std::sin(heading));
  *cx = centre.x;
  *cy = centre.y;
  *dx = front.x;
  *dy = front.y;
  return 0;
}

int scene_arena_truth(const scene_description *scene, double corner_xy[8]) {
  if (!valid(scene) || !scene->arena || corner_xy == nullptr)
    return -1;
  const View view(*scene);
  const cv::Point2d corner[4] = {view.pixel(0.0, field_height),
                                 view.pixel(field_width, field_height),
                                 view.pixel(field_width, 0.0),
                                 view.pixel(0.0, 0.0)};
  for (int k = 0; k < 4; ++k) {
    corner_xy[2 * k] = corner[k].x;
    corner_xy[2 * k + 1] = corner[k].y;
  }
  return 0;
}

int scene_jpeg(const scene_description *scene, int quality,
               unsigned char *buffer, int capacity) {
  try {
    if (!valid(scene) || quality < 1 || quality > 100 || buffer == nullptr ||
        capacity <= 0)
      return -1;
    Studio &here = studio();
    draw(*scene, here.colour);
    return encode(here.colour, quality, buffer, capacity);
  } catch (...) {
    return -1;
  }
}

}  // extern "C"
