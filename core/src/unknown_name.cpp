// SPDX-License-Identifier: MIT
#include "cageproof/core/unknown_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof {

InputError unknown_name(std::string_view what, std::string_view name, const std::vector<std::string_view>& known) {
  const std::string where = known.empty() ? "see `cageproof list`" : fmt::format("known: {}", fmt::join(known, ", "));
  return InputError(fmt::format("unknown {} '{}'; {}", what, name, where));
}

}  // namespace cageproof
