// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/validation/verify.h"

namespace cageproof::cli {

void add_report(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("report", "the report of a finished run afresh, from its journal");
  auto folder = std::make_shared<std::string>();
  command->add_option("folder", *folder, "the run's folder")->required();
  command->callback(
      [&action, folder] { action = [folder] { return print_verdict(validation::report_again(*folder), *folder); }; });
}

}  // namespace cageproof::cli
