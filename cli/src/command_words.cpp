// SPDX-License-Identifier: MIT
#include "command_words.h"

#include "cageproof/core/catalogue/field_words.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

namespace cageproof::cli {
namespace {

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  text.positional = option.get_positional();
  if (text.positional) text.names.push_back(option.get_name(true, false));
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  text.description = option.get_description();
  // CLI11's own name of the group of options without a heading.
  if (option.get_group() != "Options") text.heading = option.get_group();
  text.repeats = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  text.required = option.get_required();
  text.preset = option.get_default_str();
  if (option.get_items_expected_max() > 0) {
    text.type = option.get_type_name();
    if (text.type.find('|') != std::string::npos) {
      text.choices = CLI::detail::split(text.type, '|');
      text.type = "WORD";
    }
  }
  const auto names_of = [](const auto& options) {
    std::vector<std::string> names;
    names.reserve(options.size());
    for (const CLI::Option* other : options) names.push_back(other->get_name());
    std::ranges::sort(names);
    return names;
  };
  text.needs = names_of(option.get_needs());
  text.excludes = names_of(option.get_excludes());
  return text;
}

// Adds the options of a command and of its groups, which come first: one of each group is to be chosen.
void add_options(const CLI::App& app, CommandText& command) {
  for (const CLI::App* group : app.get_subcommands([](const CLI::App* one) { return one->get_name().empty(); })) {
    const std::size_t first = command.options.size();
    add_options(*group, command);
    for (std::size_t i = first; i < command.options.size(); ++i) {
      command.options[i].heading = fmt::format("{}: exactly one of these", group->get_group());
      command.options[i].alternative = true;
    }
  }
  // A group has a --help of its own, which is the command's.
  for (const CLI::Option* option : app.get_options())
    if (!app.get_name().empty() || option != app.get_help_ptr()) command.options.push_back(text_of(*option));
}

CommandText command_text(const CLI::App& app) {
  CommandText command{app.get_name(), app.get_description(), {}, {}};
  add_options(app, command);
  std::ranges::stable_partition(command.options, [](const OptionText& option) { return option.positional; });
  for (std::string line : CLI::detail::split(app.get_footer(), '\n'))
    if (CLI::detail::trim(line) != examples_title && !line.empty()) command.examples.push_back(line);
  return command;
}

std::string help_row(const std::string& name, const std::string& what) {
  constexpr std::size_t column = 34;
  const std::string text = "  " + name;
  if (text.size() < column) return fmt::format("{:<{}}{}\n", text, column, what);
  return fmt::format("{}\n{:{}}{}\n", text, "", column, what);
}

std::string help_row(OptionText option) {
  std::string name = fmt::format("{}", fmt::join(option.names, ","));
  if (!option.positional && !option.type.empty())
    name += " " + (option.choices.empty() ? option.type : fmt::format("{}", fmt::join(option.choices, "|")));
  if (!option.positional) option.choices.clear();  // stand beside its name
  return help_row(name, whole_description(option));
}

bool is_command(const CLI::App* app) { return !app->get_name().empty(); }

class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string /*name*/, CLI::AppFormatMode /*mode*/) const override {
    const CommandText command = command_text(*app);
    const bool is_program = app->get_parent() == nullptr;
    ProgramText program;
    program.name = is_program ? command.name : app->get_parent()->get_name();
    std::string text = fmt::format("{}\nUsage: {}\n", command.description,
                                   is_program ? command.name + " COMMAND [options]" : usage(program, command));
    for (const OptionGroup& group : groups_of(command.options)) {
      text += fmt::format("\n{}:\n", group.heading);
      for (const OptionText& option : group.options) text += help_row(option);
    }
    const auto commands = app->get_subcommands(is_command);
    if (!commands.empty()) text += "\nCommands:\n";
    for (const CLI::App* one : commands) text += help_row(one->get_name(), one->get_description());
    return text + (app->get_footer().empty() ? "" : "\n" + app->get_footer() + "\n");
  }
};

