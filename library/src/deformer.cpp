// SPDX-License-Identifier: MIT
#include "conversions.h"

#include "cageproof/core/coordinates/whole_evaluation.h"
#include "cageproof/deformation/deformer.h"
#include "cageproof/deformation/point_images.h"

#include <algorithm>

namespace cageproof::library {
namespace {

std::shared_ptr<const deformation::Deformer<double>> prepared_deformer(const cageproof::Cage& cage,
                                                                       const std::string& name,
                                                                       const Options& options) {
  const deformation::DeformMethod& method = deformation::deform_method_named(name);
  return deformation::prepare_deformer<double>(
      method, cage,
      {.evaluation = options.evaluation.empty() ? std::string(quickest) : options.evaluation,
       .triangulation = triangulation_of(options),
       .parameters = parameters_of(options, deformation::parameters_of(method), name)});
}

}  // namespace

struct Deformer::Prepared {
  Prepared(const cageproof::Cage& cage, const std::string& method, const Options& options)
      : deformer(prepared_deformer(cage, method, options)),
        region(deformation::region_of(deformer->coordinates())),
        threads(options.threads) {}

  std::shared_ptr<const deformation::Deformer<double>> deformer;
  std::unique_ptr<const deformation::Posed<double>> posed;
  std::optional<deformation::Inside> region;
  int threads;
};

Deformer::Deformer(const Cage& rest, const std::string& method, const Options& options)
    : prepared_(std::make_unique<Prepared>(checked_cage(rest, options), method, options)) {}
Deformer::~Deformer() = default;
Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;

void Deformer::pose(std::span<const double> vertices) {
  const int dimension = prepared_->deformer->coordinates().dimension();
  prepared_->posed = prepared_->deformer->pose({.vertices = vectors_of(vertices, dimension, "posed vertices")});
}

void Deformer::images(std::span<const double> points, std::span<double> images, std::span<double> jacobians) const {
  if (!prepared_->posed) throw InputError("images of points are asked for before the cage has a pose");
  const CageCoordinates& coordinates = prepared_->deformer->coordinates();
  const auto d = static_cast<std::size_t>(coordinates.dimension());
  const std::vector<Vec3<double>> at = vectors_of(points, coordinates.dimension(), "points");
  const int order = jacobians.empty() ? 0 : 1;
  if (order > prepared_->deformer->max_order()) throw InputError("the method gives no Jacobians");
  const std::array<std::span<double>, 2> out{images, jacobians};
  check_size(images.size(), at.size() * d, "images");
  if (order == 1) check_size(jacobians.size(), at.size() * d * d, "jacobians");
  const std::array maps{prepared_->posed.get()};
  deformation::PointImages found =
      deformation::images_of(coordinates, at, maps, {order, prepared_->threads, 64}, prepared_->region);
  deformation::fill_missing(found, at, coordinates.dimension(), deformation::Missing::Nan);
  for (int o = 0; o <= order; ++o) std::ranges::copy(found.maps.front().tensors[o], out[o].begin());
}

}  // namespace cageproof::library
