// SPDX-License-Identifier: GPL-3.0-or-later
/* What scenes are made of: floors, and things that lie and stand about. */
#include "photographs.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

cv::Vec3f Stage::colour(double grey, double coloured) {
  cv::Vec3f hue(1, 1, 1);
  for (int c = 0; c < 3; ++c)
    hue[c] = float(std::exp(coloured * random.in(-1, 1)));
  const float weight = 0.114f * hue[0] + 0.587f * hue[1] + 0.299f * hue[2];
  return hue * float(sensor.tone.light(grey) / weight);
}

void Stage::add(const PaintPtr &paint, cv::Point2d at, cv::Point2d half,
                double angle, double height, bool solid) {
  Surface surface;
  surface.paint = paint;
  surface.centre = at;
  surface.half = half;
  surface.angle = angle;
  surface.height = height;
  surface.solid = solid;
  world.surfaces.push_back(surface);
}

void Stage::floor(double grey, bool photographs) {
  Surface ground;
  if (photographs && photograph_count() > 0) {
    const TexturePtr picture = pick_photograph(random);
    const double width = random.in(120, 300);
    ground.paint = picture_paint(picture, width, width * picture->aspect(),
                                 colour(grey));
  } else {
    ground.paint = plain_paint(colour(grey, 0.25), pick_floor(random));
  }
  ground.centre = {random.in(-50, 50), random.in(-50, 50)};
  ground.angle = random.in(0, 2 * M_PI);
  ground.endless = true;
  ground.solid = true;
  world.surfaces.insert(world.surfaces.begin(), ground);
}

cv::Point2d Stage::on_floor(cv::Point2d pixel, double height) const {
  const cv::Vec3d ray = camera.ray(pixel.x, pixel.y);
  const double t = (-height - camera.position[2]) / ray[2];
  return {camera.position[0] + t * ray[0], camera.position[1] + t * ray[1]};
}

Lens pick_lens(Random &random, const Range &k1, double division) {
  Lens lens;
  lens.model = random.chance(division) ? Lens::division : Lens::brown;
  lens.k1 = k1.of(random);
  if (lens.model == Lens::brown && lens.k1 < -0.05)
    lens.k2 = lens.k1 * lens.k1 * random.in(0, 0.6);
  return lens;
}

void Stage::set_light(double uneven, int shades, double lamp, double reach) {
  Light &light = world.light;
  const double angle = random.in(0, 2 * M_PI);
  light.gradient = cv::Point2d(std::cos(angle), std::sin(angle)) *
                   (random.in(0, uneven) / reach);
  light.vignette = random.in(0, 0.1 + uneven);
  if (lamp > 0) {
    const cv::Point2d at(random.in(-reach, reach), random.in(-reach, reach));
    light.lamps.push_back({at, random.in(30, 120), float(random.in(0, lamp))});
  }
  for (int i = 0; i < shades; ++i)
    light.shades.push_back(
        {{random.in(-reach, reach), random.in(-reach, reach)},
         random.in(0, 2 * M_PI),
         random.chance(0.5) ? 0 : random.in(5, 40),
         random.in(1, 15),
         float(random.in(0.55, 0.85))});
}

void Stage::set_sensor(double noise, double defocus) {
  sensor.sharp = random.in(0.3, 0.6);
  sensor.defocus = random.in(0, defocus);
  sensor.read_noise = 0.0015 * noise * random.in(0.5, 1.5);
  sensor.shot_noise = 0.008 * noise * random.in(0.5, 1.5);
  sensor.mosaic = random.chance(0.7);
  sensor.sharpening = random.in(0, 0.6);
  sensor.jpeg = random.chance(0.2) ? 100 : random.whole(70, 95);
  sensor.flicker = random.chance(0.2) ? random.in(0, 0.03) : 0;
  sensor.flicker_rows = random.in(100, 600);
  for (int c = 0; c < 3; ++c)
    sensor.balance[c] = float(random.in(0.94, 1.06));
}

double grey_at(const cv::Mat &image, cv::Point2d point) {
  const double x = std::clamp(point.x, 0.0, image.cols - 1.001);
  const double y = std::clamp(point.y, 0.0, image.rows - 1.001);
  const double a = x - std::floor(x), b = y - std::floor(y);
  double sum = 0;
  for (int k = 0; k < 4; ++k) {
    const cv::Vec3b c = image.at<cv::Vec3b>(int(y) + k / 2, int(x) + k % 2);
    sum += (k % 2 ? a : 1 - a) * (k / 2 ? b : 1 - b) *
           (0.114 * c[0] + 0.587 * c[1] + 0.299 * c[2]);
  }
  return sum;
}

cv::Mat Stage::take() {
  cv::Mat light = show(world, camera);
  return develop(light, sensor, random);
}

