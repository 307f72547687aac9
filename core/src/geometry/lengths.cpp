// SPDX-License-Identifier: MIT
#include "lengths.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace cageproof {

int compare_lengths(const Segment<double>& a, const Segment<double>& b) {
  using Filtered = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Vec3<double>& v) { return Filtered::Point_3(v[0], v[1], v[2]); };
  return static_cast<int>(
      Filtered().compare_squared_distance_3_object()(point(a[0]), point(a[1]), point(b[0]), point(b[1])));
}

}  // namespace cageproof
