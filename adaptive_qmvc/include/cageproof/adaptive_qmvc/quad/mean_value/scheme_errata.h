// SPDX-License-Identifier: MIT
// The errata of [T18], measured on random valid quads.
#pragma once

#include "cageproof/core/results/run_result.h"

#include <vector>

namespace cageproof::adaptive_qmvc {

/// A misprint, and what measures it.
struct SchemeErratum {
  /// `evaluation` says what is compared, `regime` where; `formula` is empty where nothing is measured.
  ErratumRow row;
  /// Fills in samples, nonfinite and the errors, each relative to what is compared. Null where nothing is measured.
  void (*measure)(ErratumRow& row) = nullptr;
};

/// All of them, in the order of the paper's text.
const std::vector<SchemeErratum>& scheme_errata();

}  // namespace cageproof::adaptive_qmvc
