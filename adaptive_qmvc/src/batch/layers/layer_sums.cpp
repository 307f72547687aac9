// SPDX-License-Identifier: MIT
#include "layer_sums.h"

#include "../chunk_size.h"

#include "cageproof/core/numbers/scalar.h"

#include <algorithm>
#include <cmath>

namespace cageproof::adaptive_qmvc::batch {
namespace {

// Cubes of distances beyond 2^300 sizes leave double's range.
constexpr double kFarthest = 0x1p300;

// Corners of a quad, and of the same one turned (FaceTables).
constexpr std::array<std::array<int, 4>, 2> kCorners{{{0, 1, 2, 3}, {0, 3, 2, 1}}};

// The quotient of an integral of QuadLayers and the value of its formula.
double integral_over_value(std::size_t layer) {
  constexpr std::array<double, 4> times_pi{4, 4, -8, 8};
  return times_pi[layer] * pi<double>();
}
// Powers of the unit that integrals over triangles and quads have, with the measures of areas and of du dv.
constexpr std::array<int, 4> kDegree{0, -1, 2, 1};

}  // namespace

LayerTables::LayerTables(const Geometry& geometry, const CageElements& elements, bool biharmonic) {
  for (std::size_t b = 0; b < (biharmonic ? 4 : 2); b += 2)
    factors.push_back({std::ldexp(1 / integral_over_value(b), kDegree[b] * geometry.exponent()), {}});
  for (std::size_t f = 0; f < elements.count(); ++f) {
    const std::span<const int> normals = elements.shares_of(f, Owner::Normal);
    first.push_back(normals[0]);
    is_quad.push_back(elements.type(f).kind == ElementKind::Quad ? 1 : 0);
    const auto& n = geometry.faces()[f].along.n;
    area.push_back(std::hypot(n[0], n[1], n[2]));
    for (std::size_t l = 0; l < factors.size(); ++l) {
      const double layer = 1 / integral_over_value(2 * l + 1);
      const int unit = kDegree[2 * l + 1] * geometry.exponent();
      std::vector<double>& factor = factors[l].single_layer;
      if (is_quad[f] != 0)
        for (const int normal : normals)
          factor.push_back(std::ldexp(elements.area_element_of(normal, Owner::Normal) * layer, unit));
      else factor.push_back(std::ldexp(area[f] * layer, unit + 2 * geometry.exponent()));
    }
  }
}

std::size_t LayerSums::chunk_size(const Geometry& geometry, const LayerTables& tables) {
  const std::size_t of_layers = static_cast<std::size_t>(geometry.vertices()) + 4 * geometry.faces().size();
  return points_a_chunk(tables.factors.size() * of_layers);
}

LayerSums::LayerSums(const Geometry& geometry, const CageElements& elements, const LayerTables& tables,
                     const Kernels& with)
    : geometry_(geometry),
      elements_(elements),
      tables_(tables),
      kernels_(with),
      plans_(Plans::of_layers()),
      sorted_(plans_),
      near_(with, tables.factors.size() == 2) {
  for (std::size_t f = 0; f < elements.count(); ++f) {
    const ElementKind kind = elements.type(f).kind;
    auto& evaluations = evaluations_[static_cast<std::size_t>(kind)];
    if (evaluations.empty())
      for (std::size_t b = 0; b < tables.blocks(); ++b)
        evaluations.push_back(
            *EvaluationRegister::instance().with_role(find_formula(kind, kKernels[b])->name, Role::Recommended));
    auto& scaled = corner_.emplace_back();
    const std::vector<Vec3<double>> corners = elements.corners(f);
    for (std::size_t k = 0; k < corners.size(); ++k)
      for (int i = 0; i < 3; ++i) scaled[k][i] = std::ldexp(corners[k][i], -geometry.exponent());
  }
}

void LayerSums::take(std::span<const Vec3<double>> points) {
  points_ = static_cast<int>(points.size());
  const std::size_t stride = padded(points.size());
  at_.resize(3 * stride);
  for (std::size_t l = 0; l < tables_.factors.size(); ++l) {
    double_layer_[l].assign(stride * geometry_.vertices(), 0.0);
    single_layer_[l].resize(4 * stride * geometry_.faces().size());
  }
  distances_.resize(stride * geometry_.edges().size());
  is_left_.assign(points.size(), 0);
  chunk_ = {static_cast<int>(stride), at_.data(), nullptr};
  for (std::size_t p = 0; p < stride; ++p) {
    // A chunk that is not full goes on with its last point.
    const Vec3<double>& point = points[std::min(p, points.size() - 1)];
    for (int i = 0; i < 3; ++i) at_[i * stride + p] = std::ldexp(point[i], -geometry_.exponent());
  }
  for (int p = 0; p < points_; ++p)
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(at_[i * stride + p]) < kFarthest)) is_left_[p] = 1;
}

LayerColumns LayerSums::columns(std::size_t layers, std::size_t face) {
  if (layers >= tables_.factors.size()) return {nullptr, nullptr};
  return {double_layer_[layers].data(), single_layer_[layers].data() + 4 * face * chunk_.stride};
}

