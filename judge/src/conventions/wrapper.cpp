// SPDX-License-Identifier: MIT
// A convention, undone: an evaluation whose numbers are ours.
#include "conventions/tensors.h"

#include <numeric>

namespace cageproof::judge {
namespace {

using validation::Sample;

// The inverse of arranged(), which takes tensors without factor from theirs to ours.
Tensors undone(const Formula& formula, const Convention& convention, const Tensors& theirs, const Sample& sample) {
  Tensors ours = theirs;
  const auto dim = static_cast<std::size_t>(formula.dim());
  if (convention.normalised) {
    const Tensors full = reference_of(formula, sample, theirs[1].empty() ? 0 : 1);
    const double sum = std::accumulate(full[0].begin(), full[0].end(), 0.0);
    for (double& x : ours[0]) x *= sum;
    for (std::size_t i = 0; i < dim && !theirs[1].empty(); ++i) {
      double by_i = 0;
      for (std::size_t c = 0; c < full[0].size(); ++c) by_i += full[1][c * dim + i];
      for (std::size_t c = 0; c < full[0].size(); ++c)
        ours[1][c * dim + i] = sum * theirs[1][c * dim + i] + theirs[0][c] * by_i;
    }
  }
  Arrangement inverse{.transposed = convention.transposed};
  inverse.corners.resize(convention.corners.size());
  for (std::size_t k = 0; k < convention.corners.size(); ++k)
    inverse.corners[static_cast<std::size_t>(convention.corners[k])] = static_cast<int>(k);
  return arranged(formula, ours, inverse);
}

// The same element the other way round: the first two corners swapped, of quads the second and the fourth.
std::array<std::size_t, 2> swapped(std::size_t corners) {
  return corners == 4 ? std::array<std::size_t, 2>{1, 3} : std::array<std::size_t, 2>{0, 1};
}
std::vector<Vec3<double>> turned(std::span<const Vec3<double>> corners, const Convention& convention) {
  std::vector<Vec3<double>> all(corners.begin(), corners.end());
  const auto [a, b] = swapped(all.size());
  if (convention.reversed) std::swap(all[a], all[b]);
  return all;
}
std::vector<int> turned_corners(const Formula& formula) {
  if (!formula.shape.per_corner) return {};
  std::vector<int> order(static_cast<std::size_t>(formula.corners()));
  std::iota(order.begin(), order.end(), 0);
  const auto [a, b] = swapped(order.size());
  std::swap(order[a], order[b]);
  return order;
}

void divide(std::vector<double>& tensor, double by) {
  for (double& x : tensor) x /= by;
}

}  // namespace

Evaluation in_our_convention(const Evaluation& theirs, const Convention& convention) {
  EvaluationFacts facts = theirs.facts();
  facts.max_order = std::min(facts.max_order, 1);
  facts.description += ", in our convention";
  Evaluation ours(convention.formula, theirs.name(), std::move(facts));
  const Formula& formula = ours.formula();
  ours.set_point<double>([theirs, convention, &formula](const Query<double>& query, Result<double>& result) {
    Result<double> given;
    const std::vector<Vec3<double>> corners = turned(query.corners, convention);
    theirs(Query<double>{corners, query.point, query.order, query.parameters, query.finite_part}, given);
    Tensors tensors{given.value, given.gradient};
    const double scale = scale_of(formula, convention, query.parameters);
    if (convention.derivative_first) tensors[1] = component_first(tensors[1], formula.dim());
    divide(tensors[0], scale);
    divide(tensors[1], scale * convention.derivative_sign);
    if (convention.reversed) tensors = arranged(formula, tensors, {.corners = turned_corners(formula)});
    if (convention.normalised || convention.transposed || !convention.corners.empty()) {
      const Sample sample{.corners{query.corners.begin(), query.corners.end()},
                          .point = query.point,
                          .parameters{query.parameters.begin(), query.parameters.end()}};
      tensors = undone(formula, convention, tensors, sample);
    }
    result.reset(formula.components(), formula.dim(), query.order);
    result.value = std::move(tensors[0]);
    result.gradient = std::move(tensors[1]);
  });
  return ours;
}

}  // namespace cageproof::judge
