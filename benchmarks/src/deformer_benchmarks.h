// SPDX-License-Identifier: MIT
// Benchmarks of deformers measure the preparation for a cage, coordinates of points, poses, and images of points.
#pragma once

#include "cageproof/core/cage/cage.h"

#include <memory>
#include <string>
#include <vector>

namespace cageproof::benchmarks {

/// A cage, a pose of it and points in it.
struct DeformedCage {
  std::string name;
  Cage cage;
  std::vector<Vec3<double>> posed;
  std::vector<Vec3<double>> points;
};

/// An embedded cage, sheared, and so many points in its box.
DeformedCage embedded_deformed_cage(std::string_view name, int points);

/// Registers, for every method that takes the cage,
///   `deform/<cage>/<method>/prepare`      the method for the rest cage: sampling, systems and their factors
///   `deform/<cage>/<method>/coordinates`  those of all points, by the recommended evaluations
///   `deform/<cage>/<method>/pose`         what is solved for one pose
///   `deform/<cage>/<method>/images`       all points under it, from their coordinates
/// and the same for every method that takes constraints, and its other subspaces (`variational-elastic`): a few of the
/// points, those inside, are drawn to where the shear takes them; `pose` takes all its steps. What they start from is
/// made once, when the first benchmark of a method that needs it runs. A second pose costs the last two. Counter
/// `ns_per_point` of `coordinates` and `images`: processor time. \returns the names, in order of registration
std::vector<std::string> register_deformer_benchmarks(const std::shared_ptr<const DeformedCage>& what);

}  // namespace cageproof::benchmarks
