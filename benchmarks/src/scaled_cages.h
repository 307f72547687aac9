// SPDX-License-Identifier: MIT
// Cages of any number of faces, to see how times grow with it.
#pragma once

#include "deformer_benchmarks.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cageproof::benchmarks {

/// A cage and what becomes of it when each of its faces is cut in four, again and again. Large cages take a while to
/// make, so they are made when they are first asked for. For one thread.
class ScaledCages {
 public:
  using Shape = std::function<Vec3<double>(const Vec3<double>&)>;

  /// \param label what names of benchmarks say before the number of faces, such as "long-"; may be empty
  /// \param coarsest its points are those of all cages
  /// \param shape where vertices, cut at midpoints, are moved to
  ScaledCages(
      std::string label, DeformedCage coarsest, Shape shape = [](const Vec3<double>& v) { return v; })
      : label_(std::move(label)), coarsest_(std::move(coarsest)), shape_(std::move(shape)) {}

  /// How many faces the cage has, of which a quad that is not kept is two.
  std::size_t faces(int times, bool keeps_quads) const;
  /// The label and the faces.
  std::string name(int times, bool keeps_quads) const;
  const DeformedCage& coarsest() const { return coarsest_; }
  std::shared_ptr<const DeformedCage> cut(int times) const;

 private:
  std::string label_;
  DeformedCage coarsest_;
  Shape shape_;
  mutable std::vector<Cage> cages_;  // before vertices are moved
};

/// Cubes of 6 quads and more.
ScaledCages cubes(int points);
/// Icospheres of 80 faces and more, and points within them.
ScaledCages spheres(int points);
/// The same 16 times as long.
ScaledCages long_spheres(int points);
/// Spheres whose faces are the smaller the nearer they are to one point: of 1,280 faces some are a thousand times as
/// long as others.
ScaledCages graded_spheres(int points);

}  // namespace cageproof::benchmarks
