// SPDX-License-Identifier: MIT
// Constraints of variational maps.
#pragma once

#include "support.h"

#include "variational/variational.h"

#include <cmath>

namespace cageproof::deformation::test {

using Mat = Mat3<double>;

/// The points of the specification's case on the bar: the upper four positions are to turn by a quarter and rise.
inline Constraints bar_constraints(const Cage& cage) {
  Constraints c;
  for (const double z : {-.9, .9})
    for (const auto& [x, y] : {std::pair{-.3, -.3}, {.3, -.3}, {.3, .3}, {-.3, .3}})
      c.positions.push_back({{x, y, z}, z < 0 ? Vec(x, y, z) : Vec(-y, x, z + .1)});
  for (int k = 0; k < 9; ++k) c.rotations.emplace_back(0, 0, -.8 + .2 * k);
  const CageElements elements(cage, false, Triangulation::Shortest);
  for (std::size_t e = 0; e < elements.count(); ++e) {
    Vec middle = Vec::Zero();
    for (const Vec& corner : elements.corners(e)) middle += corner / 3;
    c.hessians.push_back(middle - .05 * elements.normals()[e]);
  }
  return c;
}

inline VariationalOptions bar_options(Subspace subspace, int steps) {
  return {.subspace = subspace, .beta = .01, .gamma = .001, .steps = steps, .tolerance = 0};
}

/// As bar_constraints, and two orientations that the positions contradict.
inline Constraints with_orientations(const Cage& cage) {
  Constraints c = bar_constraints(cage);
  Mat a;
  a << 1.1, .2, -.1, .05, .8, .3, -.2, .1, 1.2;
  c.orientations = {{{.1, .1, -.5}, a}, {{-.2, .1, .4}, a.transpose()}};
  return c;
}

inline Constraints plane_constraints() {
  Constraints c;
  c.positions = {{{.2, .2, 0}, {.1, .3, 0}}, {{1.8, .1, 0}, {2.0, -.2, 0}}, {{1.1, 1.8, 0}, {.7, 2.1, 0}},
                 {{.3, 1, 0}, {.2, 1.2, 0}}, {{2.2, 1, 0}, {2, 1.4, 0}},    {{1, .9, 0}, {1.2, .8, 0}}};
  Mat a = Mat::Zero();
  a.topLeftCorner<2, 2>() << 1, .3, -.2, 1.2;
  c.orientations = {{{1.4, .5, 0}, a}};
  c.rotations = {{.5, .5, 0}, {1.5, 1, 0}, {1, .3, 0}, {1, 1.5, 0}};
  for (int k = 0; k < 12; ++k) c.hessians.emplace_back(1 + .7 * std::cos(.5236 * k), 1 + .6 * std::sin(.5236 * k), 0);
  return c;
}

}  // namespace cageproof::deformation::test
