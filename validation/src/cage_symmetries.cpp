// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_symmetries.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

constexpr double scale = 0x1p10;  // a power of two, so that the scaled input is exact

// Axes permuted with signs, so that the turned input is exact.
Vec3<double> turn(const Vec3<double>& v) { return {v[1], -v[2], -v[0]}; }

// A matrix as it would be without the turn.
void turn_back(double* matrix) {
  Mat3<double> q;
  for (int i = 0; i < 3; ++i) q.col(i) = turn(Vec3<double>::Unit(i));
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  Eigen::Map<Rows> m(matrix);
  m = (q.transpose() * m * q).eval();
}

template <Scalar R>
double relative_difference(const std::vector<R>& a, const std::vector<R>& b) {
  R error = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    error += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  using std::isfinite, std::sqrt;
  if (!isfinite(error) || !isfinite(size)) return std::numeric_limits<double>::infinity();
  return error == 0 ? 0 : static_cast<double>(R(sqrt(R(error / size))));
}

}  // namespace

CageSymmetries::Variant CageSymmetries::variant(std::string check, const std::string& name,
                                                const std::vector<Vec3<double>>& vertices, const std::vector<Face>& faces,
                                                const CoordinateKind& kind, const std::string& evaluation) const {
  const CageOptions options{.allow_invalid_quads = allow_invalid_quads_};
  Variant v{std::move(check), {Cage::make(name, vertices, faces, options), kind, evaluation, Triangulation::Fan}, {}, {}, 1, false};
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i) v.vertex_parts.push_back({i});
  for (int t = 0; t < static_cast<int>(faces.size()); ++t) v.element_of.push_back(t);
  return v;
}

CageSymmetries::CageSymmetries(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation,
                               Triangulation rule)
    : size_(cage.size()), allow_invalid_quads_(cage.allows_invalid_quads()), base_(cage, kind, evaluation, rule) {
  const auto& vertices = cage.vertices();
  std::vector<Vec3<double>> scaled, turned, finer = vertices;
  for (const auto& v : vertices) {
    scaled.push_back(scale * v);
    turned.push_back(turn(v));
  }
  std::vector<Face> faces, permuted, parts;
  std::vector<int> part_of;
  std::map<std::pair<int, int>, int> midpoints;
  std::vector<std::vector<int>> ends;
  for (int i = 0; i < static_cast<int>(vertices.size()); ++i) ends.push_back({i});
  const auto midpoint = [&](int a, int b) {
    const auto [place, added] = midpoints.try_emplace(std::minmax(a, b), static_cast<int>(finer.size()));
    if (added) {
      finer.push_back((vertices[a] + vertices[b]) / 2);
      ends.push_back({a, b});
    }
    return place->second;
  };
  for (const Face& element : base_.elements()) {
    const auto& v = element.vertices;
    const int n = element.size(), last = v[n - 1];
    faces.push_back(element);
    permuted.push_back(n == 3 ? Face{{v[1], v[2], v[0], -1}} : Face{{v[1], v[2], v[3], v[0]}});
    std::array<int, 4> middle{};
    for (int k = 0; k < n; ++k) middle[k] = midpoint(v[k], v[(k + 1) % n]);
    const int element_index = static_cast<int>(faces.size()) - 1, before = middle[n - 1];
    if (n == 3) {
      parts.insert(parts.end(), {{{v[0], middle[0], before, -1}}, {{middle[0], v[1], middle[1], -1}}, {{before, middle[1], last, -1}},
                                 {{middle[0], middle[1], before, -1}}});
    } else {
      // The parts of a bilinear quad at u = 1/2 and v = 1/2 are bilinear quads.
      const int centre = static_cast<int>(finer.size());
      finer.push_back((vertices[v[0]] + vertices[v[1]] + vertices[v[2]] + vertices[v[3]]) / 4);
      ends.push_back({v.begin(), v.end()});
      parts.insert(parts.end(), {{{v[0], middle[0], centre, before}}, {{middle[0], v[1], middle[1], centre}},
                                 {{centre, middle[1], v[2], middle[2]}}, {{before, centre, middle[2], last}}});
    }
    part_of.insert(part_of.end(), 4, element_index);
  }
  variants_.push_back(variant("cage_scaling", cage.name(), scaled, faces, kind, evaluation));
  variants_.back().unit = scale;
  variants_.push_back(variant("cage_rigid_motion", cage.name(), turned, faces, kind, evaluation));
  variants_.back().turned = true;
  variants_.push_back(variant("cage_corner_permutation", cage.name(), vertices, permuted, kind, evaluation));
  // What is no sum over faces has no reason to stay when they are divided.
  if (kind.direct) return;
  variants_.push_back(variant("cage_subdivision", cage.name(), finer, parts, kind, evaluation));
  variants_.back().vertex_parts = ends;
  variants_.back().element_of = part_of;
}

