// SPDX-License-Identifier: MIT
#include "peers/peers.h"

#include "deformer_benchmarks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cageproof::benchmarks {
namespace {

// Largest difference of values over the largest value.
double difference(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& points,
                  const std::vector<double>& values) {
  const auto tables = coordinates.at<double>(std::span<const Vec3<double>>(points), 0);
  double worst = 0, largest = 0;
  auto found = values.begin();
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const auto& table : tables)
      for (std::size_t i = 0; i < table.stride[0]; ++i, ++found) {
        const double expected = table.tensors[0][p * table.stride[0] + i], apart = std::abs(*found - expected);
        largest = std::max(largest, std::abs(expected));
        worst = std::isfinite(apart) ? std::max(worst, apart) : HUGE_VAL;
      }
  return worst / largest;
}

// A form that is timed must compute what it is compared with. Sums of elements one by one are the reference.
TEST(Peers, compute_the_kind_they_are_timed_beside) {
  for (const char* cage : {"icosphere", "twisted-bar", "comb"}) {
    const DeformedCage in = embedded_deformed_cage(cage, 50);
    int tried = 0;
    for (const Peer& peer : peers()) {
      if (peer.dimension != in.cage.dimension()) continue;
      SCOPED_TRACE(std::string(cage) + ' ' + std::string(peer.kind) + ' ' + std::string(peer.name));
      const CageCoordinates coordinates(in.cage, coordinate_kind_named(peer.kind), CoordinateOptions{});
      std::size_t entries = 0;
      for (const CoordinateBlock& block : coordinates.blocks())
        entries += static_cast<std::size_t>(block.size) * block.entries();
      // Numbers that stand there before must not count.
      std::vector<double> values(in.points.size() * entries, 1e300);
      peer.prepare(coordinates.elements())(in.points, values);
      EXPECT_LT(difference(coordinates, in.points, values), 1e-9);
      ++tried;
    }
    EXPECT_EQ(tried, 3);
  }
}

}  // namespace
}  // namespace cageproof::benchmarks
