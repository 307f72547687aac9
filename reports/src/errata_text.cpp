// SPDX-License-Identifier: MIT
#include "errata_text.h"

#include "figure.h"

#include <fmt/format.h>

namespace cageproof::reports {

std::string printed_error_text(const ErratumRow& row) {
  if (row.nonfinite == 0) return short_error(row.printed_error);
  if (row.nonfinite == row.samples) return "not finite";
  return fmt::format("{}, not finite on {} of {}", short_error(row.printed_error), grouped(row.nonfinite),
                     grouped(row.samples));
}

}  // namespace cageproof::reports
