// SPDX-License-Identifier: MIT
#include "rounded_pose.h"

namespace cageproof::validation {

RoundedPose::RoundedPose(Prepare deformer, deformation::Pose<Mp50> rounded, deformation::Pose<Mp50> exact)
    : both_([deformer = std::move(deformer), rounded = std::move(rounded), exact = std::move(exact)] {
        Both both{deformer(), nullptr, nullptr};
        both.rounded = both.deformer->pose(rounded);
        both.exact = both.deformer->pose(exact);
        return both;
      }) {}

Vec3<double> RoundedPose::moves(const Vec3<double>& point) const {
  const Both& both = both_.get();
  const Vec3<Mp50> at = convert<Mp50>(point);
  const auto there = images_at(*both.deformer, *both.rounded, at, 0).tensors[0],
             here = images_at(*both.deformer, *both.exact, at, 0).tensors[0];
  Vec3<double> found = Vec3<double>::Zero();
  for (std::size_t c = 0; c < there.size(); ++c)
    found[static_cast<int>(c)] = static_cast<double>(Mp50(there[c] - here[c]));
  return found;
}

}  // namespace cageproof::validation
