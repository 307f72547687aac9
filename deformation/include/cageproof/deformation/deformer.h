// SPDX-License-Identifier: MIT
// Deformers: what a posed cage does to the points of space. A method, prepared for one rest cage, then posed as often
// as one likes; points are asked through their coordinates, which outlive poses.
#pragma once

#include "cageproof/core/numbers/least_squares.h"

#include <limits>
#include <list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::deformation {

/// The report of a method about its computation.
struct DeformationReport {
  std::vector<SolvedSystem> systems;
  std::vector<std::pair<std::string, double>> figures;  ///< energies, counts, by name
  std::vector<std::string> warnings;
  /// Why the map is none that the method defines; empty where it is one.
  std::string unsolved = {};
  /// About how far images are off because posed vertices are rounded to double, in sizes of the posed cage; 0 where
  /// that was not found.
  double pose_rounding = 0;
  /// The energy after every half step, or step, of methods that iterate.
  std::vector<double> energies = {};
  /// A merit that does not rise, after every step, of methods whose energy may rise on the way to the constraints.
  std::vector<double> merits = {};
};

/// Another pose of a cage: its vertices, in their order, elsewhere.
template <Scalar R>
struct Pose {
  std::vector<Vec3<R>> vertices;
  /// Normal derivatives that the user prescribes instead of the method's own, one for each of normals_owner(): of each
  /// element, of each corner of each element where they are affine, or, of quads that are kept, of each corner of a
  /// quad and each triangle, along the unit normal there; empty for those.
  std::vector<Vec3<R>> normal_derivatives = {};
  /// The densities of methods that take them, of the Laplacian at each vertex, and of its normal derivative on each
  /// element (L' and D' of [T24] Eq 19); empty for zeros.
  std::vector<Vec3<R>> laplacians = {}, laplacian_derivatives = {};
};

/// Images of points and their derivatives: tensors[o] is [point][component][derivatives by the rest axes], with as many
/// components and axes as the space has dimensions.
template <Scalar R>
struct Images {
  std::array<std::vector<R>, 3> tensors;
};

/// A deformer with a pose.
template <Scalar R>
class Posed {
 public:
  virtual ~Posed() = default;
  /// \param coordinates of the points, by Deformer::coordinates() \pre order <= Deformer::max_order()
  virtual Images<R> images(std::span<const CoordinateTable<R>> coordinates, std::size_t points, int order) const = 0;
  virtual const DeformationReport& report() const = 0;
  /// The posed cage's vertices, in their order, of methods that find it themselves (Thickness); empty for others.
  virtual std::vector<Vec3<R>> vertices() const { return {}; }
};

/// The derivative of a deformer's images by the vertices of its posed cage, at one pose: a linear map J of changes of
/// vertices, which is exact to rounding (no differences). Points come as their coordinates, as they do for images.
template <Scalar R>
class PoseDerivative {
 public:
  virtual ~PoseDerivative() = default;

  /// J times a change: a pose whose images are the changes of images. Only values: it has no Jacobians.
  /// \param change one row per vertex
  virtual std::unique_ptr<const Posed<R>> along(const std::vector<Vec3<R>>& change) const = 0;

  /// What `gather` adds to, of zeros.
  virtual std::vector<Matrix<R>> nothing() const = 0;
  /// Adds points' shares in the transposed J, with as many numbers as the pose has data.
  /// \param weights [point][component], of the images
  virtual void gather(std::span<const CoordinateTable<R>> coordinates, std::size_t points, std::span<const R> weights,
                      std::vector<Matrix<R>>& gathered) const = 0;
  /// The transposed J times the weights of all points that were gathered: one row per vertex.
  virtual std::vector<Vec3<R>> back(const std::vector<Matrix<R>>& gathered) const = 0;
};

/// A method prepared for one cage. Safe from any thread.
template <Scalar R>
class Deformer {
 public:
  virtual ~Deformer() = default;
  /// The coordinates that images of points are made from.
  virtual const CageCoordinates& coordinates() const = 0;
  virtual int max_order() const { return coordinates().max_order(); }
  /// The report on systems that were solved for the rest cage.
  virtual DeformationReport prepared() const { return {}; }
  /// \throws InputError for a pose that the method cannot take, naming the vertex or element
  virtual std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const = 0;
  /// The derivative of images by the vertices of the pose, which refers to the deformer. Null where
  /// the method has none with its parameters. \throws InputError as `pose`, and where there is none at the pose
  virtual std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& /*pose*/) const { return nullptr; }
  /// The method with other parameters, for the same cage, whose images are made from the same coordinates. Null where
  /// the parameters decide the coordinates, and of methods that know of no others.
  /// \pre as many as the method has, in range: with_other_parameters sees to it
  virtual std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& /*parameters*/) const {
    return nullptr;
  }

  /// Images of points under one pose.
  Images<R> images(const Posed<R>& posed, std::span<const Vec3<R>> points, int order) const {
    return posed.images(coordinates().template at<R>(points, order), points.size(), order);
  }
};

