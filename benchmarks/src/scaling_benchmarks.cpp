// SPDX-License-Identifier: MIT
#include "cage_benchmarks.h"
#include "timed_run.h"

#include "cageproof/core/cage/winding_numbers.h"
#include "cageproof/core/numbers/random_stream.h"

#include <fmt/format.h>

#include <map>

namespace cageproof::benchmarks {
namespace {

// A cage whose faces are each cut in four, at the midpoints of edges and, of quads, of faces.
DeformedCage subdivided(const DeformedCage& coarse) {
  std::vector<Vec3<double>> vertices = coarse.cage.vertices();
  std::map<std::vector<int>, int> midpoints;
  const auto middle_of = [&](std::vector<int> of) {
    std::ranges::sort(of);
    const auto [found, is_new] = midpoints.try_emplace(of, static_cast<int>(vertices.size()));
    if (is_new) {
      Vec3<double> sum = Vec3<double>::Zero();
      for (const int v : of) sum += vertices[v];
      vertices.push_back(sum / static_cast<double>(of.size()));
    }
    return found->second;
  };
  std::vector<Face> faces;
  for (const Face& face : coarse.cage.faces()) {
    const int corners = face.size();
    std::array<int, 4> middles{};
    for (int k = 0; k < corners; ++k) middles[k] = middle_of({face.vertices[k], face.vertices[(k + 1) % corners]});
    if (corners == 3) faces.push_back({{middles[0], middles[1], middles[2], -1}});
    for (int k = 0; k < corners; ++k) {
      const int last = middles[(k + corners - 1) % corners];
      if (corners == 3) faces.push_back({{face.vertices[k], middles[k], last, -1}});
      else
        faces.push_back({{face.vertices[k], middles[k],
                          middle_of({face.vertices[0], face.vertices[1], face.vertices[2], face.vertices[3]}), last}});
    }
  }
  return {coarse.name, coarse.cage.with(vertices, faces), vertices, coarse.points};
}

struct Scaled {
  CageCoordinates coordinates;
  std::vector<Vec3<double>> points;
};

class Scaling {
 public:
  Scaling(const CoordinateKind& of, const TimedEvaluation& by, std::vector<std::string>& into)
      : kind_(of), evaluation_(by), names_(into) {}

  void add(std::string_view over, std::size_t count, const DeformedCage& in, std::size_t points, int threads) {
    const auto scaled = std::make_shared<const Scaled>(Scaled{
        CageCoordinates(in.cage, kind_, CoordinateOptions{.evaluation = evaluation_.name}), spread(in.points, points)});
    names_.push_back(fmt::format("scaling/{}/{}/{}/{}", kind_.name, over, evaluation_.name, count));
    add_benchmark(names_.back(), [scaled, threads](benchmark::State& state) {
      const std::size_t elements = scaled->coordinates.elements().count();
      const double seconds = time_fill(state, scaled->coordinates, scaled->points, 0, threads, Clock::Wall);
      count_pairs(state, seconds, scaled->points.size(), elements);
      state.counters["elements"] = static_cast<double>(elements);
      state.counters["threads"] = threads;
    });
  }

 private:
  const CoordinateKind& kind_;
  const TimedEvaluation& evaluation_;
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
void add_winding_numbers(const Cage& cage, int points, std::vector<std::string>& names) {
  names.push_back(fmt::format("scaling/inside/faces/tree/{}", cage.faces().size()));
  const auto windings = std::make_shared<const WindingNumbers>(CageElements(cage, false, Triangulation::Shortest));
  add_benchmark(names.back(), [windings, asked = in_box(cage, points)](benchmark::State& state) {
    for (auto iteration : state)
      for (const Vec3<double>& point : asked) benchmark::DoNotOptimize(windings->around(point));
    state.counters["points"] = static_cast<double>(asked.size());
    state.counters["points_per_second"] =
        benchmark::Counter(static_cast<double>(asked.size()), benchmark::Counter::kIsIterationInvariantRate);
  });
}

}  // namespace

std::vector<std::string> register_scaling_benchmarks() {
  constexpr int all_points = 16384;
  std::vector<std::string> names;
  DeformedCage sphere = embedded_deformed_cage("icosphere", 1);
  for (int i = 0; i < 6; ++i) {
    add_winding_numbers(sphere.cage, all_points, names);
    sphere = subdivided(sphere);
  }
  for (const char* name : {"green", "biharmonic", "somigliana", "mean_value", "quad_mean_value", "quad_green"}) {
    const CoordinateKind& kind = coordinate_kind_named(name);
    std::vector<DeformedCage> cages{embedded_deformed_cage(kind.keeps_quads ? "cube" : "icosphere", all_points)};
    // Drawn towards the origin, which is inside: off the faces and not beyond them, as most points of a mesh are.
    for (Vec3<double>& p : cages.front().points) p *= 0.5;
    for (int i = 0; i < 3; ++i) cages.push_back(subdivided(cages.back()));
    for (const TimedEvaluation& evaluation : timed_evaluations(kind, cages.front().cage)) {
      const auto found =
          EvaluationRegister::instance().find(formulas_of(kind, cages.front().cage).back()->name, evaluation.name);
      if (!evaluation.whole && found->role() != Role::Recommended) continue;
      Scaling scaling(kind, evaluation, names);
      // Slow evaluations at fewer points.
      const std::size_t most = evaluation.whole ? all_points : 256;
      for (std::size_t points = most / 256; points <= most; points *= 16)
        scaling.add("points", points, cages.front(), points, 1);
      for (const DeformedCage& cage : cages) scaling.add("faces", cage.cage.faces().size(), cage, most / 16, 1);
      for (const int threads : {1, 2}) scaling.add("threads", threads, cages.front(), most, threads);
    }
  }
  return names;
}

}  // namespace cageproof::benchmarks
