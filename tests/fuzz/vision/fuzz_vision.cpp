// SPDX-License-Identifier: GPL-3.0-or-later
// bin/destijl_fuzz_vision: the fuzz targets of vision_c. What a call gives
// back is checked against what vision.h says; anything else ends the process
// with abort.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#include <opencv2/imgcodecs.hpp>

#include "fuzz_engine.h"
#include "scene.h"
#include "slots.h"
#include "vision_internal.hpp"

namespace {

// An input of the fuzzer, read from its beginning: the bytes decide what a
// target does. Behind the end there are zeros.
class Input {
public:
  Input(const unsigned char *data, std::size_t size)
      : next(data), end(data + size) {}

  bool empty() const { return next == end; }
  std::size_t remaining() const { return std::size_t(end - next); }
  const unsigned char *rest() const { return next; }

  unsigned byte() { return empty() ? 0u : *next++; }

  unsigned word() {
    const unsigned high = byte();
    return high << 8 | byte();
  }

  // A number of FIRST .. LAST; 65536 of them at most can come.
  int number(int first, int last) {
    return int(first + std::int64_t(word()) %
                           (std::int64_t(last) - first + 1));
  }

  // The same in steps of a 65535th of the range.
  double share(double first, double last) {
    return first + (last - first) * word() / 65535.0;
  }

  double coordinate();

  vision_point point() {
    const double x = coordinate();
    return {x, coordinate()};
  }

