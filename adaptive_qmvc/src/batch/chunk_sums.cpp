// SPDX-License-Identifier: MIT
#include "chunk_sums.h"

#include <algorithm>
#include <cmath>

namespace cageproof::adaptive_qmvc::batch {
namespace {

// Vectors of every instruction set.
constexpr std::size_t kWidest = 8;
// Points that see a quad alike fill vectors, of which more points leave fewer half empty; their sums stay in caches.
constexpr std::size_t kMost = 1024, kLeast = 64, kSums = std::size_t(1) << 17;

std::size_t padded(std::size_t points) { return (points + kWidest - 1) / kWidest * kWidest; }

}  // namespace

std::size_t chunk_size(const Geometry& geometry) {
  return std::clamp(kSums / static_cast<std::size_t>(geometry.vertices()) / kWidest * kWidest, kLeast, kMost);
}

ChunkSums::ChunkSums(const Geometry& geometry, const CageElements& elements, const Kernels& with)
    : geometry_(geometry), elements_(elements), kernels_(with), plans_(Plans::get()) {
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
  plan_.resize(stride);
  order_.resize(stride);
  chunk_ = {static_cast<int>(stride), at_.data(), sums_.data()};
  for (std::size_t p = 0; p < stride; ++p) {
    // A chunk that is not full goes on with its last point.
    const Vec3<double>& point = points[std::min(p, points.size() - 1)];
    for (int i = 0; i < 3; ++i) at_[i * stride + p] = std::ldexp(point[i], -geometry_.exponent());
  }
}

// Points that see the face by no plan, or from no distance that is a number, come last.
void ChunkSums::sort_by_plan(const FaceTables& face) {
  const auto of = [&](int side) {
    return distances_.data() + static_cast<std::size_t>(face.edge[side]) * chunk_.stride;
  };
  const double *const d0 = of(0), *const d1 = of(1), *const d2 = of(2), *const d3 = of(3);
  first_.assign(plans_.count() + 2, 0);
  for (int p = 0; p < points_; ++p) {
    const int across_v = plans_.step_of((d0[p] + d2[p]) * face.over_v);
    const int across_u = plans_.step_of((d1[p] + d3[p]) * face.over_u);
    plan_[p] = plans_.plan_of(across_v, across_u);
    ++first_[plan_[p] + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  for (int p = 0; p < points_; ++p) order_[first_[plan_[p]]++] = p;
  // Each plan's first place is where the one before it ends.
  for (std::size_t i = first_.size() - 1; i > 0; --i) first_[i] = first_[i - 1];
  first_[0] = 0;
}

void ChunkSums::add_alone(std::size_t f, std::span<const Vec3<double>> points) {
  const std::vector<Vec3<double>> corners = elements_.corners(f);
  const std::span<const int> vertices = elements_.vertices_of(f);
  std::array<double, 4> weights{};
  const BatchOutput<double> output{.tensors = {weights.data(), nullptr, nullptr}};
  for (int i = first_[plans_.none()]; i < points_; ++i) {
    const int p = order_[i];
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
    sort_by_plan(face);
    for (int i = 0; i < plans_.count(); ++i) {
      const int count = first_[i + 1] - first_[i];
      if (count == 0) continue;
      const Plan& plan = plans_[i];
      kernels_.add(
          {&chunk_, plan.turned ? &face.turned : &face.along, plan.across, plan.along, &order_[first_[i]], count});
    }
    if (first_[plans_.none()] < points_) add_alone(f, points);
  }
  kernels_.normalise(chunk_, geometry_.vertices(), whole_.data());
  // Weights on the cage are infinite, and powers of distances may leave double's range, which no sum hides.
  left_.clear();
  for (int p = 0; p < points_; ++p)
    if (!std::isfinite(whole_[p]) || whole_[p] == 0) left_.push_back(p);
}

}  // namespace cageproof::adaptive_qmvc::batch
