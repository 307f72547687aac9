// SPDX-License-Identifier: MIT
// The option --judge: foreign code as one more evaluation of a command.
#pragma once

#include "command_line.h"

#include "cageproof/judge/foreign_code.h"

#include <memory>
#include <string>
#include <vector>

namespace cageproof::cli {

class JudgeOption {
 public:
  JudgeOption() = default;
  JudgeOption(const JudgeOption&) = delete;
  JudgeOption& operator=(const JudgeOption&) = delete;
  /// Ends the foreign processes, and reports on standard error their behaviour other than computing.
  ~JudgeOption();

  void add_to(Command command);
  bool is_given() const { return !given_.empty(); }
  /// Starts and registers what was given. \param formulas the command's own list of names and globs
  /// \throws InputError as ForeignCode and register_foreign_code
  void begin(const std::string& formulas);

 private:
  std::vector<std::string> given_;
  std::vector<std::pair<std::string, std::shared_ptr<judge::ForeignCode>>> codes_;
};

/// An incident of foreign code as one line of text, with kind, formula, sentence and input.
std::string text_of(const judge::Incident& incident);

}  // namespace cageproof::cli
