// SPDX-License-Identifier: MIT
// Plan of a verification's measurements, made only from its options.
#pragma once

#include "cageproof/reports/journal.h"
#include "cageproof/validation/measurement.h"
#include "cageproof/validation/verify.h"

namespace cageproof::validation {

struct RunPlan {
  Measurements measurements;
  std::vector<Unit> units;
  reports::JournalHeader header;
  std::vector<std::string> warnings;  ///< of its notes those that whoever runs it should see at once
  std::size_t points_outside = 0;     ///< of those to try the cage at
};

/// \throws InputError for patterns that match nothing, and stored cases that can no longer be run
RunPlan plan_run(const VerifyOptions& options);

}  // namespace cageproof::validation
