// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof {

std::span<const CoordinateKind> coordinate_kinds() {
  using Reproduces = CoordinateBlock::Reproduces;
  static const CoordinateBlock phi{"phi", "triangle.double_layer", Reproduces::Vertices};
  static const CoordinateBlock psi{"psi", "triangle.single_layer", Reproduces::Normals};
  static const std::array kinds{
      CoordinateKind{"mean_value", "[T18] Eq 9-14", {{"lambda", "triangle.mean_value", Reproduces::Vertices}}, true},
      CoordinateKind{"green", "[T24] Eq 7", {phi, psi}, false},
      CoordinateKind{"biharmonic",
                     "[T24] Eq 1, 3",
                     {phi,
                      psi,
                      {"phibar", "triangle.biharmonic_double_layer", Reproduces::Nothing},
                      {"psibar", "triangle.biharmonic_single_layer", Reproduces::Nothing}},
                     false},
  };
  return kinds;
}

const CoordinateKind* find_coordinate_kind(std::string_view name) {
  for (const CoordinateKind& kind : coordinate_kinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

CageCoordinates::CageCoordinates(const Cage& cage, const CoordinateKind& kind, std::string_view evaluation,
                                 Triangulation rule)
    : kind_(&kind), vertices_(cage.vertices()), triangles_(cage.triangulate(rule).triangles) {
  for (const auto& t : triangles_)
    normals_.push_back((vertices_[t[1]] - vertices_[t[0]]).cross(vertices_[t[2]] - vertices_[t[0]]).normalized());
  for (const CoordinateBlock& block : kind.blocks) {
    auto found = EvaluationRegister::instance().find(block.formula, evaluation);
    if (!found) throw InputError(fmt::format("{} has no evaluation '{}'; see `cageproof list`", block.formula, evaluation));
    max_order_ = std::min(max_order_, found->max_order());
    evaluations_.push_back(std::move(*found));
  }
}

int CageCoordinates::size(int b) const {
  const bool per_vertex = find_formula(kind_->blocks[b].formula)->shape.per_corner;
  return static_cast<int>(per_vertex ? vertices_.size() : triangles_.size());
}

std::vector<Touching> CageCoordinates::touching(const Vec3<double>& point) const {
  std::vector<Touching> found;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    std::array<Vec3<double>, 3> corner;
    for (int c = 0; c < 3; ++c) corner[c] = vertices_[triangles_[t][c]];
    const Vec3<double> low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]);
    const Vec3<double> high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]);
    if ((point - low).minCoeff() < 0 || (high - point).minCoeff() < 0) continue;
    // 200 digits hold the products of three doubles exactly over 100 decades.
    std::array<Vec3<Mp200>, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = convert<Mp200>(corner[c]) - convert<Mp200>(point);
    const Vec3<Mp200> normal = Vec3<Mp200>(p[1] - p[0]).cross(Vec3<Mp200>(p[2] - p[0]));
    if (normal.dot(p[0]) != 0) continue;
    std::array<Mp200, 3> part;
    for (int c = 0; c < 3; ++c) part[c] = p[(c + 1) % 3].cross(p[(c + 2) % 3]).dot(normal);
    if (part[0] < 0 || part[1] < 0 || part[2] < 0) continue;
    Touching touch{static_cast<int>(t), {}};
    for (int c = 0; c < 3; ++c) touch.hats[c] = static_cast<double>(Mp200(part[c] / normal.dot(normal)));
    found.push_back(touch);
  }
  return found;
}

