// SPDX-License-Identifier: MIT
#include "boundary_data.h"
#include "commands.h"
#include "coordinate_files.h"
#include "dropping.h"
#include "inputs_outside.h"
#include "judge_option.h"
#include "on_cage.h"
#include "progress.h"
#include "rows_file.h"
#include "solved_file.h"
#include "summary_lines.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/parallel.h"
#include "cageproof/reports/checked_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

namespace cageproof::cli {
namespace {

struct Arguments {
  CageArguments cage;
  std::string points, kind, evaluation, out, solved, data;
  std::vector<std::string> parameters;
  int order = 0, jobs = 0;
  double on = 0;  ///< a share of the cage's size
  bool strict = false, keep_quads = false;
  Dropping dropping;
  JudgeOption judge;
};

void warn(const std::string& text) { fmt::print(stderr, "warning: {}\n", text); }

// Beyond this a solution by least squares is not the function that its data belong to to the digits it aims at.
constexpr double kMetData = 1e-8;

// Says what was solved for the cage, and warns where the solution is not unique, or does not meet its data. Functions
// by least squares are more than independent ones: their rank says nothing.
void tell_solved(const CageCoordinates& coordinates) {
  for (const SolvedSystem& s : coordinates.solved()) {
    remark(fmt::format("solved {}: {} x {}, rank {}, condition {:.2g}, residual {:.2g}", s.name, s.rows, s.columns,
                       s.rank, s.condition, s.residual));
    if (!std::isnan(s.boundary_values)) {
      const bool with_gradients = !std::isnan(s.boundary_gradients);
      remark(fmt::format("  meets its data on the boundary to {:.2g}{}", s.boundary_values,
                         with_gradients ? fmt::format(", gradients to {:.2g}", s.boundary_gradients) : ""));
      if (s.boundary_values > kMetData)
        warn(fmt::format("{}: the data on the boundary are met only to {:.2g}, and values inside are no better", s.name,
                         s.boundary_values));
    } else if (s.is_singular())
      warn(fmt::format("{}: the system is singular: its rank is {}, not {}; the least solution is taken", s.name,
                       s.rank, s.columns));
  }
}

// JSON has no infinity, so an infinite number is null.
nlohmann::ordered_json solved_json(const CageCoordinates& coordinates) {
  nlohmann::ordered_json all = {{"schema", "cageproof-solved"}, {"schema_version", 1}};
  all["kind"] = coordinates.kind().name;
  all["evaluation"] = coordinates.evaluation();
  all["systems"] = nlohmann::ordered_json::array();
  for (const SolvedSystem& s : coordinates.solved())
    all["systems"].push_back({{"name", s.name},
                              {"rows", s.rows},
                              {"columns", s.columns},
                              {"rank", s.rank},
                              {"singular", s.is_singular()},
                              {"condition", s.condition},
                              {"residual", s.residual},
                              {"boundary_values", s.boundary_values},
                              {"boundary_gradients", s.boundary_gradients}});
  return all;
}

// Number of blocks of points that are computed before their rows are written.
std::size_t parts_together(std::size_t columns, int jobs) {
  // Text of a number takes about 20 bytes.
  constexpr std::size_t bytes = std::size_t{1} << 26, of_number = 20;
  const std::size_t fitting = bytes / (of_number * points_together(columns) * columns);
  return std::max(fitting, static_cast<std::size_t>(threads_for(jobs)));
}

// The file of --solved.
std::string solved_text(const Arguments& a, const CageCoordinates& coordinates, const Cage& cage,
                        const CoordinateOptions& options) {
  if (!holds_matrices(a.solved)) return solved_json(coordinates).dump(2) + '\n';
  return matrices_text(deformation::solved_matrices(coordinates.kind().name, cage, options));
}

// The file of solved systems must not be one that is read.
void check_solved_file(const Arguments& a) {
  if (a.solved.empty()) return;
  if (holds_matrices(a.solved) && !a.kind.starts_with("regularised_"))
    throw InputError(
        fmt::format("--solved {}: {} has no matrices to write, which kinds named regularised_... have; "
                    ".json takes ranks, conditions and residuals",
                    a.solved, a.kind));
  reports::require_writable({a.solved});
  const auto solved = place_of(a.solved);
  for (const auto& [file, option] : {std::pair(a.cage.file, "--cage"), {a.points, "--points"}, {a.data, "--data"}})
    if (!file.empty() && place_of(file) == solved)
      throw InputError(fmt::format("{}: --solved is the file of {}, too", a.solved, option));
}

// Takes rows of consecutive points, from any thread: the number of their block since the last flush, the first point.
using TakePart = std::function<void(std::size_t part, std::size_t first, std::span<const double> rows)>;

// Computes rows by blocks of points, so many at a time that what was made of them is flushed.
validation::CoordinateSummary for_all_rows(const Arguments& a, const CageCoordinates& coordinates, const Cage& cage,
                                           std::span<const Vec3<double>> points, std::size_t columns, std::size_t parts,
                                           const TakePart& take, const std::function<void()>& flush) {
  validation::SummaryMaker summary(coordinates, cage, a.order);
  Progress progress;
  std::atomic<std::size_t> done = 0;
  const std::size_t together = points_together(columns), most = parts * together;
  for (std::size_t begin = 0; begin < points.size(); begin += most) {
    for_rows(coordinates, points, begin, std::min(most, points.size() - begin), a.order, a.jobs,
             [&](std::size_t first, std::size_t count, std::span<const double> rows) {
               summary.add(first, points.subspan(first, count), rows);
               take((first - begin) / together, first, rows);
               progress("coordinates", done += count, points.size());
             });
    flush();
  }
  progress.clear();
  return summary.summary();
}

// Computes and writes: by rows where the file's format allows it, else as a whole.
validation::CoordinateSummary written(const Arguments& a, const CageCoordinates& coordinates, const Cage& cage,
                                      const Mesh& mesh, std::span<const Vec3<double>> points, const BoundaryData& data,
                                      const DescribedRun& described) {
  const bool by_rows = is_written_by_rows(a.out);
  CoordinateColumns table = headed_columns(coordinates, a.order);
  const std::size_t columns = table.names.size();
  if (!a.data.empty()) table = function_columns(coordinates, a.order, data);
  const std::size_t written_columns = table.names.size();
  if (!by_rows) require_memory_for(a.out, points.size(), written_columns);
  std::optional<RowsFile> file;
  if (by_rows) file.emplace(a.out, table, points.size());
  else table.values.resize(points.size() * written_columns);
  // Lines of CSV wait in memory until those before them are written, so only this many parts are computed at a time.
  const std::size_t parts = parts_together(columns, a.jobs);
  if (file) file->expect(parts);
  const auto take = [&](std::size_t part, std::size_t first, std::span<const double> rows) {
    std::vector<double> functions;
    if (!a.data.empty()) rows = functions = functions_of(rows, coordinates, a.order, data);
    if (file) file->put(part, first, rows);
    else std::ranges::copy(rows, &table.values[first * written_columns]);
  };
  const validation::CoordinateSummary summary = for_all_rows(a, coordinates, cage, points, columns, parts, take, [&] {
    if (file) file->flush();
  });
  const reports::DescribedCage of_cage = described_cage(coordinates, cage, a.cage.rule());
  const auto description = description_of(coordinates, table, described);
  if (!file) reports::replace_files(coordinate_files(a.out, table, mesh, of_cage, description, coordinates));
  else if (a.out.empty()) file->finish({});
  else file->finish({description_file(a.out, of_cage, description)});
  return summary;
}

// The same of weights that are left when small ones are dropped.
validation::CoordinateSummary written_sparse(const Arguments& a, const CageCoordinates& coordinates, const Cage& cage,
                                             std::span<const Vec3<double>> points, const DescribedRun& described) {
  const double size = cage.size();
  const CoordinateColumns table = headed_columns(coordinates, 0);
  const std::size_t columns = table.names.size(), parts = parts_together(columns, a.jobs);
  SparseFile file(a.out, weights_of(a.dropping, coordinates, size));
  file.expect(parts);
  const validation::CoordinateSummary summary = for_all_rows(
      a, coordinates, cage, points, columns, parts,
      [&](std::size_t part, std::size_t first, std::span<const double> rows) { file.put(part, first, rows); },
      [&] { file.flush(); });
  require_within(a.dropping, file.totals(), size);
  reports::DescribedCage of_cage = described_cage(coordinates, cage, a.cage.rule());
  auto description = description_of(coordinates, table, described);
  description["sparse"] = json_of(a.dropping, file.totals(), size);
  of_cage.metadata = description.dump(2);
  const std::size_t bytes = file.finish(cage_members(of_cage));
  for (const std::string& line : lines_of(a.dropping, file.totals(), size, bytes, columns)) remark(line);
  return summary;
}

int run(Arguments& a) {
  check_solved_file(a);
  check_dropping(a.dropping, a.out, a.order);
  const CoordinateKind& named = coordinate_kind_named(a.kind);
  const CoordinateKind& kind = a.keep_quads ? keeping_quads(named) : named;
  if (a.cage.allow_invalid_quads && !kind.keeps_quads)
    throw InputError(fmt::format("--allow-invalid-quads: {} splits quads in triangles", kind.name));
  require_one_reader_of_input({{a.cage.file, "--cage"}, {a.points, "--points"}, {a.data, "--data"}});
  if (!a.out.empty())
    check_coordinate_files(
        a.out, {{a.cage.file, "--cage"}, {a.points, "--points"}, {a.data, "--data"}, {a.solved, "--solved"}});
  const Cage cage = a.cage.load();
  if (cage.allows_invalid_quads())
    for (const std::string& fault : invalid_quads(cage))
      warn(fmt::format("{}: {} (faces counted from 0)", cage.name(), fault));
  const Mesh mesh = load_points(a.points, cage.dimension());
  const std::vector<double> parameters = parameters_from(a.parameters, parameters_of(kind), kind.name);
  if (a.judge.is_given()) {
    std::vector<std::string_view> names;
    for (const Formula* formula : formulas_of(kind, cage)) names.push_back(formula->name);
    if (names.empty()) throw InputError(fmt::format("{} is no sum of formulas that --judge could give", kind.name));
    a.judge.begin(fmt::format("{}", fmt::join(names, ",")));
  }
  const CoordinateOptions options{a.evaluation.empty() ? std::string(quickest) : a.evaluation, a.cage.rule(),
                                  parameters};
  const CageCoordinates coordinates(cage, kind, options);
  std::vector<Vec3<double>> points = mesh.vertices;
  take_onto_cage(a.on, coordinates, cage.size(), points, a.jobs);
  for (const CoordinateBlock& block : coordinates.blocks())
    if (block.reproduces == Reproduces::Normals && !std::isfinite(block.normal_factor))
      warn(fmt::format(
          "{} with these parameters: normals have no finite normal_factor, and positions are not reproduced",
          kind.name));
  const BoundaryData data = a.data.empty() ? BoundaryData() : read_boundary_data(a.data, coordinates);
  tell_solved(coordinates);
  if (!a.solved.empty()) reports::replace_file(a.solved, solved_text(a, coordinates, cage, options));
  const DescribedRun described{a.cage.file, a.points, a.cage.triangulate, a.data,
                               parameters,  a.order,  a.cage.merge,       a.on};
  const validation::CoordinateSummary summary = a.dropping.is_asked()
                                                    ? written_sparse(a, coordinates, cage, points, described)
                                                    : written(a, coordinates, cage, mesh, points, data, described);
  for (const std::string& line : lines_of(summary, kind, cage)) {
    if (line.starts_with("warning: ")) fmt::print(stderr, "{}\n", line);
    else remark(line);
  }
  return a.strict && summary.unusable + summary.misplaced + summary.without_derivatives() > 0 ? promise_broken
                                                                                              : success;
}

std::string names_of_kinds() {
  std::vector<std::string_view> names;
  for (const CoordinateKind& kind : coordinate_kinds()) names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

void add_coordinates(CommandLine& line) {
  Command command = line.command("coordinates", "compute coordinates of points in a cage");
  auto a = std::make_shared<Arguments>();
  command.heading("Cage and points");
  a->cage.add_to(command, true);
  command
      .option("--points", a->points,
              "a mesh, .npy, .npz, or text with three numbers per line, for polygons two; - is standard input" +
                  std::string(y_of_points))
      .taking("FILE")
      .required();
  add_on(command, a->on);
  command.heading("Coordinates");
  command.option("--kind", a->kind, names_of_kinds()).taking("KIND").required();
  command.flag("--keep-quads", a->keep_quads,
               "keep quads as bilinear surfaces: --kind green becomes quad_green, and likewise mean_value, biharmonic "
               "and somigliana");
  command.flag("--allow-invalid-quads", a->cage.allow_invalid_quads,
               "compute with quads that are not valid; for kinds that keep quads");
  command
      .option("--parameter", a->parameters,
              "mu=..., nu=... of somigliana (nu in (-1, 0.5] or inf or -inf), nu=... of elastic; pieces=1 ... 64, "
              "collocation=NAME of "
              "kinds that solve boundary equations; level=..., gamma_d=... of regularised ones; `list` names all")
      .taking("NAME=VALUE");
  command
      .option("--evaluation", a->evaluation,
              "batched, or an evaluation of the kind's formulas, such as closed_form; if not given, batched if the "
              "kind has it, otherwise the recommended one")
      .taking("EVALUATION");
  a->judge.add_to(command);
  command.option("--order", a->order, "0 values, 1 and gradients, 2 and Hessians").in_range(0, 2).showing_default();
  command.heading("Output");
  command
      .option("--out", a->out,
              ".npz (named arrays with the cage, its elements and normals), .csv or .npy (points x columns, and "
              "next to it a .json that describes them), or .vtp (and next to it the cage as .cage.vtp); CSV on "
              "standard output if not given")
      .taking("FILE");
  Option data = command.option("--data", a->data,
                               "text with one line of numbers per coordinate: write the functions that the coordinates "
                               "interpolate, one per column, instead of coordinates");
  add_dropping(command, a->dropping, data.taking("FILE"));
  command
      .option("--solved", a->solved,
              "a JSON file for rank, condition and residual of each solved system; or an .npz for the matrices of "
              "kinds named regularised_...")
      .taking("FILE");
  command.heading("Running");
  command.flag("--strict", a->strict,
               "exit with 1 if a point has no finite coordinates or derivatives, lies where they sum to zero, or is "
               "not reproduced to 8 digits");
  command.option("--jobs", a->jobs, "threads; 0: one per core").in_range(0, 1024).showing_default();
  add_quiet(command);
  command.runs([a] { return run(*a); });
}

}  // namespace cageproof::cli
