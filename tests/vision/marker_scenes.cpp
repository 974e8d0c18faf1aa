// SPDX-License-Identifier: GPL-3.0-or-later
/* Scenes with markers, with triangles, and with neither. */
#include "peers.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace {

//  The truth of a marker or a triangle: CORNERS times SCALE around AT
Target target_of(const Stage &stage, int id,
                 const std::vector<cv::Point2f> &corners, double scale,
                 cv::Point2d at, double angle, double height) {
  Target target;
  target.id = id;
  const auto seen = [&](cv::Point2d own) {
    const cv::Point2d there = at + turned(own * scale, angle);
    return stage.camera.project({there.x, there.y, -height});
  };
  for (const cv::Point2d own : corners)
    target.outline.push_back(seen(own));
  const std::vector<cv::Point2d> &c = target.outline;
  const bool marker = c.size() == 4;
  target.centre = marker ? (c[0] + c[2]) / 2 : (c[0] + c[1] + c[2]) / 3;
  target.direction = marker ? (c[0] + c[1]) / 2 : c[0];
  target.angle = std::atan2(target.centre.y - target.direction.y,
                            target.centre.x - target.direction.x) /
                 degree;
  for (std::size_t i = 0; i < c.size(); ++i)
    target.side += cv::norm(c[(i + 1) % c.size()] - c[i]) / double(c.size());
  return target;
}

const std::vector<cv::Point2f> square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

//  The tip ahead; (0, 0) is the centre of gravity, the base is 1 long
const std::vector<cv::Point2f> triangle = {
    {1.067f, 0}, {-0.533f, 0.5f}, {-0.533f, -0.5f}};

//  What is no such triangle
const std::vector<cv::Point2f> other_shapes[] = {
    //  set square of 45 degrees, of 30 and 60 degrees; equilateral
    {{0, -0.5f}, {1, 0.5f}, {-1, 0.5f}},
    {{-0.5f, -1}, {0.65f, 1}, {-0.5f, 1}},
    {{0, -0.577f}, {0.5f, 0.289f}, {-0.5f, 0.289f}},
    //  arrow, wedge; a slip of paper, askew
    {{1, 0},
     {0.2f, 0.6f},
     {0.2f, 0.2f},
     {-1, 0.2f},
     {-1, -0.2f},
     {0.2f, -0.2f},
     {0.2f, -0.6f}},
    {{1.1f, 0}, {-0.6f, 0.25f}, {-0.6f, -0.25f}},
    {{1, -0.4f}, {0.8f, 0.5f}, {-1, 0.4f}, {-0.7f, -0.5f}}};

//  A person tells the modules apart: all but one of the sixteen that bear the
//  identifier, and nearly all of the frame (which may be blotted)
bool plain(const cv::Mat &image, const Target &target, double least) {
  const std::vector<bool> white = aruco_modules(target.id);
  const std::vector<cv::Point2d> &c = target.outline;
  double grey[36], black = 0, bright = 0;
  int blacks = 0;
  for (int i = 0; i < 36; ++i) {
    const double u = (i % 6 + 0.5) / 6, v = (i / 6 + 0.5) / 6;
    grey[i] = grey_at(image, (1 - v) * ((1 - u) * c[0] + u * c[1]) +
                                 v * ((1 - u) * c[3] + u * c[2]));
    (white[std::size_t(i)] ? bright : black) += grey[i];
    blacks += !white[std::size_t(i)];
  }
  black /= blacks;
  bright /= std::max(1, 36 - blacks);
  int wrong = 0, wrong_inside = 0;
  for (int i = 0; i < 36; ++i)
    if ((grey[i] > (black + bright) / 2) != white[std::size_t(i)]) {
      ++wrong;
      wrong_inside += i % 6 > 0 && i % 6 < 5 && i / 6 > 0 && i / 6 < 5;
    }
  return bright - black > least && wrong <= 5 && wrong_inside <= 1;
}

struct Placer {
  std::vector<cv::Point3d> taken;  //  z: radius
  bool free(cv::Point2d at, double radius) {
    for (const cv::Point3d &other : taken)
      if (std::hypot(at.x - other.x, at.y - other.y) < radius + other.z)
        return false;
    taken.emplace_back(at.x, at.y, radius);
    return true;
  }
};

void scatter_things(Stage &stage, int most) {
  Random &random = stage.random;
  const cv::Size size = stage.camera.size;
  for (int i = random.whole(0, most); i > 0; --i)
    stage.add_thing(
        stage.on_floor({random.in(0, size.width), random.in(0, size.height)}));
}

