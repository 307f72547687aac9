// SPDX-License-Identifier: MIT
#include "cageproof/validation/sample.h"

#include <algorithm>

namespace cageproof::validation {

Sample rounded_to(ScalarKind scalar, Sample sample) {
  if (scalar != ScalarKind::Float) return sample;
  const auto round = [](double& x) {
    // GCC 12 drops the rounding when it vectorises a pair of such conversions; volatile keeps it.
    volatile float rounded = static_cast<float>(x);
    x = rounded;
  };
  for (auto& corner : sample.corners)
    for (int c = 0; c < 3; ++c) round(corner[c]);
  for (int c = 0; c < 3; ++c) round(sample.point[c]);
  for (double& p : sample.parameters) round(p);
  return sample;
}

bool is_finite(const Sample& sample) {
  return sample.point.allFinite() && std::ranges::all_of(sample.corners, [](const auto& v) { return v.allFinite(); });
}

}  // namespace cageproof::validation
