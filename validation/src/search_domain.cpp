// SPDX-License-Identifier: MIT
#include "search_domain.h"

#include "cageproof/validation/truth.h"
#include "element/element_sampling.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using WideVec = Vec3<Mp200>;

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
  const SearchShape& shape = sampling_of(formula.element).search;
  const std::size_t n = sample.corners.size();
  if (static_cast<int>(n) != formula.corners() || !parameters_allowed(formula, sample)) return false;
  double largest = 0;
  std::vector<WideVec> corners;
  for (std::size_t k = 0; k <= n; ++k) {
    const Vec3<double>& v = k < n ? sample.corners[k] : sample.point;
    if (!v.allFinite()) return false;
    for (int c = formula.dim(); c < 3; ++c)
      if (v[c] != 0) return false;
    largest = std::max(largest, v.cwiseAbs().maxCoeff());
    if (k < n) corners.push_back(convert<Mp200>(v));
  }
  const WideVec point = convert<Mp200>(sample.point);
  const Mp200 longest = longest_edge<Mp200>(corners), size_squared = longest * longest;
  const double size = static_cast<double>(longest);
  if (size < SearchDomain::smallest_size || size > SearchDomain::largest_size) return false;
  if (largest > SearchDomain::largest_coordinate * size) return false;
  const Mp200 aspect = shape.aspect(corners);
  if (aspect < SearchDomain::smallest_aspect || !shape.valid(sample.corners)) return false;
  if (contact_of(formula.element, sample) == Contact::Border &&
      (aspect < SearchDomain::smallest_border_aspect || largest > SearchDomain::largest_border_coordinate * size))
    return false;
  for (std::size_t k = 0; k < n; ++k) {
    const WideVec to_corner = point - corners[k], edge = corners[(k + 1) % n] - corners[k];
    const Mp200 line = edge.cross(to_corner).squaredNorm() / edge.squaredNorm();
    if (!apart(to_corner.squaredNorm(), size_squared) || !apart(line, size_squared)) return false;
  }
  const Mp200 off_surface = sampling_of(formula.element).exact.off_surface(corners, point);
  return apart(off_surface * off_surface, size_squared);
}

}  // namespace cageproof::validation
