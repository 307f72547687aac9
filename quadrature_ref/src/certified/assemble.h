// SPDX-License-Identifier: MIT
// A definition's tensors from moments: the derivatives' terms summed in the frame, then turned into the axes of space.
#pragma once

#include "moments.h"
#include "seen_element.h"

#include "cageproof/core/catalogue/formula.h"

namespace cageproof::quadrature_ref::certified {

/// A definition with the derivatives of its kernel up to order 2.
class DifferentiatedKernel {
 public:
  explicit DifferentiatedKernel(const Definition& definition);
  const Definition& definition() const { return *definition_; }

  const Formula& formula() const { return *formula_; }

  /// The moments that orders 0 to `order` need of a triangle.
  MomentRange moments(int order) const;
  /// Whether the integral of this order converges with the point on the element, and is continuous there.
  /// \param parameters in the order of Formula::parameters
  bool weakly_singular(int order, const std::vector<Real>& parameters) const;
  /// The tensor of one order, entries as in Result. \param parameters in the order of Formula::parameters
  std::vector<Real> tensor(int order, const SeenElement& element, const std::vector<Real>& parameters) const;

 private:
  const Definition* definition_;
  const Formula* formula_;
  /// [order][component][i <= j entries]
  std::array<std::vector<std::vector<Polynomial>>, 3> terms_;
};

/// The kernel of a formula. \throws std::out_of_range when it has no definition
const DifferentiatedKernel& kernel_of(std::string_view formula);

}  // namespace cageproof::quadrature_ref::certified
