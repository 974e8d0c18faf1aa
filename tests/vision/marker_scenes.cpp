// SPDX-License-Identifier: GPL-3.0-or-later
/* Scenes with markers, with triangles, and with neither. */
#include "photographs.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace {

constexpr double degree = M_PI / 180;

double angle_of(cv::Point2d centre, cv::Point2d direction) {
  return std::atan2(centre.y - direction.y, centre.x - direction.x) / degree;
}

//  Pixels a centimetre, on the floor or above, seen at PIXEL
double scale_at(const Stage &stage, cv::Point2d pixel, double height) {
  const cv::Point2d p = stage.on_floor(pixel, height);
  double sum = 0;
  for (const cv::Point2d step : {cv::Point2d(0.5, 0), cv::Point2d(0, 0.5)})
    sum += cv::norm(
        stage.camera.project({p.x + step.x, p.y + step.y, -height}) -
        stage.camera.project({p.x - step.x, p.y - step.y, -height}));
  return sum / 2;
}

Target marker_target(const Stage &stage, int id, double half, cv::Point2d at,
                     double angle, double height) {
  Surface place;
  place.centre = at;
  place.angle = angle;
  place.height = height;
  Target target;
  target.id = id;
  for (const cv::Point2d own :
       {cv::Point2d(-half, -half), cv::Point2d(half, -half),
        cv::Point2d(half, half), cv::Point2d(-half, half)})
    target.outline.push_back(stage.camera.project(place.world(own)));
  const std::vector<cv::Point2d> &c = target.outline;
  target.centre = (c[0] + c[2]) / 2;
  target.direction = (c[0] + c[1]) / 2;
  target.middle = stage.camera.project(place.world({0, 0}));
  target.angle = angle_of(target.centre, target.direction);
  for (std::size_t i = 0; i < 4; ++i)
    target.side += cv::norm(c[(i + 1) % 4] - c[i]) / 4;
  return target;
}

//  Grey of the module at (COLUMN, ROW), counted from the black frame's first
double module_grey(const cv::Mat &image, const Target &target, double column,
                   double row) {
  const double u = (column + 0.5) / 6, v = (row + 0.5) / 6;
  const std::vector<cv::Point2d> &c = target.outline;
  return grey_at(image, (1 - v) * ((1 - u) * c[0] + u * c[1]) +
                            v * ((1 - u) * c[3] + u * c[2]));
}

