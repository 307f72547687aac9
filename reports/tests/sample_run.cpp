// SPDX-License-Identifier: MIT
#include "sample_run.h"

#include "cageproof/core/catalogue/formula.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/catalogue/role.h"
#include "cageproof/core/whole_file.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cmath>
#include <numbers>

namespace cageproof::reports {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Regime {
  const char* name;
  const char* parameter;
  int first_decade, last_decade;
};
constexpr std::array kRegimes{Regime{"generic", "distance / size", -1, 1},
                              Regime{"near-face", "distance / size", -1, -16},
                              Regime{"near-edge", "distance / size", -1, -16},
                              Regime{"near-vertex", "distance / size", -1, -16},
                              Regime{"near-plane", "distance / size", -1, -16},
                              Regime{"near-line", "distance / size", -1, -16},
                              Regime{"on-face", "distance in ulps", 0, 1},
                              Regime{"far", "distance / size", 1, 8},
                              Regime{"sliver", "aspect", -1, -10},
                              Regime{"needle", "aspect", -1, -10},
                              Regime{"scaled", "unit of length", -100, 100},
                              Regime{"offset", "offset / size", 1, 8}};

double clipped(double error) { return error > 1e18 ? kInfinity : error; }

// Small for the closed form; growing with the distance to the generic case for quadrature.
double made_up_error(int evaluation, int order, int decades, RandomStream& stream) {
  const double base = stream.uniform(0.5, 5) * (1 + order);
  if (evaluation == 0) return base * (decades > 12 ? 6 : 1);
  const double growth = evaluation == 1 ? 0.6 : evaluation == 2 ? 1.5 : 0.15;
  return clipped(base * std::pow(10, growth * decades * (1 + 0.3 * order)));
}

WorstCase made_up_case(double error, double parameter, RandomStream& stream) {
  WorstCase worst{error, parameter, stream.bits(), {}, Vec3<double>(stream.uniform(), -0.0, 1e-320), {}};
  for (int k = 0; k < 3; ++k) worst.corners.push_back(Vec3<double>(stream.uniform(), stream.uniform(-1, 1), 0.1));
  return worst;
}

void add_check(RunResult& run, const Formula& formula, const char* evaluation, int index, const char* scalar,
               const Regime& regime, int order) {
  RandomStream stream(7, fmt::format("{}{}{}{}", formula.name, evaluation, scalar, regime.name), order);
  ResultCurve curve{
      {RowKey::Section::Element, std::string(formula.name), evaluation, scalar, regime.name, "truth", "", order},
      regime.parameter,
      {},
      {}};
  ErrorHistogram histogram;
  const int step = regime.first_decade < regime.last_decade ? 1 : -1;
  for (int decade = regime.first_decade; decade != regime.last_decade + step; decade += step) {
    const double error =
        made_up_error(index, order, std::abs(decade) / (std::abs(regime.last_decade) > 20 ? 10 : 1), stream);
    curve.parameters.push_back(std::pow(10.0, decade));
    curve.errors.push_back(error);
    histogram.add(error);
  }
  ResultRow row;
  row.subject = curve.subject;
  row.evaluation = evaluation;
  row.scalar = scalar;
  row.setting = regime.name;
  row.check = "truth";
  row.order = order;
  row.role = curve.role = name_of(index == 0 ? Role::Recommended : Role::Rule);
  row.unit = "conditioned";
  row.samples = 20000 + histogram.count();
  row.nonfinite = histogram.nonfinite();
  row.max = histogram.max();
  row.p999 = histogram.p999();
  row.median = histogram.median();
  row.max_relative = row.max * 1.1e-16;
  const auto counts = histogram.counts();
  row.histogram.assign(counts.begin(), counts.end());
  if (index == 0) {
    row.bound = 64;
    row.reason = "backward stable";
    row.verdict = row.max <= 64 ? Verdict::Kept : Verdict::Broken;
  } else {
    row.reason = "no rule can promise this, \"near\" the element";
  }
  row.worst.push_back(made_up_case(row.max, curve.parameters.back(), stream));
  row.worst.push_back(made_up_case(row.max / 2, curve.parameters.front(), stream));
  run.rows.push_back(row);
  run.curves.push_back(std::move(curve));
  if (index > 0) return;
  for (const char* check : {"scaling", "rigid_motion", "subdivision"}) {
    row.check = check;
    row.max /= 1.7;
    row.verdict = row.max <= 64 ? Verdict::Kept : Verdict::Broken;
    row.worst.resize(1);
    run.rows.push_back(row);
  }
}

void add_cage(RunResult& run, const char* cage) {
  for (const char* kind : {"mean_value", "green", "biharmonic"})
    for (const char* check : {"partition_of_unity", "linear_reproduction", "gradient_differences"})
      for (const char* place : {"inside", "outside", "on-face"}) {
        RandomStream stream(9, std::string(cage) + kind + check + place, 0);
        ResultRow row;
        row.section = ResultRow::Section::Cage;
        row.subject = kind;
        row.evaluation = "closed_form";
        row.scalar = "double";
        row.setting = cage;
        row.check = check;
        row.place = place;
        row.unit = "absolute";
        row.samples = 1000;
        row.max = stream.uniform(1, 9) * 1e-14;
        row.p999 = row.max / 3;
        row.median = row.max / 100;
        row.bound = 1e-12;
        row.verdict = Verdict::Kept;
        row.worst.push_back({row.max, 0, 17, {}, Vec3<double>(0.25, 1.0 / 3, -2), {}});
        run.rows.push_back(row);
      }
}

void add_deformers(RunResult& run, const char* cage) {
  for (const char* variant : {"stretch=rms", "stretch=unit"})
    for (const char* check : {"keeps_rigid", "keeps_scale"}) {
      ResultRow row;
      row.section = ResultRow::Section::Deformer;
      row.subject = "green";
      row.evaluation = variant;
      row.scalar = "double";
      row.setting = cage;
      row.check = check;
      row.place = "rotation";
      row.unit = "cage sizes";
      row.samples = row.asked = 12;
      row.max = row.max_relative = 3e-16;
      row.bound = 1e-12;
      row.verdict = Verdict::Kept;
      row.worst.push_back({row.max, 0, 5, {}, Vec3<double>(0.25, 1.0 / 3, -2), {}});
      run.rows.push_back(row);
    }
}

}  // namespace

