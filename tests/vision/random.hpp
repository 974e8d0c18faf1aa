// SPDX-License-Identifier: GPL-3.0-or-later
/* The judge's own random numbers, by OpenCV's generator: the same scene from
 * the same seed on every machine. */
#ifndef JUDGE_RANDOM_HPP
#define JUDGE_RANDOM_HPP

#include <opencv2/core.hpp>

#include <string>

class Random : public cv::RNG {
 public:
  explicit Random(std::uint64_t seed) : cv::RNG(seed) {}

  //  One stream for each scene of each row
  Random(int seed, const std::string &row, int scene)
      : cv::RNG(std::uint64_t(seed) * 0x9E3779B97F4A7C15u +
                std::uint64_t(scene)) {
    for (const char c : row)
      state = (state ^ std::uint64_t((unsigned char)c)) * 0x100000001B3u;
    next();
  }

  double in(double low, double high) { return uniform(low, high); }
  double sign() { return chance(0.5) ? 1 : -1; }
  bool chance(double share) { return in(0, 1) < share; }
  //  0 .. count - 1
  int pick(int count) { return uniform(0, count); }
  //  low .. high
  int whole(int low, int high) { return uniform(low, high + 1); }
};

#endif
