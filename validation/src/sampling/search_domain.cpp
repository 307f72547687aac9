// SPDX-License-Identifier: MIT
#include "sampling/search_domain.h"

#include "cageproof/validation/truth.h"
#include "element/element_sampling.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using WideVec = Vec3<Mp200>;

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
    if (k == n) break;
    largest = std::max(largest, v.cwiseAbs().maxCoeff());
    corners.push_back(convert<Mp200>(v));
  }
  const Mp200 size = longest_edge<Mp200>(corners);
  if (size < SearchDomain::smallest_size || size > SearchDomain::largest_size) return false;
  const double distance = sample.point.cwiseAbs().maxCoeff();
  if (largest > SearchDomain::largest_coordinate * size || distance > SearchDomain::largest_distance * size)
    return false;
  const Mp200 aspect = shape.aspect(corners);
  if (aspect < SearchDomain::smallest_aspect || !shape.valid(sample.corners)) return false;
  if (contact_of(formula.element, sample) == Contact::Border &&
      (aspect < SearchDomain::smallest_border_aspect ||
       std::max(largest, distance) > SearchDomain::largest_border_coordinate * size))
    return false;
  return true;
}

}  // namespace cageproof::validation
