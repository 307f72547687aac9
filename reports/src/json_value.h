// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace cageproof::reports {

using Json = nlohmann::ordered_json;

/// A number as JSON; numbers that JSON lacks become the strings "nan", "inf" or "-inf".
inline Json json_number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "inf" : "-inf";
  return x;
}

/// The inverse of json_number; nothing for anything else.
inline std::optional<double> number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (json == "nan") return std::nan("");
  if (json == "inf") return HUGE_VAL;
  if (json == "-inf") return -HUGE_VAL;
  return std::nullopt;
}

/// Text as JSON text: bytes that are no UTF-8 (a file name may hold any) become the replacement character.
inline std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace cageproof::reports
