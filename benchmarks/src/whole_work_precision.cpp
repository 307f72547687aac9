// SPDX-License-Identifier: MIT
#include "whole_work_precision.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/name_pattern.h"
#include "cageproof/validation/cage_campaign.h"
#include "cageproof/core/parallel.h"
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/scheme_errors.h"
#include "point_times.h"
#include "summarise.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>

namespace cageproof::benchmarks {

using namespace validation;
namespace {

// Solving takes the cube of their number: a second or so.
constexpr int most_nodes = 1024;

// One way to compute the kind.
struct Way {
  std::string name;  // empty: as the coordinates call their evaluation
  CoordinateOptions options;
};

// Whether the kind has pieces of edges in the plane, and splits triangles in space.
bool is_split_by_level(const CoordinateKind& kind, const Cage& cage) {
  const auto has = [&](std::string_view name) {
    return std::ranges::find(kind.parameters, name, &KindParameter::name) != kind.parameters.end();
  };
  return cage.dimension() == 3 && has("pieces") && has("level");
}

// Levels whose unknowns, three a piece, are few enough; the first always.
std::vector<int> levels_of(const Cage& cage, const WorkPrecisionOptions& given) {
  const auto triangles = static_cast<int>(cage.parts(false, given.triangulation).elements.size());
  std::vector<int> levels{0};
  while (3 * triangles * (4 << (2 * levels.back())) <= most_nodes) levels.push_back(levels.back() + 1);
  return levels;
}

CoordinateOptions at_level(const CoordinateKind& kind, const WorkPrecisionOptions& given, int level) {
  CoordinateOptions options{"", given.triangulation, {}};
  for (const KindParameter& p : kind.parameters) options.parameters.push_back(p.name == "level" ? level : p.preset);
  return options;
}

std::vector<Way> ways_of(const CoordinateKind& kind, const Cage& cage, const WorkPrecisionOptions& given,
                         std::vector<std::string>& notes) {
  std::vector<double> parameters = given.parameters;
  if (parameters.empty())
    for (const KindParameter& p : kind.parameters) parameters.push_back(p.preset);
  const auto pieces = std::ranges::find(kind.parameters, "pieces", &KindParameter::name);
  std::vector<Way> ways;
  if (!given.evaluations.empty()) {
    for (const std::string& list : given.evaluations)
      for (const std::string& evaluation : names_in(list))
        ways.push_back({"", {evaluation, given.triangulation, parameters}});
  } else if (given.parameters.empty() && is_split_by_level(kind, cage)) {
    for (const int level : levels_of(cage, given))
      ways.push_back({fmt::format("level={}", level), at_level(kind, given, level)});
  } else if (given.parameters.empty() && pieces != kind.parameters.end()) {
    for (const int n : {1, 2, 4, 8, 16, 32}) {
      if (n * static_cast<int>(cage.faces().size()) > most_nodes) {
        notes.push_back(fmt::format("not measured, more than {} nodes: {} pieces and more", most_nodes, n));
        break;
      }
      parameters[pieces - kind.parameters.begin()] = n;
      ways.push_back({fmt::format("pieces={}", n), {"", given.triangulation, parameters}});
    }
  } else {
    ways.push_back({"", {"", given.triangulation, parameters}});
  }
  return ways;
}

}  // namespace

WorkPrecision whole_work_precision(const Cage& cage, const CoordinateKind& kind, const std::vector<PointGroup>& groups,
                                   const WorkPrecisionOptions& options) {
  WorkPrecision result;
  result.subject = kind.name;
  result.where = cage.name();
  result.unit = "1";
  result.timed = "point";
  result.order = 0;
  result.seed = options.seed;
  auto approximated = approximated_by(cage, kind, options.triangulation);
  const bool by_level = !approximated && is_split_by_level(kind, cage);
  result.error = approximated ? fmt::format("difference from {}", kind.approximates) : "partition of unity residual";
  if (by_level) {
    const int finest = levels_of(cage, options).back() + 1;
    approximated.emplace(cage, kind, at_level(kind, options, finest));
    result.error = fmt::format("difference from level {}", finest);
    result.notes.emplace_back("the finest level is itself off by a third or so of the difference from the one before");
  } else if (approximated)
    if (const auto residual = boundary_residuals(*approximated)[0])
      result.notes.push_back(
          fmt::format("{} meets its data on the boundary to {:.1e} here: differences of that size are "
                      "its own",
                      kind.approximates, *residual));
  if (!approximated && std::ranges::find(kind.parameters, "pieces", &KindParameter::name) != kind.parameters.end())
    result.notes.emplace_back(
        "nothing to compare with here: the partition of unity says nothing of the scheme's error");
  double sink = 0;
  std::vector<std::pair<std::string, CageCoordinates>> prepared;
  for (const Way& way : ways_of(kind, cage, options, result.notes)) {
    const auto start = std::chrono::steady_clock::now();
    CageCoordinates coordinates(cage, kind, way.options);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    const std::string name = way.name.empty() ? coordinates.evaluation() : way.name;
    result.notes.push_back(fmt::format("{}: prepared in {:.2g} s", name, spent.count()));
    prepared.emplace_back(name, std::move(coordinates));
  }
  for (PointGroup group : groups) {
    // Coordinates that are solved for inside have no meaning elsewhere.
    if (approximated || kind.inside_alone) {
      const auto left_out = std::erase_if(group.points, [](const CagePoint& p) { return p.place != Place::Inside; });
      if (left_out > 0) result.notes.push_back(fmt::format("{}: {} points not inside left out", group.place, left_out));
    }
    if (group.points.empty()) {
      result.notes.push_back(fmt::format("{}: no point found", group.place));
      continue;
    }
    std::vector<Vec3<double>> points;
    points.reserve(group.points.size());
    for (const CagePoint& p : group.points) points.push_back(p.point);
    for (const auto& [name, coordinates] : prepared) {
      WorkPrecisionRow row;
      row.evaluation = name;
      set_place(group, row);
      std::vector<double> errors(points.size());
      for_each_parallel(errors.size(), options.jobs, [&](std::size_t i) {
        const double expected = expected_sum(kind, group.points[i].place);
        errors[i] = approximated ? scheme_errors_at(coordinates, *approximated, cage, points[i], 0)[0]
                                 : errors_at(coordinates, cage, points[i], expected, 0).partition[0].relative;
      });
      summarise(std::move(errors), row);
      summarise_times(nanoseconds_of_points(coordinates, points, options.seconds, SIZE_MAX, sink), row);
      result.rows.push_back(std::move(row));
    }
  }
  if (result.rows.empty()) throw InputError(fmt::format("{}: no point to measure at", cage.name()));
  if (std::isnan(sink)) result.notes.emplace_back("some points have no coordinates");
  return result;
}

}  // namespace cageproof::benchmarks
