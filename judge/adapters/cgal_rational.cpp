// SPDX-License-Identifier: MIT
// CGAL's Wachspress_coordinates_2 and Discrete_harmonic_coordinates_2 (docs/judged.md): a program of its own that
// rational_polygons.py asks, since CGAL's headers are under the GPL, and with them what is built of this file. Each
// line of input is the number of vertices, the vertices in order, and a point; each line of output their coordinates.
//   c++ -O2 -DNDEBUG cgal_rational.cpp -o cgal_rational -lgmp
//   ./cgal_rational wachspress|discrete_harmonic precise|fast
#include <CGAL/Barycentric_coordinates_2/Discrete_harmonic_coordinates_2.h>
#include <CGAL/Barycentric_coordinates_2/Wachspress_coordinates_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <string_view>
#include <vector>

namespace {

namespace bc = CGAL::Barycentric_coordinates;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = std::vector<Kernel::Point_2>;

template <class Coordinates>
void answer_lines(bc::Computation_policy_2 policy) {
  for (std::size_t count = 0; std::cin >> count;) {
    Polygon polygon;
    polygon.reserve(count);
    double x = 0, y = 0;
    for (std::size_t v = 0; v < count && std::cin >> x >> y; ++v) polygon.emplace_back(x, y);
    std::cin >> x >> y;
    std::vector<double> found;
    Coordinates(polygon, policy)(Kernel::Point_2(x, y), std::back_inserter(found));
    for (const double value : found) std::printf("%.17g ", value);
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto policy = std::string_view(argv[2]) == "fast" ? bc::Computation_policy_2::FAST_WITH_EDGE_CASES
                                                          : bc::Computation_policy_2::PRECISE_WITH_EDGE_CASES;
  if (std::string_view(argv[1]) == "wachspress") answer_lines<bc::Wachspress_coordinates_2<Polygon, Kernel>>(policy);
  else answer_lines<bc::Discrete_harmonic_coordinates_2<Polygon, Kernel>>(policy);
}
