// SPDX-License-Identifier: GPL-3.0-or-later
/* The rows: what is judged, on how many scenes, against which goal; and how
 * the outcome is told. */
#ifndef JUDGE_JUDGING_HPP
#define JUDGE_JUDGING_HPP

#include "scenes.hpp"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

struct Row {
  enum Kind { arena, no_arena, markers, triangles };
  std::string name;
  Kind kind;
  double goal;       //  share that has to be found; of pictures without an
                     //  arena, in which one may be seen nevertheless
  int brief, full;   //  scenes in the short and in the long form
  std::function<Scene(Random &, int)> make;  //  scene of this number
};

//  Those with photographs only where some were read
std::vector<Row> all_rows();

//  What one finder did in a row
struct Tally {
  int found = 0;         //  as the row asks
  int nearly = 0;        //  arenas: within 1 %
  int wrong = 0;         //  markers taken for another
  int invented = 0;      //  found where there is nothing
  double centre_error = 0, angle_error = 0;  //  sums over the found ones
  double milliseconds = 0;

  Tally &operator+=(const Tally &other);
};

struct Result {
  int scenes = 0;
  int targets = 0;  //  that are to be found
  Tally ours, peer;
  std::vector<int> missed;  //  scenes in which ours missed or invented

  void add(const Result &one, int scene);
  void join(const Result &row);  //  without the numbers of scenes
};

Result judge(const Row &row, const Scene &scene, int slot);

struct Outcome {
  Row row;
  Result result;
  std::string why;  //  the row's goal is not reached; else empty
};

Outcome conclude(const Row &row, const Result &result);

//  One line, below the names of its columns if BEFORE has others; and the
//  scenes that were missed
void print_outcome(std::ostream &out, const Outcome &outcome,
                   const Outcome *before);

void write_markdown(std::ostream &out, const std::vector<Outcome> &outcomes,
                    int seed);

#endif