std::vector<std::string> option_names(const CLI::App& app) {
  CommandText command;
  add_options(app, command);
  std::vector<std::string> names;
  for (const OptionText& option : command.options)
    if (!option.positional) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::string_view meant = nearest_name(word, {known.begin(), known.end()});
  return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

// What CLI11 says, where it does not say what would have been right: how often an option was given, and a value that is
// missing.
std::string plain_words(const CLI::ParseError& error) {
  std::string text = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr) return text;
  const std::string option = text.substr(0, text.find(": "));
  const auto number_behind = [&](std::string_view words) {
    const std::size_t at = text.find(words);
    return at == text.npos ? 0 : std::atoi(text.c_str() + at + words.size());
  };
  const int received = number_behind("required but received ");
  for (const std::string_view bound : {": At Most ", ": At least "})
    if (const int wanted = number_behind(bound); wanted > 0)
      return wanted == 1 ? fmt::format("{} takes one value, once: it was given {} of them", option, received)
                         : fmt::format("{} takes {} values: it was given {}", option, wanted, received);
  if (text.find("disallowed flag override") != text.npos)
    return fmt::format("{}{} takes no value", text.starts_with("-") ? "" : "--", text.substr(0, text.find(' ')));
  if (text.find("1 required ") != text.npos) return fmt::format("{0} needs a value, as {0} VALUE", option);
  return text;
}

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<HelpFormatter>(); }

ProgramText text_of(const CLI::App& app) {
  ProgramText program{app.get_name(), app.get_description(), {}, {}, {}};
  program.version = app.version();
  program.options = command_text(app).options;
  for (const CLI::App* command : app.get_subcommands(is_command)) program.commands.push_back(command_text(*command));
  return program;
}

InputError unknown_command(std::string_view word, const std::vector<std::string>& known) {
  std::string meant = called_here("command", word, {known.begin(), known.end()});
  if (meant.empty()) meant = did_you_mean(word, known);
  if (meant.empty()) meant = fmt::format("; known: {}", fmt::join(known, ", "));
  return InputError(fmt::format("unknown command '{}'{} (see `cageproof --help`)", word, meant));
}

void refuse_unknown_command(const CLI::App& app, std::string_view first) {
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands(is_command)) commands.push_back(command->get_name());
  if (first.empty())
    throw InputError(
        fmt::format("a command is missing: one of {} (see `cageproof --help`)", fmt::join(commands, ", ")));
  if (std::ranges::find(commands, first) != commands.end()) return;
  if (app.get_option_no_throw(std::string(first)) != nullptr) return;
  if (first.front() != '-') throw unknown_command(first, commands);
  for (const CLI::App* command : app.get_subcommands(is_command))
    if (const auto names = option_names(*command); std::ranges::find(names, first) != names.end())
      throw InputError(
          fmt::format("'{0}' stands behind its command, as in `cageproof {1} {0}`", first, command->get_name()));
  throw InputError(
      fmt::format("unknown option '{}'{} (see `cageproof --help`)", first, did_you_mean(first, option_names(app))));
}

std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  const std::string parsers = plain_words(error);
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) return parsers + " (see `cageproof --help`)";
  const CLI::App& command = *chosen.front();
  const std::string help = fmt::format("(see `cageproof {} --help`)", command.get_name());
  const std::vector<std::string> left = command.remaining();
  if (left.empty()) return parsers + " " + help;
  const std::string word = left.front().substr(0, left.front().find('='));
  if (!word.starts_with("-"))
    return fmt::format("unexpected '{}': no option of `cageproof {}` takes it {}", word, command.get_name(), help);
  const std::vector<std::string> known = option_names(command);
  // Coordinates have kinds, and deformers methods, of nearly the same names.
  for (const auto& [asked, meant] : {std::pair("--kind", "--method"), std::pair("--method", "--kind")})
    if (word == asked && std::ranges::find(known, meant) != known.end())
      return fmt::format("unknown option '{}' of `cageproof {}`; did you mean '{}'? {}", word, command.get_name(),
                         meant, help);
  return fmt::format("unknown option '{}' of `cageproof {}`{} {}", word, command.get_name(), did_you_mean(word, known),
                     help);
}

}  // namespace cageproof::cli
