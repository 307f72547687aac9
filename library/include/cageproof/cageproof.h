// SPDX-License-Identifier: MIT
// Cage coordinates and deformations of a mesh by them, in plain arrays of double: the whole library behind one header
// that includes only the standard library. docs/library.md has a program that uses it.
#pragma once

#include "cageproof/core/input_error.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cageproof::library {

/// A cage: a closed surface of triangles and quads, or in the plane one or more closed polygons.
struct Cage {
  std::vector<double> vertices;         ///< three numbers per vertex, in the plane two
  std::vector<std::vector<int>> faces;  ///< vertices from 0: 3 or 4, counter-clockwise seen from outside; in the plane
                                        ///< 2, with the inside on the left
  int dimension = 3;                    ///< 3 in space, 2 in the plane
  std::string name = "cage";            ///< its name in messages
  std::vector<std::string> warnings = {};  ///< about its file: parts left out, faces cut in triangles
};

/// Reads a cage from an OBJ file. Polylines (`l`), and faces whose vertices all have z = 0, make a cage in the plane.
/// Faces of more than four corners are cut in triangles. \throws InputError naming file, line and reason
Cage read_obj(const std::string& file);

/// Returns a built-in cage, such as "cube" or "twisted-bar". \throws InputError naming all, for another name
Cage embedded_cage(const std::string& name);

/// How coordinates and images are computed. `cageproof list` prints all names.
struct Options {
  /// Name of an evaluation. Empty: "batched" if the kind has it, otherwise the recommended one.
  std::string evaluation = {};
  /// How kinds that do not keep quads split them: by the "shortest" diagonal, or as a "fan" from the first corner.
  std::string triangulation = "shortest";
  /// Names and values of parameters, such as {"nu", "0.3"} and {"collocation", "vertices"}; each name once.
  std::vector<std::pair<std::string, std::string>> parameters = {};
  bool flip_inward = false;          ///< reverse parts whose normals point inward, instead of refusing them
  bool allow_invalid_quads = false;  ///< accept quads that cross themselves or fold; for kinds that keep quads
  int threads = 0;                   ///< at most this many threads; 0: all cores
  /// Digits of images, 3 to 12, relative to the posed cage's size; 0 for all. Only for the Deformer "green" in space,
  /// which is faster with fewer digits if faces and points are many. The error is bounded; roundings come on top. Each
  /// call of `images` prepares its points, so pass many at once. Bound points have all digits.
  int digits = 0;
};

/// A block of coordinates: one for each vertex, element, or corner of an element.
struct Block {
  std::string label;  ///< "phi", "psi", "lambda" ...
  /// The owner of each coordinate: "vertex", "element", "corner" (element by element), or "normal"
  /// (Element::normals).
  std::string one_a;
  std::size_t count;   ///< number of coordinates
  int rows, columns;   ///< shape of each coordinate; 1 and 1 for numbers
  std::size_t offset;  ///< position of the first number in a point's row of values
  /// The cage's data that the block multiplies to reproduce a linear map: "vertices", "turned vertices" (by a quarter
  /// counter-clockwise), "normals" times `normal_factor`, or "nothing". Normals are the elements' outward unit normals,
  /// or for blocks with one coordinate per "normal" all Element::normals, one after the other.
  std::string reproduces;
  double normal_factor;
};

/// An element that coordinates belong to: a triangle (also half of a quad), a quad that the kind keeps, or a segment.
struct Element {
  std::vector<int> vertices;   ///< indices of the cage's vertices, in its orientation
  int face;                    ///< index of the cage's face that it is, or is a part of
  std::vector<double> normal;  ///< unit, outward; for a quad along its area vector
  /// Normals for blocks with one coordinate per "normal": the element's own, or for a quad those of the bilinear
  /// surface at each corner, in the order of `vertices`.
  std::vector<std::vector<double>> normals;
};

/// Coordinates of one kind in one cage. Thread-safe; copies share prepared data.
class Coordinates {
 public:
  /// \param kind "mean_value", "green", "biharmonic", "somigliana", "quad_mean_value" ...
  /// \throws InputError for a cage that is not closed, not oriented or otherwise broken, naming the face or vertex; for
  /// an unknown kind, evaluation or parameter, naming all known ones; for a parameter that is out of range, or given
  /// twice; if the kind has no coordinates in the cage
  Coordinates(const Cage& cage, const std::string& kind, const Options& options = {});

  int dimension() const;
  /// The highest order of derivatives that exists: 2 for most kinds.
  int max_order() const;
  std::string evaluation() const;
  const std::vector<Block>& blocks() const;
  const std::vector<Element>& elements() const;
  /// Number of numbers per point: those of all blocks, times dimension^order.
  std::size_t row(int order = 0) const;

  /// Computes values at points, and the derivatives by the point for which spans are given.
  /// \param points `dimension` numbers per point
  /// \param values row(0) numbers per point: [block][coordinate][row][column]
  /// \param gradients empty, or row(1) numbers per point: the same with [axis] behind
  /// \param hessians empty, or row(2) per point: the same with [axis][axis] behind; needs gradients
  /// On the cage, values are limits from inside. Derivatives that do not exist, and values at points without
  /// coordinates, are NaN.
  /// \throws InputError for spans of other sizes, or derivatives above max_order()
  void evaluate(std::span<const double> points, std::span<double> values, std::span<double> gradients = {},
                std::span<double> hessians = {}) const;

