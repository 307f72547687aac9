// SPDX-License-Identifier: MIT
// Positive mean value coordinates (Lipman, Kopf, Cohen-Or, Levin 2007): mean value coordinates of what the point sees.
// There the surface is what a cube map shows; here the parts of faces that are seen are found exactly.
#include "visible_parts.h"

#include "cageproof/core/cage/point_places.h"
#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/core/coordinates/coordinates_in_double.h"
#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <limits>
#include <memory>

namespace cageproof::adaptive_qmvc {
namespace {

// More digits than the scalar's, which cuts next to edges, and faces seen at a small angle, cost.
template <Scalar R>
using Wider =
    std::conditional_t<std::same_as<R, double>, Mp50, std::conditional_t<std::same_as<R, Mp50>, Mp100, Mp200>>;

// Whether no direction shows both, decided in double where that is certain: one of their sides' planes is between them.
bool are_apart(const SeenTriangle<double>& t, const SeenTriangle<double>& u) {
  constexpr double kCertain = 1e-9;
  for (int k = 0; k < 3; ++k) {
    const int from = t.vertices[k], to = t.vertices[(k + 1) % 3];
    const bool beyond = [&] {
      for (int c = 0; c < 3; ++c) {
        if (u.vertices[c] == from || u.vertices[c] == to) continue;
        if (!(t.side[k].dot(u.p[c]) < -kCertain * t.side[k].norm() * u.p[c].norm())) return false;
      }
      return true;
    }();
    if (beyond) return true;
  }
  return false;
}

// Whether all of u is behind the plane of t, or on it, as far as double is certain.
bool is_behind(const SeenTriangle<double>& u, const SeenTriangle<double>& t) {
  constexpr double kCertain = 1e-9;
  for (int c = 0; c < 3; ++c) {
    if (std::ranges::find(t.vertices, u.vertices[c]) != t.vertices.end()) continue;
    if (!(t.normal.dot(u.p[c] - t.p[0]) > kCertain * t.normal.norm() * u.p[c].norm())) return false;
  }
  return true;
}

class PositiveMeanValue final : public CoordinatesInDouble<PositiveMeanValue> {
 public:
  PositiveMeanValue(const Cage& cage, Triangulation rule)
      : elements_(cage, false, rule), places_(cage, false, rule), vertices_(elements_.vertices()) {
    blocks_.push_back({.label = "lambda",
                       .owner = Owner::Vertex,
                       .size = static_cast<int>(vertices_.size()),
                       .shape = {},
                       .reproduces = Reproduces::Vertices});
  }
  const std::vector<CoordinateBlock>& blocks() const override { return blocks_; }
  int max_order() const override { return 0; }
  bool is_exact_in(ScalarKind scalar) const override { return scalar != ScalarKind::Digits200; }

  template <Scalar R>
  void compute(std::span<const Vec3<R>> points, int /*order*/, std::span<CoordinateTable<R>> tables) const {
    for (std::size_t p = 0; p < points.size(); ++p)
      put(points[p], std::span(tables[0].tensors[0]).subspan(p * tables[0].stride[0], vertices_.size()));
  }

 private:
  template <Scalar R>
  void put(const Vec3<R>& eta, std::span<R> to) const {
    const Vec3<double> rounded = convert<double>(eta);
    const PointPlace at = places_.at(rounded);
    if (at.place == Place::Outside) {
      std::ranges::fill(to, std::numeric_limits<R>::quiet_NaN());
      return;
    }
    // Points that are no doubles are taken to lie off the cage.
    if (at.place == Place::On && convert<R>(rounded) == eta) {
      const Touching touch = elements_.touching(rounded).front();
      const auto vertices = elements_.vertices_of(touch.element);
      for (std::size_t k = 0; k < vertices.size(); ++k) to[vertices[k]] += R(touch.basis[k]);
      return;
    }
    using Wide = Wider<R>;
    const std::vector<Wide> weights = visible_weights<Wide>(convert<Wide>(eta));
    Wide sum = 0;
    for (const Wide& w : weights) sum += w;
    for (std::size_t v = 0; v < weights.size(); ++v) to[v] = static_cast<R>(Wide(weights[v] / sum));
  }

  template <Scalar R>
  SeenTriangle<R> seen(std::size_t element, const Vec3<R>& eta) const {
    const auto v = elements_.vertices_of(element);
    const auto corner = [&](int k) { return Vec3<R>(convert<R>(vertices_[v[k]]) - eta); };
    return {{v[0], v[1], v[2]}, {corner(0), corner(1), corner(2)}};
  }

  // The weight of each vertex, not normalised. A ray leaves the inside through the first face in its direction, so only
  // faces that it leaves through are looked at.
  template <Scalar R>
  std::vector<R> visible_weights(const Vec3<R>& eta) const {
    std::vector<SeenTriangle<R>> faces;
    std::vector<SeenTriangle<double>> rounded;
    for (std::size_t e = 0; e < elements_.count(); ++e) {
      SeenTriangle<R> face = seen<R>(e, eta);
      if (!(face.volume > 0)) continue;
      rounded.push_back(
          {face.vertices, {convert<double>(face.p[0]), convert<double>(face.p[1]), convert<double>(face.p[2])}});
      faces.push_back(std::move(face));
    }
    std::vector<R> weights(vertices_.size(), R(0));
    for (std::size_t t = 0; t < faces.size(); ++t) {
      const SeenTriangle<R>& face = faces[t];
      std::vector<SeenPolygon<R>> visible{{face.p[0], face.p[1], face.p[2]}};
      const R size = face.normal.norm();
      for (std::size_t u = 0; u < faces.size() && !visible.empty(); ++u)
        if (u != t && !are_apart(rounded[t], rounded[u]) && !are_apart(rounded[u], rounded[t]) &&
            !is_behind(rounded[u], rounded[t]))
          take_hidden(faces[u], size, visible);
      Vec3<R> mean = Vec3<R>::Zero();
      for (const SeenPolygon<R>& part : visible) mean += mean_vector_of(part);
      for (int k = 0; k < 3; ++k) weights[face.vertices[k]] += mean.dot(face.side[(k + 1) % 3]) / face.volume;
    }
    // Integrands are not negative, so a negative weight is rounding, of a hidden vertex.
    for (R& w : weights) w = std::max(w, R(0));
    return weights;
  }

  CageElements elements_;
  PointPlaces places_;
  std::vector<Vec3<double>> vertices_;
  std::vector<CoordinateBlock> blocks_;
};

std::shared_ptr<const PreparedCoordinates> prepare_positive(const Cage& cage, const CoordinateOptions& options) {
  auto coordinates = std::make_shared<PositiveMeanValue>(cage, options.triangulation);
  const std::string only = coordinates->evaluation();
  if (!options.evaluation.empty() && options.evaluation != only)
    throw InputError(fmt::format("positive_mean_value has no evaluation '{}', only {}", options.evaluation, only));
  return coordinates;
}

const RegisterCoordinateKind register_positive_mean_value{
    {.name = "positive_mean_value",
     .source = "Lipman, Kopf, Cohen-Or, Levin 2007; [T18] Section 5",
     .normalised = true,
     .prepare = prepare_positive,
     .missing_because = "from outside, not every direction meets the cage",
     // Every face may hide every other, in 50 digits: a point takes the square of the number of faces, too.
     .solves_on_samples = true,
     .inside_alone = true}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
