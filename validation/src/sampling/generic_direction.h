// SPDX-License-Identifier: MIT
// A direction that no symmetry of an element or a cage knows, to take derivatives along.
#pragma once

#include "cageproof/core/numbers/mp.h"
#include "cageproof/core/numbers/random_stream.h"

#include <bit>
#include <cmath>
#include <vector>

namespace cageproof::validation {

/// A unit vector, drawn by the point's first coordinate. Each of its components is at least a sixth.
template <Scalar R>
Vec3<R> generic_direction(const Vec3<double>& point, int dim) {
  using std::sqrt;
  RandomStream random(0, "direction", std::bit_cast<std::uint64_t>(point[0]));
  Vec3<R> direction = Vec3<R>::Zero();
  for (int c = 0; c < dim; ++c) direction[c] = R((random.uniform() < 0.5 ? -1 : 1) * random.uniform(0.3, 1));
  return direction / sqrt(R(direction.dot(direction)));
}

/// The derivatives along a direction, of a tensor whose last index is that of a derivative.
template <Scalar R>
std::vector<R> along(const Vec3<R>& direction, const std::vector<R>& tensor, int dim) {
  std::vector<R> contracted(tensor.size() / static_cast<std::size_t>(dim), R(0));
  for (std::size_t i = 0; i < tensor.size(); ++i)
    contracted[i / static_cast<std::size_t>(dim)] += direction[static_cast<Eigen::Index>(i) % dim] * tensor[i];
  return contracted;
}

}  // namespace cageproof::validation
