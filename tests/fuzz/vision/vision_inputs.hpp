// SPDX-License-Identifier: GPL-3.0-or-later
// An input of the fuzzer, read from its beginning: the bytes decide what a
// target does. Behind the end there are zeros.

#ifndef VISION_INPUTS_HPP
#define VISION_INPUTS_HPP

#include <cstddef>
#include <cstdint>

#include "vision.h"

class Input {
public:
  Input(const unsigned char *data, std::size_t size)
      : next(data), end(data + size) {}

  bool empty() const { return next == end; }
  std::size_t remaining() const { return std::size_t(end - next); }
  const unsigned char *rest() const { return next; }

  unsigned byte() { return empty() ? 0u : *next++; }

  unsigned word() {
    const unsigned high = byte();
    return high << 8 | byte();
  }

  // A number of FIRST .. LAST; 65536 of them at most can come.
  int number(int first, int last) {
    return int(first + std::int64_t(word()) %
                           (std::int64_t(last) - first + 1));
  }

  // The same in steps of a 65535th of the range.
  double share(double first, double last) {
    return first + (last - first) * word() / 65535.0;
  }

  double coordinate();

  vision_point point() {
    const double x = coordinate();
    return {x, coordinate()};
  }

private:
  const unsigned char *next, *const end;
};

#endif
