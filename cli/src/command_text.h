// SPDX-License-Identifier: MIT
// The command line in words, as its own description has them: what help, manual and completion are made of.
#pragma once

#include <string>
#include <vector>

namespace cageproof::cli {

/// An option, or a positional argument.
struct OptionText {
  std::vector<std::string> names;    ///< "--regimes", "--regime"; of a positional its one name
  std::string type;                  ///< name of its value, "FOLDER"; empty: takes none
  std::string description;           ///< with range and choices
  std::string preset;                ///< the default; empty where none is said
  std::string heading;               ///< its heading in help; empty: none of its own
  std::vector<std::string> choices;  ///< all values that there are; empty: others too
  std::vector<std::string> needs, excludes;
  bool required = false, positional = false, repeats = false;
  bool alternative = false;  ///< exactly one of the options under its heading is required
};

struct CommandText {
  std::string name, description;
  std::vector<OptionText> options;    ///< positionals first
  std::vector<std::string> examples;  ///< command lines
};

struct ProgramText {
  std::string name, description, version;
  std::vector<OptionText> options;
  std::vector<CommandText> commands;
};

/// The description with all conditions: "; default: 1; required; not with --out".
std::string whole_description(const OptionText& option);

/// The options that stand under one heading, in their order.
struct OptionGroup {
  std::string heading;
  std::vector<OptionText> options;
};
/// Options by heading, in the order in which headings come first: positionals before all, under "Arguments", and what
/// has no heading after all, under "Options", or "Other options" where headings are.
std::vector<OptionGroup> groups_of(const std::vector<OptionText>& options);

/// "cageproof deform (--posed CAGE | --constraints FILE) --cage CAGE ... [options]".
std::string usage(const ProgramText& program, const CommandText& command);

}  // namespace cageproof::cli
