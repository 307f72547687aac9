// SPDX-License-Identifier: MIT
// Quads, points and a function that tests of enclosures over bilinear quads share.
#pragma once

#include "certified_support.h"
#include "support.h"

#include "certified/certified.h"

namespace cageproof::quadrature_ref {

inline const Quad<double> kSquare{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, 0),
                                  Vec3<double>(0, 1, 0)};
inline const Quad<double> kTwistedUp{Vec3<double>(0, 0, 0), Vec3<double>(1, 0, 0), Vec3<double>(1, 1, .5),
                                     Vec3<double>(0, 1, 0)};
inline const Vec3<double> kBelow(.5, .375, -.5);

inline const std::vector<std::string>& enclosed_formulas() {
  static const std::vector<std::string> all{"quad.single_layer",
                                            "quad.double_layer",
                                            "quad.solid_angle",
                                            "quad.mean_value",
                                            "quad.biharmonic_single_layer",
                                            "quad.biharmonic_double_layer",
                                            "quad.kelvin_displacement",
                                            "quad.kelvin_traction"};
  return all;
}

template <Scalar R>
std::vector<R> parameters_for(const std::string& formula, double nu) {
  return formula.find("kelvin") == std::string::npos ? std::vector<R>{} : std::vector<R>{R(1), static_cast<R>(nu)};
}

template <Scalar R = Mp100>
Result<R> enclosed_quad(const std::string& formula, const Quad<double>& q, const Vec3<double>& point, int order,
                        const CertifiedEffort& effort = {}, double nu = .25) {
  const Quad<R> corners{convert<R>(q[0]), convert<R>(q[1]), convert<R>(q[2]), convert<R>(q[3])};
  const std::vector<R> parameters = parameters_for<R>(formula, nu);
  Result<R> result;
  integrate_certified(formula, Query<R>{corners, convert<R>(point), order, parameters}, result, effort);
  return result;
}

inline Vec3<double> on_quad(const Quad<double>& q, double u, double v) {
  return (1 - u) * (1 - v) * q[0] + u * (1 - v) * q[1] + u * v * q[2] + (1 - u) * v * q[3];
}

}  // namespace cageproof::quadrature_ref
