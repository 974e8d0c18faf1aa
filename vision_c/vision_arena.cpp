// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the arena: the best outlines are examined more and more
// closely.

#include "vision_rims.hpp"

#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

// Noise of a pixel: standard deviation, from the difference of each pixel and
// the mean of its two neighbours on a line; the lower quartile is 0.32 of
// that.
double noise_of(const cv::Mat &grey) {
  std::array<int, 256> tally{};
  int count = 0;
  const int rows = std::max(1, grey.rows / 120);
  const int columns = std::max(1, grey.cols / 160);
  for (int row = rows / 2; row < grey.rows; row += rows) {
    const uchar *const line = grey.ptr<uchar>(row);
    for (int column = 1; column < grey.cols - 1; column += columns) {
      ++tally[std::min(
          std::abs(2 * line[column] - line[column - 1] - line[column + 1]),
          255)];
      ++count;
    }
  }
  int below = 0, level = 0;
  while (level < 255 && below + tally[level] < count / 4)
    below += tally[level++];
  const double part =
      tally[level] > 0 ? (count / 4.0 - below) / tally[level] : 0.0;
  return std::max(0.3, (level - 0.5 + part) / (0.32 * std::sqrt(6.0)));
}

// Edge points in the field per pixel.
double busyness(const std::vector<Spot> &spots, const cv::Mat &small,
                const Outline &outline, double contrast) {
  constexpr double part = 0.1;  // of the border's contrast that counts
  constexpr double rim = 4.0;  // pixels beside the border that do not count
  const double unit = View(small).unit;
  std::array<Point, 4> corner;
  for (int k = 0; k < 4; ++k)
    corner[k] = unit * outline.shown(k);
  const double area =
      0.5 * cross(corner[2] - corner[0], corner[3] - corner[1]);
  int within = 0;
  for (const Spot &spot : spots)
    within += spot.slope > part * contrast &&
              depth(Point(spot.at), corner.data(), 4) > rim;
  return within / std::max(1.0, area);
}

double grade(const Evidence &evidence) {
  return evidence.support * evidence.alike * (0.6 + 0.4 * evidence.weakest) *
         std::pow(0.85, 4 - evidence.corners);
}

// Whether ONE lies in OTHER: two edges of one border, of which the inner one
// belongs to the field.
bool inside(const Outline &one, const Outline &other) {
  for (int k = 0; k < 4; ++k)
    if (depth(one.corner[k], other.corner.data(), 4) < -0.01)
      return false;
  return true;
}

// Whether ONE, which shares two corners with OTHER and does not lie in it, is
// OTHER with a wrong line.
bool is_variant(const Outline &one, const Outline &other) {
  constexpr double near = 0.03;
  int shared = 0;
  for (int k = 0; k < 4; ++k)
    shared += length(one.shown(k) - other.shown(k)) < near;
  return shared >= 2 && !inside(one, other);
}

// -------------------------------------------------------- The best outline

// What an outline must reach. The numbers separate the rows of tests/vision
// with an arena from those without.
constexpr double surely = 0.9;  // a grade that no variant can be better than
constexpr double least_grade = 0.48;
constexpr double least_support = 0.5;      // in the small image
constexpr double least_alike = 0.7, least_weakest = 0.25;
constexpr double least_contrast = 10.0;    // grey levels
constexpr double least_dark = 0.85, least_plain = 0.35;  // of the field
constexpr double most_busy = 0.085;        // edge points a pixel
// How far it may be from the image of a 4:3 rectangle: less and less.
constexpr double roughly = 0.13, well = 0.1, exactly = 0.06;
constexpr double nested = 0.85;  // the grade of an inner border, as a share of
                                 // the outer one's

// The image in two sizes, and the noise of both: standard deviations of a
// pixel.
struct Images {
  const cv::Mat &grey, &small;
  double scale, noise, noise_small;
};

// Whether the sides continue beyond the corners: then it is one of several
// tiles or panes, or part of a frame. Rough ground looks like a weak border.
bool continues(const Images &images, const Outline &outline,
               const Evidence &evidence) {
  constexpr double weak = 35.0;  // grey levels
  return ends_continued(images.small, outline, images.noise_small) >
         (evidence.usual > weak ? 1 : 2);
}

// Those that lie on edges of the small image.
Candidates settled(const Images &images, Candidates found) {
  constexpr double reach = 4.0;  // pixels
  Candidates kept;
  for (Candidate &candidate : found) {
    Evidence evidence;
    if (!kept.empty() && kept[0].score > surely &&
        is_variant(candidate.outline, kept[0].outline))
      continue;
    if (!settle(images.small, candidate.outline, reach, images.noise_small,
                quick, evidence) ||
        evidence.support < least_support ||
        !is_field(candidate.outline, roughly) ||
        continues(images, candidate.outline, evidence))
      continue;
    candidate.score = grade(evidence);
    add(kept, candidate);
  }
  return kept;
}

