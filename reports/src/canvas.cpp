// SPDX-License-Identifier: MIT
#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cageproof::reports {
namespace {

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cannot draw a picture: ") + cairo_status_to_string(status));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

Canvas::Canvas(int width, int height, bool transparent)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)), pen_(cairo_create(surface_.get())) {
  check(cairo_surface_status(surface_.get()));
  check(cairo_status(pen_.get()));
  cairo_set_line_join(pen_.get(), CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(pen_.get(), CAIRO_LINE_CAP_ROUND);
  if (transparent) return;
  cairo_set_source_rgb(pen_.get(), 1, 1, 1);
  cairo_paint(pen_.get());
}

void Canvas::trace(std::span<const Place> points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    (i == 0 ? cairo_move_to : cairo_line_to)(pen_.get(), points[i][0], points[i][1]);
}

void Canvas::fill(std::span<const Place> polygon, const Rgb& colour) {
  trace(polygon);
  cairo_close_path(pen_.get());
  cairo_set_source_rgb(pen_.get(), colour[0], colour[1], colour[2]);
  cairo_fill(pen_.get());
}

void Canvas::set_smooth(bool smooth) {
  cairo_set_antialias(pen_.get(), smooth ? CAIRO_ANTIALIAS_DEFAULT : CAIRO_ANTIALIAS_NONE);
}

void Canvas::line(std::span<const Place> points, const Rgb& colour, double width) {
  trace(points);
  cairo_set_source_rgb(pen_.get(), colour[0], colour[1], colour[2]);
  cairo_set_line_width(pen_.get(), width);
  cairo_stroke(pen_.get());
}

void Canvas::dot(const Place& at, double radius, const Rgb& colour) {
  cairo_new_sub_path(pen_.get());
  cairo_arc(pen_.get(), at[0], at[1], radius, 0, 2 * std::numbers::pi);
  cairo_set_source_rgb(pen_.get(), colour[0], colour[1], colour[2]);
  cairo_fill(pen_.get());
}

void Canvas::arrow(const Place& at, const Place& along, const Rgb& colour, double width) {
  constexpr double head = 0.42, half = 0.17;  // of its length
  const Place tip{at[0] + along[0], at[1] + along[1]};
  const Place neck{tip[0] - head * along[0], tip[1] - head * along[1]};
  line(std::array{at, neck}, colour, width);
  fill(std::array{tip, Place{neck[0] - half * along[1], neck[1] + half * along[0]},
                  Place{neck[0] + half * along[1], neck[1] - half * along[0]}},
       colour);
}

void Canvas::text(double left, double baseline, double width, std::string_view words, double size, Weight weight,
                  const Rgb& colour) {
  const std::string line(words);
  cairo_select_font_face(pen_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         weight == Weight::Bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_text_extents_t extents;
  cairo_set_font_size(pen_.get(), size);
  cairo_text_extents(pen_.get(), line.c_str(), &extents);
  if (extents.x_advance > width) {
    cairo_set_font_size(pen_.get(), size * width / extents.x_advance);
    cairo_text_extents(pen_.get(), line.c_str(), &extents);
  }
  cairo_set_source_rgb(pen_.get(), colour[0], colour[1], colour[2]);
  cairo_move_to(pen_.get(), left + (width - extents.x_advance) / 2, baseline);
  cairo_show_text(pen_.get(), line.c_str());
}

void Canvas::put(Canvas& other, double left, double top, int times) {
  cairo_save(pen_.get());
  cairo_translate(pen_.get(), left, top);
  cairo_scale(pen_.get(), 1.0 / times, 1.0 / times);
  cairo_set_source_surface(pen_.get(), other.surface_.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(pen_.get()), CAIRO_FILTER_GOOD);
  cairo_paint(pen_.get());
  cairo_restore(pen_.get());
}

std::string Canvas::png() {
  check(cairo_status(pen_.get()));
  cairo_surface_flush(surface_.get());
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface_.get(), append, &bytes));
  return bytes;
}

}  // namespace cageproof::reports
