// SPDX-License-Identifier: MIT
#include "conventions/tensors.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace cageproof::judge {
namespace {

using validation::Sample;

template <Scalar R>
Tensors rounded(const Result<R>& result) {
  Tensors tensors;
  for (int o = 0; o < 2; ++o)
    for (const R& x : result.of(o)) tensors[o].push_back(static_cast<double>(x));
  return tensors;
}

// Where entry (tensor k, row i, column j) of theirs stands in ours.
std::size_t source(const Formula& formula, const Arrangement& arrangement, std::size_t component) {
  const auto entries = static_cast<std::size_t>(formula.shape.entries());
  const auto rows = static_cast<std::size_t>(formula.shape.rows), columns = entries / rows;
  const std::size_t tensor = component / entries, row = component % entries / columns, column = component % columns;
  const std::size_t from = arrangement.corners.empty() ? tensor : static_cast<std::size_t>(arrangement.corners[tensor]);
  return from * entries + (arrangement.transposed ? column * columns + row : row * columns + column);
}

}  // namespace

Tensors tensors_of(const Evaluation& evaluation, const Sample& sample, int order) {
  return rounded(validation::evaluate<double>(evaluation, sample, order));
}

Tensors reference_of(const Formula& formula, const Sample& sample, int order) {
  auto& known = EvaluationRegister::instance();
  if (const auto closed = known.with_role(formula.name, Role::ClosedForm); closed && closed->supports<Mp50>())
    return rounded(validation::evaluate<Mp50>(*closed, sample, order));
  if (const auto best = known.with_role(formula.name, Role::Recommended)) return tensors_of(*best, sample, order);
  throw InputError(fmt::format("{} has no closed form and no recommended evaluation to compare with", formula.name));
}

Tensors arranged(const Formula& formula, const Tensors& ours, const Arrangement& arrangement) {
  Tensors theirs = ours;
  const auto dim = static_cast<std::size_t>(formula.dim());
  for (std::size_t c = 0; c < ours[0].size(); ++c) {
    const std::size_t from = source(formula, arrangement, c);
    theirs[0][c] = ours[0][from];
    for (std::size_t i = 0; i < dim && !ours[1].empty(); ++i) theirs[1][c * dim + i] = ours[1][from * dim + i];
  }
  if (!arrangement.normalised) return theirs;
  const double sum = std::accumulate(theirs[0].begin(), theirs[0].end(), 0.0);
  for (double& x : theirs[0]) x /= sum;
  for (std::size_t i = 0; i < dim && !theirs[1].empty(); ++i) {
    double sum_by_i = 0;
    for (std::size_t c = 0; c < theirs[0].size(); ++c) sum_by_i += theirs[1][c * dim + i];
    for (std::size_t c = 0; c < theirs[0].size(); ++c)
      theirs[1][c * dim + i] = (theirs[1][c * dim + i] - theirs[0][c] * sum_by_i) / sum;
  }
  return theirs;
}

double scale_of(const Formula& formula, const Convention& convention, std::span<const double> parameters) {
  double scale = convention.factor;
  for (std::size_t p = 0; p < convention.powers.size() && p < parameters.size(); ++p) {
    const bool ratio = formula.parameters[p].name == "nu";
    if (convention.powers[p] != 0) scale *= std::pow(ratio ? 1 - parameters[p] : parameters[p], convention.powers[p]);
  }
  return scale;
}

std::vector<double> component_first(const std::vector<double>& gradient, int dim) {
  std::vector<double> turned(gradient.size());
  const std::size_t components = gradient.size() / static_cast<std::size_t>(dim);
  for (std::size_t c = 0; c < components; ++c)
    for (std::size_t i = 0; i < static_cast<std::size_t>(dim); ++i)
      turned[c * static_cast<std::size_t>(dim) + i] = gradient[i * components + c];
  return turned;
}

}  // namespace cageproof::judge
