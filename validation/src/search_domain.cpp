// SPDX-License-Identifier: MIT
#include "search_domain.h"

#include "cageproof/validation/truth.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using Vec = Vec3<Mp200>;

// A distance, given squared, that is zero or large enough.
bool apart(const Mp200& squared, const Mp200& size_squared) {
  static const Mp200 least = Mp200(SearchDomain::smallest_distance) * SearchDomain::smallest_distance;
  return squared == 0 || squared >= least * size_squared;
}

bool parameters_allowed(const Formula& formula, const Sample& sample) {
  if (sample.parameters.size() != formula.parameters.size()) return false;
  for (std::size_t k = 0; k < sample.parameters.size(); ++k)
    if (!formula.parameters[k].allows(sample.parameters[k])) return false;
  return true;
}

}  // namespace

bool in_search_domain(const Formula& formula, const Sample& sample) {
  if (sample.corners.size() != 3 || !sample.point.allFinite() || !parameters_allowed(formula, sample)) return false;
  double largest = sample.point.cwiseAbs().maxCoeff();
  for (const auto& corner : sample.corners) {
    if (!corner.allFinite()) return false;
    largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  }
  std::array<Vec, 3> to_corner, edge;
  for (int i = 0; i < 3; ++i) {
    to_corner[i] = convert<Mp200>(sample.point) - convert<Mp200>(sample.corners[i]);
    edge[i] = convert<Mp200>(sample.corners[(i + 1) % 3]) - convert<Mp200>(sample.corners[i]);
  }
  const Mp200 size_squared = std::max({edge[0].squaredNorm(), edge[1].squaredNorm(), edge[2].squaredNorm()});
  const double size = static_cast<double>(Mp200(sqrt(size_squared)));
  if (size < SearchDomain::smallest_size || size > SearchDomain::largest_size) return false;
  if (largest > SearchDomain::largest_coordinate * size) return false;
  const Vec normal = edge[0].cross(edge[1]);
  const Mp200 normal_squared = normal.squaredNorm();
  const auto aspect_below = [&](double aspect) {
    const Mp200 area = size_squared * aspect;
    return normal_squared < area * area;
  };
  if (aspect_below(SearchDomain::smallest_aspect)) return false;
  if (contact_of(sample) == Contact::Border &&
      (aspect_below(SearchDomain::smallest_border_aspect) || largest > SearchDomain::largest_border_coordinate * size))
    return false;
  for (int i = 0; i < 3; ++i) {
    const Mp200 line = edge[i].cross(to_corner[i]).squaredNorm() / edge[i].squaredNorm();
    if (!apart(to_corner[i].squaredNorm(), size_squared) || !apart(line, size_squared)) return false;
  }
  const Mp200 height = normal.dot(to_corner[0]);
  return apart(height * height / normal_squared, size_squared);
}

}  // namespace cageproof::validation
