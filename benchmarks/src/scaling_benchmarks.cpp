// SPDX-License-Identifier: MIT
#include "cage_benchmarks.h"
#include "scaled_cages.h"
#include "timed_run.h"

#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/numbers/random_stream.h"

#include <fmt/format.h>

namespace cageproof::benchmarks {
namespace {

// Pairs of a point and a face that a pass over a large cage takes about, and the fewest points.
constexpr std::size_t kPairs = 10'000'000, kFewest = 128;
constexpr std::size_t kMostFaces = 100'000, kMostPoints = 1'000'000;
// The points of all cages, of which those of fine ones take a part.
constexpr int kAllPoints = 16384;
constexpr std::size_t kPointsOfCages = 1024;
// Evaluations that sum elements take microseconds per pair.
constexpr std::size_t kMostFacesOfSums = 5'120, kMostPointsOfSums = 256, kPointsOfSums = 16;

struct Scaled {
  CageCoordinates coordinates;
  std::vector<Vec3<double>> points;
};

class Scaling {
 public:
  Scaling(const CoordinateKind& of, const TimedEvaluation& by, std::vector<std::string>& into)
      : kind_(of), evaluation_(by), names_(into) {}

  std::size_t most_faces() const { return evaluation_.whole ? kMostFaces : kMostFacesOfSums; }

  void add_faces(const std::shared_ptr<const ScaledCages>& cages, int times) {
    const std::size_t points =
        evaluation_.whole ? std::min(kPointsOfCages, std::max(kFewest, kPairs / cages->faces(times, kind_.keeps_quads)))
                          : kPointsOfSums;
    add(
        "faces", cages->name(times, kind_.keeps_quads), [cages, times] { return cages->cut(times); }, points, 1);
  }
  void add_points(const std::shared_ptr<const ScaledCages>& cages) {
    for (std::size_t points = 1; points <= most_points(); points *= evaluation_.whole && points == 1 ? 64 : 16)
      add(
          "points", fmt::format("{}", points), [cages] { return cages->cut(0); }, points, 1);
    if (evaluation_.whole)
      add(
          "points", fmt::format("{}", kMostPoints), [cages] { return with_points(cages->coarsest(), kMostPoints); },
          kMostPoints, 1);
  }
  void add_threads(const std::shared_ptr<const ScaledCages>& cages) {
    for (const int threads : {1, 2})
      add(
          "threads", fmt::format("{}", threads), [cages] { return cages->cut(0); }, most_points(), threads);
  }

 private:
  std::size_t most_points() const { return evaluation_.whole ? kAllPoints : kMostPointsOfSums; }

  // The cage's points again and again, each a little nearer to the origin.
  static std::shared_ptr<const DeformedCage> with_points(DeformedCage in, std::size_t count) {
    const std::size_t own = in.points.size();
    in.points.reserve(count);
    for (std::size_t i = own; i < count; ++i)
      in.points.push_back(in.points[i % own] * (1 - static_cast<double>(i) / static_cast<double>(2 * count)));
    return std::make_shared<const DeformedCage>(std::move(in));
  }

  // \param make called when the benchmark runs: large cages take seconds
  template <class Make>
  void add(std::string_view over, std::string_view count, Make make, std::size_t points, int threads) {
    names_.push_back(fmt::format("scaling/{}/{}/{}/{}", kind_.name, over, evaluation_.name, count));
    add_benchmark(names_.back(), [=, &kind = kind_, evaluation = evaluation_.name](benchmark::State& state) {
      const std::shared_ptr<const DeformedCage> in = make();
      const Scaled scaled{CageCoordinates(in->cage, kind, CoordinateOptions{.evaluation = evaluation}),
                          spread(in->points, points)};
      const std::size_t elements = scaled.coordinates.elements().count();
      // Times of one thread are its own: whatever else runs adds to the clock's.
      const Clock clock = threads == 1 && over != "threads" ? Clock::Processor : Clock::Wall;
      const double seconds = time_fill(state, scaled.coordinates, scaled.points, 0, threads, clock);
      count_pairs(state, seconds, scaled.points.size(), elements);
      state.counters["elements"] = static_cast<double>(elements);
      state.counters["threads"] = threads;
    });
  }