void LayerSums::add_from_afar(std::size_t f) {
  const FaceTables& face = geometry_.faces()[f];
  for (int i = 0; i < plans_.count(); ++i) {
    const std::span<const int> alike = sorted_.by(i);
    if (alike.empty()) continue;
    const Plan& plan = plans_[i];
    const QuadTable& quad = plan.turned ? face.turned : face.along;
    kernels_.add_layers({{&chunk_, &quad, plan.across, plan.along, alike.data(), static_cast<int>(alike.size())},
                         columns(0, f),
                         columns(1, f),
                         kCorners[plan.turned ? 1 : 0].data(),
                         plan.close});
  }
}

// In the geometry's unit. False on the face, and where a number is not finite.
bool LayerSums::add_by_evaluations(std::size_t f, const Vec3<double>& point, QuadLayers& layers) const {
  const ElementType& type = elements_.type(f);
  const std::span<const Vec3<double>> corners = std::span(corner_[f]).first(elements_.vertices_of(f).size());
  if (type.contact(corners, point).contact != Contact::Off) return false;
  const std::vector<Evaluation>& evaluations = evaluations_[static_cast<std::size_t>(type.kind)];
  const std::size_t count = evaluations.size();
  std::array<const Evaluation*, 4> members{};
  std::array<std::array<double, 4>, 4> values{};
  std::array<BatchOutput<double>, 4> outputs;
  for (std::size_t b = 0; b < count; ++b) {
    members[b] = &evaluations[b];
    outputs[b].tensors[0] = values[b].data();
  }
  Evaluation::together<double>(std::span(members).first(count), Batch<double>{corners, std::span(&point, 1), 0, {}},
                               std::span(outputs).first(count));
  for (std::size_t b = 0; b < count; ++b)
    for (std::size_t k = 0; k < corners.size(); ++k) layers.of[b][k] += integral_over_value(b) * values[b][k];
  return std::ranges::all_of(values, [](const std::array<double, 4>& of) {
    return std::ranges::all_of(of, [](double x) { return std::isfinite(x); });
  });
}

void LayerSums::add_alone(std::size_t f, int p) {
  const std::size_t stride = chunk_.stride;
  const Vec3<double> point(at_[p], at_[stride + p], at_[2 * stride + p]);
  QuadLayers layers;
  const auto reach = tables_.is_quad[f] != 0 ? near_.add(corner_[f], point, layers) : NearQuadLayers::Reach::Nearer;
  if (reach == NearQuadLayers::Reach::Touching ||
      (reach == NearQuadLayers::Reach::Nearer && !add_by_evaluations(f, point, layers))) {
    is_left_[p] = 1;
    return;
  }
  const std::span<const int> vertices = elements_.vertices_of(f);
  for (std::size_t l = 0; l < tables_.factors.size(); ++l) {
    for (std::size_t k = 0; k < vertices.size(); ++k) double_layer_[l][vertices[k] * stride + p] += layers.of[2 * l][k];
    std::array<double, 4>& single = layers.of[2 * l + 1];
    // The formula of triangles has the area element.
    if (tables_.is_quad[f] == 0) single = {single[0] / tables_.area[f]};
    std::ranges::copy(single, single_layer_[l].data() + 4 * (f * stride + p));
  }
}

void LayerSums::put(std::size_t first, std::size_t count, double* rows, std::size_t stride) const {
  const std::size_t padded = chunk_.stride;
  for (std::size_t l = 0; l < tables_.factors.size(); ++l) {
    const LayerTables::Factors& factors = tables_.factors[l];
    // Points are the inner loops: each column is on a page of its own.
    for (int v = 0; v < geometry_.vertices(); ++v) {
      const double* const from = double_layer_[l].data() + v * padded + first;
      for (std::size_t p = 0; p < count; ++p) rows[p * stride + v] = from[p] * factors.double_layer;
    }
    rows += geometry_.vertices();
    for (std::size_t f = 0; f < tables_.first.size(); ++f) {
      const double* const from = single_layer_[l].data() + 4 * (f * padded + first);
      const double* const factor = factors.single_layer.data() + tables_.first[f];
      double* const to = rows + tables_.first[f];
      // A triangle's area element is linear, and zero on the side without length (QuadTable): of both corners off it.
      if (tables_.is_quad[f] == 0)
        for (std::size_t p = 0; p < count; ++p) to[p * stride] = (from[4 * p] + from[4 * p + 1]) * factor[0];
      else
        for (std::size_t p = 0; p < count; ++p)
          for (int k = 0; k < 4; ++k) to[p * stride + k] = from[4 * p + k] * factor[k];
    }
    rows += factors.single_layer.size();
  }
}

void LayerSums::run(std::span<const Vec3<double>> points) {
  take(points);
  const std::vector<EdgeTable>& edges = geometry_.edges();
  for (std::size_t e = 0; e < edges.size(); ++e)
    kernels_.distances(chunk_, edges[e], distances_.data() + e * chunk_.stride);
  for (std::size_t f = 0; f < geometry_.faces().size(); ++f) {
    sorted_.sort(geometry_.faces()[f], distances_.data(), chunk_.stride, points_);
    add_from_afar(f);
    for (const int p : sorted_.by(plans_.none()))
      if (is_left_[p] == 0) add_alone(f, p);
  }
  left_.clear();
  for (int p = 0; p < points_; ++p)
    if (is_left_[p] != 0) left_.push_back(p);
}

}  // namespace cageproof::adaptive_qmvc::batch
