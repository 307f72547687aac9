// SPDX-License-Identifier: MIT
#include "completion.h"
#include "value_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cageproof::cli {
namespace {

constexpr const char* helpers = R"(# Offers words for what was typed so far.
_cageproof_words() {
  local candidate
  COMPREPLY=()
  while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen -W "$1" -- "$word")
}

# The same for the last name of a list between commas.
_cageproof_list() {
  local typed=$word kept= i
  if [[ $typed == *,* ]]; then kept=${typed%,*},; fi
  local word=${typed##*,}
  _cageproof_words "$1"
  for i in "${!COMPREPLY[@]}"; do COMPREPLY[i]=$kept${COMPREPLY[i]}; done
  compopt -o nospace 2>/dev/null
}

_cageproof_files() {
  local candidate
  while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen "$1" -- "$word")
  compopt -o filenames 2>/dev/null
}

)";

// Shell code that offers values of an option.
std::string offer(const OptionText& option) {
  if (!option.choices.empty()) return fmt::format("_cageproof_words '{}'", fmt::join(option.choices, " "));
  const std::vector<std::string> names = names_of_type(option.type);
  if (is_list_type(option.type)) return fmt::format("_cageproof_list '{}'", fmt::join(names, " "));
  std::string text;
  if (!names.empty()) text = fmt::format("_cageproof_words '{}'", fmt::join(names, " "));
  if (is_file_type(option.type)) text += std::string(text.empty() ? "" : "; ") + "_cageproof_files -f";
  if (is_folder_type(option.type)) text = "_cageproof_files -d";
  return text.empty() ? ":" : text;
}

std::string names_of(const std::vector<OptionText>& options) {
  std::vector<std::string> names;
  for (const OptionText& option : options)
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, " "));
}

void add_command(const CommandText& command, std::string& text) {
  text += fmt::format("    {})\n      case $option in\n", command.name);
  std::string positional = ":";
  for (const OptionText& option : command.options) {
    if (option.positional) positional = offer(option);
    if (option.positional || option.type.empty()) continue;
    text += fmt::format("        {}) {} ;;\n", fmt::join(option.names, " | "), offer(option));
  }
  text += fmt::format("        *)\n          if [[ $word == -* ]]; then _cageproof_words '{}'; else {}; fi ;;\n",
                      names_of(command.options), positional);
  text += "      esac ;;\n";
}

}  // namespace

std::string bash_completion(const ProgramText& program) {
  std::vector<std::string> commands;
  commands.reserve(program.commands.size());
  for (const CommandText& command : program.commands) commands.push_back(command.name);
  std::string text = "# bash completion of cageproof, made by `cageproof completion bash`.\n\n";
  text += helpers;
  text +=
      "_cageproof() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]} command= joined= i\n"
      "  # --option=value comes as three words, or as one where COMP_WORDBREAKS has no =.\n"
      "  if [[ $word == = ]]; then word=; elif [[ $option == = ]]; then option=${COMP_WORDS[COMP_CWORD - 2]}; fi\n"
      "  if [[ $word == --*=* ]]; then option=${word%%=*}; word=${word#*=}; joined=$option=; fi\n"
      "  COMPREPLY=()\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    if [[ ${COMP_WORDS[i]} != -* ]]; then command=${COMP_WORDS[i]}; break; fi\n"
      "  done\n"
      "  case $command in\n";
  text += fmt::format("    '') _cageproof_words '{} {}' ;;\n", fmt::join(commands, " "), names_of(program.options));
  for (const CommandText& command : program.commands) add_command(command, text);
  return text +
         "  esac\n"
         "  for i in \"${!COMPREPLY[@]}\"; do COMPREPLY[i]=$joined${COMPREPLY[i]}; done\n"
         "}\ncomplete -F _cageproof cageproof\n";
}

}  // namespace cageproof::cli
