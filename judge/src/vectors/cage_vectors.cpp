// SPDX-License-Identifier: MIT
#include "cageproof/judge/cage_vectors.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/parallel.h"
#include "cageproof/validation/second_route.h"
#include "vectors/cage_defects.h"
#include "whole_cage/cage_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace cageproof::judge {
namespace {

constexpr std::array<std::string_view, 4> kInSpace{"tetrahedron", "small-tetrahedron", "cube", "l-block"};
constexpr std::array<std::string_view, 2> kOfQuads{"bent-box", "quad-l-block"};
constexpr std::array<std::string_view, 2> kInPlane{"l-shape", "star"};
// Kinds whose coordinates are computed in two ways that share no code.
constexpr std::array<std::string_view, 8> kKinds{"mean_value",           "green",          "biharmonic",
                                                 "biharmonic_affine",    "somigliana",     "quad_mean_value",
                                                 "spherical_mean_value", "maximum_entropy"};

CageRequest tetrahedron(double unit) {
  CageRequest question{{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {1, 1, 2}}, {}, {}};
  for (Vec3<double>& vertex : question.vertices) vertex *= unit;
  for (const auto& [a, b, c] : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    question.faces.push_back({{a, b, c, -1}});
  return question;
}

// A box with one vertex moved: the three quads that meet there are bent.
CageRequest bent_box() {
  CageRequest question{
      {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {0, 0, 2}, {4, 0, 2}, {5, 4, 3}, {0, 3, 2}}, {}, {}};
  for (const auto& corners :
       {std::array{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
    question.faces.push_back({corners});
  return question;
}

CagePlaces places_in(std::string_view cage) {
  if (cage == "bent-box") return CagePlaces(bent_box(), true);
  if (cage == "quad-l-block") return {"l-block", Placing{.keeps_quads = true}};
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

// The coordinates of a kind in a cage, computed in two ways that share no code.
class CageTruths {
 public:
  CageTruths(const Cage& cage, const CoordinateKind& kind)
      : first_(cage, kind, CoordinateOptions{kind.is_sum() && !kind.keeps_quads ? "closed_form" : ""}),
        size_(cage.size()) {
    if (kind.is_sum()) integrals_.emplace(cage, kind, CoordinateOptions{"multiprecision"});
    else route_ = validation::second_route_of(kind, cage);
  }

  const CageCoordinates& coordinates() const { return first_; }

  // Sets truths, and what one unit of error is, block by block. Returns whether both ways exist and say the same.
  bool fill(CageVector& vector) const {
    const auto truth = first_.at<Mp100>(convert<Mp100>(vector.point), 0);
    const auto derivatives = first_.at<Mp50>(convert<Mp50>(vector.point), 1);
    for (std::size_t b = 0; b < truth.size(); ++b) {
      Mp100 norm(0);
      for (const Mp100& x : truth[b].value) {
        if (!isfinite(x)) return false;
        norm += x * x;
      }
      vector.value.insert(vector.value.end(), truth[b].value.begin(), truth[b].value.end());
      vector.denominators.push_back(sqrt(norm) + Mp100(size_) * Mp100(moved_by(derivatives[b])));
    }
    return integrals_ ? agree(truth, integrals_->at<Mp50>(convert<Mp50>(vector.point), 0), vector.denominators)
                      : follows_route(truth, vector.point);
  }

 private:
  // The sum over the axes of the norm of what the derivatives by this axis are.
  Mp50 moved_by(const Result<Mp50>& derivatives) const {
    const auto dimension = static_cast<std::size_t>(first_.dimension());
    Mp50 moved(0);
    for (std::size_t axis = 0; axis < dimension; ++axis) {
      Mp50 squares(0);
      for (std::size_t i = axis; i < derivatives.gradient.size(); i += dimension)
        if (isfinite(derivatives.gradient[i])) squares += derivatives.gradient[i] * derivatives.gradient[i];
      moved += sqrt(squares);
    }
    return moved;
  }

  static bool agree(const std::vector<Result<Mp100>>& truth, const std::vector<Result<Mp50>>& defined,
                    const std::vector<Mp100>& denominators) {
    for (std::size_t b = 0; b < truth.size(); ++b)
      for (std::size_t i = 0; i < truth[b].value.size(); ++i) {
        const Mp100 off = abs(truth[b].value[i] - Mp100(defined[b].value[i]));
        if (!isfinite(off) || off > Mp100(kAgreed) * denominators[b]) return false;
      }
    return true;
  }

  bool follows_route(const std::vector<Result<Mp100>>& truth, const Vec3<double>& point) const {
    std::vector<std::vector<Mp100>> blocks;
    blocks.reserve(truth.size());
    for (const auto& block : truth) blocks.push_back(block.value);
    return route_(point, blocks) <= kAgreed;
  }

  CageCoordinates first_;
  std::optional<CageCoordinates> integrals_;  // of sums
  validation::SecondRoute route_;             // of other kinds
  double size_;
};

}  // namespace

std::vector<std::string_view> vector_kinds() { return {kKinds.begin(), kKinds.end()}; }

std::vector<std::string_view> vector_cages() {
  std::vector<std::string_view> all(kInSpace.begin(), kInSpace.end());
  all.insert(all.end(), kOfQuads.begin(), kOfQuads.end());
  all.insert(all.end(), kInPlane.begin(), kInPlane.end());
  return all;
}

bool has_vectors(std::string_view kind, std::string_view cage) {
  const CoordinateKind& row = coordinate_kind_named(kind);
  const bool is_of_quads = std::ranges::find(kOfQuads, cage) != kOfQuads.end();
  return row.keeps_quads == is_of_quads && exists_on(row, places_in(cage).question().cage());
}

CageVectorSet make_cage_vectors(std::string_view kind, std::string_view cage, const VectorOptions& options) {
  if (std::ranges::find(kKinds, kind) == kKinds.end())
    throw InputError(fmt::format("no vectors are made of the kind '{}'", kind));
  if (!has_vectors(kind, cage)) throw InputError(fmt::format("no vectors of {} are made in the cage '{}'", kind, cage));
  const CagePlaces places = places_in(cage);
  CageVectorSet set{std::string(cage), &coordinate_kind_named(kind), places.question(), {}, {}};
  const int dimension = set.question.dimension;
  const Cage solid = set.question.cage();
  const CageTruths truths(solid, *set.kind);
  set.blocks = truths.coordinates().blocks();
  std::vector<CageVector> found = cage_candidates(places, dimension, options);
  std::vector<char> has_truth(found.size(), 0);  // bytes, which threads may set side by side
  for_each_parallel(found.size(), options.jobs, [&](std::size_t i) {
    const bool is_on = places.side_of(found[i].point) == 0;
    // Second routes take integrals that do not end on the cage.
    has_truth[i] = (set.kind->is_sum() || !is_on) && truths.fill(found[i]) ? 1 : 0;
    if (has_truth[i] != 0) add_defects(found[i], set, is_on);
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
