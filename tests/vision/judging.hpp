// SPDX-License-Identifier: GPL-3.0-or-later
/* Holding what was found against the truth. */
#ifndef JUDGE_JUDGING_HPP
#define JUDGE_JUDGING_HPP

#include "rows.hpp"
#include "scenes.hpp"

#include <vector>

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
  double perspective = 0;  //  sum: middle of the diagonals to the centre
  std::vector<int> missed;  //  scenes in which ours missed or invented

  void add(const Result &one, int scene);
  void join(const Result &row);  //  without the numbers of scenes
};

Result judge(const Row &row, const Scene &scene, int slot);

//  Whether RESULT reaches the row's goal; else WHY says what does not
bool reached(const Row &row, const Result &result, std::string &why);

#endif
