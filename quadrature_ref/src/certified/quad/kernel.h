// SPDX-License-Identifier: MIT
// Kernels on bilinear quads, and their derivatives. They are sums of kernel_terms.h's terms times 1, a component of
// N = xi_u x xi_v, or N.x, in the axes of space.
#pragma once

#include "../kernel_terms.h"

#include "cageproof/core/catalogue/formula.h"

namespace cageproof::quadrature_ref::certified {

/// A term's factor. N does not depend on the point; N.x does.
enum class QuadFactor { One, NormalX, NormalY, NormalZ, Height };

/// A sum of factor * polynomial.
using QuadPolynomial = std::map<QuadFactor, Polynomial>;

/// A formula's kernel on a quad, typed in from its definition, and its derivatives.
class QuadKernel {
 public:
  using Constants = std::function<std::vector<Real>(const std::vector<Real>& parameters)>;
  /// \param components one, or a matrix row by row
  QuadKernel(const Formula& formula, const std::vector<QuadPolynomial>& components, Constants constants);

  const Formula& formula() const { return *formula_; }
  std::vector<Real> constants(const std::vector<Real>& parameters) const { return constants_(parameters); }
  /// Per component its derivatives of that order; of Hessians the upper half, row by row.
  const std::vector<std::vector<QuadPolynomial>>& terms(int order) const { return terms_[order]; }

 private:
  const Formula* formula_;
  Constants constants_;
  std::array<std::vector<std::vector<QuadPolynomial>>, 3> terms_;
};

/// All kernels on quads that are enclosed.
const std::vector<QuadKernel>& quad_kernels();

/// \throws std::out_of_range when there is none of that formula
const QuadKernel& quad_kernel_of(std::string_view formula);

}  // namespace cageproof::quadrature_ref::certified
