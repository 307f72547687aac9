// SPDX-License-Identifier: MIT
#include "cageproof/deformation/stress.h"

#include <cmath>

namespace cageproof::deformation {

double Material::lame() const {
  if (std::isinf(poisson_ratio)) return -shear_modulus;
  return shear_modulus * (2 * poisson_ratio / (1 - 2 * poisson_ratio));
}

bool has_stress(double poisson_ratio) {
  return std::isinf(poisson_ratio) || (poisson_ratio > -1 && poisson_ratio < 0.5);
}

double Stress::von_mises() const {
  const Mat3<double> deviator = stress - stress.trace() / 3 * Mat3<double>::Identity();
  return std::sqrt(1.5) * deviator.reshaped().stableNorm();
}

Stress stress_of(const Mat3<double>& jacobian, const Material& material) {
  const Mat3<double> gradient = jacobian - Mat3<double>::Identity();
  Stress found;
  found.strain = (gradient + gradient.transpose()) / 2;
  found.stress =
      2 * material.shear_modulus * found.strain + material.lame() * found.strain.trace() * Mat3<double>::Identity();
  return found;
}

}  // namespace cageproof::deformation
