// SPDX-License-Identifier: MIT
#include "conversions.h"

#include "cageproof/core/whole_evaluation.h"
#include "cageproof/deformation/deformer.h"
#include "cageproof/deformation/inside.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
      : deformer(prepared_deformer(cage, method, options)), threads(options.threads) {
    if (!deformer->coordinates().kind().normalised) inside.emplace(deformer->coordinates().elements());
  }
  // Outside, coordinates sum to zero; others have none there.
  bool has_image(const Vec3<double>& point) const { return !inside || inside->holds(point); }

  std::shared_ptr<const deformation::Deformer<double>> deformer;
  std::unique_ptr<const deformation::Posed<double>> posed;
  std::optional<deformation::Inside> inside;
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
  for_blocks(at.size(), prepared_->threads, [&](std::size_t first, std::size_t count) {
    const auto tables = coordinates.at<double>(std::span(at).subspan(first, count), order);
    const deformation::Images<double> found = prepared_->posed->images(tables, count, order);
    for (int o = 0; o <= order; ++o) {
      const std::size_t width = o == 0 ? d : d * d;
      const auto to = out[o].subspan(first * width, count * width);
      std::copy_n(found.tensors[o].data(), to.size(), to.begin());
      for (std::size_t p = 0; p < count; ++p)
        if (!prepared_->has_image(at[first + p]))
          std::ranges::fill(to.subspan(p * width, width), std::numeric_limits<double>::quiet_NaN());
    }
  });
}

}  // namespace cageproof::library
