// SPDX-License-Identifier: GPL-3.0-or-later
/* Paints: plain, pictures, shapes, boards, text and codes. */
#include "print.hpp"

#include "peers.hpp"

#include <algorithm>
#include <cmath>

namespace {

class Plain : public Paint {
 public:
  Plain(const cv::Vec3f &colour, const Floor &floor)
      : colour_(colour), floor_(floor) {}
  bool at(double x, double y, double footprint,
          cv::Vec3f &colour) const override {
    colour = colour_.mul(floor_.texture->at(
        x / floor_.size, y / floor_.size, footprint / floor_.size));
    return true;
  }
  bool detailed() const override { return false; }

 private:
  cv::Vec3f colour_;
  Floor floor_;
};

class Picture : public Paint {
 public:
  Picture(TexturePtr picture, double width, double height,
          const cv::Vec3f &tint)
      : picture_(std::move(picture)), width_(width), height_(height),
        tint_(tint) {}
  bool at(double x, double y, double footprint,
          cv::Vec3f &colour) const override {
    colour = tint_.mul(picture_->at(x / width_ + 0.5, y / height_ + 0.5,
                                    footprint / width_));
    return true;
  }
  bool detailed() const override { return false; }

 private:
  TexturePtr picture_;
  double width_, height_;
  cv::Vec3f tint_;
};

class Polygon : public Paint {
 public:
  Polygon(std::vector<cv::Point2d> corners, const cv::Vec3f &colour)
      : corners_(std::move(corners)), colour_(colour) {}
  bool at(double x, double y, double, cv::Vec3f &colour) const override {
    bool inside = false;
    for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size();
         j = i++) {
      const cv::Point2d &a = corners_[i], &b = corners_[j];
      if ((a.y > y) != (b.y > y) &&
          x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x)
        inside = !inside;
    }
    colour = colour_;
    return inside;
  }

 private:
  std::vector<cv::Point2d> corners_;
  cv::Vec3f colour_;
};

class Stroke : public Paint {
 public:
  Stroke(std::vector<cv::Point2d> points, double thickness,
         const cv::Vec3f &colour)
      : points_(std::move(points)), radius_(thickness / 2), colour_(colour) {
  }
  bool at(double x, double y, double, cv::Vec3f &colour) const override {
    const double away = gap(x, y);
    //  Round: brighter along its middle
    colour = colour_ * float(1.25 - 0.6 * away / radius_);
    return away < radius_;
  }
  bool empty(double x, double y, double reach) const override {
    return gap(x, y) > radius_ + reach;
  }

 private:
  double gap(double x, double y) const {
    double least = 1e9;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      const cv::Point2d along = points_[i] - points_[i - 1];
      const cv::Point2d to = cv::Point2d(x, y) - points_[i - 1];
      const double share = std::clamp(
          to.dot(along) / std::max(1e-9, along.dot(along)), 0.0, 1.0);
      least = std::min(least, cv::norm(to - share * along));
    }
    return least;
  }

  std::vector<cv::Point2d> points_;
  double radius_;
  cv::Vec3f colour_;
};

class Board : public Paint {
 public:
  Board(int columns, int rows, double size, double margin,
        const cv::Vec3f &light, const cv::Vec3f &dark)
      : columns_(columns), rows_(rows), size_(size), margin_(margin),
        light_(light), dark_(dark) {}
  bool at(double x, double y, double, cv::Vec3f &colour) const override {
    const double u = x / size_ + columns_ / 2.0, v = y / size_ + rows_ / 2.0;
    const double m = margin_ / size_;
    if (u < -m || v < -m || u > columns_ + m || v > rows_ + m)
      return false;
    const bool field = u >= 0 && v >= 0 && u < columns_ && v < rows_;
    colour = field && (int(u) + int(v)) % 2 == 0 ? dark_ : light_;
    return true;
  }

 private:
  int columns_, rows_;
  double size_, margin_;
  cv::Vec3f light_, dark_;
};

class Frame : public Paint {
 public:
  Frame(double width, double height, double border, const cv::Vec3f &colour)
      : half_(width / 2, height / 2), border_(border), colour_(colour) {}
  bool at(double x, double y, double, cv::Vec3f &colour) const override {
    colour = colour_;
    return out(x, y) < 0 && out(x, y) > -border_;
  }
  bool empty(double x, double y, double reach) const override {
    return out(x, y) > reach || out(x, y) < -border_ - reach;
  }

 private:
  double out(double x, double y) const {
    return std::max(std::abs(x) - half_.x, std::abs(y) - half_.y);
  }

  cv::Point2d half_;
  double border_;
  cv::Vec3f colour_;
};

