// SPDX-License-Identifier: MIT
// The command line: commands, their options, and their actions. CLI11 parses it. Only command_line.cpp and its
// neighbours instantiate CLI11's templates, because they cost every file that includes them seconds of compiling.
#pragma once

#include "command_text.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cageproof::cli {

struct NumberBounds;

/// Runs the chosen command; returns its exit code.
using Action = std::function<int()>;

/// An option of a command: a handle that can be copied, and that lives as long as the CommandLine.
class Option {
 public:
  explicit Option(CLI::Option* option, std::shared_ptr<NumberBounds> bounds = nullptr)
      : option_(option), bounds_(std::move(bounds)) {}

  /// The command is refused without this option.
  Option& required(bool whether = true);
  /// Values are one of these, and the help lists them.
  Option& one_of(const std::vector<std::string>& names);
  /// Name of the value in help, which tells completion what to offer; value_names.h has the words.
  Option& taking(const std::string& type);
  /// Values lie in the closed range, and the help shows it. \pre an option of numbers
  Option& in_range(int lowest, int highest);
  Option& in_range(double lowest, double highest);
  /// Takes exactly so many values.
  Option& values(int count);
  /// Takes one value each time it is given: the next word is not its value.
  Option& one_at_a_time();
  /// The two are not given together.
  Option& excludes(const Option& other);
  /// Is not given without the other.
  Option& needs(const Option& other);
  /// The help shows the value that the variable has now.
  Option& showing_default();
  /// The help shows this text as the default.
  Option& showing_default(const std::string& text);

 private:
  CLI::Option* option_;
  std::shared_ptr<NumberBounds> bounds_;  // of an option of numbers
};

/// A command, or a group of its options: a handle that can be copied, and that lives as long as the CommandLine.
class Command {
 public:
  /// An option whose value goes to a variable, which must outlive the parsing. A name without dashes is positional;
  /// "--regime,--regimes" are two names of one. Whole numbers may be written 1e3.
  Option option(const std::string& name, std::string& value, const std::string& description);
  Option option(const std::string& name, int& value, const std::string& description);
  Option option(const std::string& name, std::uint64_t& value, const std::string& description);
  Option option(const std::string& name, double& value, const std::string& description);
  Option option(const std::string& name, std::vector<std::string>& values, const std::string& description);
  Option option(const std::string& name, std::vector<double>& values, const std::string& description);
  /// An option without a value.
  Option flag(const std::string& name, bool& value, const std::string& description);
  /// Help and manual show the options that are added through this handle from now on under that title.
  void heading(const std::string& title) { heading_ = title; }
  /// A group of options of which exactly one must be given; help and manual show it first.
  Command exactly_one_of(const std::string& title);
  /// Whether the user gave the option of this name, which must exist.
  bool given(const std::string& name) const;
  /// A command line that does something sensible, which help and manual show.
  void example(const std::string& line);
  /// The command's action, once the whole command line is read.
  void runs(Action action);

 private:
  friend class CommandLine;
  Command(CLI::App* app, Action* chosen) : app_(app), chosen_(chosen) {}

  CLI::Option* placed(CLI::Option* option) const;

  CLI::App* app_;
  Action* chosen_;
  std::string heading_;
};

/// The commands of the program, of which the user chooses one.
class CommandLine {
 public:
  CommandLine(const std::string& description, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Command command(const std::string& name, const std::string& description);
  /// Description of the program for manuals and completion.
  ProgramText describe() const;
  /// The text that --help prints. \param command empty: help of the program \pre the command exists
  std::string help(const std::string& command) const;
  const std::string& version() const { return version_; }
  /// Reads the arguments and runs the chosen command, or prints the help or version that was asked for.
  /// \return the exit code \throws InputError when the arguments are not understood: says what would have been right
  int run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  std::string version_;
  Action chosen_;
};

/// Reads a value as the command line reads that of an option. \return whether the text is one
bool read_value(const std::string& text, std::string& value);
bool read_value(const std::string& text, int& value);
bool read_value(const std::string& text, std::uint64_t& value);

}  // namespace cageproof::cli
