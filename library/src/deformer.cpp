// SPDX-License-Identifier: MIT
#include "conversions.h"

#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/deformation/deformer.h"
#include "cageproof/deformation/point_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

namespace cageproof::library {
namespace {

std::shared_ptr<const deformation::Deformer<double>> prepared_deformer(const cageproof::Cage& cage,
                                                                       const deformation::DeformMethod& method,
                                                                       const Options& options) {
  return deformation::prepare_deformer<double>(
      method, cage,
      {.evaluation = options.evaluation.empty() ? std::string(quickest) : options.evaluation,
       .triangulation = triangulation_of(options),
       .parameters = parameters_of(options, deformation::parameters_of(method), method.name)});
}

// Points whose coordinates are computed together.
constexpr std::size_t kTogether = 64;

}  // namespace

struct Deformer::Prepared {
  Prepared(const cageproof::Cage& cage, const std::string& name, const Options& options)
      : method(deformation::deform_method_named(name)),
        deformer(prepared_deformer(cage, method, options)),
        region(deformation::region_of(deformer->coordinates())),
        threads(options.threads),
        digits(options.digits) {
    if (digits == 0) return;
    if (name != "green")
      throw InputError(fmt::format("digits: {} always computes all digits; leave digits out, or take green", name));
    if (digits < 3 || digits > 12) throw InputError(fmt::format("digits: {} is not from 3 to 12", digits));
  }

  // The pose derivative is found when it is asked for first.
  const deformation::PoseDerivative<double>& derivative() {
    const std::lock_guard lock(finding);
    if (!posed) throw InputError("the cage has no pose yet: call pose before derivatives");
    if (!found) found = deformation::pose_derivative(method, *deformer, {.vertices = vertices});
    return *found;
  }