RunResult sample_run(int formulas, int regimes) {
  RunResult run;
  run.version = "0.1.0";
  run.suite = "standard";
  run.seed = 20240607;
  run.settings = {{"triangulation", "shortest"}, {"cage file", "FireHydrant_Cage.obj"}};
  run.sessions = {{"2024-06-07T08:09:10Z",
                   187.25,
                   "cageproof verify --suite standard --out \"a <report>\"",
                   {{"processor", "two cores of something"}, {"compiler", "GCC 12.2.0"}, {"Eigen", "3.4.0"}}}};
  for (int f = 0; f < formulas; ++f)
    for (int r = 0; r < regimes; ++r)
      for (int order = 0; order < 3; ++order) {
        const Formula& formula = *std::next(catalogue().begin(), f);
        add_check(run, formula, "closed_form", 0, "double", kRegimes[r], order);
        add_check(run, formula, "closed_form", 0, "float", kRegimes[r], order);
        add_check(run, formula, "gauss-8", 1, "double", kRegimes[r], order);
        add_check(run, formula, "quads-75", 2, "double", kRegimes[r], order);
        add_check(run, formula, "near_singular", 3, "double", kRegimes[r], order);
      }
  for (const char* cage : {"cube", "icosphere", "torus", "FireHydrant_Cage.obj"}) add_cage(run, cage);
  for (const char* cage : {"cube", "square"}) add_deformers(run, cage);
  run.notes = {"regime far: the integral reached 24 digits on 3 of 8 samples", "a note with <b>markup</b> & more"};
  run.errata.push_back({.source = "[X24] Eq 3",
                        .printed = "a < b",
                        .correct = "b",
                        .formula = "triangle.single_layer",
                        .evaluation = "as-printed-eq3",
                        .regime = "generic",
                        .order = 2,
                        .samples = 24,
                        .nonfinite = 3,
                        .printed_error = 0.401,
                        .corrected_error = 3e-40});
  ErratumRow& text = run.errata.emplace_back();
  text.source = "[X24] Eq 4";
  text.printed = "V'; D'";
  text.correct = "V'; N'";
  return run;
}

ImageField sample_slice(const std::string& name, int n) {
  ImageField field{name, {2 * n, n, 1}, Vec3<double>(-1, -0.5, 0.125), Vec3<double>(1.0 / n, 1.0 / n, 1), {}};
  ImageField::Array error{"relative error", "1", 1, {}}, gradient{"gradient", "1/m", 3, {}};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < 2 * n; ++i) {
      const double x = -1 + 1.0 * i / n, y = -0.5 + 1.0 * j / n, r = std::hypot(x, y);
      error.values.push_back(r < 0.2 ? kNan
                                     : 1e-16 * std::exp(25 * std::exp(-8 * (r - 0.2)) * std::abs(std::sin(9 * x))));
      for (const double g : {x, y, 0.0}) gradient.values.push_back(g);
    }
  error.values[3 * n + 5] = kInfinity;
  error.values[3 * n + 6] = 0;
  field.arrays = {error, gradient};
  return field;
}

MeshField sample_mesh(const std::string& name, int n) {
  MeshField field{name, {}, {}, {}};
  ImageField::Array error{"partition of unity", "1", 1, {}};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i < 2 * n; ++i) {
      const double a = std::numbers::pi * i / n, b = std::numbers::pi * j / n;
      field.vertices.push_back({std::sin(b) * std::cos(a), std::cos(b), 0.6 * std::sin(b) * std::sin(a)});
      error.values.push_back(std::pow(10.0, -13 + 2 * std::sin(3 * a) * std::cos(2 * b)));
      if (j < n)
        field.faces.push_back(
            {2 * n * j + i, 2 * n * j + (i + 1) % (2 * n), 2 * n * (j + 1) + (i + 1) % (2 * n), 2 * n * (j + 1) + i});
    }
  error.values[1] = kNan;
  error.values[2] = kInfinity;
  field.arrays = {error};
  return field;
}

std::map<std::string, std::string> files_below(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      files[std::filesystem::relative(entry.path(), folder).string()] = read_file(entry.path());
  return files;
}

ScratchFolder::ScratchFolder() {
  for (int n = 0; path_.empty(); ++n) {
    const auto candidate =
        std::filesystem::temp_directory_path() / fmt::format("cageproof-reports-{}-{}", ::getpid(), n);
    if (std::filesystem::create_directory(candidate)) path_ = candidate;
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace cageproof::reports
