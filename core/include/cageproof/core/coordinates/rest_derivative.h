// SPDX-License-Identifier: MIT
// Derivatives of a kind's coordinates by the vertices of its own cage, for points that stay where they are.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

namespace cageproof {

/// A kind's values at points as a function of its cage's vertices: its derivative J, applied in both directions. A row
/// of values is [block][coordinate], as CageCoordinates::blocks() has them. On edges and vertices there is none: NaN.
struct RestDerivative {
  std::string_view kind;
  /// J times a change. \param change one row per vertex \param values [point][coordinate], which are overwritten
  /// \param threads 0: all cores
  void (*jvp)(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
              std::span<const Vec3<double>> change, int threads, std::span<double> values);
  /// The transposed J times weights [point][coordinate], summed over points: one row per vertex, the same bits with any
  /// number of threads.
  std::vector<Vec3<double>> (*vjp)(const CageCoordinates& coordinates, std::span<const Vec3<double>> points,
                                   std::span<const double> weights, int threads);
};

/// Adds one at program start: `const RegisterRestDerivative r{...};` at namespace scope of a .cpp.
struct RegisterRestDerivative {
  explicit RegisterRestDerivative(RestDerivative derivative);
};

/// That of the kind, or null where it has none. It stays where it is.
const RestDerivative* find_rest_derivative(const CoordinateKind& kind);

/// That of the kind. \throws InputError where it has none, naming the kinds that have
const RestDerivative& rest_derivative_of(const CoordinateKind& kind);

}  // namespace cageproof
