// SPDX-License-Identifier: MIT
#include "deformer_benchmarks.h"

#include "cageproof/core/embedded_cages.h"
#include "cageproof/core/random_stream.h"
#include "cageproof/deformation/deformer.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <ctime>
#include <mutex>

namespace cageproof::benchmarks {

using namespace deformation;
namespace {

// A method on a cage, made as far as a benchmark needs it.
class Stages {
 public:
  Stages(std::shared_ptr<const DeformedCage> what, const DeformMethod& method)
      : what_(std::move(what)), method_(method) {}

  const DeformedCage& what() const { return *what_; }
  std::shared_ptr<const Deformer<double>> prepare() const { return prepare_deformer<double>(method_, what_->cage, {}); }
  const Deformer<double>& deformer() const {
    std::call_once(prepared_, [this] { deformer_ = prepare(); });
    return *deformer_;
  }
  std::unique_ptr<const Posed<double>> pose() const { return deformer().pose({what_->posed}); }
  std::vector<CoordinateTable<double>> coordinates() const {
    return deformer().coordinates().at<double>(what_->points, 0);
  }

 private:
  std::shared_ptr<const DeformedCage> what_;
  const DeformMethod& method_;
  mutable std::once_flag prepared_;
  mutable std::shared_ptr<const Deformer<double>> deformer_;
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

}  // namespace

DeformedCage embedded_deformed_cage(std::string_view name, int points) {
  DeformedCage found{std::string(name), embedded_cage(name), {}, {}};
  Vec3<double> low = found.cage.vertices().front(), high = low;
  for (const Vec3<double>& v : found.cage.vertices()) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
    found.posed.emplace_back(v[0] + 0.25 * v[1], v[1] - 0.125 * v[0], v[2]);
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
    const auto stages = std::make_shared<const Stages>(what, method);
    const auto add = [&](std::string_view stage, auto run) {
      names.push_back(fmt::format("deform/{}/{}/{}", what->name, method.name, stage));
      benchmark::RegisterBenchmark(names.back().c_str(), run)->Unit(benchmark::kMillisecond);
    };
    add("prepare", [stages](benchmark::State& state) { time(state, 0, [&] { return stages->prepare(); }); });
    add("coordinates", [stages](benchmark::State& state) {
      stages->deformer();
      time(state, stages->what().points.size(), [&] { return stages->coordinates(); });
    });
    add("pose", [stages](benchmark::State& state) {
      stages->deformer();
      time(state, 0, [&] { return stages->pose(); });
    });
    add("images", [stages](benchmark::State& state) {
      const auto tables = stages->coordinates();
      const auto posed = stages->pose();
      const std::size_t points = stages->what().points.size();
      time(state, points, [&] { return posed->images(tables, points, 0); });
    });
  }
  return names;
}

}  // namespace cageproof::benchmarks
