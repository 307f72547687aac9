// SPDX-License-Identifier: MIT
// The cost of the roundings of a pose's vertices.
#pragma once

#include "cageproof/deformation/deformer.h"

#include <memory>
#include <string>

namespace cageproof::deformation {

/// Where images are looked at, and what is said when roundings move them.
class PoseRoundings {
 public:
  /// \param where the cage has elements that roundings turn, and how: begins a sentence's second half
  PoseRoundings(const CageCoordinates& coordinates, std::string where);

  /// Whether a pose is the cage itself, or shifted without a rounding.
  bool is_rest(const std::vector<Vec3<double>>& posed) const;
  /// The images of a point before each element.
  std::vector<double> images(const Posed<double>& posed) const;
  /// States that roundings moved those images by so much, and warns above 1e-12 of the posed cage's size.
  void state(const std::vector<double>& moved, const std::vector<Vec3<double>>& posed, DeformationReport& report) const;

 private:
  std::vector<Vec3<double>> rest_, within_;
  std::vector<CoordinateTable<double>> tables_;  // within
  std::string where_;
};

/// Vertices up to half a unit of their last digits off, each another way.
std::vector<Vec3<Mp50>> nudged(std::vector<Vec3<Mp50>> vertices);

/// A pose without what stating_pose_roundings has put around it.
const Posed<double>& without_report(const Posed<double>& posed);

/// A deformer in double that states what roundings of posed vertices, and its own, cost: each pose is solved twice.
std::shared_ptr<const Deformer<double>> stating_pose_roundings(std::shared_ptr<const Deformer<double>> deformer,
                                                               std::string where);

}  // namespace cageproof::deformation
