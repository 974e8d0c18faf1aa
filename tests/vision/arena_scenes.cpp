// SPDX-License-Identifier: GPL-3.0-or-later
/* Scenes with an arena, and those without that might be taken for one. */
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace {

constexpr double half_width = 40, half_height = 30;  //  of the field

cv::Size pick_size(Random &random, const Range &range) {
  const int width = int(range.of(random)) / 2 * 2;
  const int height = random.chance(0.5) ? width * 3 / 4 : width * 9 / 16;
  return {width, height / 2 * 2};
}

//  Box of a rectangle of the floor in the image, its sides included
cv::Rect2d box_of(const Camera &camera, double half_x, double half_y) {
  std::vector<cv::Point2d> points;
  for (const cv::Point2d &at : sides({half_x, half_y}, 8))
    points.push_back(camera.project({at.x, at.y, 0}));
  return box_around(points);
}

//  Moves the camera until the rectangle HALF, with ROOM around, fills FILL
//  of the width, or as much as there is place for
void frame(Camera &camera, Random &random, cv::Point2d half, cv::Point2d room,
           double fill, double tilt, double azimuth, double roll) {
  const cv::Size size = camera.size;
  const double edge = std::max(2.0, 0.004 * size.width);
  double distance = camera.focal * 2 * half.x / (fill * size.width);
  cv::Point2d aim(0, 0);
  const cv::Point2d place(random.in(0, 1), random.in(0, 1));
  for (int round = 0; round < 60; ++round) {
    camera.stand(aim, distance, tilt, azimuth, roll);
    const cv::Rect2d inner = box_of(camera, half.x, half.y);
    const cv::Rect2d outer = box_of(camera, half.x + room.x, half.y + room.y);
    const double width = size.width - 1 - 2 * edge;
    const double height = size.height - 1 - 2 * edge;
    distance *= std::max({inner.width / (fill * size.width),
                          1.002 * outer.width / width,
                          1.002 * outer.height / height});
    const cv::Point2d wanted(
        edge + place.x * std::max(0.0, width - outer.width),
        edge + place.y * std::max(0.0, height - outer.height));
    const cv::Point2d shift = (wanted - outer.tl()) * 0.8;
    //  In the floor's directions
    aim -= turned(shift, -roll) * (distance / camera.focal);
  }
  camera.stand(aim, distance, tilt, azimuth, roll);
}

//  A person sees the border: at more than SHARE of its places it is brighter
//  than the field by LEAST
bool plain(const cv::Mat &image, const Camera &camera, double border,
           double least, double share) {
  int seen = 0;
  for (int side = 0; side < 4; ++side) {
    double difference = 0;
    for (int i = -9; i <= 9; ++i) {
      const double a = i / 10.0, b = side % 2 ? 1 : -1;
      const auto grey = [&](double out) {
        return grey_at(
            image, side < 2 ? camera.project(
                                  {a * half_width, b * (half_height + out), 0})
                            : camera.project({b * (half_width + out),
                                              a * half_height, 0}));
      };
      const double here =
          grey(border / 2) - grey(-std::max(0.8, border / 2) - border);
      difference += here / 19;
      seen += here > least;
    }
    if (difference < least)
      return false;
  }
  return seen > 4 * 19 * share;
}

//  A view of the floor from above without an arena
void overhead(Stage &stage, double across, double tilt) {
  Random &random = stage.random;
  const cv::Size size = pick_size(random, {480, 1280});
  stage.look_down(size, size.width / across, random.in(0, tilt) * degree,
                  {-0.08, 0.02});
  stage.set_sensor(random.in(0.5, 2), 0.8);
  stage.set_light(0.25, random.pick(2), 0.3, across / 2);
}

}  // namespace

