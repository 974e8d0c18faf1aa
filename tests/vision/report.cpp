// SPDX-License-Identifier: GPL-3.0-or-later
/* The report's lines and tables. */
#include "report.hpp"

#include "photographs.hpp"

#include <opencv2/core/utility.hpp>

#include <cstdio>

namespace {

std::string text(const char *format, double value) {
  char line[64];
  std::snprintf(line, sizeof line, format, value);
  return line;
}

std::string percent(int part, int whole) {
  return whole > 0 ? text("%.1f", 100.0 * part / whole) : "-";
}

std::string mean(const char *format, double sum, int count) {
  return count > 0 ? text(format, sum / count) : "-";
}

bool peer_is_judged(const Outcome &outcome) {
  return outcome.row.kind != Row::triangles;
}

}  // namespace

void print_outcome(std::ostream &out, const Outcome &outcome) {
  const Result &r = outcome.result;
  char line[200];
  std::snprintf(line, sizeof line, "%-30s %4d ", outcome.row.name.c_str(),
                r.targets > 0 ? r.targets : r.scenes);
  out << line;
  if (outcome.row.kind == Row::no_arena || r.targets == 0)
    std::snprintf(line, sizeof line, "false %3d  peer %3d              ",
                  r.ours.invented, r.peer.invented);
  else if (outcome.row.kind == Row::arena)
    std::snprintf(line, sizeof line, "%5s %% (1 %%: %5s)  peer's box %5s",
                  percent(r.ours.found, r.targets).c_str(),
                  percent(r.ours.nearly, r.targets).c_str(),
                  percent(r.peer.found, r.targets).c_str());
  else
    std::snprintf(line, sizeof line,
                  "%5s %% peer %5s  wrong %d/%d false %d/%d",
                  percent(r.ours.found, r.targets).c_str(),
                  peer_is_judged(outcome)
                      ? percent(r.peer.found, r.targets).c_str()
                      : "-",
                  r.ours.wrong, r.peer.wrong, r.ours.invented,
                  r.peer.invented);
  out << line;
  std::snprintf(line, sizeof line, "  %6.2f ms, peer %6.2f  ",
                r.ours.milliseconds / r.scenes,
                r.peer.milliseconds / r.scenes);
  out << line << (outcome.passed ? "" : "BELOW: " + outcome.why) << '\n';
  if (!r.missed.empty()) {
    out << "      scenes";
    for (std::size_t i = 0; i < r.missed.size() && i < 20; ++i)
      out << ' ' << r.missed[i];
    out << (r.missed.size() > 20 ? " ...\n" : "\n");
  }
  out.flush();
}

void write_markdown(std::ostream &out, const std::vector<Outcome> &outcomes,
                    int seed) {
  out << "# What is found in images that are not ours\n\n"
      << "Written by `script/vision --docs`; do not edit. Seed " << seed
      << ", OpenCV " << cv::getVersionString() << ", " << photograph_count()
      << " photographs. What the rows are made of, and what counts as found: "
      << "[tests/vision](../tests/vision/README.md). Rates in percent; times "
      << "are processor time of a search, milliseconds, on the machine that "
      << "ran it.\n\n"
      << "## Arena\n\n"
      << "| row | scenes | every corner within 0.5 % | within 1 % | mean "
         "error, % | platform's method: its box | ms | platform's |\n"
      << "|---|---|---|---|---|---|---|---|\n";
  for (const Outcome &outcome : outcomes) {
    const Result &r = outcome.result;
    if (outcome.row.kind == Row::arena)
      out << "| " << outcome.row.name << " | " << r.targets << " | "
          << percent(r.ours.found, r.targets) << " | "
          << percent(r.ours.nearly, r.targets) << " | "
          << mean("%.2f", r.ours.centre_error, r.ours.found) << " | "
          << percent(r.peer.found, r.targets) << " | "
          << mean("%.1f", r.ours.milliseconds, r.scenes) << " | "
          << mean("%.1f", r.peer.milliseconds, r.scenes) << " |\n";
  }
  out << "\n## Images without an arena\n\n"
      << "| row | images | arenas seen | platform's method |\n"
      << "|---|---|---|---|\n";
  for (const Outcome &outcome : outcomes) {
    const Result &r = outcome.result;
    if (outcome.row.kind == Row::no_arena)
      out << "| " << outcome.row.name << " | " << r.scenes << " | "
          << r.ours.invented << " | " << r.peer.invented << " |\n";
  }
  out << "\n## Markers and triangles\n\n"
      << "Beside OpenCV's detector of the same version. Wrong: another "
         "identifier; false: none is there. Where rows have no markers, "
         "their images are counted.\n\n"
      << "| row | markers | found | OpenCV | wrong | OpenCV | false | OpenCV "
         "| centre, px | OpenCV | angle, degrees | OpenCV | ms | OpenCV |\n"
      << "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  double perspective = 0;
  int tilted = 0;
  for (const Outcome &outcome : outcomes) {
    const Result &r = outcome.result;
    if (outcome.row.kind == Row::arena || outcome.row.kind == Row::no_arena)
      continue;
    const bool peer = peer_is_judged(outcome);
    const auto of_peer = [&](const std::string &what) {
      return peer ? what : std::string("-");
    };
    out << "| " << outcome.row.name << " | "
        << (r.targets > 0 ? r.targets : r.scenes) << " | "
        << percent(r.ours.found, r.targets) << " | "
        << of_peer(percent(r.peer.found, r.targets)) << " | " << r.ours.wrong
        << " | " << of_peer(std::to_string(r.peer.wrong)) << " | "
        << r.ours.invented << " | "
        << of_peer(std::to_string(r.peer.invented)) << " | "
        << mean("%.2f", r.ours.centre_error, r.ours.found) << " | "
        << of_peer(mean("%.2f", r.peer.centre_error, r.peer.found)) << " | "
        << mean("%.2f", r.ours.angle_error, r.ours.found) << " | "
        << of_peer(mean("%.2f", r.peer.angle_error, r.peer.found)) << " | "
        << mean("%.1f", r.ours.milliseconds, r.scenes) << " | "
        << of_peer(mean("%.1f", r.peer.milliseconds, r.scenes)) << " |\n";
    if (outcome.row.name == "large, strongly tilted") {
      perspective = r.perspective;
      tilted = r.targets;
    }
  }
  if (tilted > 0)
    out << "\nThe centre that is published is the middle of the first and the "
           "third corner. In perspective a marker's own middle is where its "
           "diagonals cross: in the row of large, strongly tilted ones that "
           "is "
        << mean("%.1f", perspective, tilted)
        << " pixels away in the mean.\n";
}
