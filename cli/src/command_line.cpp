// SPDX-License-Identifier: MIT
#include "command_line.h"

#include "cageproof/core/input_error.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <system_error>
#include <utility>

namespace cageproof::cli {

Option& Option::required(bool whether) {
  option_->required(whether);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& names) {
  option_->check(CLI::IsMember(names));
  return *this;
}

Option& Option::in_range(int lowest, int highest) {
  option_->check(CLI::Range(lowest, highest));
  return *this;
}

Option& Option::in_range(double lowest, double highest) {
  option_->check(CLI::Range(lowest, highest));
  return *this;
}

Option& Option::values(int count) {
  option_->expected(count);
  return *this;
}

Option& Option::separated_by(char separator) {
  option_->delimiter(separator);
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

Option Command::option(const std::string& name, std::string& value, const std::string& description) {
  return Option(app_->add_option(name, value, description));
}

Option Command::option(const std::string& name, int& value, const std::string& description) {
  return Option(app_->add_option(name, value, description));
}

Option Command::option(const std::string& name, std::uint64_t& value, const std::string& description) {
  CLI::Option* option = app_->add_option(name, value, description);
  // CLI11 takes negative numbers, and those beyond 64 bits, as other ones.
  option->check([](const std::string& text) {
    std::uint64_t parsed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole ? std::string() : "'" + text + "' is not a number from 0 to 2^64 - 1";
  });
  return Option(option);
}

Option Command::option(const std::string& name, double& value, const std::string& description) {
  return Option(app_->add_option(name, value, description));
}

Option Command::option(const std::string& name, std::vector<std::string>& values, const std::string& description) {
  return Option(app_->add_option(name, values, description));
}

Option Command::option(const std::string& name, std::vector<double>& values, const std::string& description) {
  return Option(app_->add_option(name, values, description));
}

Option Command::flag(const std::string& name, bool& value, const std::string& description) {
  return Option(app_->add_flag(name, value, description));
}

Command Command::exactly_one_of(const std::string& title) {
  CLI::App* group = app_->add_option_group(title);
  group->require_option(1);
  return {group, chosen_};
}

bool Command::given(const std::string& name) const { return app_->count(name) > 0; }

void Command::runs(Action action) {
  app_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

CommandLine::CommandLine(const std::string& description, const std::string& version)
    : app_(std::make_unique<CLI::App>(description)) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

Command CommandLine::command(const std::string& name, const std::string& description) {
  return {app_->add_subcommand(name, description), &chosen_};
}

int CommandLine::run(int argc, char** argv) {
  // CLI11 would say that a command is missing.
  const std::string first = argc > 1 ? argv[1] : "";
  const auto named = [&](const CLI::App* command) { return command->get_name() == first; };
  if (!first.empty() && app_->get_subcommands(named).empty() && app_->get_option_no_throw(first) == nullptr) {
    const char* what = first.front() == '-' ? "option" : "command";
    throw InputError(std::string("unknown ") + what + " '" + first + "' (see `cageproof --help`)");
  }
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    // Help and version arrive as exceptions too.
    if (e.get_exit_code() == 0) return app_->exit(e);
    throw InputError(e.what() + std::string(" (see `cageproof --help`)"));
  }
  return chosen_();
}

bool read_value(const std::string& text, std::string& value) { return CLI::detail::lexical_cast(text, value); }
bool read_value(const std::string& text, int& value) { return CLI::detail::lexical_cast(text, value); }
bool read_value(const std::string& text, std::uint64_t& value) { return CLI::detail::lexical_cast(text, value); }

}  // namespace cageproof::cli
