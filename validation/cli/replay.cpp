// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/mesh_io.h"
#include "cageproof/core/scalar_text.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/replay.h"

#include <fmt/format.h>

namespace cageproof::cli {
namespace {

int run(const std::string& file) {
  int code = all_kept;
  std::size_t number = 0;
  for (const reports::WorstLine& line : reports::read_worst(file)) {
    ++number;
    ResultRow row;
    row.section = line.section;
    row.subject = line.subject;
    row.evaluation = line.evaluation;
    row.scalar = line.scalar;
    row.regime = line.regime;
    row.check = line.check;
    row.place = line.place;
    row.order = line.order;
    double error;
    try {
      error = validation::replay(row, line.worst, line.triangulation == "fan" ? Triangulation::Fan : Triangulation::Shortest);
    } catch (const InputError& e) {
      throw InputError(fmt::format("{}: case {}: {}", file, number, e.what()));
    }
    const bool broken = line.bound && !(error <= *line.bound);
    if (broken) code = promise_broken;
    fmt::print("{} {} {} {} {} order {}: error {} {} (stored {}){}\n", line.subject, line.evaluation, line.scalar,
               line.regime, line.check, line.order, format_scalar(error), line.unit, format_scalar(line.worst.error),
               broken ? fmt::format(", above the promised {}", format_scalar(*line.bound)) : "");
  }
  return code;
}

}  // namespace

void add_replay(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("replay", "re-run stored worst cases exactly");
  auto file = std::make_shared<std::string>();
  command->add_option("file", *file, "a worst.jsonl")->required();
  command->callback([&action, file] { action = [file] { return run(*file); }; });
}

}  // namespace cageproof::cli
