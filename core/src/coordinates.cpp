// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof {

namespace {

// c of [T24], below Eq 49: the traction of the identity map is c n. It grows without bound towards nu = 1/2.
double identity_traction(std::span<const double> p) {
  const double mu = p[0], nu = p[1];
  return std::isinf(nu) ? -mu : 2 * mu * (1 + 3 * nu / (1 - 2 * nu));
}

}  // namespace

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
      CoordinateKind{"somigliana",
                     "[T24] Eq 47-49, [C23] Eq 8",
                     {{"T", "triangle.kelvin_traction", Reproduces::Vertices},
                      {"K", "triangle.kelvin_displacement", Reproduces::Normals, identity_traction}},
                     false},
  };
  return kinds;
}

const std::vector<Parameter>& parameters_of(const CoordinateKind& kind) {
  return find_formula(kind.blocks.front().formula)->parameters;
}

const CoordinateKind* find_coordinate_kind(std::string_view name) {
  for (const CoordinateKind& kind : coordinate_kinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

CageCoordinates::CageCoordinates(const Cage& cage, const CoordinateKind& kind, std::string_view evaluation,
                                 Triangulation rule, std::vector<double> parameters)
    : kind_(&kind), vertices_(cage.vertices()), triangles_(cage.triangulate(rule).triangles), parameters_(std::move(parameters)) {
  const std::vector<Parameter>& known = parameters_of(kind);
  if (parameters_.empty())
    for (const Parameter& p : known) parameters_.push_back(p.preset);
  if (parameters_.size() != known.size())
    throw InputError(fmt::format("{} has {} parameters, not {}", kind.name, known.size(), parameters_.size()));
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known[i].allows(parameters_[i]))
      throw InputError(fmt::format("{}: the parameter {} = {} is out of range", kind.name, known[i].name, parameters_[i]));
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

int CageCoordinates::entries(int b) const {
  const Formula& formula = *find_formula(kind_->blocks[b].formula);
  return formula.shape.rows * formula.shape.columns;
}

double CageCoordinates::normal_factor(int b) const {
  const auto factor = kind_->blocks[b].normal_factor;
  return factor ? factor(parameters_) : 1;
}

std::vector<Touching> CageCoordinates::touching(const Vec3<double>& point) const {
  std::vector<Touching> found;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    std::array<Vec3<double>, 3> corner;
    for (int c = 0; c < 3; ++c) corner[c] = vertices_[triangles_[t][c]];
    const Vec3<double> low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]);
    const Vec3<double> high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]);
    if ((point - low).minCoeff() < 0 || (high - point).minCoeff() < 0) continue;
    if (side_of_plane(corner, point) != 0) continue;
    if (side_of_edge(corner, 0, point) < 0 || side_of_edge(corner, 1, point) < 0 || side_of_edge(corner, 2, point) < 0) continue;
    // 200 digits hold the products of three doubles exactly over 100 decades.
    std::array<Vec3<Mp200>, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = convert<Mp200>(corner[c]) - convert<Mp200>(point);
    const Vec3<Mp200> normal = Vec3<Mp200>(p[1] - p[0]).cross(Vec3<Mp200>(p[2] - p[0]));
    std::array<Mp200, 3> part;
    for (int c = 0; c < 3; ++c) part[c] = p[(c + 1) % 3].cross(p[(c + 2) % 3]).dot(normal);
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
  const std::size_t width = entries(b);
  Result<R> sum, part;
  sum.reset(static_cast<int>(size(b) * width), 3, order);
  // Adds the matrix (or number) times each hat function at the point to its vertex.
  const auto add_hats = [&](const std::vector<R>& matrix) {
    for (int c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < width; ++i)
        sum.value[triangles_[on.front().triangle][c] * width + i] += static_cast<R>(on.front().hats[c]) * matrix[i];
  };
  if (kind_->normalised && !on.empty()) {
    add_hats({R(1)});
    fill_derivatives(sum, std::numeric_limits<R>::quiet_NaN());
    return sum;
  }
  const bool jumps = formula.shape.per_corner && formula.face_jump.number != 0;
  const std::vector<R> parameters(parameters_.begin(), parameters_.end());
  std::array<Vec3<R>, 3> corners;
  std::vector<R> whole(width, R(0));  // what the triangles that the point is not on leave of the whole
  for (std::size_t i = 0; i < width; i += formula.shape.columns + 1) whole[i] = R(formula.face_jump.number);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (int c = 0; c < 3; ++c) corners[c] = convert<R>(vertices_[triangles_[t][c]]);
    const auto touch = std::ranges::find(on, static_cast<int>(t), &Touching::triangle);
    const bool touches = jumps && touch != on.end();
    evaluations_[b].operator()<R>(Query<R>{corners, eta, order, parameters, touches}, part);
    for (int o = 0; o <= order; ++o) {
      const std::vector<R>& from = part.of(o);
      std::vector<R>& to = sum.of(o);
      const std::size_t block = width * (o == 0 ? 1 : o == 1 ? 3 : 9), tensors = from.size() / block;
      for (std::size_t k = 0; k < tensors; ++k) {
        const std::size_t place = formula.shape.per_corner ? triangles_[t][k] : t;
        for (std::size_t i = 0; i < block; ++i) to[place * block + i] += from[k * block + i];
      }
      if (!jumps || on.empty() || o != 0) continue;
      // On the cage: the sum over all triangles of int (hat - hat at the point) kernel, whose integrals exist, and hat at the point.
      for (std::size_t i = 0; i < width; ++i) {
        R all = 0;
        for (std::size_t k = 0; k < tensors; ++k) all += from[k * width + i];
        if (!touches) whole[i] -= all;
        else
          for (int c = 0; c < 3; ++c) to[triangles_[t][c] * width + i] -= static_cast<R>(touch->hats[c]) * all;
      }
    }
  }
  if (jumps && !on.empty()) add_hats(whole);
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