Scene arena_scene(Random &random, const ArenaOptions &options) {
  for (;;) {
    Stage stage(random);
    const cv::Size size = pick_size(random, options.width);
    const double border = options.border.of(random) * 2 * half_width;
    stage.look_down(size, 1, 0, options.k1);
    const double turned_by = options.turned ? random.sign() * M_PI / 2 : 0;
    const double lean = options.roll.of(random) * degree;
    frame(stage.camera, random, {half_width, half_height}, {border, border},
          options.fill.of(random), options.tilt.of(random) * degree,
          random.in(0, 2 * M_PI), turned_by + lean);

    const double field = options.field.of(random);
    const double white = std::min(field + options.contrast.of(random), 248.0);
    //  A floor as bright as the border would hide its outer edge
    const double floor = std::min(options.floor.of(random), white - 15);
    stage.set_light(options.uneven, options.shades, options.lamp, 45);
    if (options.sun.high > 1)
      stage.world.light.shades.push_back(
          {{random.in(-25, 25), random.in(-18, 18)},
           random.in(0, 2 * M_PI),
           0,
           random.in(0.1, 5),
           float(options.sun.of(random))});
    stage.set_sensor(options.noise, options.defocus);

    stage.floor(floor, random.chance(options.photographs));
    for (int i = random.whole(0, options.things); i > 0; --i) {
      const double angle = random.in(0, 2 * M_PI);
      stage.add_thing(turned({random.in(55, 110), 0}, angle));
    }
    const bool table = random.chance(0.25);
    if (options.second_frame || table) {
      //  The table that the arena lies on, or a sheet of cardboard, tape
      const cv::Point2d at(random.in(-2, 2), random.in(-2, 2));
      const cv::Point2d half(half_width + border + random.in(3, 25),
                             half_height + border + random.in(3, 25));
      const double lie = random.in(-0.05, 0.05), band = random.in(0.8, 4);
      if (options.second_frame && random.chance(0.7))
        stage.flat(stage.colour(random.in(20, 240), 0.1), at,
                   half + cv::Point2d(band, band), lie);
      stage.add(plain_paint(stage.colour(
                                std::min(random.in(30, 190), white - 15), 0.2),
                            pick_floor(random)),
                at, half, lie, 0, true);
      if (options.second_frame && random.chance(0.5))
        stage.add_poster(
            {random.sign() * random.in(70, 95), random.in(-40, 40)},
            random.in(0, M_PI), random.in(30, 50), 1.33);
    }
    const cv::Point2d inner(half_width, half_height);
    stage.flat(stage.colour(white, 0.02), {0, 0},
               inner + cv::Point2d(border, border), 0);
    stage.flat(stage.colour(field, 0.06), {0, 0}, inner, 0);
    //  Wear: faint strokes on the field
    for (int i = random.pick(4); i > 0; --i)
      stage.line(stage.colour(field + random.in(-12, 12)),
                 {random.in(-30, 30), random.in(-22, 22)},
                 {random.in(-30, 30), random.in(-22, 22)},
                 random.in(0.2, 0.6));
    for (int i = random.whole(0, options.robots); i > 0; --i) {
      const cv::Point2d at(random.in(-28, 28), random.in(-18, 18));
      const double angle = random.in(0, 2 * M_PI);
      const double height =
          stage.add_robot(at, angle, random.in(9, 16), random.in(25, 200));
      const double module = random.in(0.6, 1.0);
      stage.add(code_paint(stage.code(random.pick(1000), module,
                                      random.in(200, 240), random.in(15, 50))),
                at, {module * 4, module * 4}, angle, height + 0.05);
      if (random.chance(0.3))
        stage.flat(stage.colour(random.in(30, 230), 0.8),
                   {random.in(-30, 30), random.in(-22, 22)},
                   {random.in(1, 4), random.in(1, 4)}, random.in(0, M_PI),
                   0.5);
    }
    //  Over a side, away from the corners
    for (int i = 0; i < options.over_side; ++i) {
      const bool across = random.chance(0.5);
      const double side = random.sign();
      const cv::Point2d at =
          across ? cv::Point2d(side * half_width, random.in(-16, 16))
                 : cv::Point2d(random.in(-26, 26), side * half_height);
      if (random.chance(0.5))
        stage.add_robot(at, random.in(0, 2 * M_PI), random.in(8, 13),
                        random.in(25, 200));
      else if (random.chance(0.5))
        stage.add_cable(at * 0.6 + cv::Point2d(random.in(-8, 8), 0), at * 1.6);
      else
        stage.flat(stage.colour(random.in(30, 200), 0.8), at,
                   {random.in(2, 6), random.in(2, 5)}, random.in(0, M_PI),
                   random.in(0, 1));
    }

    Scene scene;
    const cv::Point2d p[4] = {
        stage.camera.project({-half_width, -half_height, 0}),
        stage.camera.project({half_width, -half_height, 0}),
        stage.camera.project({half_width, half_height, 0}),
        stage.camera.project({-half_width, half_height, 0})};
    //  Turned by 90 degrees another corner is the top left one
    const int first = turned_by > 0.1 ? 3 : turned_by < -0.1 ? 1 : 0;
    for (int i = 0; i < 4; ++i)
      scene.corner.push_back(p[(first + i) % 4]);
    scene.field_width = (cv::norm(p[1] - p[0]) + cv::norm(p[2] - p[3])) / 2;
    //  Too thin to be seen, or blurred away
    if (border / 80 * scene.field_width < 2 + stage.sensor.defocus)
      continue;
    scene.image = stage.take();
    const bool sunny = options.sun.high > 1;
    if (plain(scene.image, stage.camera, border, sunny ? 20 : 11,
              sunny ? 0.99 : 0.7))
      return scene;
  }
}

