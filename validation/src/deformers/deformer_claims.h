// SPDX-License-Identifier: MIT
// What the papers say of deformers and is not so, or is more than they say, measured.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <vector>

namespace cageproof::validation {

/// A claim, and what measures it.
struct DeformerClaim {
  /// `formula` is the deformer's name, `evaluation` its parameters, `regime` the cage; empty where nothing is measured.
  ErratumRow row;
  /// Fills in the errors, in cage sizes: printed_error how far images are from what is claimed, corrected_error from
  /// what is so. Null where nothing is measured.
  void (*measure)(ErratumRow& row) = nullptr;
};

/// All claims, in the order of the papers.
const std::vector<DeformerClaim>& deformer_claims();

}  // namespace cageproof::validation