// The best of them, more closely.
Candidates resettled(const Images &images, Candidates found) {
  constexpr std::size_t most = 3;
  constexpr double reach = 2.5;  // pixels
  Candidates kept;
  found.resize(std::min(found.size(), most));
  for (Candidate &candidate : found) {
    Evidence evidence;
    if (!settle(images.small, candidate.outline, reach, images.noise_small,
                normal, evidence) ||
        !is_field(candidate.outline, well))
      continue;
    candidate.score = grade(evidence);
    add(kept, candidate);
  }
  return kept;
}

// Moves OUTLINE onto the edges of the whole image, until it stays.
bool settle_exactly(const Images &images, Outline &outline,
                    Evidence &evidence) {
  constexpr int rounds = 3;
  if (!settle(images.grey, outline, std::max(3.0, 1.8 * images.scale),
              images.noise, normal, evidence))
    return false;
  for (int round = 0; round < rounds; ++round) {
    if (!settle(images.grey, outline, std::max(2.5, images.scale),
                images.noise, thorough, evidence))
      return false;
    if (evidence.moved < 0.2 * images.scale)
      break;
  }
  return true;
}

// Whether it is the border of a plain field, darker than the border.
bool is_arena(const Images &images, const std::vector<Spot> &spots,
              const Outline &outline, const Evidence &evidence) {
  double dark = 0.0, plain = 0.0;
  look_inside(images.small, outline, evidence, dark, plain);
  return is_field(outline, exactly) && grade(evidence) >= least_grade &&
         evidence.alike >= least_alike &&
         evidence.weakest >= least_weakest &&
         evidence.usual >= least_contrast && dark >= least_dark &&
         plain >= least_plain &&
         busyness(spots, images.small, outline, evidence.usual) <=
             most_busy &&
         !continues(images, outline, evidence);
}

// The arena among the candidates; its score is 0 if there is none.
Candidate best_of(const Images &images, const std::vector<Spot> &spots,
                  Candidates found) {
  constexpr std::size_t most = 2;
  Candidate best;
  found.resize(std::min(found.size(), most));
  for (Candidate &candidate : found) {
    Outline &outline = candidate.outline;
    Evidence evidence;
    if ((best.score > surely && is_variant(outline, best.outline)) ||
        !settle_exactly(images, outline, evidence) ||
        !is_arena(images, spots, outline, evidence))
      continue;
    candidate.score = grade(evidence);
    if (best.score <= 0.0 ||
        (inside(outline, best.outline)
             ? candidate.score > nested * best.score
         : inside(best.outline, outline)
             ? nested * candidate.score > best.score
             : candidate.score > best.score))
      best = candidate;
  }
  return best;
}

// The corners in the image; the first side is the top: the one closest to
// pointing right.
vision_arena arena_of(const Outline &outline, const View &view) {
  const std::array<Point, 4> &corner = outline.corner;
  int first = 0;
  double furthest = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Point way = corner[(k + 1) % 4] - corner[k] + corner[(k + 2) % 4] -
                      corner[(k + 3) % 4];
    if (way.x / length(way) > furthest) {
      furthest = way.x / length(way);
      first = k;
    }
  }
  vision_arena arena;
  for (int k = 0; k < 4; ++k) {
    const Point place = view.pixel(outline.shown((first + k) % 4));
    arena.corner[k] = {place.x, place.y};
  }
  return arena;
}

vision_status find_arena(Frame &here, vision_arena &arena) {
  static thread_local std::vector<Spot> spots;
  const cv::Size size = here.image.size();
  const double scale =
      std::max(1.0, double(std::max(size.width, size.height)) / small_side);
  if (std::min(size.width, size.height) < 16 * scale)
    return fail(VISION_NOT_FOUND, "too small an image for an arena");

  cv::cvtColor(here.image, scratch.grey, cv::COLOR_BGR2GRAY);
  cv::resize(scratch.grey, scratch.small,
             cv::Size(cvRound(size.width / scale),
                      cvRound(size.height / scale)),
             0, 0, cv::INTER_AREA);
  const Candidates found = find_candidates(scratch.small, spots);
  const double noise = noise_of(scratch.grey);
  const Images images{scratch.grey, scratch.small, scale, noise,
                      scale > 1.0 ? noise_of(scratch.small) : noise};
  const Candidate best = best_of(images, spots,
                                 resettled(images, settled(images, found)));
  if (best.score <= 0.0)
    return fail(VISION_NOT_FOUND, "no arena in the image");
  arena = arena_of(best.outline, View(scratch.grey));
  return VISION_OK;
}

}  // namespace

}  // namespace vision

extern "C" vision_status vision_find_arena(int slot, vision_arena *arena) {
  return vision::on_image(slot, [&](vision::Frame &here) {
    if (arena == nullptr)
      return vision::fail(VISION_BAD_ARGUMENT, "no place for the arena");
    return vision::find_arena(here, *arena);
  });
}
