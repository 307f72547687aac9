// SPDX-License-Identifier: MIT
#include "commands.h"

#include "cageproof/core/input_error.h"
#include "cageproof/reports/compare.h"
#include "cageproof/reports/journal.h"
#include "cageproof/reports/packed_file.h"
#include "cageproof/reports/summary.h"
#include "cageproof/validation/verify.h"

#include <fmt/format.h>

namespace cageproof::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string before, after, names;
};

// A report's folder, its summary.json.gz, or a journal, which is judged now.
std::string summary_of(const fs::path& path) {
  std::error_code ignored;
  fs::path file = path;
  if (fs::is_directory(path, ignored))
    for (const std::string_view name :
         {std::string_view(reports::summary_file), std::string_view("summary.json"), reports::journal_file})
      if (file = path / name; fs::exists(file, ignored)) break;
  if (!reports::find_journal_header(file)) return reports::read_packed(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (const auto lacking = validation::unfinished(reports::read_journal(file), folder))
    fmt::print(stderr, "warning: {}; only what these found is compared\n", *lacking);
  return validation::summary_of_journal(file);
}

int run(const Arguments& a) {
  const reports::Renamed renamed = a.names.empty() ? reports::Renamed() : reports::read_renamed(a.names);
  const reports::Differences found =
      reports::compare_summaries(summary_of(a.before), summary_of(a.after), renamed, a.before, a.after);
  if (found.taken_for_hybrid > 0)
    fmt::print("{} entries closed_form of {}, whose schema is before 4, are compared with hybrid, their name today\n",
               found.taken_for_hybrid, a.before);
  for (const std::string& line : found.differing) fmt::print("differs: {}\n", line);
  for (const std::string& line : found.gone) fmt::print("only in {}: {}\n", a.before, line);
  for (const std::string& line : found.added) fmt::print("only in {}: {}\n", a.after, line);
  fmt::print("{} equal, {} differ, {} only in {}, {} only in {}\n", found.equal, found.differing.size(),
             found.gone.size(), a.before, found.added.size(), a.after);
  return found.same() ? success : promise_broken;
}

}  // namespace

void add_compare(CommandLine& line) {
  Command command =
      line.command("compare", "figures and verdicts that differ between two reports or journals; exit 1 when any does");
  auto a = std::make_shared<Arguments>();
  command.option("old", a->before, "a report's folder, its summary.json.gz, or a journal").taking("FILE").required();
  command.option("new", a->after, "another").taking("FILE").required();
  command
      .option("--names", a->names,
              R"(JSON object {"old": "new"} of names that changed; "subject/old" in that subject's rows alone)")
      .taking("FILE");
  command.example("cageproof compare report-before report-after");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
