// SPDX-License-Identifier: GPL-3.0-or-later
/* The table of rows. */
#include "rows.hpp"

#include "photographs.hpp"

namespace {

constexpr double arena_goal = 0.98, marker_goal = 0.9, triangle_goal = 0.95;
// The share of the pictures in which an arena may be seen that is not there
constexpr double false_goal = 0.01, poster_goal = 0.1;
constexpr int arena_brief = 8, arena_full = 100;
constexpr int false_brief = 10, false_full = 100;
constexpr int marker_brief = 2, marker_full = 30;

template <typename Change>
Row arena_row(const char *name, Change change) {
  return {name, Row::arena, arena_goal, arena_brief, arena_full,
          [change](Random &random, int) {
            ArenaOptions options;
            change(options);
            return arena_scene(random, options);
          }};
}

Row false_row(const char *name, Scene (*make)(Random &),
              double goal = false_goal) {
  return {name, Row::no_arena, goal, false_brief, false_full,
          [make](Random &random, int) { return make(random); }};
}

template <typename Change>
Row marker_row(const std::string &name, Change change,
               double goal = marker_goal) {
  return {name, Row::markers, goal, marker_brief, marker_full,
          [change](Random &random, int) {
            MarkerOptions options;
            change(options, random);
            return marker_scene(random, options);
          }};
}

template <typename Change>
Row triangle_row(const char *name, Change change) {
  return {name, Row::triangles, triangle_goal, 4, 60,
          [change](Random &random, int) {
            TriangleOptions options;
            change(options);
            return triangle_scene(random, options);
          }};
}

Scene photograph(Random &random, int number) {
  Scene scene;
  scene.image = photograph_view(number, random);
  return scene;
}

using A = ArenaOptions;
using M = MarkerOptions;
using T = TriangleOptions;

void add_arena_rows(std::vector<Row> &rows) {
  const auto arena = [&](const char *name, auto change) {
    rows.push_back(arena_row(name, change));
  };
  arena("border 0.5 to 1 %", [](A &o) {
    o.border = {0.005, 0.01};
    o.width = {960, 1920};
    o.defocus = 0.2;
    o.contrast = {80, 150};
  });
  arena("border 1 to 2 %", [](A &o) { o.border = {0.01, 0.02}; });
  arena("border 2 to 2.5 %", [](A &o) { o.border = {0.02, 0.025}; });
  arena("border 2.5 to 5 %", [](A &o) { o.border = {0.025, 0.05}; });
  arena("border 5 to 10 %", [](A &o) { o.border = {0.05, 0.10}; });
  arena("field of grey 165 to 200", [](A &o) {
    o.field = {165, 200};
    o.contrast = {40, 70};
  });
  arena("border 20 to 40 over field", [](A &o) {
    o.contrast = {20, 40};
    o.field = {70, 190};
  });
  arena("barrel, k1 -0.25 to -0.1", [](A &o) {
    o.k1 = {-0.25, -0.1};
    o.division = 0.2;
  });
  arena("pincushion, k1 0.02 to 0.1", [](A &o) { o.k1 = {0.02, 0.1}; });
  arena("tilt 15 to 20 degrees", [](A &o) { o.tilt = {15, 20}; });
  arena("roll to 30 degrees", [](A &o) { o.roll = {-30, 30}; });
  arena("turned by 90 degrees", [](A &o) { o.turned = true; });
  arena("field 35 to 50 % of the image", [](A &o) {
    o.fill = {0.35, 0.5};
    o.things = 5;
  });
  arena("field 80 to 95 % of the image", [](A &o) { o.fill = {0.8, 0.95}; });
  arena("320 to 480 pixels wide", [](A &o) { o.width = {320, 480}; });
  arena("1280 to 1920 pixels wide", [](A &o) { o.width = {1280, 1920}; });
  arena("floor brighter than the field", [](A &o) {
    o.field = {50, 110};
    o.contrast = {110, 150};
    o.floor = {120, 200};
  });
  arena("things over a side", [](A &o) {
    o.over_side = 2;
    o.robots = 4;
  });
  arena("uneven light", [](A &o) {
    o.uneven = 0.35;
    o.shades = 2;
    o.lamp = 0.5;
  });
  arena("in part in the sun", [](A &o) {
    o.field = {60, 110};
    o.contrast = {70, 130};
    o.sun = {1.5, 6};
  });
  arena("another frame in view", [](A &o) {
    o.second_frame = true;
    o.fill = {0.4, 0.75};
  });
  if (photograph_count() > 0)
    arena("on photographs", [](A &o) {
      o.photographs = 1;
      o.things = 4;
    });
  arena("a laboratory's mixture", [](A &o) {
    o.width = {480, 1920};
    o.border = {0.01, 0.08};
    o.field = {50, 190};
    o.contrast = {30, 130};
    o.floor = {25, 200};
    o.k1 = {-0.2, 0.02};
    o.tilt = {0, 18};
    o.roll = {-20, 20};
    o.fill = {0.4, 0.95};
    o.things = 6;
    o.robots = 4;
    o.over_side = 1;
    o.uneven = 0.25;
    o.shades = 1;
    o.lamp = 0.3;
    o.noise = 1.5;
    o.defocus = 0.8;
    o.photographs = 0.15;
  });
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

void add_marker_rows(std::vector<Row> &rows) {
  const auto marker = [&](const char *name, auto change,
                          double goal = marker_goal) {
    rows.push_back(marker_row(name, change, goal));
  };
  const auto triangle = [&](const char *name, auto change) {
    rows.push_back(triangle_row(name, change));
  };
  struct Size {
    const char *name;
    cv::Size image;
  };
  const Size sizes[] = {{" at 640 x 480", {640, 480}},
                        {" at 1280 x 720", {1280, 720}},
                        {" at 1920 x 1080", {1920, 1080}}};
  const int bands[] = {10, 12, 16, 20, 24, 32, 64, 140};
  for (const Size &size : sizes)
    for (int band = 0; band < 7; ++band) {
      const double low = bands[band], high = bands[band + 1];
      const std::string name = std::to_string(bands[band]) + " to " +
                               std::to_string(bands[band + 1]) + " px" +
                               size.name;
      //  Modules of two pixels behind a colour mosaic are hardly plain to
      //  see; of the smallest no more is asked than OpenCV's rate
      Row row = marker_row(
          name,
          [=](M &o, Random &) {
            o.image = size.image;
            o.side = {low, high};
            o.count = low < 64 ? 12 : size.image.width < 1000 ? 4 : 8;
            o.tilt = {0, low < 24 ? 5.0 : 10.0};
            o.noise = low < 16 ? 0.5 : 1;
            if (low < 20)
              o.defocus = {0, 0.05};
          },
          low < 12 ? 0 : low < 16 ? 0.75 : marker_goal);
      if (size.image.width > 1900)
        row.brief = 1;
      rows.push_back(row);
    }
  marker("white margin of 1 module", [](M &o, Random &) {
    o.margin = {1, 1};
    o.ground = {15, 60};
  });
  marker("white margin of 1/2 module", [](M &o, Random &) {
    o.margin = {0.5, 0.5};
    o.ground = {15, 60};
  });
  marker("white margin of 1/4 module", [](M &o, Random &) {
    o.margin = {0.25, 0.25};
    o.ground = {15, 60};
    o.side = {28, 56};
  });
  marker("14 to 20 px, margin of 1/4", [](M &o, Random &) {
    o.image = {1280, 720};
    o.side = {14, 20};
    o.margin = {0.25, 0.3};
    o.ground = {40, 110};
    o.defocus = {0, 0.05};
    o.on_robots = 0;
    o.count = 20;
  });
  marker("dark ground, margin of 0 to 1/8", [](M &o, Random &) {
    o.image = {1280, 720};
    o.side = {16, 56};
    o.margin = {0, 0.125};
    o.ground = {40, 60};
    o.defocus = {0, 0.05};
    o.on_robots = 0;
    o.count = 20;
  }, 0.7);
  marker("14 to 20 px, steep, margin of 0 to 1", [](M &o, Random &) {
    o.image = {1280, 720};
    o.side = {14, 20};
    o.margin = {0, 1};
    o.ground = {100, 225};
    o.tilt = {0, 45};
    o.defocus = {0, 0.05};
    o.noise = 0.5;
    o.on_robots = 0;
    o.count = 20;
  });
  marker("contrast of 20 to 35", [](M &o, Random &) {
    o.contrast = {20, 35};
    o.noise = 0.6;
    o.ground = {30, 150};
  });
  marker("glare", [](M &o, Random &) { o.glare = true; });
  marker("blot over a corner", [](M &o, Random &) { o.blot = 1; });
  marker("blot over a side", [](M &o, Random &) { o.blot = 2; });
  marker("motion blur", [](M &o, Random &) { o.shake = {0.5, 1.1}; });
  marker("out of focus", [](M &o, Random &) { o.defocus = {0.3, 0.65}; });
  marker("noise", [](M &o, Random &) { o.noise = 6; });
  marker("close and steep", [](M &o, Random &) {
    o.image = {1280, 720};
    o.side = {90, 140};
    o.tilt = {30, 45};
    o.count = 6;
  });
  marker("large, strongly tilted", [](M &o, Random &) {
    o.image = {1280, 720};
    o.side = {140, 260};
    o.tilt = {40, 55};
    o.count = 3;
  });
  marker("at the image's rim", [](M &o, Random &) {
    o.rim = true;
    o.on_robots = 0;
  });
  marker("twenty", [](M &o, Random &) {
    o.side = {16, 32};
    o.count = 20;
    o.on_robots = 0.3;
  });
  marker("fifty at 1280 x 720", [](M &o, Random &) {
    o.image = {1280, 720};
    o.side = {16, 30};
    o.count = 51;
    o.on_robots = 0.2;
    o.things = 6;
  });
  marker("a competition's mixture", [](M &o, Random &r) {
    const cv::Size images[] = {{640, 480}, {1280, 720}, {1280, 960}};
    o.image = images[r.pick(3)];
    o.competition = true;
    o.side = o.image.width > 1000 ? Range{20, 60} : Range{18, 40};
    o.count = 9;
    o.margin = {0.25, 1};
    o.contrast = {60, 180};
    o.ground = {20, 180};
    o.tilt = {0, 35};
    o.uneven = 0.3;
    o.shake = {0, 0.4};
    o.defocus = {0, 0.3};
    o.noise = 1.5;
    o.on_robots = 0.8;
    o.things = 8;
  });
  rows.push_back({"no markers", Row::markers, 0, 6, 100,
                  [](Random &random, int) {
                    return markerless_scene(random);
                  }});
  if (photograph_count() > 0)
    rows.push_back({"no markers: photographs", Row::markers, 0,
                    photograph_count() / 2, 5 * photograph_count(),
                    photograph});
  triangle("triangles", [](T &) {});
  triangle("triangles, sheets", [](T &o) { o.sheets = 4; });
  triangle("triangles, shapes", [](T &o) { o.shapes = 6; });
  triangle("triangles, all of it", [](T &o) {
    o.count = 6;
    o.sheets = 3;
    o.shapes = 5;
  });
}

}  // namespace

std::vector<Row> all_rows() {
  std::vector<Row> rows;
  add_arena_rows(rows);
  add_marker_rows(rows);
  return rows;
}
