// SPDX-License-Identifier: MIT
#include "commands.h"
#include "npz.h"

#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/results/build_facts.h"
#include "cageproof/judge/cage_vectors.h"
#include "cageproof/judge/vectors.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/ranges.h>

#include <concepts>
#include <filesystem>

namespace cageproof::cli {
namespace {

struct VectorArguments {
  std::string out, formulas, kinds, cages = "*", command;
  judge::VectorOptions options;
};

template <class T>
std::string npy(const std::vector<T>& numbers, const std::vector<std::size_t>& shape) {
  std::string bytes = npy_header(std::same_as<T, double> ? "<f8" : "<i4", shape);
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
  return bytes;
}

struct Written {
  std::vector<std::pair<std::filesystem::path, std::string>> files;
  std::size_t vectors = 0, bytes = 0;

  void add(const std::filesystem::path& stem, const char* ending, std::string content) {
    bytes += content.size();
    files.emplace_back(stem.string() + ending, std::move(content));
  }
};

void add_cages(Written& written, const VectorArguments& a, const std::string& version) {
  for (const std::string_view kind : judge::vector_kinds()) {
    if (!matches(a.kinds, kind)) continue;
    for (const std::string_view cage : judge::vector_cages()) {
      if (!matches(a.cages, cage) || !judge::has_vectors(kind, cage)) continue;
      const judge::CageVectorSet set = judge::make_cage_vectors(kind, cage, a.options);
      const judge::CageVectorTables tables = judge::cage_vectors_tables(set);
      const std::size_t rows = set.vectors.size();
      const std::filesystem::path stem = std::filesystem::path(a.out) / fmt::format("{}.{}", kind, cage);
      written.add(stem, ".json", judge::cage_vectors_json(set, a.options, version, a.command));
      written.add(stem, ".txt", judge::cage_vectors_text(set));
      written.add(stem, ".vertices.npy", npy(tables.vertices, {set.question.vertices.size(), tables.dimension}));
      written.add(stem, ".faces.npy", npy(tables.faces, {set.question.faces.size(), tables.corners}));
      written.add(stem, ".points.npy", npy(tables.points, {rows, tables.dimension}));
      written.add(stem, ".truths.npy", npy(tables.truths, {rows, tables.coordinates, 2}));
      written.add(stem, ".denominators.npy", npy(tables.denominators, {rows, set.blocks.size()}));
      written.vectors += rows;
      fmt::print("{} in {}: {} vectors; of {} points {} fail no known defect, and {} have no truth to 28 digits\n",
                 kind, cage, rows, set.candidates, set.without_defect, set.without_truth);
      std::fflush(stdout);
    }
  }
}

std::vector<std::string_view> formula_names() {
  std::vector<std::string_view> names;
  for (const Formula& formula : catalogue())
    if (validation::has_truth_source(formula)) names.push_back(formula.name);
  return names;
}

void add_formulas(Written& written, const VectorArguments& a, const std::string& version) {
  for (const std::string_view name : formula_names()) {
    if (!matches(a.formulas, name)) continue;
    const judge::VectorSet set = judge::make_vectors(formula_named(name), a.options);
    const judge::VectorTables tables = judge::vectors_tables(set);
    const std::size_t rows = set.vectors.size();
    const std::filesystem::path stem = std::filesystem::path(a.out) / name;
    written.add(stem, ".json", judge::vectors_json(set, a.options, version, a.command));
    written.add(stem, ".txt", judge::vectors_text(set));
    written.add(stem, ".inputs.npy", npy(tables.inputs, {rows, tables.input_columns}));
    written.add(stem, ".truths.npy", npy(tables.truths, {rows, tables.truth_columns, 2}));
    written.add(stem, ".denominators.npy", npy(tables.denominators, {rows, 3}));
    written.vectors += rows;
    fmt::print("{}: {} vectors; {} of {} inputs fail no known defect\n", name, rows, set.without_defect,
               set.candidates);
    std::fflush(stdout);
  }
}

int run(const VectorArguments& given) {
  VectorArguments a = given;
  if (a.formulas.empty() && a.kinds.empty()) a.formulas = "triangle.*,segment.*";
  if (!a.formulas.empty()) require_known("formula", a.formulas, formula_names());
  if (!a.kinds.empty()) require_known("kind of coordinates", a.kinds, judge::vector_kinds());
  require_known("cage", a.cages, judge::vector_cages());
  std::error_code failed;
  std::filesystem::create_directories(a.out, failed);
  if (failed) throw InputError(fmt::format("cannot make the folder {}: {}", a.out, failed.message()));
  const std::string version = fmt::format("{} (commit {})", CAGEPROOF_VERSION, build_commit());
  Written written;
  if (!a.formulas.empty()) add_formulas(written, a, version);
  if (!a.kinds.empty()) add_cages(written, a, version);
  reports::replace_files(written.files);
  fmt::print("{} vectors in {}: {:.1f} MB\n", written.vectors, a.out, static_cast<double>(written.bytes) / 1e6);
  return success;
}

}  // namespace

void add_vectors(CommandLine& line, const std::string& command_line) {
  Command command =
      line.command("vectors", "write test vectors: exact inputs, truths in 40 digits, the defects they find");
  auto a = std::make_shared<VectorArguments>();
  a->command = command_line;
  command.option("--out", a->out, "a folder for the files, which is made if it is missing").taking("DIR").required();
  command
      .option("--formulas", a->formulas,
              "names and globs with commas between; without --formulas and --kinds all formulas of triangles and "
              "segments")
      .taking("GLOB");
  command
      .option("--kinds", a->kinds,
              fmt::format("coordinates of whole cages: {}, or globs", fmt::join(judge::vector_kinds(), ", ")))
      .taking("GLOB");
  command.option("--cages", a->cages, "cages for --kinds: names or globs").taking("GLOB").showing_default();
  command.option("--seed", a->options.seed, "seed of the samples").showing_default();
  command.option("--jobs", a->options.jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  command.example("cageproof vectors --kinds mean_value --out vectors");
  command.example("cageproof vectors --formulas triangle.single_layer --out vectors");
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
