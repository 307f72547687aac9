// SPDX-License-Identifier: MIT
// The line form of potentials on bilinear quads: elementary along lines, Gauss-Legendre across them.
#pragma once

#include "cageproof/adaptive_qmvc/quad/potentials/kernel_terms.h"
#include "cageproof/core/batch.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// What is asked of a potential.
template <class R>
struct PotentialTask {
  Potential potential;
  int order = 0;                            ///< highest derivative
  double digits = 17;                       ///< of the integral, relative to the sizes of its terms
  std::array<R, 2> parameters{R(1), R(1)};  ///< of the kernel's parts, 1/(4 pi) included: see KernelTape::Part
  bool finite_part = false;                 ///< Batch::finite_part
};

/// A potential's tensors with derivatives: for each order those of the four corners, one after the other.
template <class R>
struct PotentialTensors {
  std::array<std::vector<R>, 3> of;
  /// How many times as large as a tensor the terms are that it is the sum of.
  double cancelled = 1;
};

/// The potential and its derivatives. On the quad: limits from inside, the side that N looks away from, where there is
/// one; NaN where it depends on the direction or diverges. NaN for an input that is not finite.
template <Scalar R>
Statement potential_form(std::span<const Vec3<R>> corners, const Vec3<R>& point, const PotentialTask<R>& task,
                         PotentialTensors<R>& tensors);

extern template Statement potential_form<double>(std::span<const Vec3<double>>, const Vec3<double>&,
                                                 const PotentialTask<double>&, PotentialTensors<double>&);
extern template Statement potential_form<Mp50>(std::span<const Vec3<Mp50>>, const Vec3<Mp50>&,
                                               const PotentialTask<Mp50>&, PotentialTensors<Mp50>&);
extern template Statement potential_form<Mp100>(std::span<const Vec3<Mp100>>, const Vec3<Mp100>&,
                                                const PotentialTask<Mp100>&, PotentialTensors<Mp100>&);
extern template Statement potential_form<Mp200>(std::span<const Vec3<Mp200>>, const Vec3<Mp200>&,
                                                const PotentialTask<Mp200>&, PotentialTensors<Mp200>&);

}  // namespace cageproof::adaptive_qmvc
