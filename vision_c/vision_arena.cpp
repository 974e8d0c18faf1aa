// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the arena: the best outlines are examined more and more
// closely.

#include "vision_rims.hpp"

namespace vision {

namespace {

double grade(const Evidence &evidence) {
  return evidence.support * evidence.alike * (0.6 + 0.4 * evidence.weakest);
}

// -------------------------------------------------------- The best outline

// What an outline must reach. The numbers separate the rows of tests/vision
// with an arena from those without.
constexpr double least_grade = 0.48;
constexpr double least_long = 0.3;         // of the image's width
constexpr double least_support = 0.5;      // in the small image
constexpr double least_alike = 0.7, least_weakest = 0.25;
constexpr double least_contrast = 10.0;    // grey levels
constexpr double least_dark = 0.85, least_plain = 0.35;  // of the field
// How far it may be from the image of a 4:3 rectangle: less and less.
constexpr double roughly = 0.13, well = 0.1, exactly = 0.06;

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

// The best of them, at most MOST, that lie on edges of the small image, moved
// by at most REACH pixels, and can be a field by TOLERANCE.
Candidates settled(const Images &images, Candidates found, std::size_t most,
                   double reach, const Pace &pace, double tolerance) {
  Candidates kept;
  found.resize(std::min(found.size(), most));
  for (Candidate &candidate : found) {
    Evidence evidence;
    if (!settle(images.small, candidate.outline, reach, images.noise_small,
                pace, evidence) ||
        evidence.support < least_support ||
        !is_field(candidate.outline, tolerance) ||
        continues(images, candidate.outline, evidence))
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
bool is_arena(const Images &images, const Outline &outline,
              const Evidence &evidence) {
  double dark = 0.0, plain = 0.0, longest = 0.0;
  look_inside(images.small, outline, evidence, dark, plain);
  const View view(images.small);
  for (int k = 0; k < 4; ++k)
    longest = std::max(longest, length(view.pixel(outline.shown((k + 1) % 4)) -
                                       view.pixel(outline.shown(k))));
  return longest >= least_long * images.small.cols &&
         is_field(outline, exactly) && grade(evidence) >= least_grade &&
         evidence.alike >= least_alike &&
         evidence.weakest >= least_weakest &&
         evidence.usual >= least_contrast && dark >= least_dark &&
         plain >= least_plain &&
         !continues(images, outline, evidence);
}

// The arena among the candidates; its score is 0 if there is none.
Candidate best_of(const Images &images, Candidates found) {
  constexpr std::size_t most = 2;
  Candidate best;
  found.resize(std::min(found.size(), most));
  for (Candidate &candidate : found) {
    Outline &outline = candidate.outline;
    Evidence evidence;
    if (!settle_exactly(images, outline, evidence) ||
        !is_arena(images, outline, evidence))
      continue;
    candidate.score = grade(evidence);
    if (candidate.score > best.score)
      best = candidate;
  }
  return best;
}

// The corners in the image; the first side is the top: the one closest to
// pointing right.
vision_arena arena_of(const Outline &outline, const View &view) {
  const std::array<Point, 4> &corner = outline.corner;
  const auto rightward = [&](int k) {
    const Point way = corner[(k + 1) % 4] - corner[k] + corner[(k + 2) % 4] -
                      corner[(k + 3) % 4];
    return way.x / length(way);
  };
  int first = 0;
  for (int k = 1; k < 4; ++k)
    if (rightward(k) > rightward(first))
      first = k;
  vision_arena arena;
  for (int k = 0; k < 4; ++k) {
    const Point place = view.pixel(outline.shown((first + k) % 4));
    arena.corner[k] = {place.x, place.y};
  }
  return arena;
}

vision_status find_arena(Frame &here, vision_arena &arena) {
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
  double noise = 0.0;
  const Candidates found = find_candidates(scratch.small, noise);
  const Images images{scratch.grey, scratch.small, scale, scale * noise,
                      noise};
  const Candidates near = settled(images, found, 8, 4.0, quick, roughly);
  const Candidate best =
      best_of(images, settled(images, near, 3, 2.5, normal, well));
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
