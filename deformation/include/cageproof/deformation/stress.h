// SPDX-License-Identifier: MIT
// Strain and stress of a map of space, as linear elasticity has them ([C23] Section 3.1).
#pragma once

#include "cageproof/core/numbers/linear.h"

namespace cageproof::deformation {

/// A homogeneous and isotropic elastic material ([C23] Eq 1).
struct Material {
  double shear_modulus = 1;    ///< mu, positive: stresses have its unit
  double poisson_ratio = 0.3;  ///< nu, in (-1, 1/2), or infinite, which stands for the limit

  /// Lame's first parameter, 2 mu nu/(1 - 2 nu), the factor of the divergence in [C23] Eq 2: -mu for infinite nu.
  double lame() const;
};

/// Whether the stress of a strain has a meaning: it is infinite at 1/2, and nu beyond (-1, 1/2) is of no material. The
/// limit of infinite nu has no energy that is positive, but equilibrium, which makes each component harmonic.
bool has_stress(double poisson_ratio);

/// Symmetric tensors at a point. In the plane both are those of plane strain: what points across is zero, except the
/// stress zz.
struct Stress {
  Mat3<double> strain;  ///< (grad u + grad u^T)/2, without unit
  Mat3<double> stress;  ///< sigma of [C23] Eq 2, in the unit of the shear modulus

  /// sigma n, the force per area on the plane with that unit normal, from the side that the normal points to.
  Vec3<double> traction(const Vec3<double>& normal) const { return stress * normal; }
  /// The size of the stress without its mean: sqrt(3/2 s:s), s = sigma - tr(sigma)/3 I.
  double von_mises() const;
};

/// Both tensors of the displacement u = f(x) - x.
/// \param jacobian of f, [component][derivatives by the rest axes]; in the plane its third row and column are those of
/// the identity. Where one of its numbers is not finite, no entry of the stress is
/// \pre has_stress(material.poisson_ratio)
Stress stress_of(const Mat3<double>& jacobian, const Material& material);

}  // namespace cageproof::deformation
