// SPDX-License-Identifier: MIT
#include "cage_benchmarks.h"

#include "gauss_loop.h"
#include "timed_run.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

namespace cageproof::benchmarks {
namespace {

// Limits for evaluations that take microseconds per pair, and for nodes of rules that take nanoseconds each.
constexpr std::size_t slow_pairs = 20'000, vector_nodes = 40'000'000, plain_nodes = 10'000'000;

std::size_t points_for(std::size_t pairs, std::size_t elements, std::size_t all) {
  constexpr std::size_t least = 16;
  return std::min(all, std::max(least, pairs / elements / least * least));
}

// Coordinates of one kind by one evaluation in one cage, and the points that it is timed at.
struct Prepared {
  std::shared_ptr<const DeformedCage> what;
  CageCoordinates coordinates;
  std::vector<Vec3<double>> points;

  Prepared(std::shared_ptr<const DeformedCage> cage, const CoordinateKind& kind, const TimedEvaluation& evaluation)
      : what(std::move(cage)), coordinates(what->cage, kind, CoordinateOptions{.evaluation = evaluation.name}) {
    const std::size_t all = what->points.size();
    points = spread(what->points, evaluation.whole ? all : points_for(slow_pairs, elements(), all));
  }
  std::size_t elements() const { return coordinates.elements().count(); }
};

// All points, or as many of them as take some seconds: whole evaluations leave some orders to sums.
std::vector<Vec3<double>> affordable(const Prepared& prepared, int order) {
  constexpr std::size_t tried = 64;
  constexpr double seconds = 2;
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  const auto few = spread(prepared.points, tried);
  std::vector<CoordinateTable<double>> tables;
  const double start = seconds_of(Clock::Processor);
  prepared.coordinates.at(few, order, tables);
  const double a_point = (seconds_of(Clock::Processor) - start) / static_cast<double>(few.size());
  const double all = a_point * static_cast<double>(prepared.points.size());
  return all < seconds ? prepared.points
                       : spread(prepared.points, std::max(tried, static_cast<std::size_t>(seconds / a_point)));
}

void run_fill(benchmark::State& state, const Prepared& prepared, int order) {
  const auto points = affordable(prepared, order);
  const double seconds = time_fill(state, prepared.coordinates, points, order, 1, Clock::Processor);
  count_pairs(state, seconds, points.size(), prepared.elements());
}

void run_apply(benchmark::State& state, const Prepared& prepared, int order) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  const CageCoordinates& coordinates = prepared.coordinates;
  const CageData data = data_of_pose(coordinates, prepared.what->posed);
  const auto chosen = affordable(prepared, order);
  const std::span points(chosen);
  coordinates.apply(points.first(1), order, data);
  const double start = seconds_of(Clock::Processor);
  for (auto _ : state) {
    auto made = coordinates.apply(points, order, data);
    benchmark::DoNotOptimize(made);
    benchmark::ClobberMemory();
  }
  count_pairs(state, seconds_of(Clock::Processor) - start, points.size(), prepared.elements());
}

void run_gauss(benchmark::State& state, const GaussLoop& loop, const std::vector<Vec3<double>>& points, bool plain) {
  std::vector<double> values(points.size() * loop.entries());
  const double start = seconds_of(Clock::Processor);
  for (auto _ : state) {
    if (plain) loop.fill_plainly(points, values);
    else loop.fill_on_vectors(points, values);
    benchmark::DoNotOptimize(values.data());
    benchmark::ClobberMemory();
  }
  count_pairs(state, seconds_of(Clock::Processor) - start, points.size(), loop.elements().count());
}

void add_evaluation(const std::shared_ptr<const DeformedCage>& what, const CoordinateKind& kind,
                    const TimedEvaluation& evaluation, std::vector<std::string>& names) {
  const auto prepared = std::make_shared<const Prepared>(what, kind, evaluation);
  for (int order = 0; order <= prepared->coordinates.max_order(); ++order) {
    const std::string start = fmt::format("cage/{}/{}/{}", kind.name, evaluation.name, order_names[order]);
    names.push_back(fmt::format("{}/{}", start, what->name));
    add_benchmark(names.back(), [prepared, order](benchmark::State& state) { run_fill(state, *prepared, order); });
    names.push_back(fmt::format("{}/apply/{}", start, what->name));
    add_benchmark(names.back(), [prepared, order](benchmark::State& state) { run_apply(state, *prepared, order); });
  }
}

void add_rules(const std::shared_ptr<const DeformedCage>& what, const CoordinateKind& kind,
               std::vector<std::string>& names) {
  std::vector<GaussRule> rules{collapsed_rule(4), collapsed_rule(8), collapsed_rule(20)};
  if (kind.name == "somigliana") rules.push_back(three_quad_rule(50));
  for (const GaussRule& rule : rules)
    for (const bool plain : {false, true}) {
      const auto loop = std::make_shared<const GaussLoop>(what->cage, kind, rule);
      const std::size_t pairs = (plain ? plain_nodes : vector_nodes) / rule.weights.size();
      const auto points = spread(what->points, points_for(pairs, loop->elements().count(), what->points.size()));
      names.push_back(fmt::format("cage/{}/{}{}/value/{}", kind.name, rule.name, plain ? "-plain" : "", what->name));
      add_benchmark(names.back(),
                    [loop, points, plain](benchmark::State& state) { run_gauss(state, *loop, points, plain); });
    }
}

}  // namespace

std::vector<std::string> register_cage_benchmarks(const std::shared_ptr<const DeformedCage>& what) {
  std::vector<std::string> names;
  for (const CoordinateKind& kind : coordinate_kinds()) {
    if (!kind.is_sum() || !accepts(kind, what->cage)) continue;
    for (const TimedEvaluation& evaluation : timed_evaluations(kind, what->cage))
      add_evaluation(what, kind, evaluation, names);
    if (GaussLoop::exists(kind, what->cage)) add_rules(what, kind, names);
  }
  return names;
}

}  // namespace cageproof::benchmarks