  const deformation::DeformMethod& method;
  std::shared_ptr<const deformation::Deformer<double>> deformer;
  std::unique_ptr<const deformation::Posed<double>> posed;
  std::optional<deformation::Inside> region;
  int threads, digits;
  std::vector<Vec3<double>> vertices;  // of the pose
  std::mutex finding;
  std::unique_ptr<const deformation::PoseDerivative<double>> found;
};

Deformer::Deformer(const Cage& rest, const std::string& method, const Options& options)
    : prepared_(std::make_unique<Prepared>(checked_cage(rest, options), method, options)) {}
Deformer::~Deformer() = default;
Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;

void Deformer::pose(std::span<const double> vertices) {
  const int dimension = prepared_->deformer->coordinates().dimension();
  std::vector<Vec3<double>> posed = vectors_of(vertices, dimension, "posed vertices");
  prepared_->posed = prepared_->deformer->pose({.vertices = posed});
  prepared_->vertices = std::move(posed);
  prepared_->found.reset();
}

struct BoundPoints::Kept {
  std::shared_ptr<const deformation::Deformer<double>> of;
  std::size_t dimension;
  std::vector<Vec3<double>> points;
  deformation::BoundPoints coordinates;
};

BoundPoints::BoundPoints(std::shared_ptr<const Kept> kept) : kept_(std::move(kept)) {}
std::size_t BoundPoints::size() const { return kept_->points.size(); }
bool BoundPoints::has_jacobians() const { return kept_->coordinates.order() >= 1; }

namespace {

// Room for images and, where they are asked for, Jacobians. \return the highest derivative
int checked_order(std::size_t points, std::size_t d, int max_order, std::span<double> images,
                  std::span<double> jacobians) {
  const int order = jacobians.empty() ? 0 : 1;
  if (order > max_order) throw InputError("the method gives no Jacobians");
  check_size(images.size(), points * d, "images");
  if (order == 1) check_size(jacobians.size(), points * d * d, "jacobians");
  return order;
}

void put(deformation::PointImages found, std::span<const Vec3<double>> points, std::size_t d,
         const std::array<std::span<double>, 2>& out) {
  deformation::fill_missing(found, points, static_cast<int>(d), deformation::Missing::Nan);
  for (std::size_t o = 0; o < 2; ++o)
    if (!out[o].empty()) std::ranges::copy(found.maps.front().tensors[o], out[o].begin());
}

}  // namespace

namespace {

void check_given(std::span<const double> numbers, std::size_t wanted, std::string_view what) {
  if (numbers.size() != wanted) throw InputError(fmt::format("{}: {} numbers, not {}", what, numbers.size(), wanted));
}

// The pose's derivative along a change. Generic, because only members name the type.
template <class Prepared>
std::unique_ptr<const deformation::Posed<double>> changed(Prepared& prepared, std::size_t d,
                                                          std::span<const double> change) {
  const deformation::PoseDerivative<double>& derivative = prepared.derivative();
  check_given(change, prepared.vertices.size() * d, "change");
  return derivative.along(vectors_of(change, static_cast<int>(d), "change"));
}

void put_vertices(const std::vector<Vec3<double>>& found, std::size_t d, std::span<double> vertices) {
  check_size(vertices.size(), found.size() * d, "vertices");
  for (std::size_t v = 0; v < found.size(); ++v)
    std::copy_n(found[v].data(), d, vertices.begin() + static_cast<std::ptrdiff_t>(v * d));
}

}  // namespace

void Deformer::images(std::span<const double> points, std::span<double> images, std::span<double> jacobians) const {
  if (!prepared_->posed) throw InputError("the cage has no pose yet: call pose before images");
  const CageCoordinates& coordinates = prepared_->deformer->coordinates();
  const auto d = static_cast<std::size_t>(coordinates.dimension());
  const std::vector<Vec3<double>> at = vectors_of(points, coordinates.dimension(), "points");
  const int order = checked_order(at.size(), d, prepared_->deformer->max_order(), images, jacobians);
  const std::array maps{prepared_->posed.get()};
  if (prepared_->digits > 0) {
    if (order > 0) throw InputError("digits: Jacobians have all digits only");
    std::vector<deformation::DigitsReport> reports;
    return put(deformation::images_to_digits(coordinates, at, maps, prepared_->digits, prepared_->threads,
                                             prepared_->region, reports),
               at, d, {images, jacobians});
  }
  put(deformation::images_of(coordinates, at, maps, {order, prepared_->threads, kTogether}, prepared_->region), at, d,
      {images, jacobians});
}

BoundPoints Deformer::bind(std::span<const double> points, bool jacobians) const {
  const CageCoordinates& coordinates = prepared_->deformer->coordinates();
  if (jacobians && prepared_->deformer->max_order() < 1) throw InputError("the method gives no Jacobians");
  std::vector<Vec3<double>> at = vectors_of(points, coordinates.dimension(), "points");
  deformation::BoundPoints bound(coordinates, at, {jacobians ? 1 : 0, prepared_->threads, kTogether},
                                 prepared_->region);
  return BoundPoints(std::make_shared<const BoundPoints::Kept>(BoundPoints::Kept{
      prepared_->deformer, static_cast<std::size_t>(coordinates.dimension()), std::move(at), std::move(bound)}));
}

void Deformer::images(const BoundPoints& points, std::span<double> images, std::span<double> jacobians) const {
  if (!prepared_->posed) throw InputError("the cage has no pose yet: call pose before images");
  const BoundPoints::Kept& kept = *points.kept_;
  if (kept.of != prepared_->deformer)
    throw InputError("the points were bound by another Deformer; bind them by this one");
  const int order = checked_order(points.size(), kept.dimension, prepared_->deformer->max_order(), images, jacobians);
  if (order > kept.coordinates.order()) throw InputError("jacobians: the points were bound without; bind them with");
  const std::array maps{prepared_->posed.get()};
  put(kept.coordinates.images(maps, order, prepared_->threads), kept.points, kept.dimension, {images, jacobians});
}

void Deformer::jvp(std::span<const double> points, std::span<const double> change, std::span<double> images) const {
  const CageCoordinates& coordinates = prepared_->deformer->coordinates();
  const auto d = static_cast<std::size_t>(coordinates.dimension());
  const auto along = changed(*prepared_, d, change);
  const std::vector<Vec3<double>> at = vectors_of(points, coordinates.dimension(), "points");
  check_size(images.size(), points.size(), "images");
  const std::array maps{along.get()};
  put(deformation::images_of(coordinates, at, maps, {0, prepared_->threads, kTogether}, prepared_->region), at, d,
      {images, {}});
}

void Deformer::jvp(const BoundPoints& points, std::span<const double> change, std::span<double> images) const {
  const BoundPoints::Kept& kept = *points.kept_;
  if (kept.of != prepared_->deformer)
    throw InputError("the points were bound by another Deformer; bind them by this one");
  const auto along = changed(*prepared_, kept.dimension, change);
  check_size(images.size(), points.size() * kept.dimension, "images");
  const std::array maps{along.get()};
  put(kept.coordinates.images(maps, 0, prepared_->threads), kept.points, kept.dimension, {images, {}});
}

void Deformer::vjp(std::span<const double> points, std::span<const double> weights, std::span<double> vertices) const {
  const CageCoordinates& coordinates = prepared_->deformer->coordinates();
  const deformation::PoseDerivative<double>& derivative = prepared_->derivative();
  const std::vector<Vec3<double>> at = vectors_of(points, coordinates.dimension(), "points");
  check_given(weights, points.size(), "weights");
  put_vertices(deformation::pulled_back(coordinates, at, derivative, weights, {0, prepared_->threads, kTogether},
                                        prepared_->region),
               static_cast<std::size_t>(coordinates.dimension()), vertices);
}

void Deformer::vjp(const BoundPoints& points, std::span<const double> weights, std::span<double> vertices) const {
  const BoundPoints::Kept& kept = *points.kept_;
  if (kept.of != prepared_->deformer)
    throw InputError("the points were bound by another Deformer; bind them by this one");
  const deformation::PoseDerivative<double>& derivative = prepared_->derivative();
  check_given(weights, points.size() * kept.dimension, "weights");
  put_vertices(kept.coordinates.pulled_back(derivative, weights, prepared_->threads), kept.dimension, vertices);
}

}  // namespace cageproof::library
