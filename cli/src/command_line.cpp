// SPDX-License-Identifier: MIT
#include "command_line.h"

#include "command_numbers.h"
#include "command_words.h"
#include "value_names.h"

#include "cageproof/closed_form/batch/instruction_set.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cageproof::cli {

Option& Option::required(bool whether) {
  option_->required(whether);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& names) {
  // The value's type name holds its choices: descriptions find them there.
  option_->type_name(fmt::format("{}", fmt::join(names, "|")));
  option_->check([names](const std::string& text) -> std::string {
    if (std::ranges::find(names, text) != names.end()) return {};
    const std::string_view meant = nearest_name(text, {names.begin(), names.end()});
    return fmt::format("'{}' is none of {}{}", text, fmt::join(names, ", "),
                       meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant));
  });
  return *this;
}

Option& Option::taking(const std::string& type) {
  option_->type_name(type);
  // Lists stand between commas, in every command.
  if (is_list_type(type)) option_->allow_extra_args(false);
  return *this;
}

Option& Option::in_range(int lowest, int highest) {
  return in_range(static_cast<double>(lowest), static_cast<double>(highest));
}

Option& Option::in_range(double lowest, double highest) {
  bounds_->lowest = lowest;
  bounds_->highest = highest;
  option_->description(fmt::format("{} ({} to {})", option_->get_description(), lowest, highest));
  return *this;
}

Option& Option::values(int count) {
  option_->expected(count);
  return *this;
}

Option& Option::one_at_a_time() {
  option_->allow_extra_args(false);
  return *this;
}

Option& Option::excludes(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}

Option& Option::needs(const Option& other) {
  option_->needs(other.option_);
  return *this;
}

Option& Option::showing_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::showing_default(const std::string& text) {
  option_->default_str(text);
  return *this;
}

namespace {

// CLI11 takes hexadecimal and octal numbers, not 1e3, and some that are too large as others.
Option with_numbers(CLI::Option* option, bool whole) {
  auto bounds = std::make_shared<NumberBounds>();
  bounds->whole = whole;
  if (whole) {
    bounds->lowest = std::numeric_limits<int>::lowest();
    bounds->highest = std::numeric_limits<int>::max();
  }
  option->transform(CLI::Validator([bounds](std::string& text) { return make_plain(text, *bounds); }, ""));
  option->type_name(whole ? "N" : "NUMBER");
  return Option(option, bounds);
}

// An empty word, as of a shell's variable that is not set, would pass for an option that is not given.
Option with_words(CLI::Option* option) {
  option->check(CLI::Validator(
      [](std::string& text) {
        return text.empty() ? std::string("'' is empty: give a value, or leave the option out") : "";
      },
      ""));
  return Option(option);
}

}  // namespace

CLI::Option* Command::placed(CLI::Option* option) const {
  if (!heading_.empty()) option->group(heading_);
  return option;
}

Option Command::option(const std::string& name, std::string& value, const std::string& description) {
  return with_words(placed(app_->add_option(name, value, description)));
}

Option Command::option(const std::string& name, int& value, const std::string& description) {
  return with_numbers(placed(app_->add_option(name, value, description)), true);
}

Option Command::option(const std::string& name, std::uint64_t& value, const std::string& description) {
  CLI::Option* option = placed(app_->add_option(name, value, description));
  // A range makes it an ordinary number; without one it is a seed, which has all 64 bits.
  auto bounds = std::make_shared<NumberBounds>();
  option->transform(CLI::Validator(
      [bounds](std::string& text) {
        return std::isfinite(bounds->highest) ? make_plain(text, *bounds) : make_plain_seed(text);
      },
      ""));
  option->type_name("N");
  return Option(option, bounds);
}

Option Command::option(const std::string& name, double& value, const std::string& description) {
  return with_numbers(placed(app_->add_option(name, value, description)), false);
}

Option Command::option(const std::string& name, std::vector<std::string>& values, const std::string& description) {
  return with_words(placed(app_->add_option(name, values, description)));
}

Option Command::option(const std::string& name, std::vector<double>& values, const std::string& description) {
  return with_numbers(placed(app_->add_option(name, values, description)), false);
}

Option Command::flag(const std::string& name, bool& value, const std::string& description) {
  CLI::Option* option = placed(app_->add_flag(name, value, description));
  return Option(option->disable_flag_override());
}

Command Command::exactly_one_of(const std::string& title) {
  CLI::App* group = app_->add_option_group(title);
  group->require_option(1);
  return Command(group, chosen_);
}

bool Command::given(const std::string& name) const { return app_->count(name) > 0; }

void Command::example(const std::string& line) {
  const std::string before = app_->get_footer();
  app_->footer((before.empty() ? examples_title : before) + "\n  " + line);
}

void Command::runs(Action action) {
  app_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

CommandLine::CommandLine(const std::string& description, const std::string& version)
    : app_(std::make_unique<CLI::App>(description)), version_(version) {
  app_->name("cageproof");
  app_->set_version_flag("-V,--version", version, "print version and commit, and exit");
  app_->set_help_flag("-h,--help", "print this help, and exit");
  app_->formatter(help_formatter());
  // A command's name behind a command is a value like others.
  app_->require_subcommand(0, 1);
  app_->footer("`cageproof help COMMAND` says more of each; `man cageproof` and docs/command_line.md say it all.");
}

CommandLine::~CommandLine() = default;

Command CommandLine::command(const std::string& name, const std::string& description) {
  CLI::App* command = app_->add_subcommand(name, description);
  command->group("Commands");
  // CLI11 hands the program's down.
  command->footer("");
  return Command(command, &chosen_);
}

ProgramText CommandLine::describe() const { return text_of(*app_); }

std::string CommandLine::help(const std::string& command) const {
  // App::help would show the help of the command chosen in this run instead.
  return help_formatter()->make_help(command.empty() ? app_.get() : app_->get_subcommand(command),
                                     command.empty() ? "cageproof" : "cageproof " + command,
                                     CLI::AppFormatMode::Normal);
}

int CommandLine::run(int argc, char** argv) {
  const std::string first = argc > 1 ? argv[1] : "";
  // CLI11 would take the next argument for the value.
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.starts_with("--") && word.find('=') + 1 == word.size())
      throw InputError(
          fmt::format("{}: '' is empty: give a value, or leave the option out", word.substr(0, word.size() - 1)));
  }
  // CLI11 would say that a command is missing.
  refuse_unknown_command(*app_, first);
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // Help and version arrive as exceptions too.
    if (e.get_exit_code() == 0) return app_->exit(e);
    throw InputError(complaint_of(*app_, e));
  }
  // A misspelt one must not be found after hours, or never.
  closed_form::batch::instruction_set();
  return chosen_();
}

bool read_value(const std::string& text, std::string& value) { return CLI::detail::lexical_cast(text, value); }
bool read_value(const std::string& text, int& value) { return CLI::detail::lexical_cast(text, value); }
bool read_value(const std::string& text, std::uint64_t& value) { return CLI::detail::lexical_cast(text, value); }

}  // namespace cageproof::cli