void add_sheet(Stage &stage, cv::Point2d at, double angle, double size) {
  Random &random = stage.random;
  const double ratio = random.chance(0.7) ? std::sqrt(2) : 1;
  const cv::Point2d half(size / 2, size / 2 * ratio);
  const cv::Vec3f paper = stage.colour(random.in(185, 240), 0.03);
  if (random.chance(0.3))
    stage.add(plain_paint(paper, pick_grain(random)), at, half, angle, 0,
              true);
  else
    stage.add(text_paint(size, size * ratio, size / random.in(25, 45), paper,
                         stage.colour(random.in(30, 110)), random.next()),
              at, half, angle, 0, true);
}

void add_book(Stage &stage, cv::Point2d at, double angle) {
  Random &random = stage.random;
  const cv::Point2d half(random.in(7, 11), random.in(10, 15));
  const double height = random.in(0.5, 3);
  for (const double h : {0.0, height / 2, height})
    stage.add(plain_paint(stage.colour(h < height ? 200 : random.in(40, 180),
                                       h < height ? 0.05 : 0.7),
                          pick_grain(random)),
              at, half, angle, h, true);
  stage.add(plain_paint(stage.colour(random.in(60, 230), 0.3),
                        pick_grain(random)),
            at, {half.x * 0.7, half.y * 0.12}, angle, height + 0.01, true);
}

void add_cable(Stage &stage, cv::Point2d from, cv::Point2d to) {
  Random &random = stage.random;
  const cv::Point2d middle = (from + to) / 2, half = (to - from) / 2;
  const cv::Point2d across(-half.y, half.x);
  const double wave = random.in(0.05, 0.4), turns = random.in(1, 3);
  std::vector<cv::Point2d> points;
  for (int i = 0; i <= 24; ++i) {
    const double t = i / 12.0 - 1;
    points.push_back(t * half +
                     wave * std::sin(turns * M_PI * t) * across);
  }
  const double reach = cv::norm(half) * 1.2 + 2;
  stage.add(stroke_paint(points, random.in(0.4, 1.2),
                         stage.colour(random.chance(0.6) ? random.in(15, 50)
                                                         : random.in(120, 220),
                                      0.3)),
            middle, {reach, reach}, 0);
}

void add_chess_board(Stage &stage, cv::Point2d at, double angle,
                     double size) {
  Random &random = stage.random;
  const int columns = random.whole(5, 10), rows = random.whole(5, 8);
  const double field = size / columns;
  const double margin = random.chance(0.7) ? field * random.in(0.3, 1.2) : 0;
  stage.add(board_paint(columns, rows, field, margin,
                        stage.colour(random.in(190, 240), 0.05),
                        stage.colour(random.in(15, 70), 0.1)),
            at,
            {columns * field / 2 + margin, rows * field / 2 + margin}, angle);
}

void add_poster(Stage &stage, cv::Point2d at, double angle, double width,
                double ratio) {
  Random &random = stage.random;
  const double height = width / ratio, margin = width * random.in(0.02, 0.1);
  stage.add(plain_paint(stage.colour(random.in(195, 240), 0.03),
                        pick_grain(random)),
            at, {width / 2 + margin, height / 2 + margin}, angle, 0, true);
  if (photograph_count() > 0 && random.chance(0.6)) {
    stage.add(picture_paint(pick_photograph(random), width, height,
                            stage.colour(random.in(80, 150))),
              at, {width / 2, height / 2}, angle, 0, true);
    return;
  }
  stage.add(plain_paint(stage.colour(random.in(50, 180), 0.6),
                        pick_floor(random)),
            at, {width / 2, height / 2}, angle, 0, true);
  const double c = std::cos(angle), s = std::sin(angle);
  for (int i = random.whole(2, 7); i > 0; --i) {
    const double a = random.in(-0.3, 0.3) * width;
    const double b = random.in(-0.3, 0.3) * height;
    stage.add(plain_paint(stage.colour(random.in(30, 230), 0.8),
                          pick_grain(random)),
              at + cv::Point2d(c * a - s * b, s * a + c * b),
              {width * random.in(0.03, 0.18), height * random.in(0.03, 0.18)},
              angle, 0, true);
  }
}

void add_keyboard(Stage &stage, cv::Point2d at, double angle, double width) {
  Random &random = stage.random;
  const bool light = random.chance(0.4);
  const double key = width / 16, c = std::cos(angle), s = std::sin(angle);
  stage.add(plain_paint(stage.colour(light ? 215 : 35, 0.05),
                        pick_grain(random)),
            at, {width / 2, key * 3}, angle, 0, true);
  const PaintPtr cap = plain_paint(
      stage.colour(light ? random.in(120, 235) : random.in(55, 90), 0.05),
      pick_grain(random));
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 15; ++column) {
      if (row == 4 && column > 4 && column < 10)
        continue;
      const double x = (column - 7) * key, y = (row - 2) * key * 1.08;
      stage.add(cap, at + cv::Point2d(c * x - s * y, s * x + c * y),
                {key * 0.43, key * 0.45}, angle, 0, true);
    }
  const double y = 2 * key * 1.08;
  stage.add(cap, at + cv::Point2d(-s * y, c * y), {key * 2.4, key * 0.45},
            angle, 0, true);
}

