// SPDX-License-Identifier: MIT
#include "own_place.h"

#include "cageproof/core/geometry/box.h"

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

// Images that are found elsewhere, and where that is.
template <Scalar R>
class ShiftedPosed final : public Posed<R> {
 public:
  ShiftedPosed(std::unique_ptr<const Posed<R>> posed, const Vec3<double>& place, int dimension)
      : posed_(std::move(posed)), place_(convert<R>(place)), dimension_(static_cast<std::size_t>(dimension)) {}

  Images<R> images(std::span<const CoordinateTable<R>> coordinates, std::size_t points, int order) const override {
    Images<R> found = posed_->images(coordinates, points, order);
    std::vector<R>& values = found.tensors[0];
    for (std::size_t i = 0; i < values.size(); ++i) values[i] += place_[static_cast<int>(i % dimension_)];
    return found;
  }
  const Posed<R>& posed() const { return *posed_; }
  const Vec3<R>& place() const { return place_; }
  const DeformationReport& report() const override { return posed_->report(); }
  std::vector<Vec3<R>> vertices() const override {
    std::vector<Vec3<R>> found = posed_->vertices();
    for (Vec3<R>& v : found) v += place_;
    return found;
  }

 private:
  std::unique_ptr<const Posed<R>> posed_;
  Vec3<R> place_;
  std::size_t dimension_;
};

template <Scalar R>
class InOwnPlace final : public Deformer<R> {
 public:
  explicit InOwnPlace(std::shared_ptr<const Deformer<R>> deformer) : deformer_(std::move(deformer)) {}

  const CageCoordinates& coordinates() const override { return deformer_->coordinates(); }
  int max_order() const override { return deformer_->max_order(); }
  DeformationReport prepared() const override { return deformer_->prepared(); }
  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    auto other = deformer_->with_parameters(parameters);
    return other ? in_own_place<R>(std::move(other)) : nullptr;
  }

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const Vec3<double> place = place_of(pose);
    if (place == Vec3<double>::Zero()) return deformer_->pose(pose);
    return shifted<R>(deformer_->pose(at_place(pose, place)), place, coordinates().dimension());
  }
  // A shift has no derivative, and changes none.
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    return deformer_->derivative(at_place(pose, place_of(pose)));
  }

 private:
  static Vec3<double> place_of(const Pose<R>& pose) {
    std::vector<Vec3<double>> vertices;
    vertices.reserve(pose.vertices.size());
    for (const Vec3<R>& v : pose.vertices) vertices.push_back(convert<double>(v));
    return own_place(vertices);
  }
  static Pose<R> at_place(Pose<R> pose, const Vec3<double>& place) {
    for (Vec3<R>& v : pose.vertices) v -= convert<R>(place);
    return pose;
  }

  std::shared_ptr<const Deformer<R>> deformer_;
};

}  // namespace

Vec3<double> own_place(const std::vector<Vec3<double>>& points) {
  if (points.empty() || !std::ranges::all_of(points, [](const Vec3<double>& p) { return p.allFinite(); }))
    return Vec3<double>::Zero();
  const auto [low, high] = box_of(points);
  const double side = (high - low).maxCoeff();
  if (!std::isfinite(side)) return Vec3<double>::Zero();
  // A whole number of units of at least the side, not above the middle: points on its far side are at most a side
  // nearer to the origin than it is, and where it is one unit off, they are as fine numbers as their step from it.
  const double unit = side > 0 ? std::exp2(std::ilogb(side) + 1) : 0;
  Vec3<double> place = Vec3<double>::Zero();
  for (int c = 0; c < 3; ++c) {
    const double middle = low[c] + (high[c] - low[c]) / 2;
    place[c] = unit > 0 && std::isfinite(unit) ? std::trunc(middle / unit) * unit : middle;
  }
  return place;
}

template <Scalar R>
std::unique_ptr<const Posed<R>> shifted(std::unique_ptr<const Posed<R>> posed, const Vec3<double>& by, int dimension) {
  if (by == Vec3<double>::Zero()) return posed;
  return std::make_unique<ShiftedPosed<R>>(std::move(posed), by, dimension);
}

std::pair<const Posed<double>*, Vec3<double>> without_shift(const Posed<double>& posed) {
  const auto* const moved = dynamic_cast<const ShiftedPosed<double>*>(&posed);
  if (moved == nullptr) return {&posed, Vec3<double>::Zero()};
  return {&moved->posed(), moved->place()};
}

template <Scalar R>
std::shared_ptr<const Deformer<R>> in_own_place(std::shared_ptr<const Deformer<R>> deformer) {
  return std::make_shared<InOwnPlace<R>>(std::move(deformer));
}

template std::unique_ptr<const Posed<double>> shifted<double>(std::unique_ptr<const Posed<double>>, const Vec3<double>&,
                                                              int);
template std::unique_ptr<const Posed<Mp50>> shifted<Mp50>(std::unique_ptr<const Posed<Mp50>>, const Vec3<double>&, int);
template std::shared_ptr<const Deformer<double>> in_own_place<double>(std::shared_ptr<const Deformer<double>>);
template std::shared_ptr<const Deformer<Mp50>> in_own_place<Mp50>(std::shared_ptr<const Deformer<Mp50>>);

}  // namespace cageproof::deformation
