// SPDX-License-Identifier: MIT
// A kind of coordinates prepared for one cage: its blocks, their tables, and what a kind can do beside filling them.
#pragma once

#include "cageproof/core/cage/cage_elements.h"
#include "cageproof/core/catalogue/evaluation.h"

#include <limits>
#include <memory>

namespace cageproof {

/// The cage data that a block of coordinates multiplies when a linear map is reproduced. TurnedVertices, in the plane,
/// are vertices turned by a quarter counter-clockwise, which imaginary parts of complex coordinates multiply.
enum class Reproduces { Vertices, TurnedVertices, Normals, Nothing };

/// One block of prepared coordinates: a coordinate (a number, or a matrix) a vertex, an element, or a corner of one.
struct CoordinateBlock {
  std::string label;
  Owner owner;
  int size;     ///< coordinates: the number of owners
  Shape shape;  ///< of one coordinate
  Reproduces reproduces = Reproduces::Nothing;
  double normal_factor = 1;  ///< of blocks that reproduce normals
  /// The power of the unit of length that coordinates grow with, and what stands before the logarithm:
  /// Formula::behaviour.
  int degree = 0;
  Logarithm logarithmic = {};
  /// The trace of the Hessian: nothing known, zero, or another block.
  struct Trace {
    enum class Kind { Unknown, Zero, Block } kind = Kind::Unknown;
    std::size_t block = 0;
  } trace = {};

  /// Numbers of a coordinate.
  int entries() const { return shape.entries(); }
};

/// All coordinates of one block at a block of points: tensors[o] is [point][coordinate][entry][derivatives].
template <Scalar R>
struct CoordinateTable {
  std::array<std::vector<R>, 3> tensors;
  std::array<std::size_t, 3> stride{};  ///< numbers per point
};

/// The data that coordinates are multiplied with, such as deformed vertices and normals. Block b's numbers lie as
/// [coordinate][column][set], where a coordinate that is a number counts as one column.
struct CageData {
  int sets = 3;
  std::vector<std::vector<double>> blocks;
};

/// The functions that coordinates make of cage data at a block of points: tensors[o] is [point][row][set][derivatives],
/// where coordinates that are numbers have one row.
struct AppliedTable {
  std::array<std::vector<double>, 3> tensors;
  std::array<std::size_t, 3> stride{};  ///< numbers per point
};

/// A linear system that was solved to prepare a kind for its cage.
struct SolvedSystem {
  std::string name;   ///< "Psi^H k = (H - Phi^H) l"
  int rows, columns;  ///< equations and unknowns
  int rank;           ///< as found; columns where the solution is unique
  double condition;   ///< largest over smallest singular value; infinite where the smallest is zero
  /// The relative residual: the largest over all right sides of |right - matrix x| / |right|, in Euclidean norms.
  double residual;
  /// Boundary errors of a least-squares solution: the largest differences of values and of gradients on the boundary,
  /// between the points solved for, divided by the largest number of each right side. NaN where not measured.
  double boundary_values = std::numeric_limits<double>::quiet_NaN();
  double boundary_gradients = std::numeric_limits<double>::quiet_NaN();

  bool is_singular() const { return rank < columns; }
};

/// The systems that were solved to prepare a kind for its cage, in double.
class SolvesSystems {
 public:
  virtual std::vector<SolvedSystem> solved() const = 0;
  /// Whether `solved` states how well the data on the boundary are met.
  virtual bool measures_boundary() const { return false; }

 protected:
  ~SolvesSystems() = default;
};

/// Limits from inside at points within elements. Points are given by the basis functions there, because points on an
/// element are seldom exact in double.
class HasLimits {
 public:
  virtual void fill_limits(std::span<const Touching> places, int order,
                           std::span<CoordinateTable<double>> tables) const = 0;
  virtual void fill_limits(std::span<const Touching> places, int order,
                           std::span<CoordinateTable<Mp50>> tables) const = 0;