void add_window(Stage &stage, cv::Point2d at, double angle, double width) {
  Random &random = stage.random;
  const int columns = random.whole(2, 3), rows = random.whole(1, 3);
  const double pane = width / columns, tall = pane * random.in(0.9, 1.6);
  const double bar = pane * random.in(0.08, 0.15);
  const double c = std::cos(angle), s = std::sin(angle);
  stage.add(plain_paint(stage.colour(random.in(150, 240), 0.05),
                        pick_grain(random)),
            at, {width / 2 + bar, tall * rows / 2 + bar}, angle, 0, true);
  const bool bright = random.chance(0.6);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = (column - (columns - 1) / 2.0) * pane;
      const double y = (row - (rows - 1) / 2.0) * tall;
      const cv::Point2d middle =
          at + cv::Point2d(c * x - s * y, s * x + c * y);
      const cv::Point2d half((pane - bar) / 2, (tall - bar) / 2);
      const double grey = bright ? random.in(225, 252) : random.in(20, 140);
      if (photograph_count() > 0 && random.chance(0.5))
        stage.add(picture_paint(pick_photograph(random), 2 * half.x,
                                2 * half.y, stage.colour(grey)),
                  middle, half, angle, 0, true);
      else
        stage.add(plain_paint(stage.colour(grey, 0.1), pick_grain(random)),
                  middle, half, angle, 0, true);
    }
}

void add_code_board(Stage &stage, cv::Point2d at, double angle,
                    double size) {
  Random &random = stage.random;
  const int columns = random.whole(3, 6), rows = random.whole(2, 5);
  const double cell = size / columns, c = std::cos(angle), s = std::sin(angle);
  stage.add(plain_paint(stage.colour(225, 0.02), pick_grain(random)), at,
            {cell * (columns + 0.4) / 2, cell * (rows + 0.4) / 2}, angle, 0,
            true);
  const int first = random.pick(900);
  for (int i = 0; i < columns * rows; ++i) {
    const double x = (i % columns - (columns - 1) / 2.0) * cell;
    const double y = (i / columns - (rows - 1) / 2.0) * cell;
    Code code;
    code.white = aruco_modules(first + i);
    code.module = cell * 0.75 / 6;
    code.margin = 0.5;
    code.paper = stage.colour(225, 0.02);
    code.ink = stage.colour(25);
    code.grain = pick_grain(random);
    stage.add(code_paint(code),
              at + cv::Point2d(c * x - s * y, s * x + c * y),
              {cell / 2, cell / 2}, angle);
  }
}

void add_thing(Stage &stage, cv::Point2d at) {
  Random &random = stage.random;
  const double angle = random.in(0, 2 * M_PI);
  switch (random.pick(8)) {
    case 0:
    case 1: add_sheet(stage, at, angle, random.in(15, 25)); break;
    case 2: add_book(stage, at, angle); break;
    case 3:
      add_cable(stage, at,
                at + cv::Point2d(random.in(-80, 80), random.in(-80, 80)));
      break;
    case 4: add_chess_board(stage, at, angle, random.in(15, 35)); break;
    case 5:
      add_poster(stage, at, angle, random.in(20, 50),
                 random.chance(0.5) ? 1 : 1.6);
      break;
    case 6: add_keyboard(stage, at, angle, random.in(35, 45)); break;
    default:
      stage.add(plain_paint(stage.colour(random.in(20, 200), 0.8),
                            pick_grain(random)),
                at, {random.in(3, 12), random.in(3, 12)}, angle,
                random.in(0, 2), true);
  }
}

double add_robot(Stage &stage, cv::Point2d at, double angle, double length,
                 double grey) {
  Random &random = stage.random;
  const double width = length * random.in(0.7, 0.95);
  const double height = length * random.in(0.15, 0.35);
  const double c = std::cos(angle), s = std::sin(angle);
  //  Wheels, then the body in layers, the top lightest
  for (const double side : {-1.0, 1.0})
    stage.add(plain_paint(stage.colour(20), pick_grain(random)),
              at + side * width * 0.52 * cv::Point2d(-s, c),
              {length * 0.2, width * 0.06}, angle, height * 0.3, true);
  const cv::Vec3f top = stage.colour(grey, 0.5);
  for (const double h : {0.1, 0.4, 0.7, 1.0})
    stage.add(plain_paint(top * float(h < 1 ? 0.4 : 1), pick_grain(random)),
              at, {length / 2, width / 2}, angle, height * h, true);
  return height;
}
