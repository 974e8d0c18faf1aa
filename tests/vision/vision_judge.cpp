// SPDX-License-Identifier: GPL-3.0-or-later
/* Renders the rows' scenes, has them searched, and reports. */
#include "judging.hpp"
#include "photographs.hpp"
#include "report.hpp"
#include "rows.hpp"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>

namespace {

const char usage[] =
    "usage: destijl_vision_judge [--short] [--scenes N] [--row TEXT]\n"
    "                            [--seed N] [--threads N]\n"
    "                            [--photographs FOLDER] [--markdown FILE]\n"
    "       destijl_vision_judge --row NAME --scene N [--save FILE] [...]\n"
    "       destijl_vision_judge --list\n"
    "--row: the rows with TEXT in their name. Exit 1 when a row is below its\n"
    "goal.\n";

struct Options {
  bool brief = false, list = false;
  int scenes = 0, scene = -1, seed = 1;
  int threads = int(std::clamp(std::thread::hardware_concurrency(), 1u, 6u));
  std::string row, photographs, markdown, save;
};

[[noreturn]] void fail(const std::string &what, int status) {
  std::cerr << "destijl_vision_judge: " << what << '\n';
  std::exit(status);
}

int number(const char *text) {
  char *end = nullptr;
  const long value = std::strtol(text, &end, 10);
  if (*text == '\0' || *end != '\0' || value < 0 || value > 1000000)
    fail(std::string("not a number: ") + text, 2);
  return int(value);
}

Options read_options(int count, char **words) {
  Options options;
  const std::map<std::string, bool *> flags = {{"--short", &options.brief},
                                               {"--list", &options.list}};
  const std::map<std::string, int *> numbers = {
      {"--scenes", &options.scenes},
      {"--scene", &options.scene},
      {"--threads", &options.threads},
      {"--seed", &options.seed}};
  const std::map<std::string, std::string *> texts = {
      {"--row", &options.row},
      {"--photographs", &options.photographs},
      {"--markdown", &options.markdown},
      {"--save", &options.save}};
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--help") {
      std::cout << usage;
      std::exit(0);
    }
    const bool more = i + 1 < count;
    if (flags.count(word)) {
      *flags.at(word) = true;
    } else if (more && numbers.count(word)) {
      *numbers.at(word) = number(words[++i]);
    } else if (more && texts.count(word)) {
      *texts.at(word) = words[++i];
    } else {
      std::cerr << usage;
      std::exit(2);
    }
  }
  if (options.threads < 1 || options.threads > 6)
    fail("--threads: 1 to 6, vision.h has six slots", 2);
  return options;
}

Scene make(const Row &row, int seed, int scene) {
  Random random(std::uint64_t(seed), row.name, scene);
  return row.make(random, scene);
}

Result judge_row(const Row &row, const Options &options) {
  const int scenes = options.scenes > 0 ? options.scenes
                     : options.brief    ? row.brief
                                        : row.full;
  std::vector<Result> results{std::size_t(scenes)};
  std::atomic<int> next{0};
  std::mutex lock;
  std::string failure;
  std::vector<std::thread> threads;
  for (int slot = 0; slot < options.threads; ++slot)
    threads.emplace_back([&, slot] {
      try {
        for (int i; (i = next++) < scenes;)
          results[std::size_t(i)] =
              judge(row, make(row, options.seed, i), slot);
      } catch (const std::exception &error) {
        const std::lock_guard<std::mutex> guard(lock);
        failure = error.what();
      }
    });
  for (std::thread &thread : threads)
    thread.join();
  if (!failure.empty())
    fail(failure, 1);
  Result sum;
  for (int i = 0; i < scenes; ++i)
    sum.add(results[std::size_t(i)], i);
  return sum;
}

void show_scene(const Row &row, const Options &options) {
  const Scene scene = make(row, options.seed, options.scene);
  Outcome outcome{row, {}, true, ""};
  outcome.result.add(judge(row, scene, 0), options.scene);
  print_outcome(std::cout, outcome);
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
  if (options.list) {
    for (const Row &row : rows)
      std::cout << row.name << '\n';
    return 0;
  }
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
  const auto conclude = [&](const Row &row, const Result &result) {
    Outcome outcome{row, result, false, ""};
    outcome.passed = reached(row, result, outcome.why);
    below += !outcome.passed;
    print_outcome(std::cout, outcome);
    outcomes.push_back(outcome);
  };
  //  Few scenes a row may miss one each; all together may not
  Row arenas{"all arenas", Row::arena, 0, 0, 0, nullptr};
  Result found;
  for (const Row &row : rows) {
    if (row.kind != Row::arena && found.targets > 0) {
      conclude(arenas, found);
      found = Result();
    }
    const Result result = judge_row(row, options);
    if (row.kind == Row::arena) {
      found.join(result);
      arenas.goal = row.goal;
    }
    conclude(row, result);
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