 protected:
  ~HasLimits() = default;
};

/// The terms that coordinates are summed from.
class HasTerms {
 public:
  /// The tables of PreparedCoordinates::fill with the sums of the terms' absolute values, or about that: the cost of a
  /// rounding of each term.
  virtual void fill_terms(std::span<const Vec3<double>> points, int order,
                          std::span<CoordinateTable<double>> tables) const = 0;

 protected:
  ~HasTerms() = default;
};

/// The functions that coordinates make of one set of cage data, to a stated error. Safe from any thread. The
/// coordinates must outlive it.
class StatedSum {
 public:
  virtual ~StatedSum() = default;
  /// \param jobs threads; 0: all cores \param values [point][set], stored \param errors stored: a bound of each point's
  /// error except roundings, in the Euclidean norm over the sets; zero where summed element by element
  virtual void fill(std::span<const Vec3<double>> points, int jobs, std::span<double> values,
                    std::span<double> errors) const = 0;
  /// The highest degree of the expansions that elements are summed together by; zero where none are.
  virtual int degree() const = 0;
};

/// Sums of coordinates times data, without keeping coordinates.
class AppliesData {
 public:
  /// Adds the functions of CageCoordinates::apply to a table that the caller sized and set to zero.
  virtual void apply(std::span<const Vec3<double>> points, int order, const CageData& data,
                     AppliedTable& table) const = 0;
  /// The values of these functions, with far elements summed together. Null where the kind cannot do so, and unless the
  /// data have three sets. \param error in the data's unit of length, which no point's exceeds \param points how many
  /// will be asked: where they or the elements are few, element by element is quicker, and done
  virtual std::unique_ptr<const StatedSum> sum_to(double /*error*/, const CageData& /*data*/,
                                                  std::size_t /*points*/) const {
    return nullptr;
  }

 protected:
  ~AppliesData() = default;
};

/// Laplacians on the boundary, which were solved for, as linear maps from the data that blocks multiply there.
class SolvesLaplacians {
 public:
  /// At the nodes that it is solved at, in the user's unit of length. One table per block, of values only,
  /// [node][coordinate]: l = sum over blocks of table times data ([W12] Eq 17-19: B U_f and C U_d). Nodes are the
  /// cage's vertices, then what divides its edges.
  virtual void fill_boundary_laplacians(std::vector<CoordinateTable<double>>& tables) const = 0;
  virtual void fill_boundary_laplacians(std::vector<CoordinateTable<Mp50>>& tables) const = 0;

 protected:
  ~SolvesLaplacians() = default;
};

/// A kind prepared for one cage. Safe from any thread. Functions such as systems() return a pointer to itself where the
/// kind has more than coordinates.
class PreparedCoordinates {
 public:
  virtual ~PreparedCoordinates() = default;
  virtual const std::vector<CoordinateBlock>& blocks() const = 0;
  virtual int max_order() const = 0;
  /// The evaluation's name in results: that of the formulas' evaluation.
  virtual std::string evaluation() const { return std::string(name_of(Role::Recommended)); }
  /// Whether values in multiprecision have that precision's digits.
  virtual bool is_exact_in(ScalarKind scalar) const = 0;
  /// Whether preparing a cage in that scalar takes only about a second: not where large systems are solved in
  /// multiprecision.
  virtual bool is_prompt_in(ScalarKind /*scalar*/) const { return true; }
  /// One table per block, sized and set to zero by the caller. Where a point is exactly a double and lies on the cage,
  /// values are the limits from inside: interpolating kinds give the basis functions; derivatives that do not exist are
  /// NaN. Points without coordinates are NaN. \pre order <= max_order()
  virtual void fill(std::span<const Vec3<float>> points, int order, std::span<CoordinateTable<float>> tables) const = 0;
  virtual void fill(std::span<const Vec3<double>> points, int order,
                    std::span<CoordinateTable<double>> tables) const = 0;
  virtual void fill(std::span<const Vec3<Mp50>> points, int order, std::span<CoordinateTable<Mp50>> tables) const = 0;
  virtual void fill(std::span<const Vec3<Mp100>> points, int order, std::span<CoordinateTable<Mp100>> tables) const = 0;
  /// Whether `fill` in double stores what it computes, and takes tables that are not zero.
  virtual bool overwrites() const { return false; }