class Text : public Paint {
 public:
  Text(double width, double height, double line, const cv::Vec3f &paper,
       const cv::Vec3f &ink, std::uint64_t seed)
      : width_(width), height_(height), line_(line), paper_(paper),
        ink_(ink) {
    Random random(seed);
    const int rows = int(height * 0.8 / line), cells = int(width * 2 / line);
    columns_ = std::max(1, cells);
    for (int row = 0; row < rows; ++row)
      for (int cell = 0; cell < columns_; ++cell) {
        const int last = row % 9 == 8 ? columns_ / 2 : columns_;
        ink_at_.push_back(row % 9 < 8 + (row / 9) % 2 && cell < last
                              ? float(random.chance(0.17) ? 0
                                                          : random.in(0.3, 1))
                              : 0.0f);
      }
  }
  bool at(double x, double y, double, cv::Vec3f &colour) const override {
    colour = paper_;
    const double u = (x / width_ + 0.5 - 0.1) / 0.8;
    const double v = (y + 0.4 * height_) / line_;
    if (u < 0 || u >= 1 || v < 0)
      return true;
    const std::size_t cell = std::size_t(v) * std::size_t(columns_) +
                             std::size_t(u * columns_);
    const double within = v - std::floor(v);
    if (cell < ink_at_.size() && within > 0.25 && within < 0.75)
      colour += (ink_ - paper_) * ink_at_[cell];
    return true;
  }

 private:
  double width_, height_, line_;
  cv::Vec3f paper_, ink_;
  int columns_;
  std::vector<float> ink_at_;
};

class CodePaint : public Paint {
 public:
  explicit CodePaint(Code code) : code_(std::move(code)) {}
  bool at(double x, double y, double footprint,
          cv::Vec3f &colour) const override {
    const double half = code_.modules / 2.0;
    const double u = x / code_.module + half, v = y / code_.module + half;
    if (std::max(std::abs(u - half), std::abs(v - half)) >
        half + code_.margin)
      return false;
    colour = black(u, v) ? code_.ink : code_.paper;
    for (const Blot &blot : code_.blots) {
      const cv::Point2d away =
          cv::Point2d(x, y) / code_.module - blot.centre;
      //  Not a disc: a drop with lobes
      const double angle = std::atan2(away.y, away.x);
      const double lobes = 1 + 0.12 * std::sin(3 * angle + blot.radius * 40) +
                           0.08 * std::sin(7 * angle);
      if (cv::norm(away) < blot.radius * lobes)
        colour = blot.colour;
    }
    if (code_.creased) {
      const double across = (u - half) * std::cos(code_.crease_angle) +
                            (v - half) * std::sin(code_.crease_angle) -
                            code_.crease_at;
      if (std::abs(across) < 0.15)
        colour *= across > 0 ? 1.15f : 0.8f;
    }
    const double size = code_.grain.size;
    colour = colour.mul(
        code_.grain.texture->at(x / size, y / size, footprint / size));
    return true;
  }

 private:
  //  Ink spreads over the edges of what is white
  bool black(double u, double v) const {
    const double g = code_.gain;
    return ink(u, v) || (g > 0 && (ink(u - g, v) || ink(u + g, v) ||
                                   ink(u, v - g) || ink(u, v + g)));
  }
  bool ink(double u, double v) const {
    const int n = code_.modules;
    if (u < 0 || v < 0 || u >= n || v >= n)
      return false;
    return !code_.white[std::size_t(int(v) * n + int(u))];
  }

  Code code_;
};

}  // namespace

PaintPtr plain_paint(const cv::Vec3f &colour, const Floor &texture) {
  return std::make_shared<Plain>(colour, texture);
}

PaintPtr picture_paint(TexturePtr picture, double width, double height,
                       const cv::Vec3f &tint) {
  return std::make_shared<Picture>(std::move(picture), width, height, tint);
}

PaintPtr polygon_paint(std::vector<cv::Point2d> corners,
                       const cv::Vec3f &colour) {
  return std::make_shared<Polygon>(std::move(corners), colour);
}

PaintPtr stroke_paint(std::vector<cv::Point2d> points, double thickness,
                      const cv::Vec3f &colour) {
  return std::make_shared<Stroke>(std::move(points), thickness, colour);
}

PaintPtr board_paint(int columns, int rows, double size, double margin,
                     const cv::Vec3f &light, const cv::Vec3f &dark) {
  return std::make_shared<Board>(columns, rows, size, margin, light, dark);
}

PaintPtr frame_paint(double width, double height, double border,
                     const cv::Vec3f &colour) {
  return std::make_shared<Frame>(width, height, border, colour);
}

PaintPtr text_paint(double width, double height, double line,
                    const cv::Vec3f &paper, const cv::Vec3f &ink,
                    std::uint64_t seed) {
  return std::make_shared<Text>(width, height, line, paper, ink, seed);
}

PaintPtr code_paint(const Code &code) {
  return std::make_shared<CodePaint>(code);
}
