// SPDX-License-Identifier: MIT
// Deformation of the plane by points that are moved, keeping the thickness of the shape ([W12] Section 5.4).
#pragma once

#include "cageproof/deformation/constrained.h"

namespace cageproof::deformation {

struct ThicknessOptions {
  int samples = 4;  ///< of the energy on each edge, at fractions (q + 1/2)/samples; at least 1. Part of the method
  int steps = 100;  ///< at most; at least 1
  std::string evaluation = {};  ///< of the coordinates' formulas; empty for the recommended ones
  /// Parameters of the kind `biharmonic_boundary`, in the order of parameters_of; empty for their defaults.
  std::vector<double> coordinates = {};
};

/// The posed vertices F that make
///     E = sum over samples on the cage's edges of |d^2 f / dn^2|^2,   n the rest normal,
/// least subject to f(at) = to, for f = alpha F + beta n'(F) with the posed edges' outward unit normals n' ([W12] Eq
/// 22, as a sum). By Gauss-Newton steps from the rigid motion nearest to the targets, each the least of the linearised
/// energy among those that meet the linearised constraints, and as long as lowers the merit E + weight |f(at) - to|.
/// The energy is no convex function of F; the minimum need not be the global one. It has no limit as samples refine. R:
/// double or Mp50. Safe from any thread.
template <Scalar R>
class Thickness final : public ConstrainedDeformer<R> {
 public:
  /// \throws InputError for a cage that is no polygon or has no such coordinates, an option out of range, no positions
  /// or more than the cage has vertices, numbers that are not finite and points outside the cage, naming the position,
  /// constraints other than positions, and samples at ends of the edges' pieces, where second derivatives are infinite
  Thickness(const Cage& cage, Constraints constraints, const ThicknessOptions& options = {});

  /// The coordinates, of kind `biharmonic_boundary`.
  const CageCoordinates& coordinates() const override;
  DeformationReport prepared() const override;

  /// Posed::vertices has the posed cage F. The report has E of the rigid motion, which is 0, and after each step in
  /// `energies`, and the merit in `merits`, all with one weight, which does not rise; as figures "energy", "energy a
  /// sample", "steps" (0 where the motion meets the targets as well as they are rounded), "constraint misfit" (the
  /// largest |f(at) - to|) and "projected gradient" (of E along the constraints, its largest number, per length). In
  /// the end misfit, step and projected gradient are down to double's rounding; or no part of a step that is shorter
  /// than 1e-6 sizes lowers the merit, with a warning; or the report says why the pose is unsolved. Where the weight
  /// turns out to be less than the constraints' multipliers, steps begin anew with a larger one, from the motion and
  /// number 1 on. What is watched is E. \throws InputError for targets for which an edge of the posed cage shrinks to
  /// nothing
  std::unique_ptr<const Posed<R>> pose(const StepWatcher& watch = {}) const override;
  std::unique_ptr<const Posed<R>> pose_to(const std::vector<Vec3<double>>& targets,
                                          const StepWatcher& watch = {}) const override;
  /// pose_to, with images in another scalar. To: R, or double
  template <Scalar To>
  std::unique_ptr<const Posed<To>> pose_in(const std::vector<Vec3<double>>& targets, const StepWatcher& watch) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace cageproof::deformation
