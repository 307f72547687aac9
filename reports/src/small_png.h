// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// The same picture with at most `colours` (2 ... 256) colours and a palette: a quarter of the bytes.
/// Nothing when the bytes are no whole PNG.
std::optional<std::string> small_png(std::string_view bytes, int colours);

}  // namespace cageproof::reports
