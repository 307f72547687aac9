// SPDX-License-Identifier: MIT
#include "chunk_sums.h"

#include "chunk_size.h"

#include <algorithm>
#include <cmath>

namespace cageproof::adaptive_qmvc::batch {
std::size_t chunk_size(const Geometry& geometry) {
  return points_a_chunk(static_cast<std::size_t>(geometry.vertices()));
}

ChunkSums::ChunkSums(const Geometry& geometry, const CageElements& elements, const Kernels& with)
    : geometry_(geometry), elements_(elements), kernels_(with), plans_(Plans::of_mean_values()), sorted_(plans_) {
  for (std::size_t f = 0; f < elements.count(); ++f) {
    const ElementKind kind = elements.type(f).kind;
    std::optional<Evaluation>& evaluation = evaluations_[static_cast<std::size_t>(kind)];
    if (!evaluation)
      evaluation = EvaluationRegister::instance().with_role(find_formula(kind, "mean_value")->name, Role::Recommended);
  }
}

void ChunkSums::take(std::span<const Vec3<double>> points) {
  points_ = static_cast<int>(points.size());
  const std::size_t stride = padded(points.size());
  at_.resize(3 * stride);
  sums_.assign(stride * geometry_.vertices(), 0.0);
  distances_.resize(stride * geometry_.edges().size());
  whole_.resize(stride);
  chunk_ = {static_cast<int>(stride), at_.data(), sums_.data()};
  for (std::size_t p = 0; p < stride; ++p) {
    // A chunk that is not full goes on with its last point.
    const Vec3<double>& point = points[std::min(p, points.size() - 1)];
    for (int i = 0; i < 3; ++i) at_[i * stride + p] = std::ldexp(point[i], -geometry_.exponent());
  }
}

void ChunkSums::add_alone(std::size_t f, std::span<const Vec3<double>> points) {
  const std::vector<Vec3<double>> corners = elements_.corners(f);
  const std::span<const int> vertices = elements_.vertices_of(f);
  std::array<double, 4> weights{};
  const BatchOutput<double> output{.tensors = {weights.data(), nullptr, nullptr}};
  for (const int p : sorted_.by(plans_.none())) {
    (*evaluations_[static_cast<std::size_t>(elements_.type(f).kind)])(
        Batch<double>{corners, points.subspan(p, 1), 0, {}}, output);
    for (std::size_t k = 0; k < vertices.size(); ++k)
      sums_[vertices[k] * stride() + p] += std::ldexp(weights[k], geometry_.exponent());
  }
}

void ChunkSums::run(std::span<const Vec3<double>> points) {
  take(points);
  const std::vector<EdgeTable>& edges = geometry_.edges();
  for (std::size_t e = 0; e < edges.size(); ++e)
    kernels_.distances(chunk_, edges[e], distances_.data() + e * chunk_.stride);
  for (std::size_t f = 0; f < geometry_.faces().size(); ++f) {
    const FaceTables& face = geometry_.faces()[f];
    sorted_.sort(face, distances_.data(), chunk_.stride, points_);
    for (int i = 0; i < plans_.count(); ++i) {
      const std::span<const int> alike = sorted_.by(i);
      if (alike.empty()) continue;
      const Plan& plan = plans_[i];
      kernels_.add({&chunk_, plan.turned ? &face.turned : &face.along, plan.across, plan.along, alike.data(),
                    static_cast<int>(alike.size())});
    }
    if (!sorted_.by(plans_.none()).empty()) add_alone(f, points);
  }
  kernels_.normalise(chunk_, geometry_.vertices(), whole_.data());
  // Weights on the cage are infinite, and powers of distances may leave double's range, which no sum hides.
  left_.clear();
  for (int p = 0; p < points_; ++p)
    if (!std::isfinite(whole_[p]) || whole_[p] == 0) left_.push_back(p);
}

}  // namespace cageproof::adaptive_qmvc::batch
