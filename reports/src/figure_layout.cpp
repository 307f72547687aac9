// SPDX-License-Identifier: MIT
// Places and scales of a figure's panels.
#include "figure_layout.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cageproof::reports {
namespace {

using Box = Eigen::AlignedBox2d;

Eigen::Vector2d projected(const ViewAxes& axes, const Vec3<double>& point) {
  return {axes.right.dot(point), axes.up.dot(point)};
}

void extend(Box& box, const ViewAxes& axes, const std::vector<Vec3<double>>& points) {
  for (const Vec3<double>& point : points) box.extend(projected(axes, point));
}

// The box of the cage, or of the whole panel where it has no cage.
Box cage_box(const FigurePanel& panel, const ViewAxes& axes) {
  Box box;
  extend(box, axes, panel.cage.empty() ? panel.data.vertices : panel.cage);
  if (box.isEmpty()) throw std::invalid_argument("a panel without points: " + panel.title);
  return box;
}

Box whole_box(const FigurePanel& panel, const ViewAxes& axes) {
  Box box = cage_box(panel, axes);
  extend(box, axes, panel.data.vertices);
  extend(box, axes, panel.marks);
  return box;
}

}  // namespace

ViewAxes axes_of(const FigureView& view) {
  ViewAxes axes;
  axes.towards = view.towards.normalized();
  axes.right = view.up.cross(axes.towards).normalized();
  axes.up = axes.towards.cross(axes.right);
  return axes;
}

std::array<double, 2> FigureFrame::at(const Vec3<double>& p) const {
  std::array<double, 2> place{};
  for (std::size_t c = 0; c < 2; ++c) place[c] = origin[c] + p[0] * x[c] + p[1] * y[c] + p[2] * z[c];
  return place;
}

FigureLayout layout_of(const FigureSheet& sheet) {
  if (sheet.panels.empty() || sheet.columns < 1) throw std::invalid_argument("a figure without panels");
  // Images may reach beyond their cage by so much before their panel is drawn smaller than others.
  constexpr double beyond = 1.3;
  constexpr double margin = 10, gap = 8, most_height = 380, least_height = 90;
  const ViewAxes axes = axes_of(sheet.view);
  Eigen::Array2d cages(0, 0), wholes(0, 0);
  for (const FigurePanel& panel : sheet.panels) {
    cages = cages.max(cage_box(panel, axes).sizes().array());
    wholes = wholes.max(whole_box(panel, axes).sizes().array());
  }
  Eigen::Array2d room = wholes.min(beyond * cages);
  if ((room == 0).all()) room.setOnes();  // points at one place, which have no scale
  const int columns = std::min<int>(sheet.columns, static_cast<int>(sheet.panels.size()));
  const double width = std::floor((1360.0 - 2 * margin - (columns - 1) * gap) / std::max(columns, 3));
  const double height = std::floor(std::clamp(width * room[1] / room[0], least_height, most_height));
  constexpr double inset = 8;  // of lines and dots at the panel's border
  const double scale = std::min((width - 2 * inset) / room[0], (height - 2 * inset) / room[1]);
  FigureLayout layout{};
  layout.width = static_cast<int>(2 * margin + columns * width + (columns - 1) * gap);
  for (std::size_t i = 0; i < sheet.panels.size(); ++i) {
    const int number = static_cast<int>(i), row = number / columns, column = number % columns;
    const Box box = whole_box(sheet.panels[i], axes);
    FigureFrame frame{};
    frame.left = margin + column * (width + gap);
    frame.top = margin + row * (height + title_height + gap) + title_height;
    frame.width = width;
    frame.height = height;
    frame.share = std::min(
        {1.0, (width - 2 * inset) / (scale * box.sizes()[0]), (height - 2 * inset) / (scale * box.sizes()[1])});
    // A share of one up to rounding fits.
    if (frame.share > 1 - 1e-9) frame.share = 1;
    frame.scale = scale * frame.share;
    const auto step = [&](const Vec3<double>& axis) {
      return std::array<double, 2>{frame.scale * axes.right.dot(axis), -frame.scale * axes.up.dot(axis)};
    };
    frame.x = step(Vec3<double>::UnitX());
    frame.y = step(Vec3<double>::UnitY());
    frame.z = step(Vec3<double>::UnitZ());
    frame.origin = {frame.left + width / 2 - frame.scale * box.center()[0],
                    frame.top + height / 2 + frame.scale * box.center()[1]};
    layout.frames.push_back(frame);
  }
  const int rows = (static_cast<int>(sheet.panels.size()) + columns - 1) / columns;
  layout.height = static_cast<int>(2 * margin + rows * (height + title_height) + (rows - 1) * gap);
  return layout;
}

}  // namespace cageproof::reports
