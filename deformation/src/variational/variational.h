// SPDX-License-Identifier: MIT
// Deformation by constraints on points of space, without a posed cage: variational harmonic and biharmonic maps ([T24]
// Section 4.2, Eq 37-40).
#pragma once

#include "cageproof/deformation/constrained.h"

namespace cageproof::deformation {

/// Maps f = phi a + psi b, or f = phi a + psi b + phibar c + psibar d, or f = x + T u + K t: displacements of elastic
/// bodies, whose vertices move by u, with tractions t on elements ([T24] Section 5 suggests them). T and K are the
/// matrices of Somigliana coordinates, so that components are not independent.
enum class Subspace { Harmonic, Biharmonic, Elastic };

/// What Jacobians at Constraints::rotations are drawn to.
enum class Nearest { Rotation, Similarity };

/// The paper gives no values for weights. They carry units: in a unit of length s times smaller, the same map takes
/// s^2 alpha, s^2 beta and s^4 gamma, except biharmonic maps of the plane, whose logarithms add |x|^2 to the layers.
struct VariationalOptions {
  Subspace subspace = Subspace::Biharmonic;
  Nearest nearest = Nearest::Rotation;
  double nu = 0.3;       ///< Poisson's ratio of elastic maps, in (-1, 1/2), or infinite
  double alpha = 0.01;   ///< weight of orientations, at least 0
  double beta = 0.01;    ///< of rotations, at least 0; the larger, the slower the convergence
  double gamma = 0.001;  ///< of Hessians, at least 0
  int steps = 100;       ///< of alternation, at most; at least 1
  /// Steps end when one lowers the energy by no more than this part of it, or when roundings are all that is left; 0:
  /// all steps are taken. Near the minimum the energy misses it by the square of what the map does.
  double tolerance = 1e-12;
  std::string evaluation = {};  ///< of the coordinates' formulas; empty for the recommended ones
  Triangulation triangulation = Triangulation::Shortest;
};

/// The energy
///   E = sum |f(p) - to|^2 + alpha sum |Jf - jacobian|^2 + beta sum |Jf - R|^2 + gamma sum |Hf|^2
/// of f's coefficients and of the rotations R, in Frobenius norms, made less by turns: each R becomes the rotation (or
/// similarity) nearest to Jf, then the coefficients solve a linear least-squares problem. Its matrix depends only on
/// places and weights and is factored once. The first map is the identity. The energy rises only by rounding, at
/// any half step; its minimum need not be the global one. Coefficients are found as differences from those of the rigid
/// motion nearest to the positions and orientations, so that a motion itself has no roundings; where constraints do not
/// determine them, the differences of least norm are taken, in the cage's own unit of length, and the report has a
/// warning. Targets that a motion meets as well as they are rounded are met by it in one step. R: double or Mp50. Safe
/// from any thread.
template <Scalar R>
class Variational final : public ConstrainedDeformer<R> {
 public:
  /// \throws InputError for a cage without coordinates of the kind, an option out of range, no constraints, and, naming
  /// the constraint, for numbers that are not finite, points outside the cage, and points on it where the derivatives
  /// do not exist
  Variational(const Cage& cage, Constraints constraints, const VariationalOptions& options = {});

  /// The coordinates, of kind `green`, `biharmonic` or `somigliana`.
  const CageCoordinates& coordinates() const override;
  DeformationReport prepared() const override;

  /// The report has the energies after all half steps, local ones first, and as figures "energy", "steps" and "last
  /// relative decrease".
  std::unique_ptr<const Posed<R>> pose(const StepWatcher& watch = {}) const override;
  std::unique_ptr<const Posed<R>> pose_to(const std::vector<Vec3<double>>& targets,
                                          const StepWatcher& watch = {}) const override;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace cageproof::deformation
