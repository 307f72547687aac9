// SPDX-License-Identifier: MIT
#include "derivative_benchmarks.h"

#include "timed_run.h"

#include "cageproof/core/coordinates/rest_derivative.h"
#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/core/lazy.h"
#include "cageproof/deformation/deformer.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

namespace cageproof::benchmarks {
namespace {

using deformation::Deformer;
using deformation::DeformMethod;
using deformation::Posed;
using deformation::PoseDerivative;

// Calls both as often as the state asks for, in turns.
void time_both(benchmark::State& state, std::size_t points, const auto& product, const auto& values) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  // The first call prepares tables, which are no part of its time.
  values();
  double of_product = 0, of_values = 0;
  const auto timed = [](double& sum, const auto& run) {
    const double start = seconds_of(Clock::Processor);
    auto made = run();
    benchmark::DoNotOptimize(made);
    benchmark::ClobberMemory();
    sum += seconds_of(Clock::Processor) - start;
  };
  for (auto _ : state) {
    timed(of_product, product);
    timed(of_values, values);
  }
  state.counters["ns_per_point"] =
      1e9 * of_product / (static_cast<double>(state.iterations()) * static_cast<double>(points));
  state.counters["ratio"] = of_product / of_values;
}

// A change of the vertices that keeps nothing.
std::vector<Vec3<double>> some_change(const DeformedCage& what) {
  std::vector<Vec3<double>> change;
  for (std::size_t v = 0; v < what.posed.size(); ++v)
    change.push_back(what.posed[v] * (0.01 * static_cast<double>(v % 7)));
  return change;
}

struct PreparedProducts {
  std::shared_ptr<const DeformedCage> what;
  std::shared_ptr<const Deformer<double>> deformer;
  std::unique_ptr<const Posed<double>> posed;
  std::unique_ptr<const PoseDerivative<double>> derivative;
  std::vector<CoordinateTable<double>> tables;
  std::vector<Vec3<double>> change;
  std::vector<double> weights;

  PreparedProducts(std::shared_ptr<const DeformedCage> cage, const DeformMethod& method)
      : what(std::move(cage)),
        deformer(deformation::prepare_deformer<double>(method, what->cage, {.evaluation = std::string(quickest)})),
        posed(deformer->pose({what->posed})),
        derivative(deformer->derivative({what->posed})),
        tables(deformer->coordinates().at<double>(what->points, 0)),
        change(some_change(*what)),
        weights(what->points.size() * static_cast<std::size_t>(what->cage.dimension()), 1.0) {}

  auto images() const { return posed->images(tables, what->points.size(), 0); }
  auto pose() const { return deformer->derivative({what->posed}); }
  auto jvp() const { return derivative->along(change)->images(tables, what->points.size(), 0); }
  auto vjp() const {
    auto gathered = derivative->nothing();
    derivative->gather(tables, what->points.size(), weights, gathered);
    return derivative->back(gathered);
  }
};

struct AtRest {
  CageCoordinates coordinates;
  const RestDerivative& derivative;
  std::vector<Vec3<double>> points, change;
  std::vector<double> values;  // or weights

  AtRest(const DeformedCage& what, const CoordinateKind& kind)
      : coordinates(what.cage, kind, CoordinateOptions{.evaluation = std::string(quickest)}),
        derivative(rest_derivative_of(kind)),
        points(spread(what.points, 10000 / coordinates.elements().count())),
        change(some_change(what)) {
    std::size_t row = 0;
    for (const CoordinateBlock& block : coordinates.blocks())
      row += static_cast<std::size_t>(block.size) * block.entries();
    values.assign(points.size() * row, 1.0);
  }
};

}  // namespace

std::vector<std::string> register_derivative_benchmarks(const std::shared_ptr<const DeformedCage>& what) {
  std::vector<std::string> names;
  const auto add = [&](std::string_view of, std::string_view stage, auto run) {
    names.push_back(fmt::format("derivative/{}/{}/{}", what->name, of, stage));
    add_benchmark(names.back(), run);
  };
  for (const DeformMethod& method : deformation::deform_methods()) {
    if (!method.has_pose_derivative || !why_refused(method, what->cage).empty()) continue;
    const auto made =
        std::make_shared<const Lazy<PreparedProducts>>([what, &method] { return PreparedProducts(what, method); });
    const auto add_product = [&](std::string_view stage, auto product) {
      add(method.name, stage, [what, made, product](benchmark::State& state) {
        const PreparedProducts& prepared = made->get();
        time_both(
            state, what->points.size(), [&] { return product(prepared); }, [&] { return prepared.images(); });
      });
    };
    add_product("pose", [](const PreparedProducts& prepared) { return prepared.pose(); });
    add_product("jvp", [](const PreparedProducts& prepared) { return prepared.jvp(); });
    add_product("vjp", [](const PreparedProducts& prepared) { return prepared.vjp(); });
  }
  for (const CoordinateKind& kind : coordinate_kinds()) {
    if (find_rest_derivative(kind) == nullptr || !accepts(kind, what->cage)) continue;
    const auto made = std::make_shared<const Lazy<AtRest>>([what, &kind] { return AtRest(*what, kind); });
    const auto add_product = [&](std::string_view stage, auto product) {
      add(kind.name, stage, [made, product](benchmark::State& state) {
        const AtRest& rest = made->get();
        std::vector<CoordinateTable<double>> tables;
        time_both(
            state, rest.points.size(), [&] { return product(rest); },
            [&] {
              rest.coordinates.at(rest.points, 0, tables);
              return tables.data();
            });
      });
    };
    add_product("rest_jvp", [](const AtRest& rest) {
      std::vector<double> found(rest.values.size());
      rest.derivative.jvp(rest.coordinates, rest.points, rest.change, 1, found);
      return found;
    });
    add_product("rest_vjp",
                [](const AtRest& rest) { return rest.derivative.vjp(rest.coordinates, rest.points, rest.values, 1); });
  }
  return names;
}

}  // namespace cageproof::benchmarks