  virtual const SolvesSystems* systems() const { return nullptr; }
  /// Null where coordinates are no numbers, or are normalised.
  virtual const HasLimits* limits() const { return nullptr; }
  /// Null where no terms are known but the coordinates.
  virtual const HasTerms* terms() const { return nullptr; }
  /// Null where coordinates come first, up to that order.
  virtual const AppliesData* products(int /*order*/) const { return nullptr; }
  virtual const SolvesLaplacians* boundary_laplacians() const { return nullptr; }
};

/// Implements PreparedCoordinates::fill, except in float, by `template <Scalar R> void compute(points, order, tables)
/// const` of the derived class. CoordinatesIn and CoordinatesInDouble add float.
template <class Derived>
class CoordinatesFromDouble : public PreparedCoordinates {
 public:
  using PreparedCoordinates::fill;
  void fill(std::span<const Vec3<double>> points, int order, std::span<CoordinateTable<double>> tables) const override {
    own().compute(points, order, tables);
  }
  void fill(std::span<const Vec3<Mp50>> points, int order, std::span<CoordinateTable<Mp50>> tables) const override {
    own().compute(points, order, tables);
  }
  void fill(std::span<const Vec3<Mp100>> points, int order, std::span<CoordinateTable<Mp100>> tables) const override {
    own().compute(points, order, tables);
  }

 protected:
  const Derived& own() const { return static_cast<const Derived&>(*this); }
};

/// CoordinatesFromDouble whose derived class computes float in float.
template <class Derived>
class CoordinatesIn : public CoordinatesFromDouble<Derived> {
 public:
  using CoordinatesFromDouble<Derived>::fill;
  void fill(std::span<const Vec3<float>> points, int order, std::span<CoordinateTable<float>> tables) const override {
    this->own().compute(points, order, tables);
  }
};

/// Coordinates in double that are computed all at once. Other scalars, limits and terms come from sums over elements.
class BesideSums : public PreparedCoordinates {
 public:
  /// \param dimension of the cage
  BesideSums(std::shared_ptr<const PreparedCoordinates> summed, int dimension)
      : summed_(std::move(summed)), dimension_(dimension) {}

  const std::vector<CoordinateBlock>& blocks() const override { return summed_->blocks(); }
  int max_order() const override { return summed_->max_order(); }
  bool is_exact_in(ScalarKind scalar) const override { return summed_->is_exact_in(scalar); }
  bool overwrites() const override { return true; }
  using PreparedCoordinates::fill;
  /// Fills tables in float with the results in double, rounded.
  void fill(std::span<const Vec3<float>> points, int order, std::span<CoordinateTable<float>> tables) const override;
  void fill(std::span<const Vec3<Mp50>> points, int order, std::span<CoordinateTable<Mp50>> tables) const override {
    summed_->fill(points, order, tables);
  }
  void fill(std::span<const Vec3<Mp100>> points, int order, std::span<CoordinateTable<Mp100>> tables) const override {
    summed_->fill(points, order, tables);
  }
  const HasLimits* limits() const override { return summed_->limits(); }
  const HasTerms* terms() const override { return summed_->terms(); }

 protected:
  /// In double, into tables that may hold anything.
  void fill_with_sums(std::span<const Vec3<double>> points, int order, std::span<CoordinateTable<double>> tables) const;
  /// The sums at one point: one table per block.
  std::vector<CoordinateTable<double>> sums_at(const Vec3<double>& point, int order) const;

 private:
  std::shared_ptr<const PreparedCoordinates> summed_;
  int dimension_;
};

}  // namespace cageproof