//  A person tells the modules apart: all but one of the sixteen that bear the
//  identifier, and nearly all of the frame (which may be blotted)
bool plain(const cv::Mat &image, const Target &target,
           const std::vector<bool> &white, double least) {
  double grey[36], black = 0, bright = 0;
  int blacks = 0;
  for (int i = 0; i < 36; ++i) {
    grey[i] = module_grey(image, target, i % 6, i / 6);
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

void overhead(Stage &stage, cv::Size size, double pixels_a_cm, double tilt,
              double k1) {
  Random &random = stage.random;
  const double focal = size.width * random.in(0.8, 1.4);
  stage.camera = Camera(size, focal,
                        {size.width / 2.0 - 0.5, size.height / 2.0 - 0.5},
                        pick_lens(random, {-k1, k1 / 4}, 0.3));
  stage.camera.stand({0, 0}, focal / pixels_a_cm, tilt,
                     random.in(0, 2 * M_PI), random.in(-0.2, 0.2));
  stage.sensor.tone = Tone(random.in(1.9, 2.4), random.in(0, 0.35));
}

void scatter_things(Stage &stage, int most) {
  Random &random = stage.random;
  const cv::Size size = stage.camera.size;
  for (int i = random.whole(0, most); i > 0; --i)
    add_thing(stage, stage.on_floor({random.in(0, size.width),
                                     random.in(0, size.height)}));
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
  overhead(stage, size, usual / 8, options.tilt.of(random) * degree, 0.05);
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
    stage.add(plain_paint(cloth, pick_grain(random)), {0, 0},
              {half, half * 0.7}, random.in(-0.2, 0.2), 0, true);
    for (int i = random.whole(1, 5); i > 0; --i)
      stage.add(plain_paint(stage.colour(random.chance(0.5) ? 225 : 30, 0.2),
                            pick_grain(random)),
                {random.in(-half, half) * 0.7, random.in(-half, half) * 0.5},
                {random.in(0.2, 1) * half, random.in(0.5, 1.5)},
                random.chance(0.5) ? 0 : M_PI / 2, 0, true);
  }

  Scene scene;
  Placer placer;
  std::set<int> used;
  std::vector<std::vector<bool>> modules;
  for (int tries = 0;
       int(scene.targets.size()) < options.count && tries < 4000; ++tries) {
    const double side = options.side.of(random);
    const double margin = options.margin.of(random);
    const double around = side * (1 + margin / 3);
    const double angle = random.in(0, 2 * M_PI);
    const double edge = options.rim ? 0.4 * side : around * 0.8;
    if (2 * edge > std::min(size.width, size.height))
      continue;
    cv::Point2d pixel(random.in(edge, size.width - edge),
                      random.in(edge, size.height - edge));
    const bool on_robot = random.chance(options.on_robots);
    const double robot = on_robot ? random.in(1.3, 1.7) : 0;
    //  The robot's height follows from its length, in centimetres
    const double cm = side / scale_at(stage, pixel, 0);
    double height = 0;
    Target target;
    cv::Point2d at;
    const int side_of_image = random.pick(4);
    const double rim_gap = random.in(1.5, 5);
    double half = 0;
    for (int round = 0; round < 4; ++round) {
      at = stage.on_floor(pixel, height);
      half = side / scale_at(stage, pixel, height) / 2;
      target = marker_target(stage, 0, half, at, angle, height);
      half *= side / target.side;
      target = marker_target(stage, 0, half, at, angle, height);
      if (!options.rim)
        break;
      const cv::Rect2d box = box_around(target.outline);
      switch (side_of_image) {
        case 0: pixel.x += rim_gap - box.x; break;
        case 1: pixel.x += size.width - 1 - rim_gap - box.br().x; break;
        case 2: pixel.y += rim_gap - box.y; break;
        default: pixel.y += size.height - 1 - rim_gap - box.br().y;
      }
    }
    const double taken =
        on_robot ? side * robot * 0.75 : around * 0.72;
    if (!placer.free(pixel, taken))
      continue;
    if (on_robot) {
      height = add_robot(stage, at, angle - M_PI / 2 * random.pick(4),
                         std::max(cm * robot, 2 * half * (1 + margin / 3)),
                         options.ground.of(random));
      at = stage.on_floor(pixel, height);
      half = side / scale_at(stage, pixel, height) / 2;
      half *= side /
              marker_target(stage, 0, half, at, angle, height).side;
    }
    int id = random.pick(1000);
    while (!used.insert(id).second)
      id = random.pick(1000);
    target = marker_target(stage, id, half, at, angle, height + 0.02);
    bool inside = true;
    for (const cv::Point2d &p : target.outline)
      inside = inside && p.x > 0.5 && p.y > 0.5 && p.x < size.width - 1.5 &&
               p.y < size.height - 1.5;

    Code code;
    code.white = aruco_modules(id);
    code.module = half / 3;
    code.margin = margin;
    const double contrast = options.contrast.of(random);
    const double ink = contrast < 60
                           ? random.in(40, 150)
                           : random.in(12, std::min(60.0, 245 - contrast));
    code.paper = stage.colour(ink + contrast, 0.03);
    code.ink = stage.colour(ink, 0.05);
    code.gain = random.in(0, 0.02);
    code.grain = pick_grain(random);
    code.creased = random.chance(0.1);
    code.crease_at = random.in(-2, 2);
    code.crease_angle = random.in(0, M_PI);
    if (options.blot > 0)
      blot(random, options.blot, code);
    const double paper = half + margin * code.module;
    stage.add(code_paint(code), at, {paper, paper}, angle, height + 0.02);
    if (options.glare) {
      Glare glare;
      const cv::Point2d floor = stage.on_floor(pixel);
      glare.at = floor + cv::Point2d(random.in(-1, 1), random.in(-1, 1)) *
                             half;
      glare.length = half * random.in(0.6, 2.5);
      glare.width = half * random.in(0.4, 1);
      glare.angle = random.in(0, M_PI);
      glare.strength = float(random.in(0.15, 0.5));
      stage.world.light.glares.push_back(glare);
    }
    modules.push_back(code.white);
    scene.targets.push_back(target);
    scene.targets.back().plain = inside;
  }
  scene.image = stage.take();
  for (std::size_t i = 0; i < scene.targets.size(); ++i) {
    Target &target = scene.targets[i];
    target.plain = target.plain &&
                   plain(scene.image, target, modules[i],
                         std::min(40.0, 0.5 * options.contrast.low));
  }
  return scene;
}

Scene markerless_scene(Random &random) {
  Stage stage(random);
  const cv::Size sizes[] = {{640, 480}, {1280, 720}};
  overhead(stage, sizes[random.pick(2)], random.in(5, 15),
           random.in(0, 30) * degree, 0.05);
  stage.set_light(0.2, random.pick(2), 0.2, 40);
  stage.set_sensor(1, 0.5);
  stage.floor(random.in(25, 190), random.chance(0.4));
  scatter_things(stage, 12);
  //  Codes of other families: of five and more modules across, or whose
  //  frame is open
  for (int i = random.whole(2, 10); i > 0; --i) {
    Code code;
    code.modules = random.whole(7, 10);
    const int n = code.modules;
    for (int k = 0; k < n * n; ++k) {
      const int x = k % n, y = k / n;
      const bool rim = x == 0 || y == 0 || x == n - 1 || y == n - 1;
      code.white.push_back(!rim && random.chance(0.5));
    }
    code.module = random.in(0.4, 1.5);
    code.paper = stage.colour(random.in(190, 240), 0.03);
    code.ink = stage.colour(random.in(15, 60));
    code.grain = pick_grain(random);
    const double half = code.module * (n / 2.0 + 1);
    const cv::Size size = stage.camera.size;
    stage.add(code_paint(code),
              stage.on_floor({random.in(0, size.width),
                              random.in(0, size.height)}),
              {half, half}, random.in(0, 2 * M_PI));
  }
  Scene scene;
  scene.image = stage.take();
  return scene;
}

Scene triangle_scene(Random &random, const TriangleOptions &options) {
  Stage stage(random);
  const bool large = random.chance(0.5);
  const cv::Size size = large ? cv::Size(1280, 720) : cv::Size(640, 480);
  const double pixels_a_cm = random.in(5, 9) * (large ? 1.5 : 1);
  overhead(stage, size, pixels_a_cm, random.in(0, 10) * degree, 0.05);
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
  for (int i = random.whole(1, options.count); i > 0; --i) {
    cv::Point2d pixel;
    if (!place(9, pixel))
      break;
    const double angle = random.in(0, 2 * M_PI);
    const double grey = random.in(25, 110);
    const double height =
        add_robot(stage, stage.on_floor(pixel), angle, random.in(10, 14),
                  grey);
    const cv::Point2d at = stage.on_floor(pixel, height);
    //  Its tip ahead; (0, 0) its centre of gravity
    const double base = 4 * random.in(0.95, 1.05), tall = base * 1.6;
    const std::vector<cv::Point2d> corners = {{tall * 2 / 3, 0},
                                              {-tall / 3, base / 2},
                                              {-tall / 3, -base / 2}};
    stage.add(polygon_paint(corners, stage.colour(paper_grey, 0.02)), at,
              {tall, tall}, angle, height + 0.02);
    Surface own;
    own.centre = at;
    own.angle = angle;
    own.height = height + 0.02;
    Target target;
    for (const cv::Point2d &corner : corners)
      target.outline.push_back(stage.camera.project(own.world(corner)));
    target.centre =
        (target.outline[0] + target.outline[1] + target.outline[2]) / 3;
    target.middle = stage.camera.project(own.world({0, 0}));
    target.direction = target.outline[0];
    target.angle = angle_of(target.centre, target.direction);
    target.side = cv::norm(target.outline[0] - target.outline[1]);
    scene.targets.push_back(target);
  }
  for (int i = 0; i < options.sheets; ++i) {
    cv::Point2d pixel;
    if (place(14, pixel))
      add_sheet(stage, stage.on_floor(pixel), random.in(0, 2 * M_PI),
                random.in(8, 16));
  }
  for (int i = 0; i < options.shapes; ++i) {
    cv::Point2d pixel;
    if (!place(8, pixel))
      continue;
    const double s = random.in(3, 6);
    std::vector<cv::Point2d> corners;
    switch (random.pick(6)) {
      case 0:  //  set square of 45 degrees
        corners = {{0, -s / 2}, {s, s / 2}, {-s, s / 2}};
        break;
      case 1:  //  set square of 30 and 60 degrees
        corners = {{-s / 2, -s}, {s / 2, s}, {-s / 2, s}};
        corners[1].x = s * 0.65;
        break;
      case 2:  //  equilateral
        corners = {{0, -s * 0.577}, {s / 2, s * 0.289}, {-s / 2, s * 0.289}};
        break;
      case 3:  //  arrow
        corners = {{s, 0},           {0.2 * s, s * 0.6},  {0.2 * s, s * 0.2},
                   {-s, s * 0.2},    {-s, -s * 0.2},      {0.2 * s, -s * 0.2},
                   {0.2 * s, -s * 0.6}};
        break;
      case 4:  //  wedge
        corners = {{s * 1.1, 0}, {-s * 0.6, s * 0.25}, {-s * 0.6, -s * 0.25}};
        break;
      default:  //  a slip of paper, askew
        corners = {{s, -s * 0.4}, {s * 0.8, s * 0.5}, {-s, s * 0.4},
                   {-s * 0.7, -s * 0.5}};
    }
    stage.add(polygon_paint(corners, stage.colour(random.in(200, 245), 0.03)),
              stage.on_floor(pixel), {1.3 * s, 1.3 * s},
              random.in(0, 2 * M_PI));
  }
  scene.image = stage.take();
  return scene;
}
