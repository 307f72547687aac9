// SPDX-License-Identifier: MIT
// Dirichlet problems of the Laplace and the biharmonic equation in a polygon, solved by least squares on its boundary
// in functions that fulfil the equation exactly.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/numbers/scalar.h"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace cageproof::solved::goursat {

/// Harmonic functions from their boundary values; biharmonic functions from boundary values and normal derivatives.
enum class Equation { Harmonic, Biharmonic };

/// A point of a polygon's boundary, off its corners.
struct EdgePoint {
  int face;                     ///< of the cage, counted from 0
  double from_start, from_end;  ///< fractions of the edge, whose sum is one
  Vec3<double> point;           ///< rounded
  Vec3<double> along, normal;   ///< unit vectors; the normal points outward
};

/// Data of solutions at a point of the boundary, one number per problem. Derivatives are per length of the cage's unit,
/// and only the biharmonic equation uses them. Derivatives along the edge are those of the values.
struct BoundaryData {
  std::span<double> values, normal_derivatives, derivatives_along;
};
/// Fills the data at one point; all are zero before. Values must be continuous along the polygon.
using BoundaryFunction = std::function<void(const EdgePoint&, const BoundaryData&)>;

/// A description of the solution, and how far it is from its data at points between those solved for.
struct DirichletReport {
  int degree = 0;  ///< of the polynomials
  int terms = 0;   ///< exponents of corners are taken up to terms pi/angle
  int equations = 0, unknowns = 0;
  int rank = 0;          ///< of the equations with columns of unit length, pivots below 1e-13 of the largest left out
  double condition = 0;  ///< largest over smallest singular value of what is kept
  double residual =
      0;  ///< Euclidean norm of what least squares leave, over that of the right side: the worst problem's
  /// Largest differences next to the boundary, a few roundings of a point inside, and so with the rounding of
  /// evaluations, over the largest number of a problem's data. By the maximum principle a
  /// harmonic solution is off by at most the first anywhere in the polygon. For biharmonic solutions there is no such
  /// bound for all polygons; differences found were below the sum of both.
  double value_residual = 0;
  double gradient_residual = 0;  ///< the polygon's bounding box measured in a unit that makes its diagonal 1 ... 2
};

struct DirichletOptions {
  /// More functions are taken until the residuals of values and gradients are below these, or the least squares take no
  /// more unknowns, or more do not help.
  double value_tolerance = 1e-10, gradient_tolerance = 1e-9;
  int most_unknowns = 1000;
  /// Alone these, when not zero.
  int degree = 0, terms = 0;
};

/// Where a point lies, exactly. Corners belong to no edge.
enum class PointPlace { Inside, OnEdge, OnCorner, Outside };

/// Solutions of several problems in one polygon. Safe from any thread. Scaling the cage by a power of two multiplies
/// solutions by that power, and changes no bit otherwise.
class DirichletSolution {
 public:
  /// \param problems the number of solutions
  /// \throws InputError for a cage that is no single polygon without holes, or has more than most_edges edges
  DirichletSolution(const Cage& cage, Equation equation, int problems, const BoundaryFunction& data,
                    const DirichletOptions& options = {});
  ~DirichletSolution();
  DirichletSolution(DirichletSolution&&) noexcept;

  int problems() const;
  const DirichletReport& report() const;
  PointPlace place(const Vec3<double>& point) const;
  /// All solutions at a point: values, gradients, Hessians up to `order`, as [problem], [problem][i], [problem][i][j].
  /// On edges they are limits from inside; at corners and outside NaN. In multiprecision the functions are evaluated to
  /// that precision, the coefficients are those found in double.
  template <Scalar R>
  std::array<std::vector<R>, 3> at(const Vec3<R>& point, int order) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

/// Each corner takes functions of its own, and least squares the cube of their number in time: with more edges the
/// functions that a second of solving allows no longer meet the data.
inline constexpr int most_edges = 48;

/// Why there are no solutions in such a cage; empty where there are.
std::string why_no_dirichlet_solution(const Cage& cage);

}  // namespace cageproof::solved::goursat
