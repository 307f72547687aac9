// SPDX-License-Identifier: MIT
// Commands about the program itself: help, version, manual and completion.
#include "commands.h"
#include "command_words.h"
#include "completion.h"
#include "manual.h"

#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

namespace cageproof::cli {
namespace {

int write(const std::string& out, const std::string& text) {
  if (out.empty()) std::cout << text;
  else reports::replace_file(out, text);
  return success;
}

struct Arguments {
  std::string command, shell, out;
  bool markdown = false;
};

std::vector<std::string> names_of_commands(const CommandLine& line) {
  std::vector<std::string> names;
  for (const CommandText& command : line.describe().commands) names.push_back(command.name);
  return names;
}

int print_help(const CommandLine& line, const std::string& command) {
  const std::vector<std::string> known = names_of_commands(line);
  if (!command.empty() && std::ranges::find(known, command) == known.end()) throw unknown_command(command, known);
  std::cout << line.help(command);
  return success;
}

}  // namespace

void add_descriptions(CommandLine& line) {
  auto a = std::make_shared<Arguments>();
  Command help = line.command("help", "print the help of the program or of a command");
  help.example("cageproof help deform");
  help.runs([a, &line] { return print_help(line, a->command); });
  Command version = line.command("version", "print version and commit");
  version.runs([&line] {
    std::cout << line.version() << '\n';
    return success;
  });
  Command manual = line.command("man", "print this manual, as a page for man or as Markdown");
  manual.flag("--markdown", a->markdown, "Markdown, as in docs/command_line.md");
  manual.option("--out", a->out, "a file for it, instead of standard output").taking("FILE");
  manual.example("cageproof man | man -l -");
  manual.runs([a, &line] {
    const ProgramText program = line.describe();
    return write(a->out, a->markdown ? manual_markdown(program) : manual_page(program));
  });
  Command completion =
      line.command("completion", "print a script that completes commands, options and names in a shell");
  completion.option("shell", a->shell, "the shell").one_of({"bash", "zsh", "fish"}).required();
  completion.option("--out", a->out, "a file for it, instead of standard output").taking("FILE");
  completion.example("source <(cageproof completion bash)");
  // Known once all commands are.
  help.option("command", a->command, "a command; if not given, the program")
      .taking(fmt::format("{}", fmt::join(names_of_commands(line), "|")));
  completion.runs([a, &line] {
    const ProgramText program = line.describe();
    return write(a->out, a->shell == "bash"  ? bash_completion(program)
                         : a->shell == "zsh" ? zsh_completion(program)
                                             : fish_completion(program));
  });
}

}  // namespace cageproof::cli
