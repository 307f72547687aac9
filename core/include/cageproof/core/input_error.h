// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace cageproof {

/// Bad input or usage: its message is one line that names the file, line or face and the reason. The command line
/// prints it and exits with 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cageproof
