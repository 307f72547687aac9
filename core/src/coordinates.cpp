// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/orientation.h"
#include "cageproof/core/quad_geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof {
namespace {

Evaluation evaluation_of(std::string_view formula, std::string_view name) {
  auto found = EvaluationRegister::instance().find(formula, name);
  if (!found) throw InputError(fmt::format("{} has no evaluation '{}'; see `cageproof list`", formula, name));
  return std::move(*found);
}

// The cage's faces, or its triangles.
std::vector<Face> elements_of(const Cage& cage, bool keep_quads, Triangulation rule) {
  if (keep_quads) return cage.faces();
  std::vector<Face> elements;
  for (const auto& t : cage.triangulate(rule).triangles) elements.push_back({{t[0], t[1], t[2], -1}});
  return elements;
}

}  // namespace

CageCoordinates::CageCoordinates(const Cage& cage, const CoordinateKind& kind, std::string_view evaluation,
                                 Triangulation rule, std::vector<double> parameters)
    : kind_(&kind), vertices_(cage.vertices()), elements_(elements_of(cage, kind.keeps_quads(), rule)), parameters_(std::move(parameters)) {
  const std::vector<Parameter>& known = parameters_of(kind);
  if (parameters_.empty())
    for (const Parameter& p : known) parameters_.push_back(p.preset);
  if (parameters_.size() != known.size())
    throw InputError(fmt::format("{} has {} parameters, not {}", kind.name, known.size(), parameters_.size()));
  for (std::size_t i = 0; i < known.size(); ++i)
    if (!known[i].allows(parameters_[i]))
      throw InputError(fmt::format("{}: the parameter {} = {} is out of range", kind.name, known[i].name, parameters_[i]));
  if (!accepts(kind, cage)) {
    const auto faults = invalid_quads(cage);
    const std::string more = faults.size() > 1 ? fmt::format(", and {} more", faults.size() - 1) : "";
    throw InputError(fmt::format("{}: {} (faces counted from 0, corners within the face){}; {} wants valid quads, --allow-invalid-quads computes "
                                 "all the same",
                                 cage.name(), faults.front(), more, kind.name));
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const auto c = corners(static_cast<int>(e));
    const Vec3<double> area = c.size() == 3 ? (c[1] - c[0]).cross(c[2] - c[0]) : (c[2] - c[0]).cross(c[3] - c[1]);
    normals_.push_back(area.normalized());
  }
  if (kind.direct) {
    direct_ = kind.direct(cage, evaluation);
    max_order_ = 0;
    return;
  }
  for (const CoordinateBlock& block : kind.blocks) {
    if (block.quad_formula.empty()) {
      evaluations_.push_back(evaluation_of(block.formula, evaluation));
    } else {
      const bool has = EvaluationRegister::instance().find(block.formula, evaluation).has_value();
      evaluations_.push_back(evaluation_of(block.formula, has ? evaluation : "closed_form"));
      quad_evaluations_.push_back(evaluation_of(block.quad_formula, evaluation));
      if (cage.has_quads()) max_order_ = std::min(max_order_, quad_evaluations_.back().max_order());
    }
    max_order_ = std::min(max_order_, evaluations_.back().max_order());
  }
}

std::vector<Vec3<double>> CageCoordinates::corners(int element) const {
  std::vector<Vec3<double>> found;
  const Face& face = elements_[element];
  for (int k = 0; k < face.size(); ++k) found.push_back(vertices_[face.vertices[k]]);
  return found;
}

Vec3<double> CageCoordinates::normal_at(const Touching& touch) const {
  const auto q = corners(touch.element);
  if (q.size() == 3) return normals_[touch.element];
  const double u = touch.basis[1] + touch.basis[2], v = touch.basis[2] + touch.basis[3];
  const Vec3<double> along_u = (1 - v) * (q[1] - q[0]) + v * (q[2] - q[3]), along_v = (1 - u) * (q[3] - q[0]) + u * (q[2] - q[1]);
  return along_u.cross(along_v).normalized();
}

int CageCoordinates::size(int b) const {
  const bool per_vertex = find_formula(kind_->blocks[b].formula)->shape.per_corner;
  return static_cast<int>(per_vertex ? vertices_.size() : elements_.size());
}

int CageCoordinates::entries(int b) const {
  const Formula& formula = *find_formula(kind_->blocks[b].formula);
  return formula.shape.rows * formula.shape.columns;
}

double CageCoordinates::normal_factor(int b) const {
  const auto factor = kind_->blocks[b].normal_factor;
  return factor ? factor(parameters_) : 1;
}

namespace {

// The hat functions of a point that lies on the triangle, exactly; nothing for one that does not.
std::optional<std::array<double, 4>> hats_at(const Triangle<double>& corner, const Vec3<double>& point) {
  const Vec3<double> low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]);
  const Vec3<double> high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]);
  if ((point - low).minCoeff() < 0 || (high - point).minCoeff() < 0) return std::nullopt;
  if (side_of_plane(corner, point) != 0) return std::nullopt;
  if (side_of_edge(corner, 0, point) < 0 || side_of_edge(corner, 1, point) < 0 || side_of_edge(corner, 2, point) < 0) return std::nullopt;
  // 200 digits hold the products of three doubles exactly over 100 decades.
  std::array<Vec3<Mp200>, 3> p;
  for (int c = 0; c < 3; ++c) p[c] = convert<Mp200>(corner[c]) - convert<Mp200>(point);
  const Vec3<Mp200> normal = Vec3<Mp200>(p[1] - p[0]).cross(Vec3<Mp200>(p[2] - p[0]));
  std::array<Mp200, 3> part;
  for (int c = 0; c < 3; ++c) part[c] = p[(c + 1) % 3].cross(p[(c + 2) % 3]).dot(normal);
  std::array<double, 4> hats{};
  for (int c = 0; c < 3; ++c) hats[c] = static_cast<double>(Mp200(part[c] / normal.dot(normal)));
  return hats;
}

}  // namespace