namespace {

template <Scalar R>
void fill_derivatives(Result<R>& result, const R& x) {
  for (int o = 1; o <= 2; ++o) std::ranges::fill(result.of(o), x);
}

// lambda = w / W with W = sum of w, and its derivatives by the quotient rule.
template <Scalar R>
void normalise(Result<R>& w, int order) {
  const std::size_t n = w.value.size();
  R W = 0;
  Vec3<R> dW = Vec3<R>::Zero();
  Mat3<R> ddW = Mat3<R>::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    W += w.value[i];
    for (int a = 0; order >= 1 && a < 3; ++a) dW[a] += w.gradient[3 * i + a];
    for (int a = 0; order >= 2 && a < 9; ++a) ddW(a / 3, a % 3) += w.hessian[9 * i + a];
  }
  for (std::size_t i = 0; i < n; ++i) {
    w.value[i] /= W;
    for (int a = 0; order >= 1 && a < 3; ++a)
      w.gradient[3 * i + a] = (w.gradient[3 * i + a] - w.value[i] * dW[a]) / W;
    for (int a = 0; order >= 2 && a < 3; ++a)
      for (int b = 0; b < 3; ++b) {
        R& h = w.hessian[9 * i + 3 * a + b];
        h = (h - w.value[i] * ddW(a, b) - w.gradient[3 * i + a] * dW[b] - w.gradient[3 * i + b] * dW[a]) / W;
      }
  }
}

}  // namespace

template <Scalar R>
Result<R> CageCoordinates::block_at(int b, const Vec3<R>& eta, int order, const std::vector<Touching>& on) const {
  const Formula& formula = *find_formula(kind_->blocks[b].formula);
  Result<R> sum, part;
  sum.reset(size(b), 3, order);
  const auto add_hats = [&](const R& factor) {
    for (int c = 0; c < 3; ++c) sum.value[triangles_[on.front().triangle][c]] += factor * static_cast<R>(on.front().hats[c]);
  };
  if (kind_->normalised && !on.empty()) {
    add_hats(R(1));
    fill_derivatives(sum, std::numeric_limits<R>::quiet_NaN());
    return sum;
  }
  const bool jumps = formula.shape.per_corner && formula.face_jump.number != 0;
  std::array<Vec3<R>, 3> corners;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (int c = 0; c < 3; ++c) corners[c] = convert<R>(vertices_[triangles_[t][c]]);
    evaluations_[b].operator()<R>(Query<R>{corners, eta, order, {}}, part);
    const bool touches = std::ranges::any_of(on, [&](const Touching& o) { return o.triangle == static_cast<int>(t); });
    for (int o = 0; o <= order; ++o) {
      // The share of the triangles that the point lies on is what the others leave of the whole.
      if (o == 0 && jumps && touches) continue;
      const std::vector<R>& from = part.of(o);
      std::vector<R>& to = sum.of(o);
      const std::size_t block = o == 0 ? 1 : o == 1 ? 3 : 9;
      for (std::size_t k = 0; k < from.size() / block; ++k) {
        const std::size_t place = formula.shape.per_corner ? triangles_[t][k] : t;
        for (std::size_t i = 0; i < block; ++i) to[place * block + i] += from[k * block + i];
      }
    }
  }
  if (jumps && !on.empty()) {
    R others = 0;
    for (const R& x : sum.value) others += x;
    add_hats(R(formula.face_jump.number) - others);
  }
  if (kind_->normalised) normalise(sum, order);
  return sum;
}

template <Scalar R>
std::vector<Result<R>> CageCoordinates::at(const Vec3<double>& point, int order) const {
  const std::vector<Touching> on = touching(point);
  std::vector<Result<R>> blocks;
  for (int b = 0; b < static_cast<int>(kind_->blocks.size()); ++b) blocks.push_back(block_at<R>(b, convert<R>(point), order, on));
  return blocks;
}

template <Scalar R>
std::vector<Result<R>> CageCoordinates::at_off_cage(const Vec3<R>& point, int order) const {
  std::vector<Result<R>> blocks;
  for (int b = 0; b < static_cast<int>(kind_->blocks.size()); ++b) blocks.push_back(block_at<R>(b, point, order, {}));
  return blocks;
}

template std::vector<Result<float>> CageCoordinates::at<float>(const Vec3<double>&, int) const;
template std::vector<Result<double>> CageCoordinates::at<double>(const Vec3<double>&, int) const;
template std::vector<Result<Mp50>> CageCoordinates::at<Mp50>(const Vec3<double>&, int) const;
template std::vector<Result<Mp100>> CageCoordinates::at_off_cage<Mp100>(const Vec3<Mp100>&, int) const;

}  // namespace cageproof