  /// Computes sums of coordinates times data, without keeping coordinates; only for kinds whose coordinates are
  /// numbers. \param data [coordinate][function], the coordinates of all blocks one after another \param functions
  /// their number \param sums [point][function] \throws InputError as evaluate, and for matrices
  void apply(std::span<const double> points, std::span<const double> data, int functions, std::span<double> sums) const;

  /// Computes the change of values under a change of the cage's vertices, to first order, for points that stay where
  /// they are: the derivative by the vertices times the change. Only for the kind "green". NaN on edges and vertices.
  /// \param change as many numbers as the cage's vertices \param values as of `evaluate`
  /// \throws InputError for other kinds, and spans of other sizes
  void jvp(std::span<const double> points, std::span<const double> change, std::span<double> values) const;

  /// Computes a function's derivatives by the vertices from those by the values (`weights`): the transposed derivative
  /// times the weights. Threads do not change the result. \param weights as values of `evaluate`
  /// \throws InputError as `jvp`
  void vjp(std::span<const double> points, std::span<const double> weights, std::span<double> vertices) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

/// Points whose coordinates a Deformer keeps, for many poses. Copies share the coordinates.
class BoundPoints {
 public:
  /// Number of points.
  std::size_t size() const;
  /// Whether `bind` also kept the data for Jacobians.
  bool has_jacobians() const;

 private:
  friend class Deformer;
  struct Kept;
  explicit BoundPoints(std::shared_ptr<const Kept> kept);
  std::shared_ptr<const Kept> kept_;
};

/// The map of points by a posed cage, with one method. `images` is thread-safe, `pose` is not.
class Deformer {
 public:
  /// \param method "mean_value", "green", "biharmonic_1_3", "somigliana" ... of `cageproof list`
  /// \throws InputError as Coordinates does, and for digits that are out of range, or with another method than "green"
  Deformer(const Cage& rest, const std::string& method, const Options& options = {});
  ~Deformer();
  Deformer(Deformer&&) noexcept;
  Deformer& operator=(Deformer&&) noexcept;

  /// Sets the pose.
  /// \param vertices the posed cage's vertices, in the rest cage's order
  /// \throws InputError for another size, and for a pose that the method cannot take, naming the vertex or element
  void pose(std::span<const double> vertices);

  /// Computes images of points, and the Jacobians there. Images of points outside the cage are NaN if the method's
  /// coordinates sum to zero there, as those of "green" do.
  /// \param points `dimension` numbers per point \param images as many numbers
  /// \param jacobians empty, or [point][component][axis]; must be empty with Options::digits
  /// \throws InputError for spans of other sizes, or before `pose`
  void images(std::span<const double> points, std::span<double> images, std::span<double> jacobians = {}) const;

  /// Computes the coordinates of points once, for any number of poses. `images` of bound points then costs only the
  /// product of these coordinates and the pose. It may be called before `pose`.
  /// \param jacobians whether images may have Jacobians: four times the memory in space, three times in the plane
  /// \throws InputError for a size that `dimension` does not divide, and if the coordinates take more than half of the
  /// memory, with their size
  BoundPoints bind(std::span<const double> points, bool jacobians = false) const;

  /// Computes images of bound points: the same numbers as for the points themselves, or to rounding if Jacobians are
  /// bound and not asked for.
  /// \param points result of this Deformer's `bind`
  /// \throws InputError as above, for Jacobians that were not bound, and for points of another Deformer
  void images(const BoundPoints& points, std::span<double> images, std::span<double> jacobians = {}) const;

  /// Computes the change of images under a change of the posed vertices, to first order: the derivative J at this pose
  /// times the change. J takes no differences, and accounts for posed normals, their stretches and all else that the
  /// method makes of the pose. NaN for points without image. Options::digits has no effect.
  /// \param change as many numbers as the pose has \param images as many as the points have
  /// \throws InputError as `images`; if the method has no derivative with its parameters, naming methods that have one;
  /// for a posed element without area or length, whose normal has no derivative, naming the element
  void jvp(std::span<const double> points, std::span<const double> change, std::span<double> images) const;
  void jvp(const BoundPoints& points, std::span<const double> change, std::span<double> images) const;

  /// Computes a function's derivatives by the posed vertices from those by the images (`weights`): the transposed J
  /// times the weights. Threads do not change the result.
  /// \param weights as many numbers as the points have \param vertices as many as the pose has
  /// \throws InputError as `jvp`, and for a point without image whose weights are not zero
  void vjp(std::span<const double> points, std::span<const double> weights, std::span<double> vertices) const;
  void vjp(const BoundPoints& points, std::span<const double> weights, std::span<double> vertices) const;

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

/// Returns the version of the library, such as "0.1.0".
std::string version();

}  // namespace cageproof::library