void blot(Random &random, int kind, Code &code) {
  Blot spot;
  const double place = kind == 1 ? 3 : random.in(-1.5, 1.5);
  const cv::Point2d at(place * (kind == 1 ? random.sign() : 1),
                       3 * random.sign());
  spot.centre = random.chance(0.5) ? at : cv::Point2d(at.y, at.x);
  spot.radius = random.in(0.4, 0.9);
  spot.colour = random.chance(0.5) ? code.paper * 0.95f : code.ink * 1.3f;
  if (random.chance(0.2))
    spot.colour = (code.paper + code.ink) * 0.4f;
  code.blots.push_back(spot);
}

}  // namespace

Scene marker_scene(Random &random, const MarkerOptions &options) {
  Stage stage(random);
  const cv::Size size = options.image;
  const double usual = (options.side.low + options.side.high) / 2;
  //  Markers of some eight centimetres
  stage.look_down(size, usual / 8, options.tilt.of(random) * degree,
                  {-0.05, 0.0125});
  const double reach = 8 / usual * size.width / 2;
  stage.set_light(options.uneven, options.competition ? random.pick(3) : 0,
                  options.competition ? 0.3 : 0, reach);
  stage.set_sensor(options.noise, 0);
  const double module_px = options.side.low / 6;
  stage.sensor.defocus = options.defocus.of(random) * module_px;
  stage.sensor.shake = options.shake.of(random) * module_px;
  stage.sensor.shake_angle = random.in(0, M_PI);
  if (module_px < 3)
    stage.sensor.sharp = random.in(0.3, 0.45);

  const double ground = options.ground.of(random);
  stage.floor(ground, random.chance(options.photographs));
  scatter_things(stage, options.things);
  if (options.competition) {
    //  The pitch: felt or cardboard with lines
    const double half = reach * random.in(0.6, 0.9);
    const cv::Vec3f cloth = stage.colour(random.in(50, 150), 0.5);
    stage.flat(cloth, {0, 0}, {half, half * 0.7}, random.in(-0.2, 0.2));
    for (int i = random.whole(1, 5); i > 0; --i)
      stage.flat(stage.colour(random.chance(0.5) ? 225 : 30, 0.2),
                 {random.in(-half, half) * 0.7, random.in(-half, half) * 0.5},
                 {random.in(0.2, 1) * half, random.in(0.5, 1.5)},
                 random.chance(0.5) ? 0 : M_PI / 2);
  }

  Scene scene;
  Placer placer;
  const int first = random.pick(1000);
  for (int tries = 0;
       int(scene.targets.size()) < options.count && tries < 4000; ++tries) {
    const double side = options.side.of(random);
    const double margin = options.margin.of(random);
    const double around = side * (1 + margin / 3);
    const double angle = random.in(0, 2 * M_PI);
    const double edge = options.rim ? 0.4 * side : around * 0.8;
    if (2 * edge > std::min(size.width, size.height))
      continue;
    const cv::Point2d pixel(random.in(edge, size.width - edge),
                            random.in(edge, size.height - edge));
    const int id = (first + 37 * int(scene.targets.size())) % 1000;
    //  What is seen there, HEIGHT above the floor, with sides of that mean
    double half = 4;
    cv::Point2d at;
    const auto target_at = [&](double height) {
      at = stage.on_floor(pixel, height);
      for (int round = 0; round < 2; ++round)
        half *= side /
                target_of(stage, id, square, half, at, angle, height).side;
      return target_of(stage, id, square, half, at, angle, height);
    };
    double height = 0.02;
    Target target = target_at(height);
    const cv::Rect2d box = box_around(target.outline);
    const double gap = std::min({box.x, box.y, size.width - 1 - box.br().x,
                                 size.height - 1 - box.br().y});
    if (options.rim && (gap < 1.5 || gap > 5))
      continue;
    const double robot =
        random.chance(options.on_robots) ? random.in(1.3, 1.7) : 0;
    if (!placer.free(pixel, robot > 0 ? side * robot * 0.75 : around * 0.72))
      continue;
    if (robot > 0) {
      height += stage.add_robot(at, angle - M_PI / 2 * random.pick(4),
                                2 * half * std::max(robot, 1 + margin / 3),
                                options.ground.of(random));
      target = target_at(height);
    }
    const cv::Rect2d image(0.5, 0.5, size.width - 2, size.height - 2);
    const cv::Rect2d seen = box_around(target.outline);
    target.plain = image.contains(seen.tl()) && image.contains(seen.br());

    const double contrast = options.contrast.of(random);
    const double ink = contrast < 60
                           ? random.in(40, 150)
                           : random.in(12, std::min(60.0, 245 - contrast));
    Code code = stage.code(id, half / 3, ink + contrast, ink);
    code.margin = margin;
    code.gain = random.in(0, 0.02);
    code.creased = random.chance(0.1);
    code.crease_at = random.in(-2, 2);
    code.crease_angle = random.in(0, M_PI);
    if (options.blot > 0)
      blot(random, options.blot, code);
    const double paper = half + margin * code.module;
    stage.add(code_paint(code), at, {paper, paper}, angle, height);
    if (options.glare)
      stage.world.light.glares.push_back(
          {stage.on_floor(pixel) +
               cv::Point2d(random.in(-1, 1), random.in(-1, 1)) * half,
           half * random.in(0.6, 2.5), half * random.in(0.4, 1),
           random.in(0, M_PI), float(random.in(0.15, 0.5))});
    scene.targets.push_back(target);
  }
  scene.image = stage.take();
  for (Target &target : scene.targets)
    target.plain = target.plain &&
                   plain(scene.image, target,
                         std::min(40.0, 0.5 * options.contrast.low));
  return scene;
}

