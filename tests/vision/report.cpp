// SPDX-License-Identifier: GPL-3.0-or-later
/* The report's lines and tables. */
#include "judging.hpp"

#include <opencv2/core/utility.hpp>

#include <cstdio>

namespace {

using Cells = std::vector<std::string>;

//  Of rows of one kind or two
struct Table {
  const char *title, *before;
  Cells columns;
};

const Table tables[] = {
    {"Arena", "",
     {"scenes", "every corner within 0.5 %", "within 1 %", "mean error, %",
      "platform's method: its box", "ms", "platform's"}},
    {"Images without an arena", "",
     {"images", "arenas seen", "platform's method"}},
    {"Markers and triangles",
     "Beside OpenCV's detector of the same version. Wrong: another "
     "identifier; false: none is there. Where rows have no markers, their "
     "images are counted.\n\n",
     {"markers", "found", "OpenCV", "wrong", "OpenCV", "false", "OpenCV",
      "centre, px", "OpenCV", "angle, degrees", "OpenCV", "ms", "OpenCV"}}};

const Table &table_of(const Outcome &outcome) {
  return tables[std::min<int>(outcome.row.kind, Row::markers)];
}

//  SUM / COUNT
std::string mean(const char *format, double sum, int count) {
  char text[64];
  std::snprintf(text, sizeof text, format, sum / count);
  return count > 0 ? text : "-";
}

Cells cells_of(const Outcome &outcome) {
  const Result &r = outcome.result;
  const auto percent = [&](int part) {
    return mean("%.1f", 100.0 * part, r.targets);
  };
  const auto spent = [&](const Tally &tally) {
    return mean("%.1f", tally.milliseconds, r.scenes);
  };
  if (outcome.row.kind == Row::arena)
    return {std::to_string(r.targets),
            percent(r.ours.found),
            percent(r.ours.nearly),
            mean("%.2f", r.ours.centre_error, r.ours.found),
            percent(r.peer.found),
            spent(r.ours),
            spent(r.peer)};
  if (outcome.row.kind == Row::no_arena)
    return {std::to_string(r.scenes), std::to_string(r.ours.invented),
            std::to_string(r.peer.invented)};
  Cells cells = {std::to_string(r.targets > 0 ? r.targets : r.scenes)};
  const auto both = [&](const auto &text) {
    cells.push_back(text(r.ours));
    cells.push_back(outcome.row.kind == Row::markers ? text(r.peer) : "-");
  };
  both([&](const Tally &t) { return percent(t.found); });
  both([](const Tally &t) { return std::to_string(t.wrong); });
  both([](const Tally &t) { return std::to_string(t.invented); });
  both([](const Tally &t) { return mean("%.2f", t.centre_error, t.found); });
  both([](const Tally &t) { return mean("%.2f", t.angle_error, t.found); });
  both(spent);
  return cells;
}

}  // namespace

void print_outcome(std::ostream &out, const Outcome &outcome,
                   const Outcome *before) {
  const Table &table = table_of(outcome);
  if (before == nullptr || &table_of(*before) != &table) {
    out << "row";
    for (const std::string &column : table.columns)
      out << " | " << column;
    out << '\n';
  }
  std::string line = outcome.row.name;
  for (const std::string &cell : cells_of(outcome)) {
    line.resize(std::max<std::size_t>(line.size(), 30), ' ');
    line += std::string(7 - std::min<std::size_t>(6, cell.size()), ' ') + cell;
  }
  out << line << (outcome.why.empty() ? "" : "  BELOW: " + outcome.why)
      << '\n';
  if (!outcome.result.missed.empty()) {
    out << "      scenes";
    for (const int scene : outcome.result.missed)
      out << ' ' << scene;
    out << '\n';
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
      << "ran it.\n";
  const auto write = [&](const std::string &first, const Cells &cells) {
    out << "| " << first << " |";
    for (const std::string &cell : cells)
      out << ' ' << cell << " |";
    out << '\n';
  };
  for (const Table &table : tables) {
    out << "\n## " << table.title << "\n\n" << table.before;
    write("row", table.columns);
    out << "|---|";
    for (std::size_t i = 0; i < table.columns.size(); ++i)
      out << "---|";
    out << '\n';
    for (const Outcome &outcome : outcomes)
      if (&table_of(outcome) == &table)
        write(outcome.row.name, cells_of(outcome));
  }
}
