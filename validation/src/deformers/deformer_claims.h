// SPDX-License-Identifier: MIT
// Claims of the papers about deformers that do not hold, and facts beyond what they say, measured.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <vector>

namespace cageproof::validation {

/// A claim, and the function that measures it.
struct DeformerClaim {
  /// `formula` is the deformer's name, `evaluation` its parameters, `regime` the cage; empty where nothing is measured.
  ErratumRow row;
  /// Fills in the errors, in cage sizes: printed_error is the distance of images from the claim, corrected_error from
  /// the corrected statement. Null where nothing is measured.
  void (*measure)(ErratumRow& row) = nullptr;
};

/// All claims, in the order of the papers.
const std::vector<DeformerClaim>& deformer_claims();

}  // namespace cageproof::validation
