// SPDX-License-Identifier: GPL-3.0-or-later
/* Scenes with an arena, and those without that might be taken for one. */
#include "photographs.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace {

constexpr double degree = M_PI / 180;
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
  const cv::Point2d place(random.unit(), random.unit());
  for (int round = 0; round < 60; ++round) {
    camera.stand(aim, distance, tilt, azimuth, roll);
    const cv::Rect2d inner = box_of(camera, half.x, half.y);
    const cv::Rect2d outer =
        box_of(camera, half.x + room.x, half.y + room.y);
    const double free_x = size.width - 1 - 2 * edge - outer.width;
    const double free_y = size.height - 1 - 2 * edge - outer.height;
    if (round < 40) {
      const double too_wide = inner.width / (fill * size.width);
      const double too_large =
          std::max(outer.width / (size.width - 1 - 2 * edge),
                   outer.height / (size.height - 1 - 2 * edge)) * 1.002;
      distance *= std::max(too_wide, too_large);
    } else if (free_x < 0 || free_y < 0) {
      distance *= 1.003;
    }
    const cv::Point2d wanted(edge + place.x * std::max(0.0, free_x),
                             edge + place.y * std::max(0.0, free_y));
    const cv::Point2d shift = (wanted - outer.tl()) * 0.8;
    //  In the floor's directions
    const double scale = distance / camera.focal;
    const double c = std::cos(roll), s = std::sin(roll);
    aim -= cv::Point2d(c * shift.x + s * shift.y, c * shift.y - s * shift.x) *
           scale;
  }
  camera.stand(aim, distance, tilt, azimuth, roll);
}

//  A person sees the border: at more than SHARE of its places it is brighter
//  than the field by LEAST
bool plain(const cv::Mat &image, const Camera &camera, double border,
           double least, double share) {
  int seen = 0, all = 0;
  for (int side = 0; side < 4; ++side) {
    double difference = 0;
    int points = 0;
    for (int i = -9; i <= 9; ++i) {
      const double a = i / 10.0, b = side % 2 ? 1 : -1;
      const double in = std::max(0.8, border / 2);
      const auto at = [&](double out) {
        return side < 2
                   ? camera.project({a * half_width,
                                     b * (half_height + out), 0})
                   : camera.project({b * (half_width + out),
                                     a * half_height, 0});
      };
      const double here = grey_at(image, at(border / 2)) -
                          grey_at(image, at(-in - border));
      difference += here;
      ++points;
      ++all;
      seen += here > least;
    }
    if (difference / points < least)
      return false;
  }
  return seen > all * share;
}

//  A view of the floor from above without an arena
void overhead(Stage &stage, double across, double tilt) {
  Random &random = stage.random;
  const cv::Size size = pick_size(random, {480, 1280});
  const double focal = size.width * random.in(0.8, 1.4);
  stage.camera = Camera(size, focal,
                        {size.width / 2.0 - 0.5, size.height / 2.0 - 0.5},
                        pick_lens(random, {-0.08, 0.02}, 0.3));
  stage.camera.stand({0, 0}, focal * across / size.width,
                     random.in(0, tilt) * degree, random.in(0, 2 * M_PI),
                     random.in(-0.3, 0.3));
  stage.sensor.tone = Tone(random.in(1.9, 2.4), random.in(0, 0.35));
  stage.set_sensor(random.in(0.5, 2), 0.8);
  stage.set_light(0.25, random.pick(2), 0.3, across / 2);
}

Scene finished(Stage &stage) {
  Scene scene;
  scene.image = stage.take();
  return scene;
}

}  // namespace

