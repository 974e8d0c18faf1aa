// SPDX-License-Identifier: GPL-3.0-or-later
// A page of markers, to be printed.

#include "vision_search.hpp"

#include <cerrno>
#include <cstdio>
#include <string>

namespace vision {

namespace {

constexpr int ids = 1000, smallest = 20, largest = 140;
constexpr double width = 210.0, height = 297.0, edge = 10.0;  // A4, mm

// In units of a module, from the frame's top left corner: the line to cut
// along, the frame, and the white modules as one path, which has no seams.
void add_marker(std::string &page, unsigned bits) {
  page += "<path fill=\"none\" stroke=\"#aaa\" stroke-width=\".02\" "
          "d=\"M-1 -1h8v8h-8z\"/><path fill=\"#000\" d=\"M0 0h6v6h-6z\"/>"
          "<path fill=\"#fff\" d=\"";
  for (int k = 0; k < 16; ++k)
    if (bits >> k & 1u)
      page += cv::format("M%d %dh1v1h-1z", 1 + k % 4, 1 + k / 4);
  page += "\"/>";
}

std::string sheet(int first, int side) {
  const double module = side / 6.0, cell = 8 * module + 2, label = 4.0;
  const int columns = int((width - 2 * edge) / cell);
  const int rows = int((height - 2 * edge) / (cell + label));
  std::string page = cv::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%gmm\" "
      "height=\"%gmm\" viewBox=\"0 0 %g %g\" font-family=\"sans-serif\" "
      "font-size=\"2.5\">\n<path fill=\"#fff\" d=\"M0 0h%gv%gh-%gz\"/>\n",
      width, height, width, height, width, height, width);
  for (int k = 0; k < rows * columns && first + k < ids; ++k) {
    const double x = edge + k % columns * cell;
    const double y = edge + k / columns * (cell + label) + label;
    page += cv::format("<text x=\"%g\" y=\"%g\">%d, frame %d mm</text>"
                       "<g transform=\"translate(%g %g) scale(%g)\">",
                       x, y - 1, first + k, side, x + module, y + module,
                       module);
    add_marker(page, marker_bits(first + k));
    page += "</g>\n";
  }
  return page + "</svg>\n";
}

}  // namespace

}  // namespace vision

extern "C" vision_status vision_print_markers(int descriptor, int first,
                                              int side) {
  using namespace vision;
  return guarded([&] {
    if (first < 0 || first >= ids || side < smallest || side > largest)
      return fail(VISION_BAD_ARGUMENT, "no such marker");
    if (dprintf(descriptor, "%s", sheet(first, side).c_str()) < 0)
      return fail(VISION_FAILED, "%s", std::strerror(errno));
    return VISION_OK;
  });
}
