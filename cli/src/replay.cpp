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

// What a case is now, and whether that breaks the promise that was stored with it.
std::pair<std::string, bool> outcome(const reports::WorstLine& line, const validation::Finding& finding) {
  using Status = validation::Finding::Status;
  if (finding.status == Status::Declined) return {"declined", false};
  if (finding.status == Status::Unreached) return {"no truth, where there must be one", line.bound.has_value()};
  if (finding.status != Status::Measured) return {"no truth", false};
  const bool broken = line.bound && !(finding.error <= *line.bound);
  return {
      fmt::format("error {} {} (stored {}){}", format_scalar(finding.error), line.unit, format_scalar(line.worst.error),
                  broken ? fmt::format(", above the promised {}", format_scalar(*line.bound)) : ""),
      broken};
}

int run(const std::string& file) {
  int code = success;
  for (const reports::WorstLine& line : reports::read_worst(file)) {
    validation::Finding finding;
    try {
      finding = validation::replay(line, line.worst,
                                   line.triangulation == "fan" ? Triangulation::Fan : Triangulation::Shortest);
    } catch (const InputError& e) {
      throw InputError(fmt::format("{}:{}: {}", file, line.number, e.what()));
    }
    const auto [text, broken] = outcome(line, finding);
    if (broken) code = promise_broken;
    fmt::print("{} {} {} {} {} order {}: {}\n", line.subject, line.evaluation, line.scalar, line.regime, line.check,
               line.order, text);
  }
  return code;
}

}  // namespace

void add_replay(CommandLine& line) {
  Command command = line.command("replay", "re-run stored worst cases exactly");
  auto file = std::make_shared<std::string>();
  command.option("file", *file, "a worst.jsonl").required();
  command.runs([file] { return run(*file); });
}

}  // namespace cageproof::cli
