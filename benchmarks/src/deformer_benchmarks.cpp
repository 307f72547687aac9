// SPDX-License-Identifier: MIT
#include "deformer_benchmarks.h"

#include "cageproof/core/cage/embedded_cages.h"
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/geometry/winding_number.h"
#include "cageproof/deformation/constrained.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <mutex>

namespace cageproof::benchmarks {

using namespace deformation;
namespace {

// A method on a cage, made as far as a benchmark needs it. Model: Deformer<double> or ConstrainedDeformer<double>.
template <class Model>
class Stages {
 public:
  using Pose = std::unique_ptr<const Posed<double>> (*)(const Model& model, const DeformedCage& what);

  Stages(std::shared_ptr<const DeformedCage> what, std::function<std::shared_ptr<const Model>()> how, Pose posing)
      : what_(std::move(what)), prepare_(std::move(how)), pose_(posing) {}

  const DeformedCage& what() const { return *what_; }
  std::shared_ptr<const Model> prepare() const { return prepare_(); }
  const Model& model() const {
    std::call_once(prepared_, [this] { model_ = prepare(); });
    return *model_;
  }
  std::unique_ptr<const Posed<double>> pose() const { return pose_(model(), *what_); }
  std::vector<CoordinateTable<double>> coordinates() const {
    return model().coordinates().template at<double>(what_->points, 0);
  }

 private:
  std::shared_ptr<const DeformedCage> what_;
  std::function<std::shared_ptr<const Model>()> prepare_;
  Pose pose_;
  mutable std::once_flag prepared_;
  mutable std::shared_ptr<const Model> model_;
};

// Calls make() as often as the state asks for; what it returns is used.
void time(benchmark::State& state, std::size_t points, const auto& make) {
  const std::clock_t start = std::clock();
  for (auto _ : state) {
    auto made = make();
    benchmark::DoNotOptimize(made);
    benchmark::ClobberMemory();
  }
  if (points == 0) return;
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  state.counters["ns_per_point"] =
      1e9 * seconds / (static_cast<double>(state.iterations()) * static_cast<double>(points));
}

// Registers the stages of one method.
template <class Model>
void add_stages(std::string_view method, std::shared_ptr<const Stages<Model>> stages, std::vector<std::string>& names) {
  const auto add = [&](std::string_view stage, auto run) {
    names.push_back(fmt::format("deform/{}/{}/{}", stages->what().name, method, stage));
    benchmark::RegisterBenchmark(names.back().c_str(), run)->Unit(benchmark::kMillisecond);
  };
  add("prepare", [stages](benchmark::State& state) { time(state, 0, [&] { return stages->prepare(); }); });
  add("coordinates", [stages](benchmark::State& state) {
    stages->model();
    time(state, stages->what().points.size(), [&] { return stages->coordinates(); });
  });
  add("pose", [stages](benchmark::State& state) {
    stages->model();
    time(state, 0, [&] { return stages->pose(); });
  });
  add("images", [stages](benchmark::State& state) {
    const auto tables = stages->coordinates();
    const auto posed = stages->pose();
    const std::size_t points = stages->what().points.size();
    time(state, points, [&] { return posed->images(tables, points, 0); });
  });
}

Vec3<double> sheared(const Vec3<double>& v) { return {v[0] + 0.25 * v[1], v[1] - 0.125 * v[0], v[2]}; }

// Points inside, a few drawn to where the shear takes them; where more is taken, some others are to turn, and the rest
// not to bend.
Constraints constraints_in(const DeformedCage& what, bool positions_alone) {
  constexpr std::size_t positions = 3, rotations = 8, hessians = 60;
  const CageElements elements(what.cage, false, Triangulation::Shortest);
  std::vector<Triangle<double>> triangles;
  std::vector<Segment<double>> segments;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.corners(e);
    if (corners.size() == 2) segments.push_back({corners[0], corners[1]});
    else triangles.push_back({corners[0], corners[1], corners[2]});
  }
  Constraints found;
  for (const Vec3<double>& p : what.points) {
    if ((segments.empty() ? winding_number(triangles, p) : winding_number(segments, p)) != 1) continue;
    if (found.positions.size() < positions) found.positions.push_back({p, sheared(p)});
    else if (positions_alone) break;
    else if (found.rotations.size() < rotations) found.rotations.push_back(p);
    else if (found.hessians.size() < hessians) found.hessians.push_back(p);
  }
  return found;
}

// The method as it is, by its name, and with each other value of a parameter that chooses a subspace.
std::vector<std::pair<std::string, std::vector<double>>> variants_of(const ConstraintMethod& method) {
  std::vector<std::pair<std::string, std::vector<double>>> found{{std::string(method.name), {}}};
  const auto subspace = std::ranges::find(method.parameters, "subspace", &KindParameter::name);
  if (subspace == method.parameters.end()) return found;
  std::vector<double> presets;
  presets.reserve(method.parameters.size());
  for (auto p = method.parameters.begin(); p != subspace; ++p) presets.push_back(p->preset);
  found.reserve(subspace->names.size());
  for (std::size_t k = 0; k < subspace->names.size(); ++k) {
    const auto value = static_cast<double>(k);
    if (value == subspace->preset) continue;
    found.emplace_back(fmt::format("{}-{}", method.name, subspace->names[k]), presets).second.push_back(value);
  }
  return found;
}

}  // namespace

DeformedCage embedded_deformed_cage(std::string_view name, int points) {
  DeformedCage found{std::string(name), embedded_cage(name), {}, {}};
  Vec3<double> low = found.cage.vertices().front(), high = low;
  for (const Vec3<double>& v : found.cage.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
    found.posed.push_back(sheared(v));
  }
  found.points.reserve(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    RandomStream random(0, fmt::format("deform/{}", name), i);
    Vec3<double> p = Vec3<double>::Zero();
    for (int c = 0; c < found.cage.dimension(); ++c) p[c] = random.uniform(low[c], high[c]);
    found.points.push_back(p);
  }
  return found;
}

std::vector<std::string> register_deformer_benchmarks(const std::shared_ptr<const DeformedCage>& what) {
  std::vector<std::string> names;
  for (const DeformMethod& method : deform_methods()) {
    if (!why_refused(method, what->cage).empty()) continue;
    using Model = Deformer<double>;
    add_stages<Model>(method.name,
                      std::make_shared<const Stages<Model>>(
                          what, [what, &method] { return prepare_deformer<double>(method, what->cage, {}); },
                          [](const Model& model, const DeformedCage& of) { return model.pose({of.posed}); }),
                      names);
  }
  for (const ConstraintMethod& method : constraint_methods()) {
    if (method.dimension != 0 && method.dimension != what->cage.dimension()) continue;
    const Constraints constraints = constraints_in(*what, method.positions_alone);
    if (constraints.positions.empty()) continue;
    using Model = ConstrainedDeformer<double>;
    for (const auto& [name, parameters] : variants_of(method))
      add_stages<Model>(name,
                        std::make_shared<const Stages<Model>>(
                            what,
                            [what, constraints, &method, parameters] {
                              return prepare_constrained(method, what->cage, constraints, {.parameters = parameters});
                            },
                            [](const Model& model, const DeformedCage&) { return model.pose(); }),
                        names);
  }
  return names;
}

}  // namespace cageproof::benchmarks
