// SPDX-License-Identifier: MIT
// What the program says of its own command line: manual and completion.
#include "commands.h"
#include "completion.h"
#include "manual.h"

#include "cageproof/reports/checked_file.h"

#include <iostream>

namespace cageproof::cli {
namespace {

int write(const std::string& out, const std::string& text) {
  if (out.empty()) std::cout << text;
  else reports::replace_file(out, text);
  return success;
}

struct Arguments {
  std::string shell, out;
  bool markdown = false;
};

}  // namespace

void add_descriptions(CommandLine& line) {
  Command manual = line.command("man", "this manual, as a page for man, or as Markdown");
  auto a = std::make_shared<Arguments>();
  manual.flag("--markdown", a->markdown, "as docs/command_line.md has it");
  manual.option("--out", a->out, "a file for it, instead of standard output").taking("FILE");
  manual.example("cageproof man | man -l -");
  manual.runs([a, &line] {
    const ProgramText program = line.describe();
    return write(a->out, a->markdown ? manual_markdown(program) : manual_page(program));
  });
  Command completion = line.command("completion", "a script that completes commands, options and names in a shell");
  completion.option("shell", a->shell, "whose").one_of({"bash", "zsh", "fish"}).required();
  completion.option("--out", a->out, "a file for it, instead of standard output").taking("FILE");
  completion.example("source <(cageproof completion bash)");
  completion.runs([a, &line] {
    const ProgramText program = line.describe();
    return write(a->out, a->shell == "bash"  ? bash_completion(program)
                         : a->shell == "zsh" ? zsh_completion(program)
                                             : fish_completion(program));
  });
}

}  // namespace cageproof::cli