Scene arena_scene(Random &random, const ArenaOptions &options) {
  for (;;) {
    Stage stage(random);
    const cv::Size size = pick_size(random, options.width);
    const double border = options.border.of(random) * 2 * half_width;
    const double focal = size.width * random.in(0.75, 1.4);
    stage.camera =
        Camera(size, focal,
               {size.width / 2.0 - 0.5 + random.in(-0.01, 0.01) * size.width,
                size.height / 2.0 - 0.5 +
                    random.in(-0.01, 0.01) * size.width},
               pick_lens(random, options.k1, options.division));
    const double turned = options.turned ? random.sign() * M_PI / 2 : 0;
    const double lean = options.roll.of(random) * degree;
    frame(stage.camera, random, {half_width, half_height}, {border, border},
          options.fill.of(random), options.tilt.of(random) * degree,
          random.in(0, 2 * M_PI), turned + lean);

    stage.sensor.tone = Tone(random.in(1.9, 2.4), random.in(0, 0.35));
    const double field = options.field.of(random);
    const double white = std::min(field + options.contrast.of(random), 248.0);
    //  A floor as bright as the border would hide its outer edge
    const double floor = std::min(options.floor.of(random), white - 15);
    stage.set_light(options.uneven, options.shades, options.lamp, 45);
    if (options.sun.high > 1)
      stage.world.light.shades.push_back(
          {{random.in(-25, 25), random.in(-18, 18)}, random.in(0, 2 * M_PI),
           0, random.in(0.1, 5), float(options.sun.of(random))});
    stage.set_sensor(options.noise, options.defocus);

    stage.floor(floor, random.chance(options.photographs));
    const double far = 110;
    for (int i = random.whole(0, options.things); i > 0; --i) {
      const double angle = random.in(0, 2 * M_PI);
      const double away = random.in(55, far);
      add_thing(stage, {away * std::cos(angle), away * std::sin(angle)});
    }
    const bool table = random.chance(0.25);
    if (options.second_frame || table) {
      //  The table that the arena lies on, or a sheet of cardboard, tape
      const cv::Point2d half(half_width + border + random.in(3, 25),
                             half_height + border + random.in(3, 25));
      const double lie = random.in(-0.05, 0.05);
      stage.add(plain_paint(stage.colour(std::min(random.in(30, 190),
                                                  white - 15), 0.2),
                            pick_floor(random)),
                {random.in(-2, 2), random.in(-2, 2)}, half, lie, 0, true);
      if (options.second_frame && random.chance(0.7))
        stage.add(frame_paint(2 * half.x, 2 * half.y, random.in(0.8, 4),
                              stage.colour(random.in(20, 240), 0.1)),
                  {0, 0}, half, lie);
      if (options.second_frame && random.chance(0.5))
        add_poster(stage, {random.sign() * random.in(70, 95),
                           random.in(-40, 40)},
                   random.in(0, M_PI), random.in(30, 50), 1.33);
    }
    const cv::Point2d inner(half_width, half_height);
    stage.add(plain_paint(stage.colour(white, 0.02), pick_grain(random)),
              {0, 0}, inner + cv::Point2d(border, border), 0, 0, true);
    stage.add(plain_paint(stage.colour(field, 0.06), pick_grain(random)),
              {0, 0}, inner, 0, 0, true);
    //  Wear: faint strokes on the field
    for (int i = random.pick(4); i > 0; --i)
      stage.add(stroke_paint({{random.in(-20, 20), random.in(-15, 15)},
                              {random.in(-20, 20), random.in(-15, 15)}},
                             random.in(0.2, 0.6),
                             stage.colour(field + random.in(-12, 12))),
                {random.in(-15, 15), random.in(-10, 10)}, {24, 19}, 0);
    for (int i = random.whole(0, options.robots); i > 0; --i) {
      const cv::Point2d at(random.in(-28, 28), random.in(-18, 18));
      const double angle = random.in(0, 2 * M_PI);
      const double height =
          add_robot(stage, at, angle, random.in(9, 16), random.in(25, 200));
      Code code;
      code.white = aruco_modules(random.pick(1000));
      code.module = random.in(0.6, 1.0);
      code.paper = stage.colour(random.in(200, 240));
      code.ink = stage.colour(random.in(15, 50));
      code.grain = pick_grain(random);
      stage.add(code_paint(code), at,
                {code.module * 4, code.module * 4}, angle, height + 0.05);
      if (random.chance(0.3))
        stage.add(plain_paint(stage.colour(random.in(30, 230), 0.8),
                              pick_grain(random)),
                  {random.in(-30, 30), random.in(-22, 22)},
                  {random.in(1, 4), random.in(1, 4)}, random.in(0, M_PI), 0.5,
                  true);
    }
    //  Over a side, away from the corners
    for (int i = 0; i < options.over_side; ++i) {
      const bool across = random.chance(0.5);
      const double side = random.sign();
      const cv::Point2d at =
          across ? cv::Point2d(side * half_width, random.in(-16, 16))
                 : cv::Point2d(random.in(-26, 26), side * half_height);
      if (random.chance(0.5))
        add_robot(stage, at, random.in(0, 2 * M_PI), random.in(8, 13),
                  random.in(25, 200));
      else if (random.chance(0.5))
        add_cable(stage, at * 0.6 + cv::Point2d(random.in(-8, 8), 0),
                  at * 1.6);
      else
        stage.add(plain_paint(stage.colour(random.in(30, 200), 0.8),
                              pick_grain(random)),
                  at, {random.in(2, 6), random.in(2, 5)}, random.in(0, M_PI),
                  random.in(0, 1), true);
    }

    Scene scene;
    scene.has_arena = true;
    const cv::Point2d order[4] = {{-half_width, -half_height},
                                  {half_width, -half_height},
                                  {half_width, half_height},
                                  {-half_width, half_height}};
    //  Turned by 90 degrees another corner is the top left one
    const int first = turned > 0.1 ? 3 : turned < -0.1 ? 1 : 0;
    cv::Point2d p[4];
    for (int i = 0; i < 4; ++i)
      p[i] = stage.camera.project({order[i].x, order[i].y, 0});
    for (int i = 0; i < 4; ++i)
      scene.corner[i] = p[(first + i) % 4];
    scene.field_width =
        (cv::norm(p[1] - p[0]) + cv::norm(p[2] - p[3])) / 2;
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
  const double angle = random.chance(0.5) ? random.in(-0.3, 0.3)
                                          : random.in(0, 2 * M_PI);
  const cv::Vec3f paper = stage.colour(random.in(190, 240), 0.03);
  stage.add(plain_paint(paper, pick_grain(random)), at, half, angle, 0, true);
  const double margin = width * random.in(0.03, 0.12);
  const cv::Point2d in(half.x - margin, half.y - margin);
  switch (square ? random.pick(5) : 1 + random.pick(3)) {
    case 0:
      stage.add(plain_paint(stage.colour(random.in(20, 170), 0.1),
                            pick_grain(random)),
                at, in, angle, 0, true);
      break;
    case 1:
      stage.add(text_paint(2 * half.x, 2 * half.y, width / random.in(20, 40),
                           paper, stage.colour(40), random.next()),
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
      Code code;
      code.white = aruco_modules(random.pick(1000));
      code.module = in.x / 3;
      code.margin = 0;
      code.paper = paper;
      code.ink = stage.colour(25);
      code.grain = pick_grain(random);
      stage.add(code_paint(code), at, in, angle);
    }
  }
  for (int i = random.pick(3); i > 0; --i)
    add_thing(stage, {random.sign() * random.in(20, 30), random.in(-20, 20)});
  return finished(stage);
}

Scene chess_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 60, 30);
  stage.floor(random.in(25, 190), random.chance(0.2));
  add_chess_board(stage, {random.in(-8, 8), random.in(-5, 5)},
                  random.in(0, 2 * M_PI), random.in(25, 50));
  if (random.chance(0.4))
    add_thing(stage, {random.sign() * 30, random.in(-20, 20)});
  return finished(stage);
}