  // Inside an image of that size.
  cv::Rect rectangle(int width, int height) {
    const int left = number(0, width - 1), top = number(0, height - 1);
    const int right = number(left, width - 1);
    return {left, top, right - left + 1, number(top, height - 1) - top + 1};
  }

private:
  const unsigned char *next, *const end;
};

double Input::coordinate() {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  static const double notable[] = {
      0.0,    -0.0,    0.5,  -0.5,  1.0,  -1.0,  1e6,      -1e6, 1000001.0,
      -1e6 - 1e-9, 1e-300, 1e9, -1e9, 2147483647.0, 2147483648.0, 1e300,
      -1e300, infinite, -infinite, std::nan("")};
  const unsigned choice = byte();
  if (choice < sizeof notable / sizeof notable[0])
    return notable[choice];
  if (choice < 0x40)
    return share(-1e6, 1e6);
  return share(-64.0, 512.0);
}

void expect(bool condition, const char *otherwise) {
  if (condition)
    return;
  std::fprintf(stderr, "vision_c: %s (%s)\n", otherwise, vision_reason());
  std::abort();
}

// Every call gives one of the documented results, and says why.
void check(vision_status status) {
  expect(status >= VISION_OK && status <= VISION_FAILED, "unknown status");
  const char *const reason = vision_reason();
  expect(reason != nullptr && std::strlen(reason) < 160, "reason too long");
  for (const char *next = reason; *next != '\0'; ++next)
    expect(static_cast<unsigned char>(*next) >= ' ', "reason of two lines");
}

// OpenCV failing inside is documented, but nothing here should make it.
void check_no_failure(vision_status status) {
  check(status);
  expect(status != VISION_FAILED, "OpenCV failed");
}

// As at the start of the program: one input must not depend on another.
void forget_all() {
  vision_close();
  for (int slot = 0; slot < VISION_SLOTS; ++slot)
    *vision::frame(slot) = vision::Frame();
}

bool holds(int slot) {
  const vision::Frame *const frame = vision::frame(slot);
  return frame != nullptr && frame->content != vision::Frame::Content::nothing;
}

bool fits(int slot, int width, int height) {
  const cv::Size size = vision::frame(slot)->size();
  return size.width >= 1 && size.width <= width && size.height >= 1 &&
         size.height <= height;
}

void check_robot(const vision_robot &robot, vision_marker marker) {
  expect(robot.id >= 0 && robot.id <= 999, "identifier out of its range");
  expect(marker == VISION_MARKER_ARUCO || robot.id == 0, "triangle's number");
  expect(vision::sound(robot.centre) && vision::sound(robot.direction),
         "robot at no place");
  expect(robot.angle > -180.0 && robot.angle <= 180.0, "angle out of range");
}

// NUMBER areas, or none where that is 0.
std::vector<vision_robot> find_robots(int slot, vision_marker marker,
                                      const vision_arena *arena, int capacity,
                                      const vision_area *areas = nullptr,
                                      int number = 0) {
  // of exactly that size: one robot more, and the sanitizer sees it
  const std::unique_ptr<vision_robot[]> place(
      new vision_robot[std::size_t(std::max(capacity, 0))]);
  int count = -1;
  const vision_status status = vision_find_robots(
      slot, marker, arena, place.get(), capacity, &count, areas, number);
  check_no_failure(status);
  expect(status == VISION_OK ? count >= 1 && count <= capacity : count == 0,
         "wrong count of robots");
  for (int n = 0; n < count; ++n) {
    check_robot(place[std::size_t(n)], marker);
    expect(number != 0 || n == 0 ||
               place[std::size_t(n - 1)].id <= place[std::size_t(n)].id,
           "robots out of order");
  }
  return {place.get(), place.get() + count};
}

// Areas anywhere.
void follow_robots(Input &input, int slot, vision_marker marker) {
  const int number = input.number(-1, 5);
  const std::unique_ptr<vision_area[]> areas(
      new vision_area[std::size_t(std::max(number, 0))]);
  for (int k = 0; k < number; ++k)
    areas[std::size_t(k)] = {input.point(), input.coordinate()};
  find_robots(slot, marker, nullptr, input.number(-1, 5),
              number < 0 ? nullptr : areas.get(), number);
}

void encode(int slot, int quality, int capacity, bool may_fail = false) {
  const std::unique_ptr<unsigned char[]> buffer(
      new unsigned char[std::size_t(std::max(capacity, 0))]);
  int length = -1;
  const vision_status status =
      vision_encode(slot, quality, buffer.get(), capacity, &length);
  check(status);
  expect(may_fail || status != VISION_FAILED, "OpenCV failed");
  if (status != VISION_OK) {
    expect(length == 0, "a length without a JPEG");
    return;
  }
  expect(quality >= 1 && quality <= 100, "a quality that there is not");
  expect(length > 3 && length <= capacity && buffer[0] == 0xFF &&
             buffer[1] == 0xD8 && buffer[std::size_t(length) - 2] == 0xFF &&
             buffer[std::size_t(length) - 1] == 0xD9,
         "not a JPEG");
}

// A JPEG as a camera delivers it: refused, or a size that fits; decoded or
// not, and what goes out is a JPEG.
void take_jpeg(Input &input, int slot, int width, int height) {
  const std::size_t length = input.remaining();
  const std::unique_ptr<unsigned char[]> bytes(new unsigned char[length]);
  std::copy_n(input.rest(), length, bytes.get());
  const vision_status status =
      slot_load_jpeg(slot, bytes.get(), int(length), width, height);
  check_no_failure(status);
  if (status != VISION_OK)
    return;
  expect(fits(slot, width, height), "the JPEG does not fit");
  // a head may promise what nobody wants to wait for
  const vision::Jpeg_Facts &facts = vision::frame(slot)->facts;
  constexpr int most = 1 << 20;
  expect(facts.whole <= length, "more of a JPEG than there is");
  if (facts.width * facts.height > most)
    return;
  encode(slot, 80, most, true);
  vision_arena arena;
  check(vision_find_arena(slot, &arena));
}

bool find_arena(int slot, vision_arena &arena) {
  const vision_status status = vision_find_arena(slot, &arena);
  check_no_failure(status);
  if (status == VISION_OK)
    expect(vision::sound(arena), "arena at no place");
  return status == VISION_OK;
}

void draw_robot(int slot, const vision_robot &robot) {
  check_no_failure(vision_draw_robot(slot, &robot));
}

void draw_arena(int slot, const vision_arena &arena) {
  const vision_status status = vision_draw_arena(slot, &arena);
  check_no_failure(status);
  expect(status == (holds(slot) && vision::sound(arena) ? VISION_OK
                                                        : VISION_BAD_ARGUMENT),
         "arena drawn, or not, against the rule");
}

// ------------------------------------------------------------------- Calls

// Sizes up to the limit; that on pixels is ours, for speed.
void choose_size(Input &input, int &width, int &height) {
  static const int notable[] = {VISION_MAX_SIDE, 1, 15, 16, 17, 4096};
  constexpr int count = sizeof notable / sizeof notable[0];
  constexpr int pixels = 64 * 1024;
  const auto side = [&] {
    const int choice = int(input.byte());
    return choice < count ? notable[choice] : choice;
  };
  width = side();
  height = std::min(side(), std::max(1, pixels / width));
}

void load(Input &input, int slot) {
  int width, height;
  choose_size(input, width, height);
  const std::size_t bytes = std::size_t(width) * height * 3;
  const std::unique_ptr<unsigned char[]> bgr(new unsigned char[bytes]);

  const unsigned kind = input.byte() % 4;
  if (kind == 0) {  // the input's own bytes, again and again
    const std::size_t length =
        std::max<std::size_t>(1, std::min<std::size_t>(input.word(),
                                                       input.remaining()));
    std::vector<unsigned char> tile(length);
    for (unsigned char &value : tile)
      value = static_cast<unsigned char>(input.byte());
    for (std::size_t k = 0; k < bytes; ++k)
      bgr[k] = tile[k % length];
  } else if (kind == 1) {  // noise
    unsigned state = input.word();
    for (std::size_t k = 0; k < bytes; ++k) {
      state = state * 1664525u + 1013904223u;
      bgr[k] = static_cast<unsigned char>(state >> 24);
    }
  } else {  // flat or a ramp, and rectangles on it
    const unsigned grey = input.byte();
    const unsigned slope = kind == 3 ? input.byte() : 0;
    for (std::size_t k = 0; k < bytes; ++k)
      bgr[k] = static_cast<unsigned char>(
          grey + slope * (k / 3 % std::size_t(width)) / 64);
    for (unsigned count = input.byte() % 16; count > 0; --count) {
      const cv::Rect where = input.rectangle(width, height);
      cv::Mat(height, width, CV_8UC3, bgr.get())(where) =
          cv::Scalar::all(input.byte());
    }
  }

  if (vision::frame(slot) != nullptr)
    slot_load(slot, bgr.get(), width, height);
}

// A name of no source: neither camera, nor device, nor URL, nor pipeline.
void open_nothing(Input &input) {
  std::string name(input.byte(), '\0');
  for (char &c : name) {
    c = char(input.byte());
    if (std::strchr("/!:", c) != nullptr || (c >= '0' && c <= '9'))
      c = '~';
  }
  const int width = input.number(-1, 10000);
  const int height = input.number(-1, 10000);
  const int fps = input.number(-1, 200);
  const vision_status status =
      vision_open(input.byte() == 1 ? nullptr : name.c_str(), width, height,
                  fps);
  check_no_failure(status);
  expect(status == VISION_NO_CAMERA || status == VISION_BAD_ARGUMENT,
         "a source that there is not is open");
}

void call(Input &input) {
  const unsigned choice = input.byte();
  // most often the same one, so that there is something in it
  const unsigned place = input.byte();
  const int slot =
      place < 64 ? int(place % (VISION_SLOTS + 2)) - 1 : VISION_SLOTS - 1;
  vision_arena arena;

  switch (choice % 11) {
  case 0:
  case 1:
    load(input, slot);
    break;
  case 2:
    find_arena(slot, arena);
    check_no_failure(vision_find_arena(slot, nullptr));
    break;
  case 3:
  case 4: {
    const bool bounded = input.byte() % 2 == 1;
    if (bounded && (input.byte() % 2 == 1 || !find_arena(slot, arena)))
      for (vision_point &corner : arena.corner)
        corner = input.point();
    const vision_marker marker =
        choice % 11 == 3 ? VISION_MARKER_ARUCO : VISION_MARKER_TRIANGLE;
    for (const vision_robot &robot :
         find_robots(slot, marker, bounded ? &arena : nullptr,
                     input.number(-1, 6)))
      draw_robot(slot, robot);
    break;
  }
  case 5:
    for (vision_point &corner : arena.corner)
      corner = input.point();
    draw_arena(slot, arena);
    check_no_failure(vision_draw_arena(slot, nullptr));
    break;
  case 6: {
    vision_robot robot;
    robot.id = int(input.word() << 16 | input.word());
    robot.centre = input.point();
    robot.direction = input.point();
    robot.angle = input.coordinate();
    draw_robot(slot, robot);
    check_no_failure(vision_draw_robot(slot, nullptr));
    break;
  }
  case 7: {
    const int quality = input.number(-2, 103);
    encode(slot, quality, input.byte() % 2 == 1 ? 1 << 20
                                                : input.number(-1, 4000));
    break;
  }
  case 8:
    open_nothing(input);
    check_no_failure(vision_grab(slot));
    break;
  case 9:
    follow_robots(input, slot,
                  input.byte() % 2 == 1 ? VISION_MARKER_TRIANGLE
                                        : VISION_MARKER_ARUCO);
    break;
  default: {
    int count = -1;
    vision_robot robot;
    unsigned char byte = 0;
    check(vision_find_robots(slot, VISION_MARKER_ARUCO, nullptr, nullptr, 1,
                             &count, nullptr, 0));
    check(vision_find_robots(slot, VISION_MARKER_ARUCO, nullptr, &robot, 1,
                             nullptr, nullptr, 0));
    check(vision_encode(slot, 80, nullptr, 1, &count));
    check(vision_encode(slot, 80, &byte, 1, nullptr));
    check(vision_close());
  }
  }
}

// Any calls in any order: small images of any pixels, and arguments that
// vision.h does not allow.
void calls(const unsigned char *data, std::size_t size) {
  constexpr int most = 12;
  static const unsigned char flat[48 * 32 * 3] = {};
  Input input(data, size);
  forget_all();
  slot_load(VISION_SLOTS - 1, flat, 48, 32);
  for (int count = 0; count < most && !input.empty(); ++count)
    call(input);
}

// ------------------------------------------------------------------ Scenes

// What the supervisor does with each image.
void work(Input &input, int slot) {
  vision_arena arena;
  const unsigned choice = input.byte();
  const vision_marker marker =
      choice & 1 ? VISION_MARKER_TRIANGLE : VISION_MARKER_ARUCO;
  const bool bounded = find_arena(slot, arena) && (choice & 2);
  const std::vector<vision_robot> robots =
      find_robots(slot, marker, bounded ? &arena : nullptr, 4);
  // Searched again where they are, nothing having changed, they are there.
  std::vector<vision_area> areas;
  for (const vision_robot &robot : robots)
    areas.push_back({robot.centre, 64.0});
  std::vector<vision_robot> again(4);
  int count = 0;
  if (!areas.empty())
    expect(vision_find_robots(slot, marker, bounded ? &arena : nullptr,
                              again.data(), 4, &count, areas.data(),
                              int(areas.size())) <= VISION_NOT_FOUND,
           "robots cannot be followed");
  if (bounded)
    draw_arena(slot, arena);
  for (const vision_robot &robot : robots)
    draw_robot(slot, robot);
  encode(slot, input.number(1, 100), 1 << 20);
}

// An arena with robots as the camera shows it, spoilt in places; then what
// the supervisor does with an image.
void scenes(const unsigned char *data, std::size_t size) {
  static const int sizes[][2] = {{64, 48},   {80, 60},   {96, 72},
                                 {160, 120}, {320, 240}, {33, 97},
                                 {240, 60},  {128, 128}};
  constexpr unsigned most_patches = 32;
  Input input(data, size);
  forget_all();

  scene_description scene = scene_default();
  const int *const chosen = sizes[input.byte() % 8];
  scene.width = chosen[0];
  scene.height = chosen[1];
  scene.arena = input.byte() % 8 != 7;
  scene.fill = input.share(0.3, 0.95);
  scene.turn = input.share(-30.0, 30.0);
  scene.noise = input.share(0.0, 30.0);
  scene.blur = input.share(0.0, 3.0);
  scene.uneven = input.share(0.0, 0.7);
  scene.seed = input.word();
  scene.robots = int(input.byte() % 5);
  for (int n = 0; n < scene.robots; ++n) {
    scene_robot &robot = scene.robot[n];
    robot.marker = int(input.byte() % 2);
    robot.id = input.number(0, 999);
    robot.x = input.share(0.0, 80.0);
    robot.y = input.share(0.0, 60.0);
    robot.heading = input.share(-360.0, 360.0);
  }
  std::vector<unsigned char> bgr(std::size_t(scene.width) * scene.height * 3);
  if (scene_draw(&scene, bgr.data()) != 0)
    return;

  const unsigned first_choice = input.byte();
  for (unsigned count = input.byte() % most_patches; count > 0; --count) {
    const cv::Rect where = input.rectangle(scene.width, scene.height);
    const unsigned value = input.byte(), way = input.byte() % 3;
    for (int y = where.y; y < where.br().y; ++y)
      for (int k = where.x * 3; k < where.br().x * 3; ++k) {
        unsigned char &here = bgr[std::size_t(y) * scene.width * 3 + k];
        here = static_cast<unsigned char>(way == 0   ? value
                                          : way == 1 ? here ^ value
                                                     : here + value);
      }
  }

  const int slot = int(first_choice % VISION_SLOTS);
  slot_load(slot, bgr.data(), scene.width, scene.height);
  work(input, slot);
}

// ------------------------------------------------------------------- Files

// The bytes of a still image in a file: JPEG, PNG or what else OpenCV reads.
void files(const unsigned char *data, std::size_t size) {
  Input input(data, size);
  forget_all();
  const int width = input.number(1, 400);
  const int height = input.number(1, 400);
  const unsigned slot = input.byte() % VISION_SLOTS;
  const int quality = input.number(1, 100);

  Input jpeg = input;
  take_jpeg(jpeg, int(slot), width, height);

  const int file = memfd_create("image", 0);
  expect(file >= 0, "no place for a file");
  const char *const name = "/proc/self/fd/";
  const std::string path = name + std::to_string(file);
  const std::size_t length = input.remaining();
  expect(write(file, input.rest(), length) == ssize_t(length),
         "no place for the bytes of a file");

  // What is no image would go to FFmpeg as a video; its parsers are long
  // under a fuzzer of their own.
  if (cv::haveImageReader(path)) {
    const vision_status status =
        vision_open(path.c_str(), width, height, 25);
    check_no_failure(status);
    if (status == VISION_OK) {
      check_no_failure(vision_grab(int(slot)));
      expect(fits(int(slot), width, height), "the image does not fit");
      vision_arena arena;
      find_arena(int(slot), arena);
      encode(int(slot), quality, 1 << 20);
    }
  }
  vision_close();
  close(file);
}

constexpr const char *names[] = {"calls", "scenes", "files", nullptr};
constexpr void (*targets[])(const unsigned char *, std::size_t) = {
    calls, scenes, files};

void give(int target, const unsigned char *data, std::size_t size) {
  targets[target](data, size);
}

}  // namespace

int main(int count, char **arguments) {
  // No image of gigabytes: its memory would be the finding.
  setenv("OPENCV_IO_MAX_IMAGE_PIXELS", "1048576", 1);
  return fuzz_main(count, arguments, names, give);
}
