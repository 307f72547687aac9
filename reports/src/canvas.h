// SPDX-License-Identifier: MIT
// A picture in memory, drawn by cairo.
#pragma once

#include <cairo.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// Red, green and blue from 0 to 1.
using Rgb = std::array<double, 3>;
/// Pixels from the upper left corner.
using Place = std::array<double, 2>;

class Canvas {
 public:
  /// White, or transparent. \throws std::runtime_error when there is no memory for it
  Canvas(int width, int height, bool transparent = false);

  void fill(std::span<const Place> polygon, const Rgb& colour);
  /// \param smooth whether borders are blended with what lies below; without, neighbours have no seam
  void set_smooth(bool smooth);
  void line(std::span<const Place> points, const Rgb& colour, double width);
  void dot(const Place& at, double radius, const Rgb& colour);
  /// With its tip at `at` + `along`.
  void arrow(const Place& at, const Place& along, const Rgb& colour, double width);
  enum class Weight { Normal, Bold };
  /// In the middle of a width that it is made smaller for, if need be.
  void text(double left, double baseline, double width, std::string_view words, double size, Weight weight,
            const Rgb& colour);
  /// Another picture, so many times larger, made smaller: each pixel the mean of those that it covers.
  void put(Canvas& other, double left, double top, int times);
  /// \throws std::runtime_error when cairo fails
  std::string png();

 private:
  struct Delete {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* pen) const { cairo_destroy(pen); }
  };
  void trace(std::span<const Place> points);

  std::unique_ptr<cairo_surface_t, Delete> surface_;
  std::unique_ptr<cairo_t, Delete> pen_;
};

}  // namespace cageproof::reports
