// SPDX-License-Identifier: MIT
// Texts that the command line prints about itself: help, its description as text, and errors in the words typed.
#pragma once

#include "command_text.h"

#include "cageproof/core/input_error.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
class ParseError;
}  // namespace CLI

namespace cageproof::cli {

/// Title of the lines of examples in help.
inline const std::string examples_title = "Examples:";

/// Help with defaults, choices and conditions in words.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// The description of all commands and options.
ProgramText text_of(const CLI::App& app);

/// The error for a command that does not exist: says which may have been meant, or lists all.
InputError unknown_command(std::string_view word, const std::vector<std::string>& known);

/// \throws InputError where the first argument is neither a command nor an option of the program, or missing
void refuse_unknown_command(const CLI::App& app, std::string_view first);

/// The error of a command line. A word that no option takes is named before a missing option, since the word is often
/// that option, misspelt. \param error that CLI11 threw
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error);

}  // namespace cageproof::cli
