// SPDX-License-Identifier: GPL-3.0-or-later
/* Renders the rows' scenes, has them searched, and reports. */
#include "judging.hpp"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <future>
#include <iostream>
#include <map>
#include <thread>

#include <getopt.h>

namespace {

const char usage[] =
    "usage: destijl_vision_judge [--short] [--scenes N] [--row TEXT]\n"
    "                            [--seed N] [--photographs FOLDER]\n"
    "                            [--markdown FILE]\n"
    "       destijl_vision_judge --row NAME --scene N [--save FILE] [...]\n"
    "--row: the rows with TEXT in their name. Exit 1 when a row is below its\n"
    "goal.\n";

//  vision.h has six slots, one for each
const int threads = std::clamp(int(std::thread::hardware_concurrency()), 1, 6);

[[noreturn]] void fail(const std::string &what, int status) {
  std::cerr << "destijl_vision_judge: " << what << '\n';
  std::exit(status);
}

struct Options {
  bool brief;
  int scenes, scene, seed;
  std::string row, photographs, markdown, save;
};

Options read_options(int count, char **words) {
  static const option known[] = {
      {"help", no_argument, nullptr, 0},
      {"short", no_argument, nullptr, 0},
      {"scenes", required_argument, nullptr, 0},
      {"scene", required_argument, nullptr, 0},
      {"seed", required_argument, nullptr, 0},
      {"row", required_argument, nullptr, 0},
      {"photographs", required_argument, nullptr, 0},
      {"markdown", required_argument, nullptr, 0},
      {"save", required_argument, nullptr, 0},
      {}};
  std::map<std::string, std::string> given;
  int got, which = 0;
  while ((got = getopt_long(count, words, "", known, &which)) == 0)
    given[known[which].name] = optarg != nullptr ? optarg : "";
  if (got == '?' || optind < count)
    fail(usage, 2);
  if (given.count("help")) {
    std::cout << usage;
    std::exit(0);
  }
  const auto number = [&](const char *name, int otherwise) {
    int value = otherwise;
    const std::string &text = given[name];
    const char *const end = text.data() + text.size();
    if (!text.empty() &&
        (std::from_chars(text.data(), end, value).ptr != end || value < 0))
      fail("not a number: " + text, 2);
    return value;
  };
  return {given.count("short") > 0, number("scenes", 0), number("scene", -1),
          number("seed", 1),        given["row"],        given["photographs"],
          given["markdown"],        given["save"]};
}

Scene make(const Row &row, int seed, int scene) {
  Random random(seed, row.name, scene);
  return row.make(random, scene);
}

Result judge_row(const Row &row, const Options &options) {
  const int scenes = options.scenes > 0 ? options.scenes
                     : options.brief    ? row.brief
                                        : row.full;
  std::vector<Result> results{std::size_t(scenes)};
  std::atomic<int> next{0};
  std::vector<std::future<void>> workers;
  for (int slot = 0; slot < threads; ++slot)
    workers.push_back(std::async(std::launch::async, [&, slot] {
      for (int i; (i = next++) < scenes;)
        results[std::size_t(i)] =
            judge(row, make(row, options.seed, i), slot);
    }));
  for (std::future<void> &worker : workers)
    worker.get();
  Result sum;
  for (int i = 0; i < scenes; ++i)
    sum.add(results[std::size_t(i)], i);
  return sum;
}

void show_scene(const Row &row, const Options &options) {
  const Scene scene = make(row, options.seed, options.scene);
  Result result;
  result.add(judge(row, scene, 0), options.scene);
  print_outcome(std::cout, {row, result, ""}, nullptr);
  if (!options.save.empty() && !cv::imwrite(options.save, scene.image))
    fail("cannot write the image", 1);
}

}  // namespace

int main(int count, char **words) try {
  const Options options = read_options(count, words);
  cv::setNumThreads(1);
  if (options.photographs.empty() ||
      read_photographs(options.photographs) == 0)
    std::cout << "no photographs: their rows are left out\n";
  std::vector<Row> rows;
  for (const Row &row : all_rows())
    if (row.name.find(options.row) != std::string::npos)
      rows.push_back(row);
  if (rows.empty())
    fail("no row is named so: " + options.row, 2);
  if (options.scene >= 0) {
    for (const Row &row : rows)
      if (rows.size() == 1 || row.name == options.row) {
        show_scene(row, options);
        return 0;
      }
    fail("more than one row is named so: " + options.row, 2);
  }

  std::vector<Outcome> outcomes;
  int below = 0;
  const auto note = [&](const Row &row, const Result &result) {
    const Outcome outcome = conclude(row, result);
    below += !outcome.why.empty();
    print_outcome(std::cout, outcome,
                  outcomes.empty() ? nullptr : &outcomes.back());
    outcomes.push_back(outcome);
  };
  //  Few scenes a row may miss one each; all together may not
  Row arenas{"all arenas", Row::arena, 0, 0, 0, nullptr};
  Result found;
  for (const Row &row : rows) {
    if (row.kind != Row::arena && found.targets > 0) {
      note(arenas, found);
      found = Result();
    }
    const Result result = judge_row(row, options);
    if (row.kind == Row::arena) {
      found.join(result);
      arenas.goal = row.goal;
    }
    note(row, result);
  }
  if (!options.markdown.empty()) {
    std::ofstream file(options.markdown);
    write_markdown(file, outcomes, options.seed);
    if (!file.flush())
      fail("cannot write " + options.markdown, 1);
  }
  std::cout << outcomes.size() << " rows, " << below << " below their goal\n";
  return below > 0;
} catch (const std::exception &error) {
  fail(error.what(), 1);
}
