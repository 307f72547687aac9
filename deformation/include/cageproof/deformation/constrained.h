// SPDX-License-Identifier: MIT
// Deformers without a posed cage: what is asked of a map at points of space decides it.
#pragma once

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/deformer.h"

#include <functional>

namespace cageproof::deformation {

/// Constraints on a map f at points inside a cage, or on it where the constrained quantities exist there. In the plane,
/// third coordinates are ignored.
struct Constraints {
  struct Position {
    Vec3<double> at, to;
  };
  struct Orientation {
    Vec3<double> at;
    Mat3<double> jacobian;  ///< row c, column j: the derivative of f's component c along axis j
  };
  std::vector<Position> positions = {};        ///< f(at) = to
  std::vector<Orientation> orientations = {};  ///< Jf(at) = jacobian
  std::vector<Vec3<double>> rotations = {};    ///< Jf is a rotation, or a similarity, whichever is nearest
  std::vector<Vec3<double>> hessians = {};     ///< Hf = 0
};

/// A constraint is wrong, not the cage or an option; the message names it.
class ConstraintError : public InputError {
 public:
  using InputError::InputError;
};

/// Called after each step of an iteration with its number, from 1 on, and the energy then.
using StepWatcher = std::function<void(int step, double energy)>;

/// A method prepared for one cage and for the places of constraints, whose targets may move. R: double or Mp50. Safe
/// from any thread.
template <Scalar R>
class ConstrainedDeformer {
 public:
  virtual ~ConstrainedDeformer() = default;
  /// The coordinates that images of points are made from.
  virtual const CageCoordinates& coordinates() const = 0;
  /// Rank and condition of what is solved, and what there is to warn of before any step.
  virtual DeformationReport prepared() const { return {}; }
  /// The map for the constraints as given. Its report has the energies of all steps, and as figures "energy" and
  /// "steps".
  /// \throws InputError for targets so large that the energy leaves the scalar's range
  virtual std::unique_ptr<const Posed<R>> pose(const StepWatcher& watch = {}) const = 0;
  /// The map for the positional constraints' points drawn elsewhere, in their order.
  /// \throws InputError as pose(), unless there are as many targets as positional constraints, and for targets that are
  /// not finite, named
  virtual std::unique_ptr<const Posed<R>> pose_to(const std::vector<Vec3<double>>& targets,
                                                  const StepWatcher& watch = {}) const = 0;

  /// Images of points under a map.
  Images<R> images(const Posed<R>& posed, std::span<const Vec3<R>> points, int order) const {
    return posed.images(coordinates().template at<R>(points, order), points.size(), order);
  }
};

/// A method that takes constraints, as users name it.
struct ConstraintMethod {
  std::string_view name;
  std::string_view source;
  std::string_view keeps;  ///< the maps of space that it reproduces, in words
  /// Its own; once programs ask for methods, those of the kind of coordinates after them, where it names one.
  std::vector<KindParameter> parameters = {};
  std::string_view kind = {};
  /// The dimension of the cages that it takes; 0 means all.
  int dimension = 0;
  /// Whether it takes only positions.
  bool positions_alone = false;
  /// \param options with all parameters, in their order, each in its range
  std::shared_ptr<const ConstrainedDeformer<double>> (*prepare)(const Cage& cage, const Constraints& constraints,
                                                                const DeformOptions& options);
};

/// All methods, by name. They stay where they are.
const std::list<ConstraintMethod>& constraint_methods();

/// Adds a method at program start: `const RegisterConstraintMethod r{...};` at namespace scope of a .cpp.
struct RegisterConstraintMethod {
  explicit RegisterConstraintMethod(ConstraintMethod method);
};

/// The method of that name, or null.
const ConstraintMethod* find_constraint_method(std::string_view name);

/// Prepares a method.
/// \throws InputError for a cage or constraints that the method refuses, and for parameters out of range
std::shared_ptr<const ConstrainedDeformer<double>> prepare_constrained(const ConstraintMethod& method, const Cage& cage,
                                                                       const Constraints& constraints,
                                                                       DeformOptions options);

}  // namespace cageproof::deformation
