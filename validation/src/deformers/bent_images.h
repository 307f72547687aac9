// SPDX-License-Identifier: MIT
// Images of a deformer under the bent pose, which several checks ask for at the same points.
#pragma once

#include "cageproof/core/lazy.h"
#include "cageproof/deformation/deformer.h"
#include "deformer_poses.h"

#include <map>
#include <mutex>
#include <tuple>

namespace cageproof::validation {

template <Scalar R>
std::vector<Vec3<R>> in(const std::vector<Vec3<double>>& points) {
  std::vector<Vec3<R>> found;
  found.reserve(points.size());
  for (const Vec3<double>& p : points) found.push_back(convert<R>(p));
  return found;
}

/// Each point by itself: products of larger matrices sum in another order.
template <Scalar R>
deformation::Images<R> images_at(const deformation::Deformer<R>& deformer, const deformation::Posed<R>& posed,
                                 const Vec3<R>& point, int order) {
  return deformer.images(posed, std::span(&point, 1), order);
}

/// Images under the pose that bent(cage) is. Safe from any thread.
template <Scalar R>
class BentImages {
 public:
  using Prepare = std::function<std::shared_ptr<const deformation::Deformer<R>>()>;

  /// \param deformer of the cage; called at the first question
  BentImages(std::shared_ptr<const Cage> cage, Prepare deformer)
      : deformer_(std::move(deformer)),
        posed_([this, cage = std::move(cage)] { return deformer_.get()->pose({in<R>(bent(*cage))}); }) {}

  const deformation::Posed<R>& posed() const { return *posed_.get(); }

  /// Image and derivatives up to that order, kept for whoever asks the same again: images that are computed together
  /// with more may have other last bits, and a question has the same answer whatever was asked before.
  /// \pre order <= Deformer::max_order()
  deformation::Images<R> at(const Vec3<double>& point, int order) const {
    const std::scoped_lock lock(mutex_);
    const auto [known, is_new] = known_.try_emplace({point[0], point[1], point[2], order});
    if (is_new) known->second = of(convert<R>(point), order);
    return known->second;
  }

  /// The same of a point in the scalar's own digits, not kept.
  deformation::Images<R> of(const Vec3<R>& point, int order) const {
    return images_at(*deformer_.get(), posed(), point, order);
  }

 private:
  Lazy<std::shared_ptr<const deformation::Deformer<R>>> deformer_;
  Lazy<std::unique_ptr<const deformation::Posed<R>>> posed_;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<double, double, double, int>, deformation::Images<R>> known_;
};

}  // namespace cageproof::validation
