// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/results/build_facts.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/memory.h"
#include "cageproof/judge/host.h"
#include "cageproof/reports/clean_end.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string_view>
#include <system_error>

namespace {

using namespace cageproof;

// One line, whatever the message holds.
int complain(std::string message) {
  reports::wait_if_ending();
  for (char& c : message)
    if (c == '\n') c = ' ';
  // Not the formatting library's, which throws where standard error takes no more.
  std::fputs(("cageproof: " + message + "\n").c_str(), stderr);
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
  using namespace cli;
  if (judge::is_host(argc, argv)) return judge::run_host(argc, argv);
  CommandLine line("Cageproof: every cage-coordinate formula, several independent ways, against its definition.",
                   fmt::format("cageproof {} (commit {})", CAGEPROOF_VERSION, build_commit()));
  const std::string as_given = quoted(argc, argv);
  add_list(line);
  add_eval(line);
  add_explain(line);
  add_inside(line);
  add_quads(line);
  add_coordinates(line);
  add_deform(line);
  add_verify(line, as_given);
  add_merge(line);
  add_report(line);
  add_compare(line);
  add_field(line, as_given);
  add_figures(line);
  add_replay(line);
  add_hunt(line);
  add_bench(line, as_given);
  add_judge(line, as_given);
  add_vectors(line, as_given);
  add_descriptions(line);
  reports::end_cleanly_on_signals();
  try {
    const int code = line.run(argc, argv);
    errno = 0;
    std::cout.flush();
    if (!std::cout)
      return complain(fmt::format("cannot write to standard output{}{}", errno != 0 ? ": " : "",
                                  errno != 0 ? std::generic_category().message(errno) : ""));
    return code;
  } catch (const InputError& e) {
    return complain(e.what());
  } catch (const std::filesystem::filesystem_error& e) {
    return complain(fmt::format("{}: {}", e.path1().string(), e.code().message()));
  } catch (const std::system_error& e) {
    // The formatting library throws this where standard output takes no more.
    if (std::string_view(e.what()).starts_with("cannot write to file"))
      return complain(fmt::format("cannot write to standard output: {}", e.code().message()));
    return complain(fmt::format("unexpected: {}", e.what()));
  } catch (const std::bad_alloc&) {
    return complain(fmt::format(
        "there is too little memory for this: of {} that this process may use; take fewer points at a time, a cage of "
        "fewer faces, or fewer threads (--jobs 1), each of which keeps numbers of its own",
        size_text(static_cast<double>(usable_memory()))));
  } catch (const std::exception& e) {
    return complain(fmt::format("unexpected: {}", e.what()));
  }
}
