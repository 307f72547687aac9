// SPDX-License-Identifier: MIT
// Completion in zsh and fish.
#include "completion.h"
#include "value_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof::cli {
namespace {

// Puts a text between single quotes; the shell function that reads it gives the characters `escaped` a meaning.
std::string quoted(const std::string& text, std::string_view escaped, std::string_view quote) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += quote;
      continue;
    }
    if (escaped.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result + "'";
}

std::string zsh_quoted(const std::string& text) { return quoted(text, "[]:\\", "'\\''"); }
std::string fish_quoted(const std::string& text) { return quoted(text, "\\", "\\'"); }

std::string words(const OptionText& option) {
  return fmt::format("{}", fmt::join(option.choices.empty() ? names_of_type(option.type) : option.choices, " "));
}

std::string zsh_action(const OptionText& option) {
  const std::string names = words(option);
  if (is_list_type(option.type)) return "_sequence compadd - " + names;
  if (is_folder_type(option.type)) return "_files -/";
  if (is_file_type(option.type))
    return names.empty() ? "_files" : "_alternative \"names:name:(" + names + ")\" \"files:file:_files\"";
  return names.empty() ? " " : "(" + names + ")";
}

// 'NAME[what it is]:VALUE:what it may be'.
std::string zsh_argument(const OptionText& option, const std::string& name) {
  const std::string value = option.type.empty() ? "" : fmt::format(":{}:{}", option.type, zsh_action(option));
  if (option.positional) return quoted(fmt::format("*:{}:{}", option.type, zsh_action(option)), "", "'\\''");
  const std::string described = zsh_quoted(option.description);
  return fmt::format("'{}{}[{}]'{}", option.repeats ? "*" : "", name, described.substr(1, described.size() - 2),
                     value.empty() ? "" : quoted(value, "", "'\\''"));
}

std::string fish_values(const OptionText& option) {
  const std::string names = words(option);
  if (option.type.empty()) return "";
  if (is_list_type(option.type)) return fmt::format(" -x -a \"(__fish_append , {})\"", names);
  if (is_folder_type(option.type)) return " -x -a \"(__fish_complete_directories)\"";
  if (is_file_type(option.type)) return names.empty() ? " -r -F" : fmt::format(" -r -F -a \"{}\"", names);
  return names.empty() ? " -x" : fmt::format(" -x -a \"{}\"", names);
}

}  // namespace

std::string zsh_completion(const ProgramText& program) {
  std::string text =
      "#compdef cageproof\n# zsh completion of cageproof, made by `cageproof completion zsh`.\n\n"
      "_cageproof() {\n  local state line\n  local -a commands\n  commands=(\n";
  for (const CommandText& command : program.commands)
    text += fmt::format("    {}\n", quoted(fmt::format("{}:{}", command.name, command.description), "", "'\\''"));
  text += "  )\n  _arguments -C";
  for (const OptionText& option : program.options)
    for (const std::string& name : option.names) text += " " + zsh_argument(option, name);
  text +=
      " '1:command:->command' '*::argument:->arguments'\n"
      "  case $state in\n"
      "    command) _describe command commands ;;\n"
      "    arguments)\n      case $words[1] in\n";
  for (const CommandText& command : program.commands) {
    text += fmt::format("        {})\n          _arguments", command.name);
    for (const OptionText& option : command.options)
      for (const std::string& name : option.names) text += " \\\n            " + zsh_argument(option, name);
    text += " ;;\n";
  }
  return text + "      esac ;;\n  esac\n}\n\n_cageproof \"$@\"\n";
}

std::string fish_completion(const ProgramText& program) {
  std::string text =
      "# fish completion of cageproof, made by `cageproof completion fish`.\n\ncomplete -c cageproof -f\n";
  const auto add = [&](const std::string& condition, const OptionText& option) {
    if (option.positional) {
      text += fmt::format("complete -c cageproof -n '{}'{}\n", condition, fish_values(option));
      return;
    }
    text += fmt::format("complete -c cageproof -n '{}'", condition);
    for (const std::string& name : option.names)
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    text += fish_values(option) + " -d " + fish_quoted(option.description) + "\n";
  };
  for (const CommandText& command : program.commands)
    text += fmt::format("complete -c cageproof -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        fish_quoted(command.description));
  for (const OptionText& option : program.options) add("__fish_use_subcommand", option);
  for (const CommandText& command : program.commands)
    for (const OptionText& option : command.options) add("__fish_seen_subcommand_from " + command.name, option);
  return text;
}

}  // namespace cageproof::cli
