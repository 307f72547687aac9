// SPDX-License-Identifier: MIT
#include "assemble.h"

#include <algorithm>
#include <stdexcept>

namespace cageproof::quadrature_ref::certified {
namespace {

// Contracts one index, of `stride` between its entries, of a tensor in the frame with the axes of a space of `dim`
// dimensions.
void turn_index(std::vector<Real>& tensor, std::size_t stride, int dim, const SeenElement& element) {
  for (std::size_t first = 0; first < tensor.size(); ++first) {
    if (first / stride % dim != 0) continue;
    std::vector<Real> old;
    for (int a = 0; a < dim; ++a) old.push_back(tensor[first + a * stride]);
    for (int i = 0; i < dim; ++i) {
      Real sum;
      for (int a = 0; a < dim; ++a) add_product(sum, element.axis(a, i), old[a]);
      tensor[first + i * stride] = std::move(sum);
    }
  }
}

// Whether a term's constant is exactly zero.
bool is_nothing(const Monomial& m, const std::vector<Real>& constants) {
  return m.constant != 0 && constants[m.constant - 1].is_zero();
}

}  // namespace

DifferentiatedKernel::DifferentiatedKernel(const Definition& definition)
    : definition_(&definition), formula_(&formula_named(definition.formula)) {
  // Indices that terms use for coordinates along the frame's axes; the last is the normal's.
  const std::vector<int> coordinates = formula_->dim() == 2 ? std::vector{0, 2} : std::vector{0, 1, 2};
  for (const Polynomial& component : definition.components) {
    terms_[0].push_back({component});
    auto& gradient = terms_[1].emplace_back();
    for (const int i : coordinates) gradient.push_back(component.derivative(i));
    auto& hessian = terms_[2].emplace_back();
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      for (std::size_t j = i; j < coordinates.size(); ++j) hessian.push_back(gradient[i].derivative(coordinates[j]));
  }
}

MomentRange DifferentiatedKernel::moments(int order) const {
  MomentRange range(terms_[0][0][0].terms().begin()->first.q % 2 != 0);
  for (int o = 0; o <= order; ++o)
    for (const auto& component : terms_[o])
      for (const Polynomial& entry : component)
        for (const auto& [monomial, factor] : entry.terms())
          range.include(monomial.in_plane() + (definition_->per_corner ? 1 : 0), monomial.q);
  return range;
}

bool DifferentiatedKernel::weakly_singular(int order, const std::vector<Real>& parameters) const {
  const std::vector<Real> constants = definition_->constants(parameters);
  for (const auto& component : terms_[order])
    for (const Polynomial& entry : component)
      for (const auto& [monomial, factor] : entry.terms())
        if (!is_nothing(monomial, constants) && !monomial.weakly_singular(formula_->dim() - 1)) return false;
  return true;
}

std::vector<Real> DifferentiatedKernel::tensor(int order, const SeenElement& element,
                                               const std::vector<Real>& parameters) const {
  const std::vector<Real> constants = definition_->constants(parameters);
  std::vector<Real> heights{Real(1)};
  for (int i = 1; i <= 8; ++i) heights.push_back(heights.back() * element.height());

  const int dim = formula_->dim();
  std::vector<Real> result;
  for (int tensor = 0; tensor < formula_->tensors(); ++tensor)
    for (const auto& component : terms_[order]) {
      std::vector<Real> entries;
      for (const Polynomial& polynomial : component) {
        Real sum;
        for (const auto& [m, factor] : polynomial.terms()) {
          // In the plane a term with its height is zero, whatever the moment.
          if ((m.powers[2] > 0 && element.in_plane()) || is_nothing(m, constants)) continue;
          Real moment = element.moment(m, definition_->per_corner ? std::optional(tensor) : std::nullopt);
          if (m.constant != 0) moment = moment * constants[m.constant - 1];
          add_product(sum, moment * factor, heights[m.powers[2]]);
        }
        entries.push_back(std::move(sum));
      }
      if (order == 2) {
        // Entry i <= j of the upper half, row by row.
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j) {
            const int low = std::min(i, j), high = std::max(i, j);
            result.push_back(entries[low * dim - low * (low - 1) / 2 + high - low]);
          }
      } else {
        for (Real& entry : entries) result.push_back(std::move(entry));
      }
    }
  // All indices but the corner's: two of a matrix, one a derivative.
  const int rank = formula_->shape.space_indices() + order;
  std::size_t stride = 1;
  for (int index = 0; index < rank; ++index, stride *= dim) turn_index(result, stride, dim, element);
  return result;
}

const DifferentiatedKernel& kernel_of(std::string_view formula) {
  static const std::vector<DifferentiatedKernel> all(definitions().begin(), definitions().end());
  for (const DifferentiatedKernel& kernel : all)
    if (kernel.definition().formula == formula) return kernel;
  throw std::out_of_range("no definition of " + std::string(formula));
}

}  // namespace cageproof::quadrature_ref::certified
