// SPDX-License-Identifier: MIT
#include "cageproof/validation/sample.h"

namespace cageproof::validation {

Sample rounded_to(ScalarKind scalar, Sample sample) {
  if (scalar != ScalarKind::Float) return sample;
  const auto round = [](double& x) { x = static_cast<double>(static_cast<float>(x)); };
  for (auto& corner : sample.corners)
    for (int c = 0; c < 3; ++c) round(corner[c]);
  for (int c = 0; c < 3; ++c) round(sample.point[c]);
  for (double& p : sample.parameters) round(p);
  return sample;
}

}  // namespace cageproof::validation
