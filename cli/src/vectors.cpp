// SPDX-License-Identifier: MIT
#include "commands.h"
#include "npz.h"

#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/results/build_facts.h"
#include "cageproof/judge/vectors.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>

#include <filesystem>

namespace cageproof::cli {
namespace {

struct VectorArguments {
  std::string out, formulas = "triangle.*,segment.*", command;
  judge::VectorOptions options;
};

std::string npy(const std::vector<double>& numbers, const std::vector<std::size_t>& shape) {
  std::string bytes = npy_header("<f8", shape);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  return bytes;
}

int run(const VectorArguments& a) {
  std::vector<std::string_view> names;
  for (const Formula& formula : catalogue())
    if (validation::has_truth_source(formula)) names.push_back(formula.name);
  require_known("formula", a.formulas, names);
  std::error_code failed;
  std::filesystem::create_directories(a.out, failed);
  if (failed) throw InputError(fmt::format("cannot make the folder {}: {}", a.out, failed.message()));
  const std::string version = fmt::format("{} (commit {})", CAGEPROOF_VERSION, build_commit());
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  std::size_t vectors = 0, bytes = 0;
  for (const std::string_view name : names) {
    if (!matches(a.formulas, name)) continue;
    const judge::VectorSet set = judge::make_vectors(formula_named(name), a.options);
    const judge::VectorTables tables = judge::vectors_tables(set);
    const std::size_t rows = set.vectors.size();
    const std::filesystem::path stem = std::filesystem::path(a.out) / name;
    const auto add = [&](const char* ending, std::string content) {
      bytes += content.size();
      files.emplace_back(stem.string() + ending, std::move(content));
    };
    add(".json", judge::vectors_json(set, a.options, version, a.command));
    add(".txt", judge::vectors_text(set));
    add(".inputs.npy", npy(tables.inputs, {rows, tables.input_columns}));
    add(".truths.npy", npy(tables.truths, {rows, tables.truth_columns, 2}));
    add(".denominators.npy", npy(tables.denominators, {rows, 3}));
    vectors += rows;
    fmt::print("{}: {} vectors; {} of {} inputs fail no known defect\n", name, rows, set.without_defect,
               set.candidates);
    std::fflush(stdout);
  }
  reports::replace_files(files);
  fmt::print("{} vectors of {} formulas in {}: {:.1f} MB\n", vectors, files.size() / 5, a.out,
             static_cast<double>(bytes) / 1e6);
  return success;
}

}  // namespace

void add_vectors(CommandLine& line, const std::string& command_line) {
  Command command =
      line.command("vectors", "write test vectors: exact inputs, truths in 40 digits, the defects they find");
  auto a = std::make_shared<VectorArguments>();
  a->command = command_line;
  command.option("--out", a->out, "a folder for the files, made where it is missing").taking("DIR").required();
  command.option("--formulas", a->formulas, "names and globs with commas between").taking("GLOB").showing_default();
  command.option("--seed", a->options.seed, "of the samples").showing_default();
  command.option("--jobs", a->options.jobs, "threads; 0: one a core").in_range(0, 1024).showing_default();
  command.example("cageproof vectors --formulas triangle.single_layer --out vectors");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
