// SPDX-License-Identifier: MIT
// Numbers as the command line takes them.
#pragma once

#include <limits>
#include <memory>
#include <string>

namespace cageproof::cli {

/// The range of an option of numbers, both ends included.
struct NumberBounds {
  bool whole = true;
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
  /// "a whole number from 1 to 100".
  std::string words() const;
};

/// Makes a number plain: 1e3 becomes 1000 where it must be whole, +2 becomes 2.
/// \return what is wrong with it, "'0x10' is not a whole number from 1 to 100"; empty: nothing
std::string make_plain(std::string& text, const NumberBounds& bounds);

/// The same of whole numbers from 0 to 2^64 - 1.
std::string make_plain_seed(std::string& text);

}  // namespace cageproof::cli
