// SPDX-License-Identifier: MIT
#include "corotation_slopes.h"

#include "../own_unit.h"
#include "../rotation_slope.h"
#include "../stretch_gradients.h"

namespace cageproof::deformation {
namespace {

// The rotation and stretch of all vertices, and their derivatives by each.
template <Scalar R>
struct SimilaritySlopes {
  Mat3<R> rotation;
  R stretch;
  RowSlopes<R> turn{.rows = 1}, stretch_slopes{.rows = 1};

  SimilaritySlopes(int d, const std::vector<Vec3<R>>& from, const std::vector<Vec3<R>>& posed, const R& unit) {
    Vec3<R> middle = Vec3<R>::Zero(), posed_middle = Vec3<R>::Zero();
    const R share = 1 / R(static_cast<double>(from.size()));
    for (std::size_t v = 0; v < from.size(); ++v) middle += share * from[v], posed_middle += share * posed[v];
    Mat3<R> h = Mat3<R>::Zero();
    R size = 0;
    for (std::size_t v = 0; v < from.size(); ++v) {
      const Vec3<R> step = from[v] - middle;
      h += (posed[v] - posed_middle) * step.transpose();
      size += step.dot(step);
    }
    if (d == 2) h(2, 2) = size;
    const RotationSlope<R> nearest(d, h, "all vertices");
    rotation = nearest.rotation();
    stretch = (rotation.transpose() * h).topLeftCorner(d, d).trace() / size;
    for (std::size_t v = 0; v < from.size(); ++v) {
      const Vec3<R> step = from[v] - middle;
      Mat3<R> slope = Mat3<R>::Zero(), of_stretch = Mat3<R>::Zero();
      for (int c = 0; c < d; ++c) {
        Mat3<R> change = Mat3<R>::Zero();
        change.row(c) = step.transpose();
        slope.col(c) = nearest.of(change) / unit;
      }
      of_stretch.row(0) = (rotation * step).transpose() / (size * unit);
      turn.parts.push_back({0, static_cast<int>(v), slope});
      stretch_slopes.parts.push_back({0, static_cast<int>(v), of_stretch});
    }
  }
};

template <Scalar R>
std::vector<Vec3<R>> zeros(std::size_t count) {
  return std::vector<Vec3<R>>(count, Vec3<R>::Zero());
}

}  // namespace

template <Scalar R>
CorotationSlopes<R>::CorotationSlopes(const CageElements& rest, const std::vector<Vec3<R>>& given,
                                      const CorotationOptions& options)
    : local_share_(options.blend), balance_(options.balance) {
  const int d = rest.dimension();
  const R unit(unit_next_to(size_of(rest)));
  const std::vector<Vec3<R>> from = over(vertices_in<R>(rest), unit), posed = over(given, unit);
  const std::vector<NormalPlace> places = normal_places(rest);
  factor_ = 2 * (1 + volume_factor<R>(options.nu) * d);
  std::vector<std::string> warnings;
  const auto local_stretches = [&] {
    std::vector<R> found;
    found.reserve(places.size());
    for (const NormalPlace& at : places) found.push_back(stretch_of(Stretch::Mean, rest, given, at.element, at.corner));
    return found;
  };
  const Turns<R> turns = turns_of<R>(rest, from, posed, local_stretches, options.blend, warnings);
  const Blend global{Mat3<R>::Identity(), Mat3<R>::Zero()};
  vertex_blends_.assign(posed.size(), global);
  normal_blends_.assign(places.size(), global);
  if (options.blend < 1) {
    SimilaritySlopes<R> all(d, from, posed, unit);
    global_turn_ = std::move(all.turn);
    global_stretch_ = std::move(all.stretch_slopes);
    if (options.blend > 0) make_local(rest, from, posed, unit);
    for (std::size_t i = 0; options.blend > 0 && i < vertex_blends_.size() + normal_blends_.size(); ++i) {
      const bool is_vertex = i < vertex_blends_.size();
      const std::size_t k = is_vertex ? i : i - vertex_blends_.size();
      const Mat3<R>& local = is_vertex ? local_vertices_.rotations[k] : local_normals_.rotations[k];
      const R share(options.blend), other = 1 - share;
      Mat3<R> sum = other * all.rotation + share * local;
      const RotationSlope<R> nearest(d, sum, is_vertex ? fmt::format("vertex {}", k) : fmt::format("normal {}", k));
      Blend& blend = is_vertex ? vertex_blends_[k] : normal_blends_[k];
      for (int c = 0; c < 3; ++c) {
        const Mat3<R> axis = cross_matrix(Vec3<R>(Mat3<R>::Identity().col(c)));
        blend.of_global.col(c) = nearest.of(Mat3<R>(other * axis * all.rotation));
        blend.of_local.col(c) = nearest.of(Mat3<R>(share * axis * local));
      }
    }
  } else {
    make_local(rest, from, posed, unit);
    const Blend local{Mat3<R>::Zero(), Mat3<R>::Identity()};
    vertex_blends_.assign(posed.size(), local);
    normal_blends_.assign(places.size(), local);
  }
  if (options.blend > 0) {
    local_stretches_.rows = places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto corners = rest.vertices_of(places[i].element);
      const std::array<Vec3<R>, 4> gradients = stretch_gradients(Stretch::Mean, rest, given, places[i]);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        Mat3<R> slope = Mat3<R>::Zero();
        slope.row(0) = gradients[k].transpose();
        local_stretches_.parts.push_back({i, corners[k], slope});
      }
    }
  }
  Mat3<R> sides = Mat3<R>::Zero();
  if (d == 2) sides(2, 2) = 1;
  Vec3<R> uneven = Vec3<R>::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3<R> normal = in_three<R>(turns.of_normals[i]) * rest_normal(rest, from, unit, places[i], i);
    const R area = area_vector(rest, from, places[i]).norm();
    tractions_.push_back({normal, area, turns.stretches[i]});
    sides += area * normal * normal.transpose();
    uneven += area * factor_ * turns.stretches[i] * normal;
  }
  if (!balance_) return;
  sides_inverse_ = Eigen::PartialPivLU<Mat3<R>>(sides).solve(Mat3<R>::Identity());
  xi_ = sides_inverse_ * uneven;
}

