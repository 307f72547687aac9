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

/// A closed surface of triangles and quads, in the plane a closed polygon, or several.
struct Cage {
  std::vector<double> vertices;         ///< three numbers per vertex, in the plane two
  std::vector<std::vector<int>> faces;  ///< vertices from 0: 3 or 4, counter-clockwise seen from outside; in the plane
                                        ///< 2, with the inside on the left
  int dimension = 3;                    ///< of space: 3, or 2 for the plane
  std::string name = "cage";            ///< its name in messages
  std::vector<std::string> warnings = {};  ///< of a file: parts left out, or faces cut in triangles
};

/// A cage from an OBJ file; polylines (`l`), and faces whose vertices all have z = 0, make one in the plane. Faces of
/// more than four corners are cut in triangles. \throws InputError naming file, line and reason
Cage read_obj(const std::string& file);

/// One of the cages that come with the library: "cube", "twisted-bar" ... \throws InputError naming all of them
Cage embedded_cage(const std::string& name);

/// How coordinates are computed. Names are those of `cageproof list`.
struct Options {
  /// Empty: all elements at once on vectors of points where the kind can ("batched"), else as recommended.
  std::string evaluation = {};
  /// How quads become triangles, of kinds that do not keep them: "shortest" diagonal, or "fan" from the first corner.
  std::string triangulation = "shortest";
  /// Name and value: {"nu", "0.3"}, {"collocation", "vertices"}; each name once.
  std::vector<std::pair<std::string, std::string>> parameters = {};
  bool flip_inward = false;          ///< turn parts whose normals point inward, instead of refusing them
  bool allow_invalid_quads = false;  ///< of kinds that keep quads: compute with those that cross themselves or fold
  int threads = 0;                   ///< at most so many; 0: all cores
  /// For images by the Deformer "green" in space: 3 to 12 digits of the posed cage's size, sooner where faces and
  /// points are many; 0 for all. The error is bounded, and roundings come on top. Each call of `images` prepares for
  /// its points, so that many should come at once; bound points have all digits.
  int digits = 0;
};

/// Coordinates that belong together: one for each vertex, element, or corner of an element.
struct Block {
  std::string label;  ///< "phi", "psi", "lambda" ...
  std::string
      one_a;  ///< "vertex", "element", "corner" (of elements, element by element), or "normal" (Element::normals)
  std::size_t count;   ///< coordinates
  int rows, columns;   ///< of each; 1 and 1 for numbers
  std::size_t offset;  ///< where its first number stands in a point's row of values
  /// The cage's data that the block multiplies where a linear map is reproduced: "vertices", "turned vertices" (by a
  /// quarter counter-clockwise), "normals" (unit and outward, of elements, or Element::normals one after the other for
  /// blocks with one coordinate per normal; times `normal_factor`), or "nothing".
  std::string reproduces;
  double normal_factor;
};

/// An element that coordinates belong to: a triangle, also half of a quad; a quad of kinds that keep them; a segment.
struct Element {
  std::vector<int> vertices;   ///< of the cage, in its orientation
  int face;                    ///< of the cage, that it is or is part of
  std::vector<double> normal;  ///< unit, outward; of a quad along its area vector
  /// Normals that multiply the coordinates of blocks with one per "normal", element by element: the element's own, or,
  /// of a quad, those of the bilinear surface at each corner, in the order of `vertices`.
  std::vector<std::vector<double>> normals;
};

/// Coordinates of one kind in one cage. Safe from any thread; copies share what was prepared.
class Coordinates {
 public:
  /// \param kind "mean_value", "green", "biharmonic", "somigliana", "quad_mean_value" ...
  /// \throws InputError for a cage that is not closed, not oriented or otherwise broken, naming the face or vertex; for
  /// an unknown kind, evaluation or parameter, naming all known ones; for a parameter that is out of range, or given
  /// twice; where the kind has no coordinates in the cage
  Coordinates(const Cage& cage, const std::string& kind, const Options& options = {});

  int dimension() const;
  /// The highest derivative that exists: 2 for most.
  int max_order() const;
  std::string evaluation() const;
  const std::vector<Block>& blocks() const;
  const std::vector<Element>& elements() const;
  /// Numbers per point: those of all blocks, times dimension^order.
  std::size_t row(int order = 0) const;

  /// Values of a block of points, and as many derivatives by the point's coordinates as there is room for.
  /// \param points `dimension` numbers per point
  /// \param values row(0) numbers per point: [block][coordinate][row][column]
  /// \param gradients empty, or row(1) numbers per point: the same with [axis] behind
  /// \param hessians empty, or row(2) per point: the same with [axis][axis] behind; needs gradients
  /// On the cage values are limits from inside, derivatives that do not exist NaN, as are points without coordinates.
  /// \throws InputError for spans of other sizes, or derivatives above max_order()
  void evaluate(std::span<const double> points, std::span<double> values, std::span<double> gradients = {},
                std::span<double> hessians = {}) const;

