// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/validation/verify.h"

namespace cageproof::cli {

void add_report(CommandLine& line) {
  Command command = line.command("report", "make the report of a finished run again, from its journal");
  auto folder = std::make_shared<std::string>();
  command.option("folder", *folder, "the run's folder").taking("FOLDER").required();
  command.example("cageproof report my-report");
  command.runs([folder] { return print_verdict(validation::report_again(*folder), *folder); });
}

}  // namespace cageproof::cli
