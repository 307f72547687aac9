// SPDX-License-Identifier: MIT
#include "on_cage.h"

#include "progress.h"

#include "cageproof/deformation/moved_inside.h"

#include <fmt/format.h>

namespace cageproof::cli {

void add_on(Command command, double& on) {
  command
      .option("--on", on,
              "points that lie outside by at most this share of the cage's size count as on it: they are moved there")
      .taking("TOLERANCE")
      .in_range(0.0, 1.0)
      .showing_default();
}

void take_onto_cage(double on, const CageCoordinates& coordinates, double size, std::vector<Vec3<double>>& points,
                    int jobs) {
  if (on == 0) return;
  deformation::MovedInside found = deformation::moved_inside(coordinates.elements(), points, on * size, jobs);
  const std::string way = found.count == 0 ? "" : fmt::format(", by at most {:.3g}", found.farthest);
  remark(fmt::format("{} of {} points lay outside by at most {:.3g} of the cage's size and were moved onto it{}",
                     found.count, points.size(), on, way));
  points = std::move(found.points);
}

}  // namespace cageproof::cli
