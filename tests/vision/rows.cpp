// SPDX-License-Identifier: GPL-3.0-or-later
/* The table of rows. */
#include "judging.hpp"


namespace {

constexpr double arena_goal = 0.98, marker_goal = 0.9, triangle_goal = 0.95;
// The share of the pictures in which an arena may be seen that is not there
constexpr double false_goal = 0.01, poster_goal = 0.1;
constexpr int arena_brief = 8, arena_full = 100;
constexpr int false_brief = 10, false_full = 100;
constexpr int marker_brief = 2, marker_full = 30;

Row false_row(const char *name, Scene (*make)(Random &),
              double goal = false_goal) {
  return {name, Row::no_arena, goal, false_brief, false_full,
          [make](Random &random, int) { return make(random); }};
}

Row marker_row(const std::string &name, const MarkerOptions &options,
               double goal = marker_goal) {
  //  Where many are missed, few scenes say little
  return {name, Row::markers, goal,
          goal < marker_goal ? 4 * marker_brief : marker_brief, marker_full,
          [options](Random &random, int) {
            return marker_scene(random, options);
          }};
}

Scene photograph(Random &random, int number) {
  return {photograph_view(number, random)};
}

const struct {
  const char *name;
  ArenaOptions options;
} arenas[] = {
    {"border 0.5 to 1 %", {.width = {960, 1920}, .border = {0.005, 0.01},
                           .contrast = {80, 150}, .defocus = 0.2}},
    {"border 1 to 2 %", {.border = {0.01, 0.02}}},
    {"border 2 to 2.5 %", {.border = {0.02, 0.025}}},
    {"border 2.5 to 5 %", {.border = {0.025, 0.05}}},
    {"border 5 to 10 %", {.border = {0.05, 0.10}}},
    {"field of grey 165 to 200", {.field = {165, 200}, .contrast = {40, 70}}},
    {"border 20 to 40 over field", {.field = {70, 190}, .contrast = {20, 40}}},
    {"barrel, k1 -0.25 to -0.1", {.k1 = {-0.25, -0.1}}},
    {"pincushion, k1 0.02 to 0.1", {.k1 = {0.02, 0.1}}},
    {"tilt 15 to 20 degrees", {.tilt = {15, 20}}},
    {"roll to 30 degrees", {.roll = {-30, 30}}},
    {"turned by 90 degrees", {.turned = true}},
    {"field 35 to 50 % of the image", {.fill = {0.35, 0.5}, .things = 5}},
    {"field 80 to 95 % of the image", {.fill = {0.8, 0.95}}},
    {"320 to 480 pixels wide", {.width = {320, 480}}},
    {"1280 to 1920 pixels wide", {.width = {1280, 1920}}},
    {"floor brighter than the field",
     {.field = {50, 110}, .contrast = {110, 150}, .floor = {120, 200}}},
    {"things over a side", {.robots = 4, .over_side = 2}},
    {"uneven light", {.uneven = 0.35, .shades = 2, .lamp = 0.5}},
    {"in part in the sun",
     {.field = {60, 110}, .contrast = {70, 130}, .sun = {1.5, 6}}},
    {"another frame in view", {.fill = {0.4, 0.75}, .second_frame = true}},
    {"on photographs", {.things = 4, .photographs = 1}},
    {"a laboratory's mixture",
     {.width = {480, 1920}, .border = {0.01, 0.08}, .field = {50, 190},
      .contrast = {30, 130}, .floor = {25, 200}, .k1 = {-0.2, 0.02},
      .tilt = {0, 18}, .roll = {-20, 20}, .fill = {0.4, 0.95}, .things = 6,
      .robots = 4, .over_side = 1, .uneven = 0.25, .shades = 1, .lamp = 0.3,
      .noise = 1.5, .defocus = 0.8, .photographs = 0.15}}};

const cv::Size half_hd(1280, 720);

const struct {
  const char *name;
  MarkerOptions options;
  double goal = marker_goal;
} markers[] = {
    {"white margin of 1 module", {.margin = {1, 1}, .ground = {15, 60}}},
    {"white margin of 1/2 module", {.margin = {0.5, 0.5}, .ground = {15, 60}}},
    {"white margin of 1/4 module",
     {.side = {28, 56}, .margin = {0.25, 0.25}, .ground = {15, 60}}},
    {"14 to 20 px, margin of 1/4",
     {.image = half_hd, .side = {14, 20}, .count = 20, .margin = {0.25, 0.3},
      .ground = {40, 110}, .defocus = {0, 0.05}, .on_robots = 0}},
    {"dark ground, margin of 0 to 1/8",
     {.image = half_hd, .side = {16, 56}, .count = 20, .margin = {0, 0.125},
      .ground = {40, 60}, .defocus = {0, 0.05}, .on_robots = 0}, 0.7},
    {"14 to 20 px, steep, margin of 0 to 1",
     {.image = half_hd, .side = {14, 20}, .count = 20, .margin = {0, 1},
      .ground = {100, 225}, .tilt = {0, 45}, .defocus = {0, 0.05},
      .noise = 0.5, .on_robots = 0}},
    {"contrast of 20 to 35",
     {.contrast = {20, 35}, .ground = {30, 150}, .noise = 0.6}},
    {"glare", {.glare = true}},
    {"blot over a corner", {.blot = 1}},
    {"blot over a side", {.blot = 2}},
    {"motion blur", {.shake = {0.5, 1.1}}},
    {"out of focus", {.defocus = {0.3, 0.65}}},
    {"noise", {.noise = 6}},
    {"close and steep", {.image = half_hd, .side = {90, 140}, .count = 6,
                         .tilt = {30, 45}}},
    {"large, strongly tilted", {.image = half_hd, .side = {140, 260},
                                .count = 3, .tilt = {40, 55}}},
    {"at the image's rim", {.rim = true, .on_robots = 0}},
    {"twenty", {.side = {16, 32}, .count = 20, .on_robots = 0.3}},
    {"fifty at 1280 x 720", {.image = half_hd, .side = {16, 30}, .count = 51,
                             .on_robots = 0.2, .things = 6}}};

const struct {
  const char *name;
  TriangleOptions options;
} triangles[] = {
    {"triangles", {}},
    {"triangles, sheets", {.sheets = 4}},
    {"triangles, shapes", {.shapes = 6}},
    {"triangles, all of it", {.count = 6, .sheets = 3, .shapes = 5}}};

void add_arena_rows(std::vector<Row> &rows) {
  for (const auto &[name, options] : arenas)
    if (options.photographs < 1 || photograph_count() > 0)
      rows.push_back({name, Row::arena, arena_goal, arena_brief, arena_full,
                      [&options = options](Random &random, int) {
                        return arena_scene(random, options);
                      }});
  rows.push_back(false_row("no arena: sheets", sheet_scene));
  rows.push_back(false_row("no arena: chess boards", chess_scene));
  rows.push_back(false_row("no arena: posters, windows", poster_scene,
                           poster_goal));
  rows.push_back(false_row("no arena: desks", desk_scene));
  rows.push_back(false_row("no arena: floors", empty_scene));
  rows.push_back(false_row("no arena: marker boards", code_board_scene));
  if (photograph_count() > 0)
    rows.push_back({"no arena: photographs", Row::no_arena, false_goal,
                    photograph_count(), 10 * photograph_count(), photograph});
}

//  By their size
void add_size_rows(std::vector<Row> &rows) {
  const int bands[] = {10, 12, 16, 20, 24, 32, 64, 140};
  for (const cv::Size &size : {cv::Size(640, 480), half_hd,
                               cv::Size(1920, 1080)})
    for (int band = 0; band < 7; ++band) {
      const double low = bands[band], high = bands[band + 1];
      MarkerOptions o;
      o.image = size;
      o.side = {low, high};
      o.count = low < 64 ? 12 : size.width < 1000 ? 4 : 8;
      o.tilt = {0, low < 24 ? 5.0 : 10.0};
      o.noise = low < 16 ? 0.5 : 1;
      if (low < 20)
        o.defocus = {0, 0.05};
      //  Modules of two pixels behind a colour mosaic are hardly plain to
      //  see; of the smallest no more is asked than OpenCV's rate
      rows.push_back(marker_row(
          std::to_string(bands[band]) + " to " +
              std::to_string(bands[band + 1]) + " px at " +
              std::to_string(size.width) + " x " + std::to_string(size.height),
          o, low < 12 ? 0 : low < 16 ? 0.75 : marker_goal));
      if (size.width > 1900)
        rows.back().brief = 1;
    }
}

Scene competition_scene(Random &random, int) {
  const cv::Size images[] = {{640, 480}, {1280, 720}, {1280, 960}};
  MarkerOptions options{
      .count = 9, .margin = {0.25, 1}, .contrast = {60, 180},
      .ground = {20, 180}, .tilt = {0, 35}, .uneven = 0.3, .shake = {0, 0.4},
      .defocus = {0, 0.3}, .noise = 1.5, .on_robots = 0.8, .things = 8,
      .competition = true};
  options.image = images[random.pick(3)];
  options.side = options.image.width > 1000 ? Range{20, 60} : Range{18, 40};
  return marker_scene(random, options);
}

void add_marker_rows(std::vector<Row> &rows) {
  add_size_rows(rows);
  for (const auto &[name, options, goal] : markers)
    rows.push_back(marker_row(name, options, goal));
  rows.push_back({"a competition's mixture", Row::markers, marker_goal,
                  marker_brief, marker_full, competition_scene});
  rows.push_back({"no markers", Row::markers, 0, 6, 100,
                  [](Random &random, int) {
                    return markerless_scene(random);
                  }});
  if (photograph_count() > 0)
    rows.push_back({"no markers: photographs", Row::markers, 0,
                    photograph_count() / 2, 5 * photograph_count(),
                    photograph});
  for (const auto &[name, options] : triangles)
    rows.push_back({name, Row::triangles, triangle_goal, 4, 60,
                    [&options = options](Random &random, int) {
                      return triangle_scene(random, options);
                    }});
}

}  // namespace

std::vector<Row> all_rows() {
  std::vector<Row> rows;
  add_arena_rows(rows);
  add_marker_rows(rows);
  return rows;
}
