// SPDX-License-Identifier: MIT
// Writes and reads lines of the protocol of `cageproof eval`: questions to a program, and its answers.
#pragma once

#include "reach/worker.h"

#include <string>
#include <string_view>

namespace cageproof::judge {

/// The line that asks a program which formulas it has.
inline constexpr const char* describe_line = "{\"describe\":true}\n";

/// The line of one point, or of a cage and all its points, with its end; numbers are the shortest decimals that read
/// back exactly.
void add_line(std::string& text, const Request& request, const Asked& asked, std::size_t point);

/// One line of answer.
struct LineAnswer {
  enum class Kind { Given, Error, Short, Garbage } kind = Kind::Garbage;
  std::string text;                            ///< what is wrong, or the program's own error
  std::array<std::vector<double>, 3> tensors;  ///< where given
};
LineAnswer parse_answer(std::string_view line, const Request& request, const Asked& asked);

/// The description in a line, {"formulas":{"NAME":ORDER,...},"about":"..."}; nothing known where it is none.
Description parse_description(std::string_view line);

}  // namespace cageproof::judge
