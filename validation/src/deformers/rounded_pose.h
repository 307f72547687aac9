// SPDX-License-Identifier: MIT
// How far the rounding of a pose's vertices moves images, and how large images are.
#pragma once

#include "bent_images.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

namespace cageproof::validation {

/// The images of a pose as it is rounded to double, less those of the exact pose, both in 50 digits: no error of
/// whoever computes in double, and none of a map that is not kept. An edge that is a millionth of the others is turned
/// by 1e-10 where its ends are rounded. Safe from any thread.
class RoundedPose {
 public:
  using Prepare = std::function<std::shared_ptr<const deformation::Deformer<Mp50>>()>;

  /// \param deformer called at the first question
  RoundedPose(Prepare deformer, deformation::Pose<Mp50> rounded, deformation::Pose<Mp50> exact);

  /// How far rounding moves the image of a point, component by component.
  Vec3<double> moves(const Vec3<double>& point) const;

 private:
  struct Both {
    std::shared_ptr<const deformation::Deformer<Mp50>> deformer;
    std::unique_ptr<const deformation::Posed<Mp50>> rounded, exact;
  };
  Lazy<Both> both_;
};

/// The norm of a tensor of derivatives of an image in cage sizes, at least one. Numbers that are larger are rounded in
/// proportion. \param from what images themselves, of order 0, are seen from
template <class R>
double own_size(const std::vector<R>& tensor, int order, double size, const Vec3<double>& from) {
  double norm = 0;
  const std::size_t d = order == 0 ? tensor.size() : 0;
  for (std::size_t i = 0; i < tensor.size(); ++i)
    norm = std::hypot(norm, static_cast<double>(i < d ? R(tensor[i] - from[static_cast<int>(i)]) : tensor[i]));
  return std::max(1., norm * std::pow(size, order - 1));
}

}  // namespace cageproof::validation
