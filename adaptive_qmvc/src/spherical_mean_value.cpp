// SPDX-License-Identifier: MIT
// Spherical mean value coordinates (Langer, Belyaev, Seidel 2006; [T18] Section 5): each face's mean vector in mean value coordinates on the sphere.
#include "cageproof/core/coordinates.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/quad_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;
using Weights = std::array<double, 4>;

// tan of half the angles from each unit direction to the next, counted about `axis`, summed over the two at each: Floater's mean value weights of the
// centre among points in these directions, times their distances.
Weights half_tangents(const Quad<double>& directions, const Vec& axis) {
  Weights tangent, sum;
  for (int i = 0; i < 4; ++i) {
    const Vec &a = directions[i], &b = directions[(i + 1) % 4];
    const double sine = axis.dot(a.cross(b)), cosine = a.dot(b);
    tangent[i] = cosine >= 0 ? sine / (1 + cosine) : (1 - cosine) / sine;
    // The centre between two opposite points is theirs alone.
    if (!std::isfinite(tangent[i])) {
      Weights between{};
      between[i] = between[(i + 1) % 4] = 1;
      return between;
    }
  }
  for (int i = 0; i < 4; ++i) sum[i] = tangent[(i + 3) % 4] + tangent[i];
  return sum;
}

// The mean vector: the integral of x over the spherical polygon, half the sum of its arcs' lengths times their normals ([T18] Eq 13 for quads).
Vec mean_vector(const Quad<double>& to_corner) {
  Vec m = Vec::Zero();
  for (int i = 0; i < 4; ++i) {
    const Vec &a = to_corner[i], &b = to_corner[(i + 1) % 4], n = a.cross(b);
    const double length = n.norm();
    if (length > 0) m += std::atan2(length, a.dot(b)) / (2 * length) * n;
  }
  return m;
}

// The quad's weights w with sum w_i (q_i - eta) = m. With axis v = m/|m|, corners in directions u_i at angles theta_i from it and e_i their unit
// tangents at v, the mean value property sum T_i e_i = 0 is sum T_i/sin(theta_i) u_i = v sum T_i cot(theta_i). Nothing is added where m vanishes: in the plane of
// a planar quad, rightly; elsewhere the limit does not exist, and coordinates are unstable around such points.
Weights quad_weights(const Quad<double>& q, const Vec& eta) {
  Quad<double> to_corner, tangents;
  for (int i = 0; i < 4; ++i) to_corner[i] = q[i] - eta;
  const Vec m = mean_vector(to_corner);
  const double size = m.norm();
  // What four arcs of at most pi leave when they cancel is rounding.
  if (!(size > 16 * std::numeric_limits<double>::epsilon())) return {};
  const Vec v = m / size;
  Weights sine, distance;
  for (int i = 0; i < 4; ++i) {
    distance[i] = to_corner[i].norm();
    const Vec u = to_corner[i] / distance[i], across = v.cross(u);
    sine[i] = across.norm();
    if (!(sine[i] > 0)) {
      Weights alone{};
      alone[i] = size / distance[i];
      return alone;
    }
    tangents[i] = across.cross(v) / sine[i];
  }
  Weights weights = half_tangents(tangents, v);
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    sum += weights[i] * to_corner[i].dot(v) / (distance[i] * sine[i]);
    weights[i] /= sine[i] * distance[i];
  }
  for (double& w : weights) w *= size / sum;
  return weights;
}

// Mean value coordinates within a planar quad (Floater 2003), for a point off its border.
Weights planar_coordinates(const Quad<double>& q, const Vec& eta) {
  Quad<double> directions;
  Weights distance;
  for (int i = 0; i < 4; ++i) {
    distance[i] = (q[i] - eta).norm();
    directions[i] = (q[i] - eta) / distance[i];
  }
  Weights weights = half_tangents(directions, (q[2] - q[0]).cross(q[3] - q[1]).normalized());
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += weights[i] /= distance[i];
  for (double& w : weights) w /= sum;
  return weights;
}

class Spherical {
 public:
  explicit Spherical(const Cage& cage)
      : quads_(std::make_shared<CageCoordinates>(cage, *find_coordinate_kind("quad_mean_value"), "closed_form", Triangulation::Shortest)),
        vertices_(cage.vertices()),
        triangle_(*EvaluationRegister::instance().find("triangle.mean_value", "closed_form")) {}

  std::vector<double> operator()(const Vec& eta) const {
    std::vector<double> found(vertices_.size(), 0.0);
    const auto add = [&](int element, std::span<const double> weights) {
      const Face& face = quads_->elements()[element];
      for (int k = 0; k < face.size(); ++k) found[face.vertices[k]] += weights[k];
    };
    for (const Touching& touch : quads_->touching(eta))
      if (const auto on = coordinates_on(touch, eta)) {
        add(touch.element, *on);
        return found;
      }
    Result<double> weights;
    for (int e = 0; e < static_cast<int>(quads_->elements().size()); ++e) {
      const auto corners = quads_->corners(e);
      if (corners.size() == 4) {
        add(e, quad_weights({corners[0], corners[1], corners[2], corners[3]}, eta));
        continue;
      }
      // Three directions leave no choice: the coordinates are those of triangles.
      triangle_(Query<double>{corners, eta, 0, {}}, weights);
      add(e, weights.value);
    }
    double sum = 0;
    for (const double w : found) sum += w;
    for (double& w : found) w /= sum;
    return found;
  }

 private:
  // The limits on a face: hat functions, linear on borders, mean value coordinates within planar quads; nothing within others.
  std::optional<Weights> coordinates_on(const Touching& touch, const Vec& eta) const {
    const auto c = quads_->corners(touch.element);
    if (c.size() == 3 || std::ranges::count(touch.basis, 0.0) >= 2) return touch.basis;
    const Quad<double> q{c[0], c[1], c[2], c[3]};
    if (!is_planar(q)) return std::nullopt;
    return planar_coordinates(q, eta);
  }

  std::shared_ptr<const CageCoordinates> quads_;
  std::vector<Vec> vertices_;
  Evaluation triangle_;
};

const RegisterCoordinateKind kind{{.name = "spherical_mean_value",
                                   .source = "Langer, Belyaev, Seidel 2006; [T18] Section 5",
                                   .blocks = {{"lambda", "triangle.mean_value", CoordinateBlock::Reproduces::Vertices, nullptr, "quad.mean_value"}},
                                   .normalised = true,
                                   .direct = [](const Cage& cage, std::string_view evaluation) -> DirectCoordinates {
                                     if (evaluation != "closed_form")
                                       throw InputError(fmt::format("spherical_mean_value has no evaluation '{}', only closed_form", evaluation));
                                     return Spherical(cage);
                                   }}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
