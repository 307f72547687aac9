// SPDX-License-Identifier: MIT
#include "gauss_loop.h"

#include "cageproof/core/numbers/gauss_legendre.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace cageproof::benchmarks {
namespace {

std::optional<GaussKernels> kernels_of(const CoordinateKind& kind) {
  if (kind.name == "green") return GaussKernels::Green;
  if (kind.name == "biharmonic") return GaussKernels::Biharmonic;
  if (kind.name == "somigliana") return GaussKernels::Somigliana;
  return std::nullopt;
}

// Points a block: nodes are placed once for all of them, and their sums stay in the processor's caches.
constexpr std::size_t points_a_block = 8 * gauss_lanes;

}  // namespace

GaussRule collapsed_rule(int side) {
  const auto& line = gauss_legendre<double>(side);
  GaussRule rule{fmt::format("gauss-{}", side), {}, {}};
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double s = line.nodes[i], sq = s * line.nodes[j];
      rule.hats.insert(rule.hats.end(), {1 - s, s - sq, sq});
      rule.weights.push_back(s * line.weights[i] * line.weights[j]);
    }
  return rule;
}

GaussRule three_quad_rule(int side) {
  const auto& line = gauss_legendre<double>(side);
  GaussRule rule{fmt::format("three-quad-{}", 3 * side * side), {}, {}};
  for (int corner = 0; corner < 3; ++corner)
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        // The quad of the corner, the midpoints of its edges and the centroid.
        const double u = line.nodes[i], v = line.nodes[j];
        std::array<double, 3> hat{};
        hat[(corner + 1) % 3] = u / 2 - u * v / 6;
        hat[(corner + 2) % 3] = v / 2 - u * v / 6;
        hat[corner] = 1 - hat[(corner + 1) % 3] - hat[(corner + 2) % 3];
        rule.hats.insert(rule.hats.end(), hat.begin(), hat.end());
        rule.weights.push_back((3 - u - v) / 12 * line.weights[i] * line.weights[j]);
      }
  return rule;
}

bool GaussLoop::exists(const CoordinateKind& kind, const Cage& cage) {
  return cage.dimension() == 3 && kernels_of(kind).has_value();
}

GaussLoop::GaussLoop(const Cage& cage, const CoordinateKind& kind, const GaussRule& rule)
    : elements_(cage, false, Triangulation::Shortest),
      hats_(rule.hats),
      plain_(rule.weights),
      kernels_(kernels_of(kind).value()) {
  for (const KindParameter& p : parameters_of(kind)) parameters_.push_back(p.preset);
  triangles_.reserve(elements_.count());
  for (std::size_t e = 0; e < elements_.count(); ++e) {
    GaussTriangle& t = triangles_.emplace_back();
    const auto corners = elements_.corners(e);
    const auto vertices = elements_.vertices_of(e);
    const Vec3<double> area = type_of(ElementKind::Triangle).extent(corners);
    for (int c = 0; c < 3; ++c) t.normal[c] = elements_.normals()[e][c];
    for (int k = 0; k < 3; ++k) {
      t.vertices[k] = vertices[k];
      for (int c = 0; c < 3; ++c) t.corners[k][c] = corners[k][c];
    }
    t.twice_area = area.norm();
    t.number = static_cast<int>(e);
  }
  weights_.reserve(plain_.size() * gauss_weights(kernels_));
  for (std::size_t n = 0; n < plain_.size(); ++n) {
    const double w = plain_[n];
    const double* const hat = hats_.data() + 3 * n;
    if (kernels_ != GaussKernels::Somigliana) {
      weights_.insert(weights_.end(), {w * hat[0], w * hat[1], w * hat[2], w});
      continue;
    }
    weights_.push_back(w);
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l) weights_.push_back(w * hat[k] * hat[l]);
    for (int k = 0; k < 3; ++k)
      for (int l = k; l < 3; ++l)
        for (int m = l; m < 3; ++m) weights_.push_back(w * hat[k] * hat[l] * hat[m]);
  }
}

GaussTask GaussLoop::task() const {
  GaussTask task{};
  task.kernels = kernels_;
  task.nodes = {static_cast<int>(plain_.size()), hats_.data(), plain_.data(), weights_.data()};
  task.triangles = triangles_.data();
  task.triangle_count = static_cast<int>(triangles_.size());
  task.vertex_count = static_cast<int>(elements_.vertices().size());
  if (kernels_ == GaussKernels::Somigliana) task.shear = parameters_[0], task.poisson = parameters_[1];
  return task;
}

std::size_t GaussLoop::entries() const { return static_cast<std::size_t>(gauss_entries(task())); }

void GaussLoop::fill_on_vectors(std::span<const Vec3<double>> points, std::span<double> values) const {
  const std::size_t width = entries();
  std::vector<double> eta(3 * points_a_block), sums(width * points_a_block), positions(3 * plain_.size());
  for (std::size_t first = 0; first < points.size(); first += points_a_block) {
    const std::size_t here = std::min(points_a_block, points.size() - first);
    const std::size_t vectors = (here + gauss_lanes - 1) / gauss_lanes;
    // Lanes without a point repeat the last one.
    for (std::size_t p = 0; p < vectors * gauss_lanes; ++p)
      for (std::size_t c = 0; c < 3; ++c)
        eta[(p / gauss_lanes * 3 + c) * gauss_lanes + p % gauss_lanes] = points[first + std::min(p, here - 1)][c];
    std::ranges::fill(sums, 0.0);
    GaussTask block = task();
    block.points = static_cast<int>(vectors * gauss_lanes);
    block.eta = eta.data();
    block.sums = sums.data();
    block.positions = positions.data();
    gauss_on_vectors(block);
    for (std::size_t p = 0; p < here; ++p) {
      const double* const from = sums.data() + p / gauss_lanes * width * gauss_lanes + p % gauss_lanes;
      double* const to = values.data() + (first + p) * width;
      for (std::size_t i = 0; i < width; ++i) to[i] = from[i * gauss_lanes];
    }
  }
}

void GaussLoop::fill_plainly(std::span<const Vec3<double>> points, std::span<double> values) const {
  std::ranges::fill(values, 0.0);
  GaussTask all = task();
  all.points = static_cast<int>(points.size());
  all.eta = points.front().data();
  all.sums = values.data();
  gauss_plainly(all);
}

}  // namespace cageproof::benchmarks
