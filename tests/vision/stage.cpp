// SPDX-License-Identifier: GPL-3.0-or-later
/* What scenes are made of: floors, and things that lie and stand about. */
#include "peers.hpp"
#include "scenes.hpp"

#include <opencv2/imgproc.hpp>

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
  world.surfaces.push_back({paint, at, half, angle, height, false, solid});
}

void Stage::flat(const cv::Vec3f &tint, cv::Point2d at, cv::Point2d half,
                 double angle, double height) {
  add(plain_paint(tint, pick_grain(random)), at, half, angle, height, true);
}

void Stage::line(const cv::Vec3f &tint, cv::Point2d from, cv::Point2d to,
                 double thickness) {
  const cv::Point2d along = to - from;
  flat(tint, (from + to) / 2,
       {(cv::norm(along) + thickness) / 2, thickness / 2},
       std::atan2(along.y, along.x));
}

Code Stage::code(int id, double module, double paper, double ink) {
  Code made;
  made.white = aruco_modules(id);
  made.module = module;
  made.paper = colour(paper, 0.03);
  made.ink = colour(ink, 0.03);
  made.grain = pick_grain(random);
  return made;
}

void Stage::floor(double grey, bool photographs) {
  PaintPtr paint;
  if (photographs && photograph_count() > 0) {
    const TexturePtr picture = pick_photograph(random);
    const double width = random.in(120, 300);
    paint =
        picture_paint(picture, width, width * picture->aspect(), colour(grey));
  } else {
    paint = plain_paint(colour(grey, 0.25), pick_floor(random));
  }
  world.surfaces.insert(world.surfaces.begin(),
                        {paint,
                         {random.in(-50, 50), random.in(-50, 50)},
                         {},
                         random.in(0, 2 * M_PI),
                         0,
                         true,
                         true});
}

cv::Point2d Stage::on_floor(cv::Point2d pixel, double height) const {
  const cv::Vec3d ray = camera.ray(pixel.x, pixel.y);
  const double t = (-height - camera.position[2]) / ray[2];
  return {camera.position[0] + t * ray[0], camera.position[1] + t * ray[1]};
}

void Stage::look_down(cv::Size size, double pixels_a_cm, double tilt,
                      const Range &k1) {
  Lens lens;
  lens.model = random.chance(0.3) ? Lens::division : Lens::brown;
  lens.k1 = k1.of(random);
  if (lens.model == Lens::brown && lens.k1 < -0.05)
    lens.k2 = lens.k1 * lens.k1 * random.in(0, 0.6);
  const double focal = size.width * random.in(0.75, 1.4);
  camera = Camera(size, focal,
                  {size.width * random.in(0.49, 0.51) - 0.5,
                   size.height * random.in(0.49, 0.51) - 0.5},
                  lens);
  camera.stand({0, 0}, focal / pixels_a_cm, tilt, random.in(0, 2 * M_PI),
               random.in(-0.3, 0.3));
  sensor.tone = Tone(random.in(1.9, 2.4), random.in(0, 0.35));
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
  cv::Mat pixel;
  cv::getRectSubPix(image, {1, 1}, point, pixel);
  cv::cvtColor(pixel, pixel, cv::COLOR_BGR2GRAY);
  return pixel.at<uchar>(0, 0);
}

cv::Mat Stage::take() {
  cv::Mat light = show(world, camera);
  return develop(light, sensor, random);
}

void Stage::add_sheet(cv::Point2d at, double angle, double size) {
  const double ratio = random.chance(0.7) ? std::sqrt(2) : 1;
  const cv::Point2d half(size / 2, size / 2 * ratio);
  const cv::Vec3f paper = colour(random.in(185, 240), 0.03);
  if (random.chance(0.3))
    flat(paper, at, half, angle);
  else
    add(text_paint(size, size * ratio, size / random.in(25, 45), paper,
                   colour(random.in(30, 110)), random),
        at, half, angle, 0, true);
}

void Stage::add_book(cv::Point2d at, double angle) {
  const cv::Point2d half(random.in(7, 11), random.in(10, 15));
  const double height = random.in(0.5, 3);
  for (const double h : {0.0, height / 2, height})
    flat(h < height ? colour(200, 0.05) : colour(random.in(40, 180), 0.7), at,
         half, angle, h);
  flat(colour(random.in(60, 230), 0.3), at, {half.x * 0.7, half.y * 0.12},
       angle, height + 0.01);
}

void Stage::add_cable(cv::Point2d from, cv::Point2d to) {
  const cv::Point2d middle = (from + to) / 2, half = (to - from) / 2;
  const cv::Point2d across(-half.y, half.x);
  const double wave = random.in(0.05, 0.4), turns = random.in(1, 3);
  const double thickness = random.in(0.4, 1.2);
  const cv::Vec3f tint = colour(
      random.chance(0.6) ? random.in(15, 50) : random.in(120, 220), 0.3);
  cv::Point2d last = from;
  for (int i = -11; i <= 12; ++i) {
    const double t = i / 12.0;
    const cv::Point2d next =
        middle + t * half + wave * std::sin(turns * M_PI * t) * across;
    line(tint, last, next, thickness);
    last = next;
  }
}

void Stage::add_chess_board(cv::Point2d at, double angle, double size) {
  const int columns = random.whole(5, 10), rows = random.whole(5, 8);
  const double field = size / columns;
  const double margin = random.chance(0.7) ? field * random.in(0.3, 1.2) : 0;
  add(board_paint(columns, rows, field, margin,
                  colour(random.in(190, 240), 0.05),
                  colour(random.in(15, 70), 0.1)),
      at, {columns * field / 2 + margin, rows * field / 2 + margin}, angle);
}

