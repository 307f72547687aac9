// SPDX-License-Identifier: MIT
#include "cages/rest_products.h"

#include "sampling/generic_change.h"

#include "cageproof/core/geometry/nearest.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

constexpr std::size_t most_rest_elements = 20;

// The error of a step is its square, and that of rounding is 1e-50 over it.
constexpr double rest_step = 1e-16;

// A formula's closed form, at one point and in 50 digits.
std::vector<Mp50> values_in_50_digits(const Evaluation& of, const std::vector<Vec3<Mp50>>& corners,
                                      const Vec3<Mp50>& point) {
  std::vector<Mp50> found(static_cast<std::size_t>(of.formula().components()));
  BatchOutput<Mp50> output{.tensors = {found.data()}, .entries = 1, .dim = of.formula().dim()};
  output.stride[0] = found.size();
  of(Batch<Mp50>{corners, std::span(&point, 1), 0, {}}, output);
  return found;
}

}  // namespace

bool RestProducts::exist(const CageCoordinates& coordinates) {
  return coordinates.kind().is_sum() && find_rest_derivative(coordinates.kind()) != nullptr &&
         coordinates.elements().count() <= most_rest_elements;
}

RestProducts::RestProducts(const CageCoordinates& coordinates, const Cage& cage, const RestDerivative& derivative)
    : coordinates_(coordinates), derivative_(derivative), change_(generic_change(cage)) {}

double RestProducts::condition(std::size_t element, const Vec3<double>& point) const {
  const std::vector<Vec3<double>> corners = coordinates_.elements().corners(element);
  const std::size_t n = corners.size();
  double longest = 0, to_border = HUGE_VAL;
  for (std::size_t k = 0; k < n; ++k) {
    const std::array side{corners[k], corners[(k + 1) % n]};
    longest = std::max(longest, (side[1] - side[0]).norm());
    const Vec3<double> nearest = n == 2 ? corners[k] : nearest_place(side, point).place;
    to_border = std::min(to_border, (nearest - point).norm());
  }
  double aspect = 1;
  if (n == 3) aspect = longest * longest / (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
  return std::max(longest / to_border, aspect);
}

RestProducts::Difference RestProducts::difference_at(const Vec3<double>& at) const {
  const std::scoped_lock lock(mutex_);
  const auto [known, is_new] = known_.try_emplace({at[0], at[1], at[2]});
  if (is_new) known->second = made_difference(at);
  return known->second;
}

RestProducts::Difference RestProducts::made_difference(const Vec3<double>& at) const {
  const CageElements& elements = coordinates_.elements();
  const Vec3<Mp50> point = convert<Mp50>(at);
  const Mp50 h = rest_step;
  const auto& blocks = coordinates_.blocks();
  Difference found;
  std::vector<std::vector<Mp50>> sums;
  for (const CoordinateBlock& block : blocks) {
    const auto size = static_cast<std::size_t>(block.size);
    sums.emplace_back(size, Mp50(0));
    found.terms.emplace_back(size, 0.);
    found.conditioned.emplace_back(size, 0.);
  }
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto vertices = elements.vertices_of(e);
    std::vector<Vec3<Mp50>> up, down;
    for (const int v : vertices) {
      const Vec3<Mp50> corner = convert<Mp50>(elements.vertices()[v]), by = h * convert<Mp50>(change_[v]);
      up.emplace_back(corner + by);
      down.emplace_back(corner - by);
    }
    const double costs = condition(e, at);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const Formula& formula = *find_formula(elements.type(e).kind, coordinates_.kind().blocks[b].kernel);
      const Evaluation closed_form = EvaluationRegister::instance().with_role(formula.name, Role::ClosedForm).value();
      const std::vector<Mp50> above = values_in_50_digits(closed_form, up, point),
                              below = values_in_50_digits(closed_form, down, point);
      const auto shares = elements.shares_of(e, blocks[b].owner);
      for (std::size_t i = 0; i < shares.size(); ++i) {
        const Mp50 term = (above[i] - below[i]) / (2 * h);
        const auto size = static_cast<double>(Mp50(abs(term)));
        sums[b][shares[i]] += term;
        found.terms[b][shares[i]] += size;
        found.conditioned[b][shares[i]] += costs * size;
      }
    }
  }
  for (const auto& block : sums) {
    auto& along = found.along.emplace_back();
    for (const Mp50& x : block) along.push_back(static_cast<double>(x));
  }
  return found;
}

std::vector<double> RestProducts::jvp(const Vec3<double>& point) const {
  std::size_t row = 0;
  for (const CoordinateBlock& block : coordinates_.blocks()) row += static_cast<std::size_t>(block.size);
  std::vector<double> found(row);
  derivative_.jvp(coordinates_, std::span(&point, 1), change_, 1, found);
  return found;
}

CageError RestProducts::error_of_jvp(const Vec3<double>& point) const {
  const std::vector<double> changes = jvp(point);
  const Difference expected = difference_at(point);
  CageError worst{0, 0};
  std::size_t first = 0;
  for (std::size_t b = 0; b < expected.along.size(); ++b) {
    const std::vector<double>& truth = expected.along[b];
    std::vector<double> error(truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i) error[i] = changes[first + i] - truth[i];
    first += truth.size();
    const double off = length_of(error);
    if (std::isnan(off)) return {};
    worst.roundings = std::max(worst.roundings, off / (unit_roundoff<double>() * length_of(expected.conditioned[b])));
    worst.relative = std::max(worst.relative, off / length_of(truth));
  }
  return worst;
}

CageError RestProducts::error_of_transposed(const Vec3<double>& point) const {
  const std::vector<double> changes = jvp(point);
  std::vector<double> weights(changes.size());
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = i % 3 == 1 ? -1 : 1;
  const std::vector<Vec3<double>> back = derivative_.vjp(coordinates_, std::span(&point, 1), weights, 1);
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < changes.size(); ++i) difference += weights[i] * changes[i];
  const double product = difference;
  for (std::size_t v = 0; v < back.size(); ++v) difference -= back[v].dot(change_[v]);
  if (std::isnan(difference)) return {};
  for (const auto& block : difference_at(point).terms)
    for (const double x : block) size += x;
  return {std::abs(difference) / (unit_roundoff<double>() * size), std::abs(difference / product)};
}

}  // namespace cageproof::validation
