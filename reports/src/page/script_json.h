// SPDX-License-Identifier: MIT
#pragma once

#include "json_value.h"

#include <string>

namespace cageproof::reports {

/// JSON as the text of a script element: nothing in it ends the element, whatever names and reasons hold.
inline std::string script_json(const Json& json) {
  std::string text = dump(json), safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') safe += "\\u003c";
    else safe += c;
  }
  return safe;
}

}  // namespace cageproof::reports
