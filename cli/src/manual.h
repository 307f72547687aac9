// SPDX-License-Identifier: MIT
// The manual, made of the command line's own description and of rules for all commands.
#pragma once

#include "command_text.h"

namespace cageproof::cli {

/// A section of the manual that holds for all commands, as names and numbers, exit codes, signals and files.
struct ManualSection {
  struct Item {
    std::string term, text;
  };
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<Item> items;  ///< after the paragraphs
};
const std::vector<ManualSection>& manual_sections();

/// cageproof.1, for man.
std::string manual_page(const ProgramText& program);

/// docs/command_line.md.
std::string manual_markdown(const ProgramText& program);

}  // namespace cageproof::cli
