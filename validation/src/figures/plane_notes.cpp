// SPDX-License-Identifier: MIT
#include "plane_notes.h"

#include "plane_measures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cageproof::validation {
namespace {

// A part of the cage's size, small ones with one digit.
std::string part(double share) { return share < 1e-3 ? fmt::format("{:.1g}", share) : fmt::format("{:.3f}", share); }

}  // namespace

std::vector<Vec3<double>> angle_points(const DeformedPlan& plan) {
  std::vector<Vec3<double>> points;
  for (const AnglePlaces& places : plan.angles) points.insert(points.end(), places.points.begin(), places.points.end());
  return points;
}

void add_plane_measures(const DeformedPlan& plan, const PanelPlan& shown, const PlaneFindings& found,
                        reports::FigurePanel& panel) {
  const double size = plan.cage->size();
  const std::vector<Vec3<double>>&rest = plan.mesh.mesh.vertices, &images = panel.data.vertices;
  std::vector<std::string> notes;
  // Where nothing else is to be seen.
  if (!found.derivatives && !found.compared && plan.watched.empty())
    notes.push_back(fmt::format("area × {:.3f}", panel.measured.front().second));
  const auto add = [&](const std::string& name, double value, const std::string& note) {
    panel.measured.emplace_back(name, value);
    if (!note.empty()) notes.push_back(note);
  };
  if (!panel.cage.empty())
    if (const auto miss = miss_of_cage(*plan.cage, panel.cage, rest, images))
      add("largest distance of the border from the posed cage over cage size", *miss / size,
          *miss < 1e-5 * size ? "meets the cage" : fmt::format("misses the cage by {}", part(*miss / size)));
  const double folded = folded_share(panel.data.faces, images);
  add("share of triangles turned over", folded, folded > 0 ? fmt::format("{:.1f} % folded", 100 * folded) : "");
  if (found.derivatives) {
    std::size_t at = 0;
    std::vector<std::string> means;
    for (const AnglePlaces& places : plan.angles) {
      double sum = 0;
      for (std::size_t p = 0; p < places.points.size(); ++p, at += 2)
        sum += angle_change(found.derivatives->at(at), found.derivatives->at(at + 1));
      const double mean = sum / static_cast<double>(places.points.size());
      add(fmt::format("mean change of angles {}, in degrees", places.where), mean, "");
      means.push_back(fmt::format("{:.1f}°", mean));
    }
    notes.push_back(fmt::format("angles off by {}", fmt::join(means, " and ")));
  }
  if (!plan.watched.empty()) {
    double moved = 0;
    for (const int vertex : plan.watched_vertices) moved = std::max(moved, (images[vertex] - rest[vertex]).norm());
    add(fmt::format("largest displacement of {} over cage size", plan.watched), moved / size,
        fmt::format("{} moved by {}", plan.watched, part(moved / size)));
  }
  if (found.compared) {
    double largest = 0;
    for (std::size_t p = 0; p < images.size(); ++p)
      largest = std::max(largest, (images[p] - found.compared->at(p)).norm());
    add(fmt::format("largest distance from {} over cage size", shown.compared_with), largest / size,
        fmt::format("{:.1e} from {}", largest / size, shown.compared_with));
  }
  panel.note = fmt::format("{}", fmt::join(notes, ", "));
}

}  // namespace cageproof::validation
