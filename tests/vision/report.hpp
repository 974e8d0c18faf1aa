// SPDX-License-Identifier: GPL-3.0-or-later
/* The report, as text and as Markdown. */
#ifndef JUDGE_REPORT_HPP
#define JUDGE_REPORT_HPP

#include "judging.hpp"

#include <ostream>
#include <vector>

struct Outcome {
  Row row;
  Result result;
  bool passed;
  std::string why;
};

void print_outcome(std::ostream &out, const Outcome &outcome);

void write_markdown(std::ostream &out, const std::vector<Outcome> &outcomes,
                    int seed);

#endif