Scene poster_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 90, 12);
  stage.floor(random.in(25, 190), random.chance(0.2));
  const cv::Point2d at(random.in(-8, 8), random.in(-5, 5));
  const double angle = random.in(-0.4, 0.4);
  if (random.chance(0.5))
    add_window(stage, at, angle, random.in(40, 65));
  else
    add_poster(stage, at, angle, random.in(40, 65),
               random.chance(0.5) ? 1 : random.in(1.6, 1.9));
  return finished(stage);
}

Scene desk_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 90, 25);
  stage.floor(random.in(25, 190), random.chance(0.2));
  add_keyboard(stage, {random.in(-15, 15), random.in(0, 15)},
               random.in(-0.3, 0.3), random.in(35, 50));
  for (int i = random.whole(3, 8); i > 0; --i)
    add_thing(stage, {random.in(-45, 45), random.in(-30, 30)});
  return finished(stage);
}

Scene empty_scene(Random &random) {
  Stage stage(random);
  overhead(stage, random.in(60, 250), 35);
  stage.floor(random.in(25, 210), random.chance(0.2));
  if (random.chance(0.4))
    stage.set_light(0.3, 2, 0.4, 40);
  return finished(stage);
}

Scene code_board_scene(Random &random) {
  Stage stage(random);
  overhead(stage, 60, 25);
  stage.floor(random.in(25, 170), random.chance(0.2));
  add_code_board(stage, {random.in(-6, 6), random.in(-4, 4)},
                 random.in(-0.5, 0.5), random.in(28, 50));
  return finished(stage);
}
