// SPDX-License-Identifier: MIT
#include "commands.h"
#include "judge_option.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/cage/mesh_io.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/core/whole_file.h"
#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/worst_file.h"
#include "cageproof/validation/replay.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

namespace cageproof::cli {
namespace {

// Counts over all cases.
struct Summary {
  std::size_t kept = 0, broken = 0, unpromised = 0, unmeasured = 0, changed = 0;
  std::string largest;  // the case with the most of its promise
  double most = -1;
};

// The case's outcome now, and whether that breaks the promise that was stored with it.
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

std::string name_of(const reports::WorstLine& line) {
  return fmt::format("{} {} {} {} {} order {}", line.subject, line.evaluation, line.scalar, line.setting, line.check,
                     line.order);
}

void count(const reports::WorstLine& line, const validation::Finding& finding, bool broken, Summary& all) {
  const bool measured = finding.status == validation::Finding::Status::Measured;
  (broken ? all.broken : !measured ? all.unmeasured : line.bound ? all.kept : all.unpromised)++;
  if (!measured) return;
  const bool same = finding.error == line.worst.error || (std::isnan(finding.error) && std::isnan(line.worst.error));
  all.changed += !same;
  const double share = line.bound && *line.bound > 0 ? finding.error / *line.bound : -1;
  // A NaN is the worst of all.
  if (line.bound && (std::isnan(share) || share > all.most)) {
    all.most = std::isnan(share) ? HUGE_VAL : share;
    all.largest = fmt::format("{} {} of the promised {} in line {}: {}", format_scalar(finding.error), line.unit,
                              format_scalar(*line.bound), line.number, name_of(line));
  }
}

void print(const Summary& all, const std::string& file) {
  const std::size_t cases = all.kept + all.broken + all.unpromised + all.unmeasured;
  fmt::print("{}: {} case{} of {}: {} kept, {} broken, {} not promised, {} without error; {} changed since stored\n",
             all.broken == 0 ? "all promises kept" : "PROMISES BROKEN", cases, cases == 1 ? "" : "s", file, all.kept,
             all.broken, all.unpromised, all.unmeasured, all.changed);
  if (!all.largest.empty()) fmt::print("largest share of a promise: {}\n", all.largest);
}

struct Arguments {
  std::string file;
  int line = 0;  // 0: all
  JudgeOption judge;
};

// The lines asked for. A report's worst.jsonl is empty where nothing fell short.
std::vector<reports::WorstLine> lines_of(const Arguments& asked) {
  std::vector<reports::WorstLine> lines = reports::parse_worst(reports::read_packed(asked.file), asked.file);
  if (asked.line == 0) return lines;
  std::erase_if(lines, [&](const reports::WorstLine& line) { return line.number != asked.line; });
  if (lines.empty()) throw InputError(fmt::format("{}: no case in line {}", asked.file, asked.line));
  return lines;
}

// The formulas of the lines, as a list.
std::string formulas_of(const std::vector<reports::WorstLine>& lines) {
  std::set<std::string> names;
  for (const reports::WorstLine& line : lines)
    if (find_formula(line.subject) != nullptr) names.insert(line.subject);
  return fmt::format("{}", fmt::join(names, ","));
}

// The folder of the file, its report's, and those above: the run may have stood in any of them.
std::vector<std::filesystem::path> folders_above(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> folders;
  std::error_code ignored;
  for (auto folder = std::filesystem::absolute(file, ignored).lexically_normal().parent_path();;
       folder = folder.parent_path()) {
    folders.push_back(folder);
    if (folder == folder.parent_path()) return folders;
  }
}

int run(Arguments& asked) {
  // A report packs its files, and people name what is packed.
  if (const std::string packed = asked.file + ".gz";
      !std::filesystem::exists(asked.file) && std::filesystem::exists(packed))
    asked.file = packed;
  Summary all;
  const std::string& file = asked.file;
  const std::vector<reports::WorstLine> lines = lines_of(asked);
  if (lines.empty()) {
    fmt::print("{} is empty: there is nothing to run again\n", file);
    return success;
  }
  asked.judge.begin(formulas_of(lines));
  const std::vector<std::filesystem::path> folders = folders_above(file);
  validation::Replayer replayer;
  for (const reports::WorstLine& line : lines) {
    validation::Finding finding;
    try {
      finding =
          replayer.replay(line, line.worst, line.triangulation == "fan" ? Triangulation::Fan : Triangulation::Shortest,
                          {line.unit, line.cage_content, folders});
    } catch (const InputError& e) {
      throw InputError(fmt::format("{}:{}: {}", file, line.number, e.what()));
    }
    const auto [text, broken] = outcome(line, finding);
    count(line, finding, broken, all);
    fmt::print("{}: {}\n", name_of(line), text);
  }
  print(all, file);
  return all.broken == 0 ? success : promise_broken;
}

}  // namespace

void add_replay(CommandLine& line) {
  Command command =
      line.command("replay", "run stored worst cases again, exactly, with a summary; exit 1 when a promise is broken");
  auto asked = std::make_shared<Arguments>();
  command.option("file", asked->file, "worst cases: a report's worst.jsonl, or a file of its folder worst")
      .taking("FILE")
      .required();
  command.option("--line", asked->line, "only the case of this line, from 1").in_range(1, 1000000000);
  asked->judge.add_to(command);
  command.example("cageproof replay report/worst.jsonl");
  command.example("cageproof replay report/worst/triangle.double_layer.jsonl.gz --line 12");
  command.runs([asked] { return run(*asked); });
}

}  // namespace cageproof::cli
