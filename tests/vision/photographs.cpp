// SPDX-License-Identifier: GPL-3.0-or-later
/* Reading photographs, and parts of them. */
#include "photographs.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <filesystem>
#include <vector>

namespace {

struct Photograph {
  cv::Mat picture;
  TexturePtr texture;
};

std::vector<Photograph> stock;

}  // namespace

int read_photographs(const std::string &folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto &entry :
       std::filesystem::recursive_directory_iterator(folder, error))
    if (entry.is_regular_file())
      names.push_back(entry.path().string());
  std::sort(names.begin(), names.end());
  for (const std::string &name : names) {
    cv::Mat picture = cv::imread(name, cv::IMREAD_COLOR);
    if (picture.empty() || picture.cols < 300 || picture.rows < 200)
      continue;
    const double scale = 1600.0 / std::max(picture.cols, picture.rows);
    if (scale < 1)
      cv::resize(picture, picture, {}, scale, scale, cv::INTER_AREA);
    cv::Mat light;
    cv::resize(picture, light, {}, 0.5, 0.5, cv::INTER_AREA);
    light.convertTo(light, CV_32F, 1 / 255.0);
    cv::pow(light, 2.2, light);
    const cv::Scalar mean = cv::mean(light);
    light *= 1 / std::max(0.02, (mean[0] + mean[1] + mean[2]) / 3);
    stock.push_back({picture, std::make_shared<const Texture>(light, false)});
  }
  return int(stock.size());
}

int photograph_count() { return int(stock.size()); }

TexturePtr pick_photograph(Random &random) {
  return stock[std::size_t(random.pick(photograph_count()))].texture;
}

cv::Mat photograph_view(int number, Random &random) {
  const cv::Mat &whole =
      stock[std::size_t(number % photograph_count())].picture;
  //  At first all of it, then parts
  const int round = number / photograph_count();
  const double share = round == 0 ? 1 : random.in(0.35, 0.9);
  const cv::Size part(int(whole.cols * share), int(whole.rows * share));
  const cv::Mat cut =
      whole(cv::Rect(random.pick(whole.cols - part.width + 1),
                     random.pick(whole.rows - part.height + 1), part.width,
                     part.height));
  const int widths[] = {640, 800, 1024, 1280};
  const int width = widths[random.pick(4)];
  cv::Mat image;
  cv::resize(cut, image, {width, width * part.height / part.width}, 0, 0,
             width < part.width ? cv::INTER_AREA : cv::INTER_CUBIC);
  if (round > 0 && random.chance(0.3))
    cv::flip(image, image, 1);
  return image;
}
