// SPDX-License-Identifier: MIT
// How long all coordinates of a point take.
#pragma once

#include "cageproof/core/coordinates.h"

#include <chrono>
#include <numeric>
#include <vector>

namespace cageproof::benchmarks {

/// Seconds a point, on this thread, from points spread over all of them: for at least `seconds`, but no more than
/// `most` of them. \param sink what is computed is added to it, since it must be used, or it may be left out \pre there
/// are points
inline double seconds_a_point(const CageCoordinates& coordinates, const std::vector<Vec3<double>>& points,
                              double seconds, std::size_t most, double& sink) {
  using Clock = std::chrono::steady_clock;
  // Tables that an evaluation builds at its first call are no part of its time.
  sink += coordinates.at<double>(points.front(), 0).front().value.front();
  std::size_t stride = static_cast<std::size_t>(0.618 * static_cast<double>(points.size())) | 1;
  while (std::gcd(stride, points.size()) != 1) ++stride;
  const auto start = Clock::now();
  double elapsed = 0;
  std::size_t done = 0;
  while (done == 0 || (done < most && elapsed < seconds)) {
    sink += coordinates.at<double>(points[done * stride % points.size()], 0).front().value.front();
    ++done;
    elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return elapsed / static_cast<double>(done);
}

}  // namespace cageproof::benchmarks