Scene markerless_scene(Random &random) {
  Stage stage(random);
  const cv::Size sizes[] = {{640, 480}, {1280, 720}};
  stage.look_down(sizes[random.pick(2)], random.in(5, 15),
                  random.in(0, 30) * degree, {-0.05, 0.0125});
  stage.set_light(0.2, random.pick(2), 0.2, 40);
  stage.set_sensor(1, 0.5);
  stage.floor(random.in(25, 190), random.chance(0.4));
  scatter_things(stage, 12);
  //  Codes of other families: of five and more modules across, or whose
  //  frame is open
  for (int i = random.whole(2, 10); i > 0; --i) {
    Code code = stage.code(0, random.in(0.4, 1.5), random.in(190, 240),
                           random.in(15, 60));
    code.modules = random.whole(7, 10);
    code.white.clear();
    const int n = code.modules;
    for (int k = 0; k < n * n; ++k) {
      const int x = k % n, y = k / n;
      const bool rim = x == 0 || y == 0 || x == n - 1 || y == n - 1;
      code.white.push_back(!rim && random.chance(0.5));
    }
    const double half = code.module * (n / 2.0 + 1);
    const cv::Size size = stage.camera.size;
    stage.add(
        code_paint(code),
        stage.on_floor({random.in(0, size.width), random.in(0, size.height)}),
        {half, half}, random.in(0, 2 * M_PI));
  }
  return {stage.take()};
}

Scene triangle_scene(Random &random, const TriangleOptions &options) {
  Stage stage(random);
  const bool large = random.chance(0.5);
  const cv::Size size = large ? cv::Size(1280, 720) : cv::Size(640, 480);
  const double pixels_a_cm = random.in(5, 9) * (large ? 1.5 : 1);
  stage.look_down(size, pixels_a_cm, random.in(0, 10) * degree,
                  {-0.05, 0.0125});
  stage.set_light(0.15, 0, 0, size.width / pixels_a_cm / 2);
  stage.set_sensor(1, 0.8);
  stage.floor(random.in(25, 120), false);
  Placer placer;
  const auto place = [&](double radius_cm, cv::Point2d &pixel) {
    const double radius = radius_cm * pixels_a_cm;
    for (int tries = 0; tries < 200; ++tries) {
      pixel = {random.in(radius, size.width - radius),
               random.in(radius, size.height - radius)};
      if (placer.free(pixel, radius))
        return true;
    }
    return false;
  };
  const double paper_grey = random.in(215, 245);
  Scene scene;
  cv::Point2d pixel;
  for (int i = random.whole(1, options.count); i > 0 && place(9, pixel); --i) {
    const double angle = random.in(0, 2 * M_PI);
    const double grey = random.in(25, 110);
    const double height =
        stage.add_robot(stage.on_floor(pixel), angle, random.in(10, 14), grey);
    const cv::Point2d at = stage.on_floor(pixel, height);
    const double base = 4 * random.in(0.95, 1.05);
    stage.add(polygon_paint(triangle, base, stage.colour(paper_grey, 0.02)),
              at, {base * 1.6, base * 1.6}, angle, height + 0.02);
    scene.targets.push_back(
        target_of(stage, 0, triangle, base, at, angle, height + 0.02));
  }
  for (int i = 0; i < options.sheets && place(14, pixel); ++i)
    stage.add_sheet(stage.on_floor(pixel), random.in(0, 2 * M_PI),
                    random.in(8, 16));
  for (int i = 0; i < options.shapes && place(8, pixel); ++i) {
    const double size = random.in(3, 6);
    stage.add(polygon_paint(other_shapes[random.pick(6)], size,
                            stage.colour(random.in(200, 245), 0.03)),
              stage.on_floor(pixel), {1.3 * size, 1.3 * size},
              random.in(0, 2 * M_PI));
  }
  scene.image = stage.take();
  return scene;
}
