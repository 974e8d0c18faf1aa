// SPDX-License-Identifier: GPL-3.0-or-later
/* Scenes: images with the truth about what they show. */
#ifndef JUDGE_SCENES_HPP
#define JUDGE_SCENES_HPP

#include "random.hpp"
#include "sensor.hpp"
#include "world.hpp"

#include <opencv2/core.hpp>

#include <vector>

struct Range {
  double low, high;
  double of(Random &random) const { return random.in(low, high); }
};

constexpr double degree = M_PI / 180;

//  A marker or a triangle, in the image
struct Target {
  int id = 0;
  std::vector<cv::Point2d> outline;  //  the corners, clockwise
  cv::Point2d centre, direction;     //  as vision.h and docs/wire.md say
  double angle = 0;                  //  degrees
  double side = 0;                   //  mean, pixels
  bool plain = true;  //  a person sees it plainly; else it is not judged
};

struct Scene {
  cv::Mat image;
  std::vector<cv::Point2d> corner = {};  //  of an arena, clockwise from the
                                         //  top left one; else none
  double field_width = 0;  //  of the 80 cm, pixels
  std::vector<Target> targets = {};
};

//  What all scenes are made with
struct Stage {
  explicit Stage(Random &numbers) : random(numbers) {}
  Random &random;
  World world;
  Camera camera;
  Sensor sensor;

  //  A colour that is shown as GREY in light 1, of a random hue as far as
  //  COLOURED
  cv::Vec3f colour(double grey, double coloured = 0);
  void add(const PaintPtr &paint, cv::Point2d at, cv::Point2d half,
           double angle, double height = 0, bool solid = false);
  //  Of one colour with a faint grain
  void flat(const cv::Vec3f &tint, cv::Point2d at, cv::Point2d half,
            double angle, double height = 0);
  void floor(double grey, bool photographs);
  void line(const cv::Vec3f &tint, cv::Point2d from, cv::Point2d to,
            double thickness);
  //  The marker ID as printed, in these greys
  Code code(int id, double module, double paper, double ink);
  //  From above, the lens having a K1 of that range
  void look_down(cv::Size size, double pixels_a_cm, double tilt,
                 const Range &k1);
  //  UNEVEN, LAMP: shares of light that differ over REACH
  void set_light(double uneven, int shades, double lamp, double reach);
  void set_sensor(double noise, double defocus);
  cv::Point2d on_floor(cv::Point2d pixel, double height = 0) const;
  cv::Mat take();

  //  Things on a floor or a table, AT in centimetres
  void add_sheet(cv::Point2d at, double angle, double size);
  void add_book(cv::Point2d at, double angle);
  void add_cable(cv::Point2d from, cv::Point2d to);
  void add_chess_board(cv::Point2d at, double angle, double size);
  void add_poster(cv::Point2d at, double angle, double width, double ratio);
  void add_keyboard(cv::Point2d at, double angle, double width);
  void add_window(cv::Point2d at, double angle, double width);
  void add_code_board(cv::Point2d at, double angle, double size);
  void add_thing(cv::Point2d at);
  //  A robot without a marker on it, LENGTH from front to back; the height of
  //  its top
  double add_robot(cv::Point2d at, double angle, double length, double grey);
};

struct ArenaOptions {
  Range width{640, 1280};     //  of the image
  Range border{0.02, 0.06};   //  of the field's width
  Range field{50, 150};       //  grey
  Range contrast{60, 150};    //  border over field
  Range floor{25, 140};       //  grey
  Range k1{-0.04, 0.01};
  Range tilt{0, 8}, roll{-5, 5};  //  degrees
  bool turned = false;
  Range fill{0.5, 0.85};      //  of the image's width
  int things = 2;             //  at most, around
  int robots = 2;             //  at most, on the field
  int over_side = 0;          //  things over a side
  double uneven = 0.1;        //  share of light that differs
  int shades = 0;
  double lamp = 0;
  Range sun{1, 1};            //  of the light on one side of a line through it
  double noise = 1, defocus = 0.4;
  bool second_frame = false;
  double photographs = 0;     //  share with one as floor
};

//  Between four pixels, as grey
double grey_at(const cv::Mat &image, cv::Point2d point);

Scene arena_scene(Random &random, const ArenaOptions &options);

//  Without an arena
Scene sheet_scene(Random &random);
Scene chess_scene(Random &random);
Scene poster_scene(Random &random);
Scene desk_scene(Random &random);
Scene empty_scene(Random &random);
Scene code_board_scene(Random &random);

struct MarkerOptions {
  cv::Size image{640, 480};
  Range side{24, 48};         //  pixels
  int count = 8;
  Range margin{0.7, 1.2};     //  modules
  Range contrast{110, 190};   //  paper over ink
  Range ground{20, 120};      //  grey
  Range tilt{0, 10};          //  degrees
  double uneven = 0.15;
  bool glare = false, rim = false;
  int blot = 0;               //  1: on a corner, 2: on a side
  Range shake{0, 0};          //  share of a module
  Range defocus{0, 0.12};     //  share of a module
  double noise = 1;
  double on_robots = 0.5;
  int things = 3;
  bool competition = false;
  double photographs = 0.15;
};

Scene marker_scene(Random &random, const MarkerOptions &options);

//  Nothing of the dictionary in view, but much that is alike
Scene markerless_scene(Random &random);

struct TriangleOptions {
  int count = 4;
  int sheets = 0, shapes = 0;
};

Scene triangle_scene(Random &random, const TriangleOptions &options);

#endif
