// SPDX-License-Identifier: MIT
// Questions to a deformer without a posed cage: whether its energy falls to a minimum, and whether rigid motions and
// other units of length give the same map.
#pragma once

#include "cageproof/deformation/constrained.h"
#include "deformer_checks.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::validation {

/// A method that takes constraints, with one of the values of its first parameter that has names, the others at their
/// defaults, weights per power of the cage's size.
struct ConstrainedVariant {
  const deformation::ConstraintMethod* method;
  std::string name;                ///< "subspace=harmonic"; empty for methods without such a parameter
  std::vector<double> parameters;  ///< DeformOptions::parameters, of a cage of size one
};

/// All variants of a method, in the order of the parameter's names.
std::vector<ConstrainedVariant> variants_of(const deformation::ConstraintMethod& method);

/// The variant of that name. \throws InputError where there is none
ConstrainedVariant variant_named(const deformation::ConstraintMethod& method, std::string_view name);

/// Whether the method takes the cage, and enough points lie deep enough inside for constraints.
bool can_be_asked(const deformation::ConstraintMethod& method, const Cage& cage, Triangulation rule);

struct ConstrainedProblem;

/// Questions to one method on one cage. Constraints are drawn to a map of space, or, `bent`, each target by itself away
/// from it by up to a twentieth of the size; their places depend only on the cage. Safe from any thread.
class ConstrainedChecks {
 public:
  /// \pre can_be_asked
  ConstrainedChecks(std::shared_ptr<const Cage> cage, ConstrainedVariant variant, Triangulation rule);

  /// energy_falls: the largest rise of the energy (of methods with a merit, of that) at a step, over it.
  /// rigid_energy: the energy that targets moved rigidly leave, in a unit in which the cage's size is one.
  /// keeps_rigid: images where targets are moved rigidly with those of the motion.
  /// energy_is_flat, of methods whose energy is quadratic in their coefficients: its gradient after the first step over
  /// that before it.
  /// second_route: unmet_stationarity(): slopes and sums of energies that are written another time.
  /// constrained_unit: images with those of the cage that is ten times as large, weights adapted; not of biharmonic
  /// maps of the plane, which are others in other units.
  /// constrained_motion: images with those of the cage and its constraints turned.
  /// keeps_offset: images of a cage far from the origin, whose targets are moved rigidly, with those of the same cage,
  /// places and targets moved back, which rounds nothing.
  /// A question's place is its pose; its systems are solved when it is first asked, and an energy is asked for at only
  /// one point. Valid while this lives.
  std::vector<Question<PointAt>> questions() const;

 private:
  using Ask = std::function<DeformerError(const Vec3<double>&)>;

  Question<PointAt> question(std::string_view check, std::string_view pose, Ask ask) const;
  Question<PointAt> energy(std::string_view check, std::string_view pose,
                           double (ConstrainedChecks::*find)(std::string_view) const) const;
  ConstrainedProblem problem(std::string_view pose) const;
  double largest_rise(std::string_view pose) const;
  double what_is_left(std::string_view pose) const;
  double slope_left(std::string_view pose) const;
  double flatness(std::string_view pose) const;
  Ask kept(const SpaceMap& map) const;
  Ask kept_far_off(const SpaceMap& offset) const;
  Ask moved(std::string_view pose, const SpaceMap& map, double length) const;

  std::shared_ptr<const Cage> cage_;
  ConstrainedVariant variant_;
  Triangulation rule_;
  std::vector<Vec3<double>> places_;  ///< of constraints
};

}  // namespace cageproof::validation