std::vector<Touching> CageCoordinates::touching(const Vec3<double>& point) const {
  std::vector<Touching> found;
  for (int e = 0; e < static_cast<int>(elements_.size()); ++e) {
    const auto& v = elements_[e].vertices;
    if (elements_[e].size() == 3) {
      if (const auto hats = hats_at({vertices_[v[0]], vertices_[v[1]], vertices_[v[2]]}, point)) found.push_back({e, *hats});
    } else if (const auto on = on_quad({vertices_[v[0]], vertices_[v[1]], vertices_[v[2]], vertices_[v[3]]}, point)) {
      found.push_back({e, on->basis});
    }
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
  // Adds the matrix (or number) times each basis function at the point to its vertex.
  const auto add_basis = [&](const std::vector<R>& matrix) {
    const Face& element = elements_[on.front().element];
    for (int c = 0; c < element.size(); ++c)
      for (std::size_t i = 0; i < width; ++i)
        sum.value[element.vertices[c] * width + i] += static_cast<R>(on.front().basis[c]) * matrix[i];
  };
  if (kind_->normalised && !on.empty()) {
    add_basis({R(1)});
    fill_derivatives(sum, std::numeric_limits<R>::quiet_NaN());
    return sum;
  }
  const bool jumps = formula.shape.per_corner && formula.face_jump.number != 0;
  const std::vector<R> parameters(parameters_.begin(), parameters_.end());
  std::array<Vec3<R>, 4> corners;
  std::vector<R> whole(width, R(0));  // what the elements that the point is not on leave of the whole
  for (std::size_t i = 0; i < width; i += formula.shape.columns + 1) whole[i] = R(formula.face_jump.number);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const std::size_t count = elements_[e].size();
    const auto& v = elements_[e].vertices;
    for (std::size_t c = 0; c < count; ++c) corners[c] = convert<R>(vertices_[v[c]]);
    const auto touch = std::ranges::find(on, static_cast<int>(e), &Touching::element);
    const bool touches = jumps && touch != on.end();
    evaluation_on(b, static_cast<int>(e)).operator()<R>(Query<R>{std::span(corners).first(count), eta, order, parameters, touches}, part);
    for (int o = 0; o <= order; ++o) {
      const std::vector<R>& from = part.of(o);
      std::vector<R>& to = sum.of(o);
      const std::size_t block = width * (o == 0 ? 1 : o == 1 ? 3 : 9), tensors = from.size() / block;
      for (std::size_t k = 0; k < tensors; ++k) {
        const std::size_t place = formula.shape.per_corner ? v[k] : e;
        for (std::size_t i = 0; i < block; ++i) to[place * block + i] += from[k * block + i];
      }
      if (!jumps || on.empty() || o != 0) continue;
      // On the cage: the sum over all elements of int (basis - basis at the point) kernel, whose integrals exist, and basis at the point.
      for (std::size_t i = 0; i < width; ++i) {
        R all = 0;
        for (std::size_t k = 0; k < tensors; ++k) all += from[k * width + i];
        if (!touches) whole[i] -= all;
        else
          for (std::size_t c = 0; c < count; ++c) to[v[c] * width + i] -= static_cast<R>(touch->basis[c]) * all;
      }
    }
  }
  if (jumps && !on.empty()) add_basis(whole);
  if (kind_->normalised) normalise(sum, order);
  return sum;
}

namespace {

template <Scalar R>
std::vector<Result<R>> direct_at(const std::vector<double>& coordinates) {
  std::vector<Result<R>> blocks(1);
  blocks[0].value.assign(coordinates.begin(), coordinates.end());
  return blocks;
}

}  // namespace

template <Scalar R>
std::vector<Result<R>> CageCoordinates::at(const Vec3<double>& point, int order) const {
  if (direct_) return direct_at<R>(direct_(point));
  const std::vector<Touching> on = touching(point);
  std::vector<Result<R>> blocks;
  for (int b = 0; b < static_cast<int>(kind_->blocks.size()); ++b) blocks.push_back(block_at<R>(b, convert<R>(point), order, on));
  return blocks;
}

template <Scalar R>
std::vector<Result<R>> CageCoordinates::at_off_cage(const Vec3<R>& point, int order) const {
  if (direct_) return direct_at<R>(direct_(convert<double>(point)));
  std::vector<Result<R>> blocks;
  for (int b = 0; b < static_cast<int>(kind_->blocks.size()); ++b) blocks.push_back(block_at<R>(b, point, order, {}));
  return blocks;
}

template std::vector<Result<float>> CageCoordinates::at<float>(const Vec3<double>&, int) const;
template std::vector<Result<double>> CageCoordinates::at<double>(const Vec3<double>&, int) const;
template std::vector<Result<Mp50>> CageCoordinates::at<Mp50>(const Vec3<double>&, int) const;
template std::vector<Result<Mp100>> CageCoordinates::at_off_cage<Mp100>(const Vec3<Mp100>&, int) const;

}  // namespace cageproof
