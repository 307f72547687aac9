// SPDX-License-Identifier: MIT
#include "command_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cageproof::cli {

std::string whole_description(const OptionText& option) {
  std::string text = option.description;
  if (!option.choices.empty()) text += fmt::format("; one of {}", fmt::join(option.choices, ", "));
  if (!option.preset.empty()) text += fmt::format("; default: {}", option.preset);
  if (option.required && !option.positional) text += "; required";
  if (!option.needs.empty()) text += fmt::format("; needs {}", fmt::join(option.needs, ", "));
  if (!option.excludes.empty()) text += fmt::format("; not with {}", fmt::join(option.excludes, ", "));
  return text;
}

std::vector<OptionGroup> groups_of(const std::vector<OptionText>& options) {
  std::vector<OptionGroup> groups;
  for (const OptionText& option : options) {
    if (option.positional) continue;
    auto group = std::ranges::find(groups, option.heading, &OptionGroup::heading);
    if (group == groups.end()) group = groups.insert(groups.end(), {option.heading, {}});
    group->options.push_back(option);
  }
  return groups;
}

std::string usage(const ProgramText& program, const CommandText& command) {
  std::string text = program.name + " " + command.name;
  for (const OptionText& option : command.options)
    if (option.positional) {
      const std::string name = option.names.front() + (option.repeats ? "..." : "");
      text += option.required ? " " + name : fmt::format(" [{}]", name);
    }
  for (const OptionText& option : command.options)
    if (option.required && !option.positional) text += fmt::format(" {} {}", option.names.front(), option.type);
  const bool others = std::ranges::any_of(
      command.options, [](const OptionText& option) { return !option.required && !option.positional; });
  return text + (others ? " [options]" : "");
}

}  // namespace cageproof::cli
