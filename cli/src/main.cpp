// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <iostream>

namespace {

using namespace cageproof;

// One line, whatever the message holds.
int complain(std::string message) {
  for (char& c : message)
    if (c == '\n') c = ' ';
  fmt::print(stderr, "cageproof: {}\n", message);
  return cli::bad_input;
}

std::string quoted(int argc, char** argv) {
  std::string line = "cageproof";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool plain = !argument.empty() && argument.find_first_of(" *?'\"\\$&;|<>()") == std::string::npos;
    line += plain ? " " + argument : " '" + argument + "'";
  }
  return line;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Cageproof: every cage-coordinate formula, several independent ways, against its definition."};
  app.set_version_flag("--version", CAGEPROOF_VERSION);
  app.require_subcommand(1);
  cli::Action action;
  cli::add_list(app, action);
  cli::add_eval(app, action);
  cli::add_coordinates(app, action);
  cli::add_verify(app, action, quoted(argc, argv));
  cli::add_merge(app, action);
  cli::add_report(app, action);
  cli::add_compare(app, action);
  cli::add_field(app, action, quoted(argc, argv));
  cli::add_replay(app, action);
  cli::add_hunt(app, action);
  cli::add_bench(app, action, quoted(argc, argv));
  try {
    app.parse(argc, argv);
    const int code = action();
    std::cout.flush();
    if (!std::cout) return complain("cannot write to standard output");
    return code;
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    return complain(fmt::format("{} (see `cageproof --help`)", e.what()));
  } catch (const InputError& e) {
    return complain(e.what());
  } catch (const std::exception& e) {
    return complain(fmt::format("unexpected: {}", e.what()));
  }
}
