// SPDX-License-Identifier: MIT
#include "cageproof/judge/cage_vectors.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"
#include "cageproof/judge/whole_cage.h"
#include "vectors/cage_defects.h"
#include "whole_cage/cage_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace cageproof::judge {
namespace {

constexpr std::array<std::string_view, 4> kInSpace{"tetrahedron", "small-tetrahedron", "cube", "l-block"};
constexpr std::array<std::string_view, 2> kInPlane{"l-shape", "star"};

CageQuestion tetrahedron(double unit) {
  CageQuestion question{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {1, 1, 2}}, {}, {}};
  for (Vec3<double>& vertex : question.vertices) vertex *= unit;
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    question.faces.push_back({{a, b, c, -1}});
  return question;
}

CagePlaces places_in(std::string_view cage) {
  if (cage == "tetrahedron") return CagePlaces(tetrahedron(1));
  if (cage == "small-tetrahedron") return CagePlaces(tetrahedron(0x1p-30));
  const auto all = vector_cages();
  if (std::ranges::find(all, cage) == all.end())
    throw InputError(fmt::format("no vectors are made of the cage '{}'", cage));
  return {cage, Placing{}};
}

// Steps from the cage, in shares of the way to a point in its box, below usual thresholds.
constexpr std::array<double, 2> kSteps{0x1p-24, 0x1p-40};
// The largest difference between the closed form in 100 digits and the integral in 50, in shares of the denominator.
constexpr double kAgreed = 1e-28;

std::vector<CageVector> cage_candidates(const CagePlaces& places, int dimension, const VectorOptions& options) {
  std::vector<CageVector> found;
  const auto add = [&](const Vec3<double>& point, const std::string& regime) {
    CageVector vector;
    vector.point = point;
    vector.regime = regime;
    found.push_back(std::move(vector));
  };
  for (int i = 0; i < options.samples / 2; ++i) {
    const auto index = static_cast<std::uint64_t>(i);
    if (const auto point = places.point("inside", options.seed, index)) add(*point, "inside");
    const Vec3<double> beside = places.point_on_any_side("generic", options.seed, index);
    if (places.side_of(beside) < 0) add(beside, "outside");
  }
  for (const std::string& part : dimension == 2 ? std::vector<std::string>{"edge", "vertex"}
                                                : std::vector<std::string>{"face", "edge", "vertex"}) {
    for (std::uint64_t i = 0; i < 2; ++i) {
      const Vec3<double> on = places.point_on_any_side("on-" + part, options.seed, i);
      if (places.side_of(on) == 0) add(on, "on-" + part);
      // From there into the box, whichever side that is.
      const Vec3<double> to = places.point_on_any_side("generic", options.seed, 100 + i);
      for (const double step : kSteps)
        if (const Vec3<double> near = on + step * (to - on); places.side_of(near) != 0) add(near, "near-" + part);
    }
  }
  return found;
}

// Truths, and what one unit of error is, block by block. Returns whether the defining integrals exist and say the same.
bool fill_cage_vector(CageVector& vector, const CageCoordinates& integrals, const CageCoordinates& closed,
                      double size) {
  const auto truth = closed.at<Mp100>(convert<Mp100>(vector.point), 0);
  const auto defined = integrals.at<Mp50>(convert<Mp50>(vector.point), 0);
  const auto derivatives = closed.at<Mp50>(convert<Mp50>(vector.point), 1);
  bool agrees = true;
  const std::size_t dimension = static_cast<std::size_t>(integrals.dimension());
  for (std::size_t b = 0; b < truth.size(); ++b) {
    Mp100 norm(0);
    for (const Mp100& x : truth[b].value) norm += x * x;
    Mp50 moved(0);
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      Mp50 squares(0);
      for (std::size_t i = axis; i < derivatives[b].gradient.size(); i += dimension)
        if (isfinite(derivatives[b].gradient[i])) squares += derivatives[b].gradient[i] * derivatives[b].gradient[i];
      moved += sqrt(squares);
    }
    vector.value.insert(vector.value.end(), truth[b].value.begin(), truth[b].value.end());
    vector.denominators.push_back(sqrt(norm) + Mp100(size) * Mp100(moved));
    for (std::size_t i = 0; i < truth[b].value.size(); ++i) {
      const Mp100 off = abs(truth[b].value[i] - Mp100(defined[b].value[i]));
      agrees = agrees && isfinite(off) && off <= Mp100(kAgreed) * vector.denominators.back();
    }
  }
  return agrees;
}

}  // namespace

std::vector<std::string_view> vector_cages() {
  std::vector<std::string_view> all(kInSpace.begin(), kInSpace.end());
  all.insert(all.end(), kInPlane.begin(), kInPlane.end());
  return all;
}

CageVectorSet make_cage_vectors(std::string_view kind, std::string_view cage, const VectorOptions& options) {
  const CagePlaces places = places_in(cage);
  CageVectorSet set{std::string(cage), &coordinate_kind_named(kind), places.question(), {}, {}};
  const int dimension = set.question.dimension;
  require_judged_kind(kind, dimension);
  const Cage solid = set.question.cage();
  const CageCoordinates integrals(solid, *set.kind, CoordinateOptions{"multiprecision"});
  const CageCoordinates closed(solid, *set.kind, CoordinateOptions{"closed_form"});
  set.blocks = integrals.blocks();
  std::vector<CageVector> found = cage_candidates(places, dimension, options);
  std::vector<char> has_truth(found.size(), 0);  // bytes, which threads may set side by side
  for_each_parallel(found.size(), options.jobs, [&](std::size_t i) {
    has_truth[i] = fill_cage_vector(found[i], integrals, closed, solid.size()) ? 1 : 0;
    if (has_truth[i] != 0) add_defects(found[i], set, places.side_of(found[i].point) == 0);
  });
  for (std::size_t i = 0; i < found.size(); ++i) {
    ++set.candidates;
    if (has_truth[i] == 0) ++set.without_truth;
    else if (found[i].defects.empty()) ++set.without_defect;
    else set.vectors.push_back(std::move(found[i]));
  }
  return set;
}

}  // namespace cageproof::judge
