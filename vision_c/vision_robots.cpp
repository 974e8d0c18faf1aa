// SPDX-License-Identifier: GPL-3.0-or-later
// The search for robots: in the whole image, in the arena, or only near known
// places if the rest has not changed.

#include "vision_search.hpp"

namespace vision {

thread_local Scratch scratch;

bool in_field(const Search &search, const Point &centre) {
  return !search.bounded || depth(centre + Point(search.box.tl()),
                                  search.field.data(), 4) >= -search.slack;
}

vision_robot make_robot(int id, const Point &centre, const Point &direction,
                        const Search &search) {
  vision_robot robot;
  const Point origin(search.box.tl());
  robot.id = id;
  robot.centre = {centre.x + origin.x, centre.y + origin.y};
  robot.direction = {direction.x + origin.x, direction.y + origin.y};
  robot.angle = std::atan2(centre.y - direction.y, centre.x - direction.x) *
                180.0 / CV_PI;
  if (robot.angle <= -180.0)
    robot.angle = 180.0;
  return robot;
}

namespace {

// Aligns a part of an image to the grid of the reduced images: the same
// pixels, and so the same results, as for the whole image.
cv::Rect on_grid(const cv::Rect &box) {
  constexpr int step = 1 << (levels - 1);
  const cv::Point first(box.x / step * step, box.y / step * step);
  return {first, box.br()};
}

// The search of the whole image or ARENA.
Search search_in(const Frame &here, const vision_arena *arena) {
  Search search;
  search.box = cv::Rect(cv::Point(), here.image.size());
  search.width = 0.85 * here.image.cols;
  if (arena == nullptr)
    return search;

  std::array<cv::Point2f, 4> corner;
  for (int k = 0; k < 4; ++k) {
    search.field[k] = Point(arena->corner[k].x, arena->corner[k].y);
    corner[k] = search.field[k];
  }
  const cv::Rect field = cv::boundingRect(corner);
  search.bounded = true;
  search.width = std::max<double>(field.width, field.height * 4.0 / 3.0);
  search.slack = 0.02 * search.width;
  // A robot with its centre inside extends beyond the field.
  const int reach = cvCeil(0.13 * search.width + 4.0);
  const cv::Point margin(reach, reach);
  search.box =
      on_grid(search.box & cv::Rect(field.tl() - margin, field.br() + margin));
  return search;
}

// ---------------------------------------------------------------- Following

// The image in tiles. If one has not changed since it was searched, no robot
// has entered it.
constexpr int across = 80;   // tiles along the image's longer side
constexpr int smallest = 8;  // side of a tile, in pixels
constexpr int samples = 4;   // pixels of a tile that count, per direction
constexpr int change = 24;   // smallest change of a tile's mean, grey levels:
                             // 4 times that of a noise of 15

// As the calling thread has searched it last: a tile a pixel.
thread_local cv::Mat searched;

// The mean of the samples of each tile, green; the side of one, in pixels.
int look(const cv::Mat &image, cv::Mat &now) {
  const int side = std::min(
      std::max(smallest,
               (std::max(image.cols, image.rows) + across - 1) / across),
      std::min(image.cols, image.rows));
  const cv::Size tiles(image.cols / side, image.rows / side);
  cv::resize(image(cv::Rect(cv::Point(), tiles * side)), scratch.tiles,
             tiles * samples, 0, 0, cv::INTER_NEAREST);
  cv::extractChannel(scratch.tiles, scratch.mask, 1);
  cv::resize(scratch.mask, now, tiles, 0, 0, cv::INTER_AREA);
  return side;
}

// The calling thread's last results, and their blur.
thread_local std::vector<vision_robot> last;
thread_local double last_blur = 0.0;

double distance(const vision_point &a, const vision_point &b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// The search of a part may end with the robots found there last.
void expect_last(const cv::Rect &part, Search &search) {
  search.known = 0;
  search.size = 0.0;
  // Blur is estimated in steps, and in a blurred image the results depend on
  // the steps.
  constexpr double sharp = 1.0;  // pixels
  search.blur = last_blur < sharp ? last_blur : 0.0;
  for (const vision_robot &robot : last)
    if (part.contains(cv::Point(cvRound(robot.centre.x),
                                cvRound(robot.centre.y)))) {
      ++search.known;
      search.size = std::max(search.size,
                             2 * distance(robot.direction, robot.centre));
    }
}

// How far a robot extends beyond its marker, as last found; pixels. An ArUco
// marker extends 1.4 times the distance from its centre to the direction
// point, the robot 2.2 times.
double beside(vision_marker marker, const vision_point &at) {
  constexpr double share = 0.55;
  for (const vision_robot &robot : last)
    if (marker == VISION_MARKER_ARUCO && distance(robot.centre, at) < 1.0)
      return share * distance(robot.direction, at);
  return 0.0;
}

// ---------------------------------------------------------------- Searching

// Removes duplicates at one place.
void drop_doubles(std::vector<vision_robot> &robots) {
  std::stable_sort(robots.begin(), robots.end(),
                   [](const vision_robot &a, const vision_robot &b) {
                     return a.id < b.id;
                   });
  const auto same = [](const vision_robot &a, const vision_robot &b) {
    return a.id == b.id && distance(a.centre, b.centre) < 8.0;
  };
  robots.erase(std::unique(robots.begin(), robots.end(), same), robots.end());
}

bool are_sound(const vision_area *areas, int count) {
  return count > 0 &&
         std::all_of(areas, areas + count, [](const vision_area &area) {
           return sound(area.centre) && area.reach >= 0.0 &&
                  area.reach <= 1e6;
         });
}

// The parts of WHOLE to search: all of it, or those near AREAS, which are none
// if anything else in WHOLE has changed since its search.
std::vector<cv::Rect> parts_of(const Frame &here, vision_marker marker,
                               const cv::Rect &whole,
                               const vision_area *areas, int area_count) {
  cv::Mat now;
  const int side = look(here.image, now);
  if (areas == nullptr) {
    searched = now;
    return {whole};
  }
  if (whole.empty() || now.size() != searched.size())
    return {};
  const auto tiles_of = [&](const cv::Rect &part) {
    const cv::Point rest(side - 1, side - 1);
    return cv::Rect(part.tl() / side, (part.br() + rest) / side) &
           cv::Rect(cv::Point(), now.size());
  };
  std::vector<cv::Rect> parts;
  for (int k = 0; k < area_count; ++k) {
    const vision_point &at = areas[k].centre;
    const auto part = [&](double reach) {
      return whole & cv::Rect(cv::Point(cvFloor(at.x - reach),
                                        cvFloor(at.y - reach)),
                              cv::Point(cvCeil(at.x + reach),
                                        cvCeil(at.y + reach)));
    };
    const cv::Rect body = tiles_of(part(areas[k].reach));
    if (!body.empty())
      now(body).copyTo(searched(body));
    parts.push_back(on_grid(part(areas[k].reach - beside(marker, at))));
  }
  const cv::Rect tiles = tiles_of(whole);
  if (cv::norm(now(tiles), searched(tiles), cv::NORM_INF) > change)
    return {};
  return parts;
}

}  // namespace

}  // namespace vision

extern "C" vision_status
vision_find_robots(int slot, vision_marker marker, const vision_arena *arena,
                   vision_robot *robots, int capacity, int *count,
                   const vision_area *areas, int area_count) {
  using namespace vision;
  if (count != nullptr)
    *count = 0;
  return on_image(slot, [&](Frame &here) {
    if (robots == nullptr || count == nullptr || capacity < 1 ||
        (marker != VISION_MARKER_ARUCO && marker != VISION_MARKER_TRIANGLE) ||
        (arena != nullptr && !sound(*arena)) ||
        (areas != nullptr && !are_sound(areas, area_count)))
      return fail(VISION_BAD_ARGUMENT, "cannot search for robots so");

    std::vector<vision_robot> found;
    Search search = search_in(here, arena);
    for (const cv::Rect &part :
         parts_of(here, marker, search.box, areas, area_count)) {
      if (part.width < 16 || part.height < 16)  // too small
        continue;
      search.box = part;
      if (areas != nullptr)
        expect_last(part, search);
      cv::cvtColor(here.image(part), scratch.grey, cv::COLOR_BGR2GRAY);
      cv::GaussianBlur(scratch.grey, scratch.smooth, cv::Size(5, 5), 0.8);
      if (marker == VISION_MARKER_ARUCO)
        find_markers(search, found);
      else
        find_triangles(search, found);
    }
    drop_doubles(found);
    last = found;
    last_blur = search.found_blur;
    if (found.empty())
      return fail(VISION_NOT_FOUND, "no robot in the image");
    *count = std::min(capacity, int(found.size()));
    std::copy(found.begin(), found.begin() + *count, robots);
    return VISION_OK;
  });
}