/// The open lower bound of parameters that may be zero: no double lies between.
inline constexpr double kBelowZero = -std::numeric_limits<double>::denorm_min();

/// The options that a method is prepared with.
struct DeformOptions {
  std::string evaluation = {};  ///< of the coordinates' formulas; empty for the recommended ones
  Triangulation triangulation = Triangulation::Shortest;
  /// In the order of parameters_of(method); those left out at the end take defaults.
  std::vector<double> parameters = {};
  /// The parameters that will have other values. Coordinates are prepared so that they serve all of these, where the
  /// method can, and may take twice as long.
  std::vector<std::string_view> varied = {};
};

/// A method, as users name it.
struct DeformMethod {
  std::string_view name;
  std::string_view source;
  std::string_view keeps;  ///< the maps of space that it reproduces, in words
  /// The kind of coordinates that images are made from, by the parameters' defaults.
  std::string_view kind;
  /// Its own; those of the kind come after them (parameters_of), unless the method says what they are.
  std::vector<KindParameter> parameters = {};
  bool with_parameters_of_kind = true;
  /// Its own parameters that decide the coordinates; all of the kind's parameters do, too.
  std::vector<std::string_view> coordinate_parameters = {};
  /// Whether poses may prescribe normal derivatives; other methods have their own and look at no others.
  bool takes_normal_derivatives = false;
  /// Whether poses may have Laplacians and their normal derivatives; other methods look at none.
  bool takes_laplacians = false;
  /// Whether preparing takes derivatives of coordinates on the cage, whose limits quadrature does not know.
  bool takes_derivatives_on_cage = false;
  /// Whether images have derivatives by posed vertices, with some parameters at least (Deformer::derivative).
  bool has_pose_derivative = false;
  /// Why there is no such deformer of a cage that has the coordinates; empty where there is. Null for methods that
  /// refuse none.
  std::string (*refuses)(const Cage& cage) = nullptr;
  std::shared_ptr<const Deformer<double>> (*prepare)(const Cage& cage, const DeformOptions& options);
  std::shared_ptr<const Deformer<Mp50>> (*prepare_in_50_digits)(const Cage& cage, const DeformOptions& options);
};

/// All methods, by name. They stay where they are.
const std::list<DeformMethod>& deform_methods();

/// Adds a method at program start: `const RegisterDeformMethod r{...};` at namespace scope of a .cpp.
struct RegisterDeformMethod {
  explicit RegisterDeformMethod(DeformMethod method);
};

/// The method of that name. \throws InputError where there is none
const DeformMethod& deform_method_named(std::string_view name);

/// The method that does the same on a cage's own quads: the method itself where its coordinates keep them, or the one
/// of its name with "quad_" before it. \throws InputError where there is none
const DeformMethod& keeping_quads(const DeformMethod& method);

/// A method's parameters: its own, then those of its kind of coordinates where users may choose them.
std::vector<KindParameter> parameters_of(const DeformMethod& method);

/// Whether a parameter decides the coordinates, so that maps of several values share none.
bool decides_coordinates(const DeformMethod& method, std::string_view parameter);

/// Why the cage has no such deformer with the parameters' defaults; empty where it has.
std::string why_refused(const DeformMethod& method, const Cage& cage);

/// Prepares a method. R: double or Mp50
/// \throws InputError for a cage that the method refuses, a parameter out of range or an unknown evaluation
template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_deformer(const DeformMethod& method, const Cage& cage,
                                                    DeformOptions options);

/// The derivative at a pose; normal derivatives and densities that the pose prescribes stay as they are.
/// \pre the deformer is of the method, and lives as long as the derivative
/// \throws InputError where the method has none with its parameters, naming the methods that have; where the map has
/// none at the pose, naming the element; and for a pose that the method does not take
template <Scalar R>
std::unique_ptr<const PoseDerivative<R>> pose_derivative(const DeformMethod& method, const Deformer<R>& deformer,
                                                         const Pose<R>& pose);

/// A prepared deformer with other parameters, made from the same coordinates (Deformer::with_parameters).
/// \throws InputError for a parameter out of range, or where these would take other coordinates
template <Scalar R>
std::shared_ptr<const Deformer<R>> with_other_parameters(const DeformMethod& method, const Deformer<R>& deformer,
                                                         const std::vector<double>& parameters);

}  // namespace cageproof::deformation
