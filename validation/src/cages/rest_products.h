// SPDX-License-Identifier: MIT
// Products with the derivative of coordinates by the vertices of their own cage, in both directions: against
// differences of the closed forms, and against each other.
#pragma once

#include "cageproof/core/coordinates/rest_derivative.h"
#include "cageproof/validation/cage_terms.h"

#include <map>
#include <mutex>
#include <tuple>
#include <vector>

namespace cageproof::validation {

/// The derivative J of a kind's values by the cage's vertices. Refers to the coordinates; safe from any thread.
class RestProducts {
 public:
  /// Whether it is asked about: the kind is a sum over elements and has J, and the cage has few elements, as a point
  /// takes a millisecond per element.
  static bool exist(const CageCoordinates& coordinates);

  /// \param derivative J, which outlives this; rest_derivative_of() the kind, except in tests
  RestProducts(const CageCoordinates& coordinates, const Cage& cage, const RestDerivative& derivative);

  /// |J c - central difference| of the worst block, norm-wise; c is generic_change(). In roundings of the elements'
  /// terms, each times what rounding the input costs: the element's size over the point's distance from its border, or
  /// its aspect (longest side over height), whichever is more. NaN where there is no J.
  CageError error_of_jvp(const Vec3<double>& point) const;

  /// |w . (J c) - (J' w) . c| in roundings of the terms of the sum over coordinates and elements; all w are one or -1.
  CageError error_of_transposed(const Vec3<double>& point) const;

 private:
  /// By block and coordinate: the difference in 50 digits, and its terms' sizes, without and with their conditions.
  struct Difference {
    std::vector<std::vector<double>> along, terms, conditioned;
  };
  /// Kept for the other question at the same point.
  Difference difference_at(const Vec3<double>& point) const;
  Difference made_difference(const Vec3<double>& point) const;
  std::vector<double> jvp(const Vec3<double>& point) const;
  double condition(std::size_t element, const Vec3<double>& point) const;

  const CageCoordinates& coordinates_;
  const RestDerivative& derivative_;
  std::vector<Vec3<double>> change_;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<double, double, double>, Difference> known_;
};

}  // namespace cageproof::validation