  /// Sums of coordinates times data, without keeping coordinates; only for kinds whose coordinates are numbers.
  /// \param data [coordinate][function], the coordinates of all blocks one after another
  /// \param functions how many \param sums [point][function] \throws InputError as evaluate, and for matrices
  void apply(std::span<const double> points, std::span<const double> data, int functions, std::span<double> sums) const;

  /// The derivative of values by the vertices of the cage, for points that stay where they are, times a change of the
  /// vertices: the change of the values. Only for kind green, in space and in the plane. NaN on edges and vertices.
  /// \param change as many numbers as the cage's vertices \param values as of `evaluate`
  /// \throws InputError for other kinds, and spans of other sizes
  void jvp(std::span<const double> points, std::span<const double> change, std::span<double> values) const;

  /// The transposed derivative times weights of values: a function's derivatives by the vertices, from those by the
  /// values. The same bits with any number of threads. \param weights as values of `evaluate` \throws InputError as
  /// `jvp`
  void vjp(std::span<const double> points, std::span<const double> weights, std::span<double> vertices) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

/// Points whose coordinates a Deformer keeps, for many poses. Copies share them.
class BoundPoints {
 public:
  /// How many points.
  std::size_t size() const;
  /// Whether Jacobians were asked for.
  bool has_jacobians() const;

 private:
  friend class Deformer;
  struct Kept;
  explicit BoundPoints(std::shared_ptr<const Kept> kept);
  std::shared_ptr<const Kept> kept_;
};

/// The map of space by a posed cage, with one method. `images` is safe from any thread, `pose` is not.
class Deformer {
 public:
  /// \param method "mean_value", "green", "biharmonic_1_3", "somigliana" ... of `cageproof list`
  /// \throws InputError as Coordinates does, and for digits out of range or of another method than "green"
  Deformer(const Cage& rest, const std::string& method, const Options& options = {});
  ~Deformer();
  Deformer(Deformer&&) noexcept;
  Deformer& operator=(Deformer&&) noexcept;

  /// \param vertices of the posed cage, in the rest cage's order: as many numbers \throws InputError for others, and
  /// for a pose that the method does not take, naming the vertex or element
  void pose(std::span<const double> vertices);

  /// Images of points, and the Jacobians there. Points outside the cage have no image, only NaN, where the method's
  /// coordinates sum to zero outside; those of interpolating methods do not.
  /// \param points `dimension` numbers per point \param images as many numbers
  /// \param jacobians empty, or [point][component][axis]; must be empty with Options::digits
  /// \throws InputError for spans of other sizes, or before `pose`
  void images(std::span<const double> points, std::span<double> images, std::span<double> jacobians = {}) const;

  /// Computes the coordinates of points once, for any number of poses, before the first one or after it: `images` of
  /// bound points costs no more than their coordinates times the pose.
  /// \param jacobians whether images may have Jacobians: four times the memory in space, three times in the plane
  /// \throws InputError for a number of numbers that `dimension` does not divide, and where the coordinates take more
  /// than half of the memory, with their size
  BoundPoints bind(std::span<const double> points, bool jacobians = false) const;

  /// The same numbers as of the points themselves; to rounding where Jacobians are bound and not asked for.
  /// \param points of this Deformer's `bind`
  /// \throws InputError as above, for Jacobians that were not bound, and for points of another Deformer
  void images(const BoundPoints& points, std::span<double> images, std::span<double> jacobians = {}) const;

  /// The derivative J of images by the posed vertices, at this pose, times a change of them: the change of the images.
  /// It is a derivative, with no differences taken; posed normals, their stretches and all that the method makes of the
  /// pose change with the vertices. NaN for points without image. Options::digits has no effect on it.
  /// \param change as many numbers as the pose has \param images as many as the points have
  /// \throws InputError as `images`; where the method has no derivative with its parameters, naming those that have;
  /// where there is none at the pose: a posed element without area or length, whose normal has none, by its name
  void jvp(std::span<const double> points, std::span<const double> change, std::span<double> images) const;
  void jvp(const BoundPoints& points, std::span<const double> change, std::span<double> images) const;

  /// The transposed J times weights of images: if these are the derivatives of a function by the images, those by the
  /// posed vertices. The same bits with any number of threads.
  /// \param weights as many numbers as the points have \param vertices as many as the pose has
  /// \throws InputError as `jvp`, and for weights other than zero of a point that has no image
  void vjp(std::span<const double> points, std::span<const double> weights, std::span<double> vertices) const;
  void vjp(const BoundPoints& points, std::span<const double> weights, std::span<double> vertices) const;

 private:
  struct Prepared;
  std::unique_ptr<Prepared> prepared_;
};

/// The version of the library, "0.1.0".
std::string version();

}  // namespace cageproof::library
