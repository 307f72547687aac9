// SPDX-License-Identifier: MIT
// How long all coordinates of a point take.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <vector>

namespace cageproof::benchmarks {

/// Nanoseconds of each of some points, on this thread, spread over all of them: for at least `seconds`, but no more
/// than `most` of them. A point takes microseconds, the clock's resolution is some tens of nanoseconds. \param sink
/// what is computed is added to it, since it must be used, or it may be left out \pre there are points
inline std::vector<double> nanoseconds_of_points(const CageCoordinates& coordinates,
                                                 const std::vector<Vec3<double>>& points, double seconds,
                                                 std::size_t most, double& sink) {
  using Clock = std::chrono::steady_clock;
  // Tables that an evaluation builds at its first call are no part of its time.
  sink += coordinates.at<double>(points.front(), 0).front().value.front();
  std::size_t stride = static_cast<std::size_t>(0.618 * static_cast<double>(points.size())) | 1;
  while (std::gcd(stride, points.size()) != 1) ++stride;
  std::vector<double> found;
  found.reserve(std::min(most, points.size()));
  const auto start = Clock::now();
  auto last = start;
  do {
    sink += coordinates.at<double>(points[found.size() * stride % points.size()], 0).front().value.front();
    const auto now = Clock::now();
    found.push_back(std::chrono::duration<double, std::nano>(now - last).count());
    last = now;
  } while (found.size() < most && std::chrono::duration<double>(last - start).count() < seconds);
  return found;
}

/// Nanoseconds of each call for all points together; calls go on for at least `seconds`, and at least three times. \pre
/// points is not empty
inline std::vector<double> nanoseconds_of_batches(const CageCoordinates& coordinates,
                                                  const std::vector<Vec3<double>>& points, double seconds) {
  using Clock = std::chrono::steady_clock;
  std::vector<CoordinateTable<double>> tables;
  // Tables that an evaluation builds at its first call are no part of its time.
  coordinates.at(points, 0, tables);
  std::vector<double> found;
  const auto start = Clock::now();
  auto last = start;
  while (found.size() < 3 || std::chrono::duration<double>(last - start).count() < seconds) {
    coordinates.at(points, 0, tables);
    const auto now = Clock::now();
    found.push_back(std::chrono::duration<double, std::nano>(now - last).count());
    last = now;
  }
  return found;
}

}  // namespace cageproof::benchmarks
