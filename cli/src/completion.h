// SPDX-License-Identifier: MIT
// Completion of the command line in shells, made of its own description.
#pragma once

#include "command_text.h"

namespace cageproof::cli {

/// Scripts for bash, zsh and fish. They hold all names: the program is not run while one types.
std::string bash_completion(const ProgramText& program);
std::string zsh_completion(const ProgramText& program);
std::string fish_completion(const ProgramText& program);

}  // namespace cageproof::cli
