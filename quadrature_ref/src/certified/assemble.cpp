// SPDX-License-Identifier: MIT
#include "assemble.h"

#include <stdexcept>

namespace cageproof::quadrature_ref::certified {
namespace {

// Contracts one index, of `stride` between its entries, of a tensor in the frame with the axes.
void turn_index(std::vector<Real>& tensor, std::size_t stride, const Frame& frame) {
  for (std::size_t first = 0; first < tensor.size(); ++first) {
    if (first / stride % 3 != 0) continue;
    const std::array<Real, 3> old{tensor[first], tensor[first + stride], tensor[first + 2 * stride]};
    for (int i = 0; i < 3; ++i) {
      Real sum;
      for (int a = 0; a < 3; ++a) add_product(sum, frame.axes[a][i], old[a]);
      tensor[first + i * stride] = std::move(sum);
    }
  }
}

}  // namespace

DifferentiatedKernel::DifferentiatedKernel(const Definition& definition) : definition_(&definition) {
  for (const Polynomial& component : definition.components) {
    terms_[0].push_back({component});
    auto& gradient = terms_[1].emplace_back();
    for (int i = 0; i < 3; ++i) gradient.push_back(component.derivative(i));
    auto& hessian = terms_[2].emplace_back();
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) hessian.push_back(gradient[i].derivative(j));
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

bool DifferentiatedKernel::weakly_singular(int order) const {
  for (const auto& component : terms_[order])
    for (const Polynomial& entry : component)
      for (const auto& [monomial, factor] : entry.terms())
        if (!monomial.weakly_singular()) return false;
  return true;
}

std::vector<Real> DifferentiatedKernel::tensor(int order, const Frame& frame, const Moments& moments,
                                               const std::vector<Real>& parameters) const {
  const std::vector<Real> constants = definition_->constants(parameters);
  std::vector<Real> heights{Real(1)};
  for (int i = 1; i <= 8; ++i) heights.push_back(heights.back() * frame.height);

  std::vector<Real> result;
  for (int corner = 0; corner < (definition_->per_corner ? 3 : 1); ++corner)
    for (const auto& component : terms_[order]) {
      std::vector<Real> entries;
      for (const Polynomial& polynomial : component) {
        Real sum;
        for (const auto& [m, factor] : polynomial.terms()) {
          const auto [a, b, c] = m.powers;
          Real moment = moments.at(a, b, m.q);
          if (definition_->per_corner) {
            const auto& hat = frame.hat[corner];
            moment = moment * hat[0] + moments.at(a + 1, b, m.q) * hat[1] + moments.at(a, b + 1, m.q) * hat[2];
          }
          // In the plane a term with its height is zero, whatever the moment.
          if (c > 0 && frame.in_plane) continue;
          if (m.constant != 0) moment = moment * constants[m.constant - 1];
          add_product(sum, moment * factor, heights[c]);
        }
        entries.push_back(std::move(sum));
      }
      if (order == 2) {
        constexpr std::array<int, 9> packed{0, 1, 2, 1, 3, 4, 2, 4, 5};
        for (const int entry : packed) result.push_back(entries[entry]);
      } else {
        for (Real& entry : entries) result.push_back(std::move(entry));
      }
    }
  // All indices but the corner's: two of a matrix, one a derivative.
  const int rank = (definition_->components.size() == 9 ? 2 : 0) + order;
  std::size_t stride = 1;
  for (int index = 0; index < rank; ++index, stride *= 3) turn_index(result, stride, frame);
  return result;
}

const DifferentiatedKernel& kernel_of(std::string_view formula) {
  static const std::vector<DifferentiatedKernel> all(definitions().begin(), definitions().end());
  for (const DifferentiatedKernel& kernel : all)
    if (kernel.definition().formula == formula) return kernel;
  throw std::out_of_range("no definition of " + std::string(formula));
}

}  // namespace cageproof::quadrature_ref::certified
