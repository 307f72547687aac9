// SPDX-License-Identifier: MIT
// The line form of potentials on bilinear quads: elementary along lines, Gauss-Legendre across them.
#pragma once

#include "quad/potentials/kernel_terms.h"
#include "cageproof/core/catalogue/batch.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// A request for a potential.
template <class R>
struct PotentialTask {
  Potential potential;
  int order = 0;                            ///< highest derivative by the point: 0, 1 or 2
  double digits = 17;                       ///< of the integral, relative to the sizes of its terms: 2 to 90
  std::array<R, 2> parameters{R(1), R(1)};  ///< of the kernel's parts, 1/(4 pi) included: see KernelTape::Part
  bool finite_part = false;                 ///< Batch::finite_part: on the border, the value just inside
};

/// A potential's tensors with derivatives: for each order those of the four corners, one after the other, entries_of()
/// numbers each times 3 a derivative, whose index is the fastest; Hessians have all nine. Units are those of the
/// coordinates to the power degree_of() less the order.
template <class R>
struct PotentialTensors {
  std::array<std::vector<R>, 3> of;
  /// How many times as large as a tensor the terms are that it is the sum of.
  double cancelled = 1;
};

/// The potential of a bilinear quad and its derivatives by the point, with the measure du dv ([T24] Eq 5, 47-49; [C23]
/// Eq 3, 4; the quads' own is derived in docs/quad_potentials.md). On the quad: limits from inside, the side that N
/// looks away from, where there is one; NaN where it depends on the direction or diverges. NaN for an input that is not
/// finite. \param corners four, in any order and shape: where the quad folds over, its parts count with their own sign
/// \returns how many lines it took, and whether every rule has the nodes that its digits ask for
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
