// SPDX-License-Identifier: GPL-3.0-or-later
/* The rows: what is judged, on how many scenes, against which goal. */
#ifndef JUDGE_ROWS_HPP
#define JUDGE_ROWS_HPP

#include "scenes.hpp"

#include <functional>
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

#endif