Scene sheet_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 40, 12);
  stage.floor(random.in(25, 170), random.chance(0.2));
  //  Square, or of A4's form; what is printed leaves a margin. A plain grey
  //  print only where nobody could take it for 4:3
  const bool square = random.chance(0.6);
  const double width = random.in(16, 26), ratio = square ? 1 : std::sqrt(0.5);
  const cv::Point2d half(width / 2, width / 2 * ratio);
  const cv::Point2d at(random.in(-4, 4), random.in(-2, 2));
  const double angle =
      random.chance(0.5) ? random.in(-0.3, 0.3) : random.in(0, 2 * M_PI);
  const cv::Vec3f paper = stage.colour(random.in(190, 240), 0.03);
  stage.flat(paper, at, half, angle);
  const double margin = width * random.in(0.03, 0.12);
  const cv::Point2d in(half.x - margin, half.y - margin);
  switch (square ? random.pick(5) : 1 + random.pick(3)) {
    case 0:
      stage.flat(stage.colour(random.in(20, 170), 0.1), at, in, angle);
      break;
    case 1:
      stage.add(text_paint(2 * half.x, 2 * half.y, width / random.in(20, 40),
                           paper, stage.colour(40), random),
                at, half, angle, 0, true);
      break;
    case 2: {
      const double field = std::min(in.x, in.y) / 4;
      stage.add(board_paint(int(in.x / field * 2), int(in.y / field * 2),
                            field, 0, paper, stage.colour(25)),
                at, in, angle);
      break;
    }
    case 3:
      if (photograph_count() > 0)
        stage.add(picture_paint(pick_photograph(random), 2 * in.x, 2 * in.y,
                                stage.colour(random.in(80, 140))),
                  at, in, angle, 0, true);
      break;
    default: {
      Code code = stage.code(random.pick(1000), in.x / 3, 0, 25);
      code.margin = 0;
      code.paper = paper;
      stage.add(code_paint(code), at, in, angle);
    }
  }
  for (int i = random.pick(3); i > 0; --i)
    stage.add_thing({random.sign() * random.in(20, 30), random.in(-20, 20)});
  return {stage.take()};
}

Scene chess_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 60, 30);
  stage.floor(random.in(25, 190), random.chance(0.2));
  stage.add_chess_board({random.in(-8, 8), random.in(-5, 5)},
                        random.in(0, 2 * M_PI), random.in(25, 50));
  if (random.chance(0.4))
    stage.add_thing({random.sign() * 30, random.in(-20, 20)});
  return {stage.take()};
}

Scene poster_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 90, 12);
  stage.floor(random.in(25, 190), random.chance(0.2));
  const cv::Point2d at(random.in(-8, 8), random.in(-5, 5));
  const double angle = random.in(-0.4, 0.4);
  if (random.chance(0.5))
    stage.add_window(at, angle, random.in(40, 65));
  else
    stage.add_poster(at, angle, random.in(40, 65),
                     random.chance(0.5) ? 1 : random.in(1.6, 1.9));
  return {stage.take()};
}

Scene desk_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 90, 25);
  stage.floor(random.in(25, 190), random.chance(0.2));
  stage.add_keyboard({random.in(-15, 15), random.in(0, 15)},
                     random.in(-0.3, 0.3), random.in(35, 50));
  for (int i = random.whole(3, 8); i > 0; --i)
    stage.add_thing({random.in(-45, 45), random.in(-30, 30)});
  return {stage.take()};
}

Scene empty_scene(Random &random) {
  Stage stage(random);
  overhead(stage, random.in(60, 250), 35);
  stage.floor(random.in(25, 210), random.chance(0.2));
  if (random.chance(0.4))
    stage.set_light(0.3, 2, 0.4, 40);
  return {stage.take()};
}

Scene code_board_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 60, 25);
  stage.floor(random.in(25, 170), random.chance(0.2));
  stage.add_code_board({random.in(-6, 6), random.in(-4, 4)},
                       random.in(-0.5, 0.5), random.in(28, 50));
  return {stage.take()};
}