template <Scalar R>
void CorotationSlopes<R>::make_local(const CageElements& rest, const std::vector<Vec3<R>>& from,
                                     const std::vector<Vec3<R>>& posed, const R& unit) {
  local_normals_ = normal_turn_slopes(rest, from, posed);
  local_vertices_ = vertex_turn_slopes(rest, from, local_normals_);
  for (TurnSlopes<R>* turns : {&local_normals_, &local_vertices_})
    for (auto& part : turns->slopes.parts) part.slope /= unit;
}

template <Scalar R>
auto CorotationSlopes<R>::along(const std::vector<Vec3<R>>& change) const -> Rows {
  const auto first = [](const std::vector<Vec3<R>>& rows) { return rows.empty() ? Vec3<R>(Vec3<R>::Zero()) : rows[0]; };
  const Vec3<R> turn = first(global_turn_.times(change));
  const R stretch = first(global_stretch_.times(change))[0];
  const auto blended = [&](const std::vector<Blend>& blends, const TurnSlopes<R>& local) {
    std::vector<Vec3<R>> found;
    const std::vector<Vec3<R>> own = local.slopes.times(change);
    for (std::size_t i = 0; i < blends.size(); ++i) {
      found.push_back(blends[i].of_global * turn);
      if (!own.empty()) found.back() += blends[i].of_local * own[i];
    }
    return found;
  };
  Rows found{blended(vertex_blends_, local_vertices_), blended(normal_blends_, local_normals_), {}};
  const std::vector<Vec3<R>> own = local_stretches_.times(change);
  std::vector<R> stretches;
  for (std::size_t i = 0; i < tractions_.size(); ++i)
    stretches.push_back((1 - local_share_) * stretch + (own.empty() ? R(0) : R(local_share_ * own[i][0])));
  Vec3<R> uneven = Vec3<R>::Zero();
  std::vector<Vec3<R>> normals;
  for (std::size_t i = 0; i < tractions_.size(); ++i) {
    const auto& [m, area, s] = tractions_[i];
    normals.push_back(found.of_normals[i].cross(m));
    const Vec3<R> without = factor_ * (stretches[i] * m + s * normals[i]);
    found.tractions.push_back(without);
    uneven += area * (without - normals[i] * m.dot(xi_) - m * normals[i].dot(xi_));
  }
  if (!balance_) return found;
  const Vec3<R> xi = sides_inverse_ * uneven;
  for (std::size_t i = 0; i < tractions_.size(); ++i) {
    const Vec3<R>& m = tractions_[i].normal;
    found.tractions[i] -= normals[i] * m.dot(xi_) + m * (normals[i].dot(xi_) + m.dot(xi));
  }
  return found;
}

template <Scalar R>
void CorotationSlopes<R>::add_back(const Rows& weights, std::vector<Vec3<R>>& vertices) const {
  std::vector<Vec3<R>> of_normals = weights.of_normals, of_stretches = zeros<R>(tractions_.size());
  Vec3<R> left = Vec3<R>::Zero();
  for (std::size_t i = 0; balance_ && i < tractions_.size(); ++i)
    left -= tractions_[i].normal * tractions_[i].normal.dot(weights.tractions[i]);
  left = sides_inverse_ * left;
  R of_stretch = 0;
  for (std::size_t i = 0; i < tractions_.size(); ++i) {
    const auto& [m, area, s] = tractions_[i];
    const Vec3<R> weight = weights.tractions[i] + area * left;
    const Vec3<R> of_normal = factor_ * s * weight - m.dot(xi_) * weight - weight.dot(m) * xi_;
    of_normals[i] += m.cross(of_normal);
    const R by_stretch = factor_ * weight.dot(m);
    of_stretches[i][0] = local_share_ * by_stretch;
    of_stretch += (1 - local_share_) * by_stretch;
  }
  Vec3<R> of_turn = Vec3<R>::Zero();
  const auto pull = [&](const std::vector<Blend>& blends, const std::vector<Vec3<R>>& given,
                        const TurnSlopes<R>& local) {
    std::vector<Vec3<R>> own;
    for (std::size_t i = 0; i < blends.size(); ++i) {
      of_turn += blends[i].of_global.transpose() * given[i];
      own.push_back(blends[i].of_local.transpose() * given[i]);
    }
    local.slopes.add_transposed(own, vertices);
  };
  pull(vertex_blends_, weights.of_vertices, local_vertices_);
  pull(normal_blends_, of_normals, local_normals_);
  local_stretches_.add_transposed(of_stretches, vertices);
  global_turn_.add_transposed(std::vector<Vec3<R>>{of_turn}, vertices);
  global_stretch_.add_transposed(std::vector<Vec3<R>>{Vec3<R>(of_stretch, R(0), R(0))}, vertices);
}

template class CorotationSlopes<double>;
template class CorotationSlopes<Mp50>;

}  // namespace cageproof::deformation
