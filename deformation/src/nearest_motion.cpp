// SPDX-License-Identifier: MIT
#include "nearest_motion.h"

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

Vec3<double> middle_of(const std::vector<Vec3<double>>& points) {
  Vec3<double> mean = Vec3<double>::Zero();
  // Each part by itself, because a sum of large numbers leaves the range.
  for (const Vec3<double>& p : points) mean += p / static_cast<double>(points.size());
  return mean;
}

// The least turn that takes one direction of space to another. \param normal at right angles to both, where they are
// opposite
template <Scalar R>
Mat3<R> least_turn(const Vec3<R>& one, const Vec3<R>& other, const Vec3<R>& normal) {
  const Vec3<R> across = one.cross(other);
  const R cosine = one.dot(other);
  if (cosine < R(-0.999999)) return R(2) * normal * normal.transpose() - Mat3<R>::Identity();
  Mat3<R> cross;
  cross << R(0), R(-across[2]), across[1], across[2], R(0), R(-across[0]), R(-across[1]), across[0], R(0);
  return Mat3<R>::Identity() + cross + cross * cross / R(1 + cosine);
}

}  // namespace

template <Scalar R>
Motion<R> nearest_motion(const Constraints& constraints, const std::vector<Vec3<double>>& targets,
                         const Vec3<double>& from, double size, int dimension) {
  Motion<R> motion{SpaceMatrix<R>::Identity(dimension, dimension), from, targets.empty() ? from : middle_of(targets)};
  std::vector<Vec3<double>> places;
  places.reserve(targets.size());
  for (const auto& position : constraints.positions) places.push_back(position.at);
  const Vec3<double> middle = places.empty() ? from : middle_of(places);
  // Both ends in units of their own: the turn is the same, and products stay in range.
  double at_unit = 0, to_unit = 0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    at_unit = std::max(at_unit, (places[p] - middle).head(dimension).cwiseAbs().maxCoeff());
    to_unit = std::max(to_unit, (targets[p] - motion.to).head(dimension).cwiseAbs().maxCoeff());
  }
  // In 50 digits, because points off a line by a hundred-thousandth of it turn about it by what is 1e-10 of the sums.
  using W = Mp50;
  SpaceMatrix<W> moved = SpaceMatrix<W>::Zero(dimension, dimension);
  if (at_unit > 0 && to_unit > 0 && std::isfinite(at_unit) && std::isfinite(to_unit))
    for (std::size_t p = 0; p < places.size(); ++p)
      moved += in<W>(dimension, convert<W>(targets[p]) - convert<W>(motion.to)) / W(to_unit) *
               (in<W>(dimension, convert<W>(places[p]) - convert<W>(middle)) / W(at_unit)).transpose();
  else to_unit = at_unit = size;
  const W weight = W(size) / W(to_unit) * (W(size) / W(at_unit));
  for (const auto& [at, jacobian] : constraints.orientations)
    moved += weight * jacobian.topLeftCorner(dimension, dimension).template cast<W>();
  if (moved.allFinite() && !moved.isZero(0)) {
    // The tolerance is the square of some roundings: points nearer to a line do not determine the turn about it.
    const NearestRotation<W> nearest = nearest_rotation<W>(moved, W(1e-29));
    if (nearest.is_unique) {
      motion.turn = nearest.rotation.template cast<R>();
    } else if (dimension == 3) {
      // All points lie in one line, and turns about it are free.
      const Eigen::JacobiSVD<SpaceMatrix<W>, Eigen::NoQRPreconditioner> svd(moved,
                                                                            Eigen::ComputeFullU | Eigen::ComputeFullV);
      motion.turn =
          least_turn<W>(Vec3<W>(svd.matrixV().col(0)), Vec3<W>(svd.matrixU().col(0)), Vec3<W>(svd.matrixV().col(1)))
              .template cast<R>();
    }
  }
  // The middle goes to the mean of the targets.
  motion.to += convert<double>(Vec3<R>(in_three<R>(motion.turn) * (convert<R>(from) - convert<R>(middle))));
  motion.to.tail(3 - dimension).setZero();
  return motion;
}

template Motion<double> nearest_motion<double>(const Constraints&, const std::vector<Vec3<double>>&,
                                               const Vec3<double>&, double, int);
template Motion<Mp50> nearest_motion<Mp50>(const Constraints&, const std::vector<Vec3<double>>&, const Vec3<double>&,
                                           double, int);

}  // namespace cageproof::deformation