std::map<std::string, double> CageSymmetries::errors_at(const Vec3<double>& point) const {
  std::map<std::string, double> errors;
  const auto expected = base_.at<double>(point, 0);
  for (const Variant& v : variants_) {
    const auto found = v.coordinates.at<double>(v.turned ? turn(point) : Vec3<double>(v.unit * point), 0);
    double& worst = errors[v.check];
    if (!base_.kind().missing_because.empty() && std::isnan(expected[0].value[0]) && std::isnan(found[0].value[0])) {
      worst = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    for (std::size_t b = 0; b < found.size(); ++b) {
      const Formula& formula = *find_formula(base_.kind().blocks[b].formula);
      const int degree = base_.kind().normalised ? 0 : formula.degree;
      std::vector<double> folded(expected[b].value.size(), 0.0);
      const std::size_t width = base_.entries(static_cast<int>(b));
      std::vector<double> plain = found[b].value;
      for (std::size_t i = 0; v.turned && width == 9 && i < plain.size(); i += width) turn_back(&plain[i]);
      for (std::size_t i = 0; i < plain.size(); ++i) {
        const double x = plain[i] / std::pow(v.unit, degree);
        const std::size_t coordinate = i / width, entry = i % width;
        if (!formula.shape.per_corner) folded[v.element_of[coordinate] * width + entry] += x;
        else
          for (const int to : v.vertex_parts[coordinate])
            folded[to * width + entry] += x / static_cast<double>(v.vertex_parts[coordinate].size());
      }
      worst = std::max(worst, relative_difference(folded, expected[b].value));
    }
  }
  return errors;
}

std::array<double, 3> CageSymmetries::differences_at(const Vec3<double>& point) const {
  const Vec3<Mp100> eta = convert<Mp100>(point);
  // Far below the distance to the cage, far above the rounding of 100 digits.
  const Mp100 step = Mp100(size_) * Mp100("1e-30");
  const auto exact = base_.at_off_cage<Mp100>(eta, 2);
  auto differences = exact;
  for (int a = 0; a < 3; ++a) {
    Vec3<Mp100> plus = eta, minus = eta;
    plus[a] += step;
    minus[a] -= step;
    const auto up = base_.at_off_cage<Mp100>(plus, 1), down = base_.at_off_cage<Mp100>(minus, 1);
    for (std::size_t b = 0; b < exact.size(); ++b)
      for (int o = 1; o <= 2; ++o)
        for (std::size_t i = 0; i < up[b].of(o - 1).size(); ++i)
          differences[b].of(o)[3 * i + a] = (up[b].of(o - 1)[i] - down[b].of(o - 1)[i]) / (2 * step);
  }
  std::array<double, 3> worst{std::numeric_limits<double>::quiet_NaN(), 0, 0};
  for (std::size_t b = 0; b < exact.size(); ++b)
    for (int o = 1; o <= 2; ++o) worst[o] = std::max(worst[o], relative_difference(differences[b].of(o), exact[b].of(o)));
  return worst;
}

}  // namespace cageproof::validation