void Stage::add_poster(cv::Point2d at, double angle, double width,
                       double ratio) {
  const double height = width / ratio, margin = width * random.in(0.02, 0.1);
  flat(colour(random.in(195, 240), 0.03), at,
       {width / 2 + margin, height / 2 + margin}, angle);
  if (photograph_count() > 0 && random.chance(0.6)) {
    add(picture_paint(pick_photograph(random), width, height,
                      colour(random.in(80, 150))),
        at, {width / 2, height / 2}, angle, 0, true);
    return;
  }
  add(plain_paint(colour(random.in(50, 180), 0.6), pick_floor(random)), at,
      {width / 2, height / 2}, angle, 0, true);
  for (int i = random.whole(2, 7); i > 0; --i) {
    const double a = random.in(-0.3, 0.3) * width;
    const double b = random.in(-0.3, 0.3) * height;
    flat(colour(random.in(30, 230), 0.8), at + turned({a, b}, angle),
         {width * random.in(0.03, 0.18), height * random.in(0.03, 0.18)},
         angle);
  }
}

void Stage::add_keyboard(cv::Point2d at, double angle, double width) {
  const bool light = random.chance(0.4);
  const double key = width / 16;
  flat(colour(light ? 215 : 35, 0.05), at, {width / 2, key * 3}, angle);
  const PaintPtr cap = plain_paint(
      colour(light ? random.in(120, 235) : random.in(55, 90), 0.05),
      pick_grain(random));
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 15; ++column) {
      if (row == 4 && column > 4 && column < 10)
        continue;
      const double x = (column - 7) * key, y = (row - 2) * key * 1.08;
      add(cap, at + turned({x, y}, angle), {key * 0.43, key * 0.45}, angle, 0,
          true);
    }
  const double y = 2 * key * 1.08;
  add(cap, at + turned({0, y}, angle), {key * 2.4, key * 0.45}, angle, 0,
      true);
}

void Stage::add_window(cv::Point2d at, double angle, double width) {
  const int columns = random.whole(2, 3), rows = random.whole(1, 3);
  const double pane = width / columns, tall = pane * random.in(0.9, 1.6);
  const double bar = pane * random.in(0.08, 0.15);
  flat(colour(random.in(150, 240), 0.05), at,
       {width / 2 + bar, tall * rows / 2 + bar}, angle);
  const bool bright = random.chance(0.6);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = (column - (columns - 1) / 2.0) * pane;
      const double y = (row - (rows - 1) / 2.0) * tall;
      const cv::Point2d middle = at + turned({x, y}, angle);
      const cv::Point2d half((pane - bar) / 2, (tall - bar) / 2);
      const double grey = bright ? random.in(225, 252) : random.in(20, 140);
      if (photograph_count() > 0 && random.chance(0.5))
        add(picture_paint(pick_photograph(random), 2 * half.x, 2 * half.y,
                          colour(grey)),
            middle, half, angle, 0, true);
      else
        flat(colour(grey, 0.1), middle, half, angle);
    }
}

void Stage::add_code_board(cv::Point2d at, double angle, double size) {
  const int columns = random.whole(3, 6), rows = random.whole(2, 5);
  const double cell = size / columns;
  flat(colour(225, 0.02), at,
       {cell * (columns + 0.4) / 2, cell * (rows + 0.4) / 2}, angle);
  const int first = random.pick(900);
  for (int i = 0; i < columns * rows; ++i) {
    const double x = (i % columns - (columns - 1) / 2.0) * cell;
    const double y = (i / columns - (rows - 1) / 2.0) * cell;
    Code one = code(first + i, cell * 0.75 / 6, 225, 25);
    one.margin = 0.5;
    add(code_paint(one), at + turned({x, y}, angle), {cell / 2, cell / 2},
        angle);
  }
}

void Stage::add_thing(cv::Point2d at) {
  const double angle = random.in(0, 2 * M_PI);
  switch (random.pick(8)) {
    case 0:
    case 1: add_sheet(at, angle, random.in(15, 25)); break;
    case 2: add_book(at, angle); break;
    case 3:
      add_cable(at, at + cv::Point2d(random.in(-80, 80), random.in(-80, 80)));
      break;
    case 4: add_chess_board(at, angle, random.in(15, 35)); break;
    case 5: add_keyboard(at, angle, random.in(35, 45)); break;
    case 6:
      flat(colour(random.in(20, 200), 0.8), at,
           {random.in(3, 12), random.in(3, 12)}, angle, random.in(0, 2));
      break;
    default:
      add_poster(at, angle, random.in(20, 50), random.chance(0.5) ? 1 : 1.6);
  }
}

double Stage::add_robot(cv::Point2d at, double angle, double length,
                        double grey) {
  const double width = length * random.in(0.7, 0.95);
  const double height = length * random.in(0.15, 0.35);
  //  Wheels, then the body in layers, the top lightest
  for (const double side : {-1.0, 1.0})
    flat(colour(20), at + turned({0, side * width * 0.52}, angle),
         {length * 0.2, width * 0.06}, angle, height * 0.3);
  const cv::Vec3f top = colour(grey, 0.5);
  for (const double h : {0.1, 0.4, 0.7, 1.0})
    flat(top * float(h < 1 ? 0.4 : 1), at, {length / 2, width / 2}, angle,
         height * h);
  return height;
}
