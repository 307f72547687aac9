// SPDX-License-Identifier: MIT
#include "command_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

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
  OptionGroup arguments{"Arguments", {}}, others{"Options", {}};
  for (const OptionText& option : options) {
    OptionGroup* group = option.positional ? &arguments : &others;
    if (!option.positional && !option.heading.empty()) {
      others.heading = "Other options";
      auto found = std::ranges::find(groups, option.heading, &OptionGroup::heading);
      if (found == groups.end()) found = groups.insert(groups.end(), {option.heading, {}});
      group = &*found;
    }
    group->options.push_back(option);
  }
  if (!arguments.options.empty()) groups.insert(groups.begin(), std::move(arguments));
  if (!others.options.empty()) groups.push_back(std::move(others));
  return groups;
}

std::string usage(const ProgramText& program, const CommandText& command) {
  std::string text = program.name + " " + command.name;
  for (const OptionText& option : command.options)
    if (option.positional) {
      const std::string name = option.names.front() + (option.repeats ? "..." : "");
      text += option.required ? " " + name : fmt::format(" [{}]", name);
    }
  const auto with_value = [](const OptionText& option) {
    return option.names.front() + (option.type.empty() ? "" : " " + option.type);
  };
  for (const OptionGroup& group : groups_of(command.options)) {
    if (!group.options.front().alternative) continue;
    std::vector<std::string> choices;
    choices.reserve(group.options.size());
    for (const OptionText& option : group.options) choices.push_back(with_value(option));
    text += fmt::format(" ({})", fmt::join(choices, " | "));
  }
  for (const OptionText& option : command.options)
    if (option.required && !option.positional) text += " " + with_value(option);
  const bool others = std::ranges::any_of(command.options, [](const OptionText& option) {
    return !option.required && !option.positional && !option.alternative;
  });
  return text + (others ? " [options]" : "");
}

}  // namespace cageproof::cli
