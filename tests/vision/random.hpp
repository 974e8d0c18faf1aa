// SPDX-License-Identifier: GPL-3.0-or-later
/* The judge's own random numbers (SplitMix64): the same scene from the same
 * seed with every library. */
#ifndef JUDGE_RANDOM_HPP
#define JUDGE_RANDOM_HPP

#include <cmath>
#include <cstdint>
#include <string>

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  //  One stream for each scene of each row
  Random(std::uint64_t seed, const std::string &row, int scene)
      : state_(seed * 0x9E3779B97F4A7C15u + std::uint64_t(scene)) {
    for (const char c : row)
      state_ = (state_ ^ std::uint64_t((unsigned char)c)) * 0x100000001B3u;
    next();
  }

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  double unit() { return double(next() >> 11) * 0x1p-53; }
  double in(double low, double high) { return low + (high - low) * unit(); }
  double sign() { return chance(0.5) ? 1 : -1; }
  bool chance(double share) { return unit() < share; }
  //  0 .. count - 1
  int pick(int count) { return int(next() % std::uint64_t(count)); }
  //  low .. high
  int whole(int low, int high) { return low + pick(high - low + 1); }

  double normal() {
    const double u = 1 - unit();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * M_PI * unit());
  }

 private:
  std::uint64_t state_;
};

#endif
