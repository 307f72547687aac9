// SPDX-License-Identifier: MIT
// Figures drawn: faces by depth, edges, arrows and titles.
#include "figure_faces.h"
#include "small_png.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace cageproof::reports {
namespace {

constexpr Rgb kCage{0.10, 0.22, 0.48}, kCageBehind{0.66, 0.72, 0.84}, kGrid{0.80, 0.52, 0.20}, kMark{0.80, 0.10, 0.12};
constexpr Rgb kTitle{0.10, 0.10, 0.12}, kNote{0.38, 0.38, 0.42};

std::vector<Place> places_of(const FigureFrame& frame, const std::vector<Vec3<double>>& points) {
  std::vector<Place> places;
  places.reserve(points.size());
  for (const Vec3<double>& point : points) places.push_back(frame.at(point));
  return places;
}

// Each edge once, and whether one of its faces is seen from its outer side.
std::map<std::pair<int, int>, bool> edges_of(const FigurePanel& panel, const ViewAxes& axes) {
  std::map<std::pair<int, int>, bool> edges;
  for (const auto& face : panel.cage_faces) {
    const bool outer = face.size() < 3 || area_of(panel.cage, face).dot(axes.towards) > 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (face.size() == 2 && k == 1) break;
      bool& seen = edges[std::minmax(face[k], face[(k + 1) % face.size()])];
      seen = seen || outer;
    }
  }
  return edges;
}

void draw_cage(const FigurePanel& panel, const FigureFrame& frame, const ViewAxes& axes, bool near, Canvas& canvas) {
  const std::vector<Place> places = places_of(frame, panel.cage);
  std::vector<char> shown(places.size());
  // Many edges would hide the picture behind them, so they are drawn thinner.
  const bool many = panel.cage_faces.size() > 40 && !panel.flat;
  for (const auto& [edge, seen] : edges_of(panel, axes)) {
    if (seen != near) continue;
    canvas.line(std::array{places[edge.first], places[edge.second]}, near ? kCage : kCageBehind,
                many   ? 0.8
                : near ? 1.3
                       : 1.0);
    shown[edge.first] = shown[edge.second] = 1;
  }
  for (std::size_t v = 0; v < places.size(); ++v)
    if (shown[v] && near && !many) canvas.dot(places[v], 2.3, kCage);
}

void draw_grid(const FigurePanel& panel, const FigureFrame& frame, Canvas& canvas) {
  const std::vector<Place> places = places_of(frame, panel.data.vertices);
  std::map<std::pair<int, int>, int> edges;
  for (const auto& face : panel.data.faces)
    for (std::size_t k = 0; k < face.size(); ++k) ++edges[std::minmax(face[k], face[(k + 1) % face.size()])];
  for (std::size_t f = 0; f < panel.data.faces.size(); ++f) {
    if (panel.tones.empty() || !panel.tones[f]) continue;
    std::vector<Place> corners;
    for (const int v : panel.data.faces[f]) corners.push_back(places[v]);
    canvas.fill(corners, kLightFace);
  }
  for (const auto& [edge, faces] : edges)
    canvas.line(std::array{places[edge.first], places[edge.second]}, kGrid, faces == 1 ? 1.3 : 0.6);
}

// From dark blue over green to yellow, evenly to the eye.
Rgb strength_colour(double strength) {
  constexpr std::array<Rgb, 5> colours{
      {{0.27, 0.00, 0.33}, {0.23, 0.32, 0.55}, {0.13, 0.57, 0.55}, {0.37, 0.79, 0.38}, {0.93, 0.80, 0.10}}};
  const double place = std::clamp(strength, 0.0, 1.0) * (colours.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const double part = place - static_cast<double>(first);
  Rgb found{};
  for (std::size_t c = 0; c < 3; ++c) found[c] = (1 - part) * colours[first][c] + part * colours[first + 1][c];
  return found;
}

void draw_arrows(const FigurePanel& panel, const FigureFrame& frame, Canvas& canvas) {
  constexpr double length = 11;
  for (const FigureArrow& arrow : panel.arrows) {
    const Place at = frame.at(arrow.at), end = frame.at(arrow.at + arrow.along);
    const double whole = std::hypot(end[0] - at[0], end[1] - at[1]);
    if (!(whole > 0)) continue;
    const Place along{(end[0] - at[0]) * length / whole, (end[1] - at[1]) * length / whole};
    canvas.arrow({at[0] - along[0] / 2, at[1] - along[1] / 2}, along, strength_colour(arrow.strength), 1.3);
  }
}

void draw_panel(const FigurePanel& panel, const FigureFrame& frame, const ViewAxes& axes, Canvas& canvas) {
  if (!panel.flat) draw_cage(panel, frame, axes, false, canvas);
  if (panel.with_faces) panel.flat ? draw_grid(panel, frame, canvas) : draw_faces(panel, frame, axes, canvas);
  draw_arrows(panel, frame, canvas);
  const std::vector<Place> places = places_of(frame, panel.data.vertices);
  for (const auto& [from, to] : panel.data.segments) canvas.line(std::array{places[from], places[to]}, kMark, 1.4);
  draw_cage(panel, frame, axes, true, canvas);
  for (const Vec3<double>& mark : panel.marks) canvas.dot(frame.at(mark), 4, kMark);
  canvas.text(frame.left, frame.top - 22, frame.width, panel.title, 13, Canvas::Weight::Bold, kTitle);
  std::string note = panel.note;
  if (frame.share < 1) note += fmt::format("{}drawn {:.2g} times as large", note.empty() ? "" : "; ", frame.share);
  canvas.text(frame.left, frame.top - 7, frame.width, note, 11, Canvas::Weight::Normal, kNote);
}

}  // namespace

std::string figure_png(const FigureSheet& sheet) {
  const FigureLayout layout = layout_of(sheet);
  const ViewAxes axes = axes_of(sheet.view);
  Canvas canvas(layout.width, layout.height);
  for (std::size_t i = 0; i < sheet.panels.size(); ++i) draw_panel(sheet.panels[i], layout.frames[i], axes, canvas);
  constexpr int colours = 256;
  const auto small = small_png(canvas.png(), colours);
  if (!small) throw std::runtime_error("cairo made a picture that is not whole");
  return *small;
}

}  // namespace cageproof::reports