  const CoordinateKind& kind_;
  TimedEvaluation evaluation_;
  std::vector<std::string>& names_;
};

// Points within the cage's box, in random order.
std::vector<Vec3<double>> in_box(const Cage& cage, int count) {
  const auto [low, high] = box_of(cage.vertices());
  std::vector<Vec3<double>> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i) {
    RandomStream random(7, "in the box", i);
    points.emplace_back(Vec3<double>(random.uniform(), random.uniform(), random.uniform()).cwiseProduct(high - low) +
                        low);
  }
  return points;
}

// Exact winding numbers around random points.
void add_winding_numbers(const std::shared_ptr<const ScaledCages>& cages, int times, std::vector<std::string>& names) {
  names.push_back(fmt::format("scaling/inside/faces/tree/{}", cages->name(times, false)));
  add_benchmark(names.back(), [cages, times](benchmark::State& state) {
    const Cage cage = cages->cut(times)->cage;
    const WindingNumbers windings(CageElements(cage, false, Triangulation::Shortest));
    const std::vector<Vec3<double>> asked = in_box(cage, kAllPoints);
    for (auto iteration : state)
      for (const Vec3<double>& point : asked) benchmark::DoNotOptimize(windings.around(point));
    state.counters["points"] = static_cast<double>(asked.size());
    state.counters["points_per_second"] =
        benchmark::Counter(static_cast<double>(asked.size()), benchmark::Counter::kIsIterationInvariantRate);
  });
}

}  // namespace

std::vector<std::string> register_scaling_benchmarks(const std::vector<std::shared_ptr<const DeformedCage>>& given) {
  std::vector<std::string> names;
  const auto share = [](ScaledCages cages) { return std::make_shared<const ScaledCages>(std::move(cages)); };
  const auto sphere = share(spheres(kAllPoints)), box = share(cubes(kAllPoints));
  std::vector others{share(long_spheres(kAllPoints)), share(graded_spheres(kAllPoints))};
  for (const auto& cage : given) others.push_back(share({cage->name + "-", *cage}));
  for (int times = 0; sphere->faces(times, false) <= kMostFaces; ++times) add_winding_numbers(sphere, times, names);
  for (const char* name :
       {"green", "biharmonic", "somigliana", "mean_value", "quad_mean_value", "quad_green", "quad_biharmonic"}) {
    const CoordinateKind& kind = coordinate_kind_named(name);
    const auto& cages = kind.keeps_quads ? box : sphere;
    const Cage& coarsest = cages->coarsest().cage;
    for (const TimedEvaluation& evaluation : timed_evaluations(kind, coarsest)) {
      const auto found = EvaluationRegister::instance().find(formulas_of(kind, coarsest).back()->name, evaluation.name);
      if (!evaluation.whole && found->role() != Role::Recommended) continue;
      Scaling scaling(kind, evaluation, names);
      scaling.add_points(cages);
      scaling.add_threads(cages);
      if (!kind.keeps_quads) scaling.add_faces(box, 0);
      for (int times = 0; cages->faces(times, kind.keeps_quads) <= scaling.most_faces(); ++times)
        scaling.add_faces(cages, times);
      // Other shapes, sixteenfold finer each time.
      for (const auto& other : others) {
        const Cage& cage = other->coarsest().cage;
        if (!evaluation.whole || !accepts(kind, cage) || (kind.keeps_quads && !cage.has_quads())) continue;
        for (int times = 0; other->faces(times, kind.keeps_quads) <= kMostFaces; times += 2)
          scaling.add_faces(other, times);
      }
    }
  }
  return names;
}

}  // namespace cageproof::benchmarks
