// SPDX-License-Identifier: GPL-3.0-or-later
/* Judging: the tolerances are here. */
#include "judging.hpp"

#include "peers.hpp"
#include "vision_internal.hpp"

#include <opencv2/imgproc.hpp>

#include <ctime>
#include <stdexcept>

#include <algorithm>
#include <cmath>

namespace {

constexpr double arena_share = 0.005;  //  of the field's width
constexpr double nearly_share = 0.01;
constexpr double centre_pixels = 2, centre_share = 0.03;  //  of the side
constexpr double angle_degrees = 2;
//  What a marker's pixels cannot tell: its middle line moves by so much
constexpr double angle_pixels = 0.4;

double milliseconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

void demand(vision_status status) {
  if (status != VISION_OK && status != VISION_NOT_FOUND)
    throw std::runtime_error(std::string("vision: ") + vision_reason());
}

void load(const Scene &scene, int slot) {
  vision::Frame &frame = *vision::frame(slot);
  scene.image.copyTo(frame.image);
  frame.content = vision::Frame::Content::pixels;
}

//  The outcome for each target, and what was found beside them
void compare(const Scene &scene, const std::vector<Finding> &findings,
             Tally &tally) {
  std::vector<bool> taken(scene.targets.size(), false);
  for (const Finding &finding : findings) {
    std::size_t nearest = scene.targets.size();
    double away = 1e9;
    for (std::size_t i = 0; i < scene.targets.size(); ++i) {
      const double d = cv::norm(scene.targets[i].centre - finding.centre);
      if (d < away && d < 0.5 * scene.targets[i].side)
        away = d, nearest = i;
    }
    if (nearest == scene.targets.size()) {
      ++tally.invented;
      continue;
    }
    const Target &target = scene.targets[nearest];
    if (finding.id != target.id) {
      ++tally.wrong;
      continue;
    }
    if (!target.plain || taken[nearest])
      continue;
    const double turn =
        std::abs(std::remainder(finding.angle - target.angle, 360));
    const double arm = cv::norm(target.direction - target.centre);
    const double most =
        std::max(angle_degrees, std::atan(angle_pixels / arm) * 180 / M_PI);
    if (away <= std::max(centre_pixels, centre_share * target.side) &&
        turn <= most) {
      taken[nearest] = true;
      ++tally.found;
      tally.centre_error += away;
      tally.angle_error += turn;
    }
  }
}

void judge_arena(const Scene &scene, int slot, Result &result) {
  load(scene, slot);
  vision_arena arena;
  double start = milliseconds();
  const vision_status status = vision_find_arena(slot, &arena);
  result.ours.milliseconds = milliseconds() - start;
  demand(status);
  cv::Rect box;
  start = milliseconds();
  const bool boxed = platform_arena(scene.image, box);
  result.peer.milliseconds = milliseconds() - start;

  if (scene.corner.empty()) {
    result.ours.invented = status == VISION_OK;
    result.peer.invented = boxed;
  } else {
    result.targets = 1;
    if (status == VISION_OK) {
      double worst = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const cv::Point2d found(arena.corner[i].x, arena.corner[i].y);
        worst = std::max(worst, cv::norm(scene.corner[i] - found));
      }
      worst /= scene.field_width;
      result.ours.found = worst <= arena_share;
      result.ours.nearly = worst <= nearly_share;
      if (result.ours.found)
        result.ours.centre_error = worst * 100;
    }
    //  The platform's has no corners: its box is held against theirs
    const cv::Rect2d field = cv::boundingRect(std::vector<cv::Point2f>(
        scene.corner.begin(), scene.corner.end()));
    const cv::Rect2d seen = box;
    if (boxed)
      result.peer.found = (field & seen).area() >= 0.8 * (field | seen).area();
  }
}

void judge_robots(const Row &row, const Scene &scene, int slot,
                  Result &result) {
  load(scene, slot);
  vision_robot robots[256];
  int count = 0;
  const bool triangles = row.kind == Row::triangles;
  double start = milliseconds();
  const vision_status status = vision_find_robots(
      slot, triangles ? VISION_MARKER_TRIANGLE : VISION_MARKER_ARUCO, nullptr,
      robots, 256, &count, nullptr, 0);
  result.ours.milliseconds = milliseconds() - start;
  demand(status);
  std::vector<Finding> findings;
  for (int i = 0; i < count; ++i)
    findings.push_back({robots[i].id,
                        {robots[i].centre.x, robots[i].centre.y},
                        robots[i].angle});
  compare(scene, findings, result.ours);
  for (const Target &target : scene.targets)
    result.targets += target.plain;
  if (triangles)
    return;

  start = milliseconds();
  findings = opencv_markers(scene.image);
  result.peer.milliseconds = milliseconds() - start;
  compare(scene, findings, result.peer);
}

}  // namespace

Tally &Tally::operator+=(const Tally &other) {
  found += other.found;
  nearly += other.nearly;
  wrong += other.wrong;
  invented += other.invented;
  centre_error += other.centre_error;
  angle_error += other.angle_error;
  milliseconds += other.milliseconds;
  return *this;
}

void Result::join(const Result &row) {
  scenes += row.scenes;
  targets += row.targets;
  ours += row.ours;
  peer += row.peer;
}

void Result::add(const Result &one, int scene) {
  join(one);
  if (one.ours.found < one.targets || one.ours.wrong || one.ours.invented)
    missed.push_back(scene);
}

Result judge(const Row &row, const Scene &scene, int slot) {
  Result result;
  result.scenes = 1;
  if (row.kind == Row::arena || row.kind == Row::no_arena)
    judge_arena(scene, slot, result);
  else
    judge_robots(row, scene, slot, result);
  return result;
}

Outcome conclude(const Row &row, const Result &result) {
  Outcome outcome{row, result, ""};
  const int missed = result.targets - result.ours.found;
  //  A row of few scenes may miss one
  const int allowed = int(std::ceil((1 - row.goal) * result.targets - 1e-9));
  if (missed > allowed)
    outcome.why += "found too few; ";
  if (row.kind == Row::markers &&
      result.ours.found < result.peer.found - result.targets / 100)
    outcome.why += "fewer than OpenCV; ";
  if (result.ours.wrong > 0)
    outcome.why += "wrong identifier; ";
  const double invented = row.kind == Row::no_arena ? row.goal : 0.01;
  if (result.ours.invented > std::floor(invented * result.scenes + 1e-9))
    outcome.why += "found what is not there; ";
  return outcome;
}
