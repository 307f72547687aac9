// SPDX-License-Identifier: MIT
// The numbered equations of the paper's scheme at one point ([T18] Algorithms 1 and 2), in the order of Algorithm 2.
#pragma once

#include "quad/bilinear_basis.h"
#include "quad/mean_value/riemann/riemann.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "cageproof/core/catalogue/steps.h"

#include <tuple>

namespace cageproof::adaptive_qmvc {

/// Gathers steps, in the unit of length of the caller's coordinates.
template <Scalar R>
class SchemeSteps {
 public:
  SchemeSteps(const Quad<R>& q, const Vec3<R>& point, int n, const PoleGuard& guard)
      : q_(q), point_(point), n_(n), guard_(guard), s_(q, point), kappa_(null_vector(s_)) {}

  std::vector<Step<R>> all() {
    add_system();
    const QuadContact contact = quad_contact(q_, point_, kappa_);
    if (contact.on) {
      const auto& on = *contact.on;
      add("uv", "[T18] Eq 19 and Section 3.3", 0, std::vector<R>{R(on.u), R(on.v)});
      add("basis", "[T18] Eq 3", 0, std::vector<R>{R(on.basis[0]), R(on.basis[1]), R(on.basis[2]), R(on.basis[3])});
    } else if (!contact.in_plane) {
      add_projection();
      add_sum();
      bool wide = false;
      if constexpr (std::same_as<R, double>) wide = is_far(s_);
      if (wide) {
        const PairFrame<Mp50> frame = wide_frame(q_, point_);
        add_solution<Mp50>(frame, parts_from<Mp50>(frame, null_vector(frame), wide_sum(omega_, s_, frame), guard_));
      } else {
        add_solution<R>(s_, parts_from<R>(s_, kappa_, omega_, guard_));
      }
    }
    return std::move(steps_);
  }

 private:
  void add(const char* name, const char* source, int length, std::vector<R> values) {
    steps_.push_back({name, source, length, std::move(values)});
  }

  // A vector in a frame's unit, whose entries are of that power of length.
  template <class S, class Vector>
  void add_scaled(const char* name, const char* source, int length, const Vector& v, const S& unit) {
    std::vector<R> values;
    S scale = 1;
    for (int k = 0; k < length; ++k) scale *= unit;
    for (int k = 0; k > length; --k) scale /= unit;
    for (Eigen::Index i = 0; i < v.size(); ++i) values.push_back(static_cast<R>(S(v[i] * scale)));
    add(name, source, length, std::move(values));
  }

  void add_system() {
    std::vector<R> a;
    for (int row = 0; row < 3; ++row)
      for (int k = 0; k < 4; ++k) a.push_back(q_[k][row] - point_[row]);
    add("A_q", "[T18] Eq 17", 1, std::move(a));
    add_scaled("kappa", "[T18] Eq 26, spans Eq 18's kernel", 3, kappa_, s_.unit);
    add_sides();
    add_scaled("m_q", "[T18] Eq 16", 0, mean_vector(s_), s_.unit);
  }

  // What Eq 16 sums: a side's angle, and the normal of its plane, which points as the paper has it.
  void add_sides() {
    using std::atan2;
    Eigen::Matrix<R, 4, 1> theta;
    Eigen::Matrix<R, 12, 1> normals;
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4;
      const Vec3<R> n = i == k03 ? Vec3<R>(s_.cross[i]) : Vec3<R>(-s_.cross[i]);
      normals.template segment<3>(3 * i) = n;
      theta[i] = atan2(R(n.norm()), R(s_.p[i].dot(s_.p[next])));
    }
    add_scaled("theta", "[T18] Eq 16, angles at the point", 0, theta, s_.unit);
    add_scaled("N_i", "[T18] Eq 16, a row per side", 2, normals, s_.unit);
  }

  void add_projection() {
    const bool inside = inside_hull(kappa_);
    const Vec3<R> step = inside ? Vec3<R>(Vec3<R>::Zero()) : to_hull(s_, kappa_);
    add_scaled("hull_point", "[T18] Eq 25, Algorithm 1 line 10", 1, Vec3<R>(point_ + s_.unit * step), R(1));
    add_scaled("hull_mean_vector", "[T18] Algorithm 1 line 11", 0, mean_vector(inside ? s_ : s_.moved(step)), R(1));
    std::tie(u_, v_) = project(s_, kappa_);
    add("uv", "[T18] Algorithm 1 line 13", 0, {u_, v_});
    Vec3<R> x = Vec3<R>::Zero();
    const Basis<R> basis = bilinear_basis(u_, v_);
    for (int k = 0; k < 4; ++k) x += basis[k] * q_[k];
    add_scaled("projection", "[T18] Eq 2, Algorithm 1 line 12", 1, x, R(1));
    const Vec3<R> twist = s_.along[k12] - s_.along[k03];
    add_scaled("normal", "[T18] Eq 4, N(u, v) there", 2,
               Vec3<R>(Vec3<R>(s_.along[k01] + v_ * twist).cross(Vec3<R>(s_.along[k03] + u_ * twist))), s_.unit);
  }

  void add_sum() {
    RiemannWorkspace<R> work;
    omega_ = omega(s_, n_, u_, v_, work);
    const auto counted = [](const std::vector<R>& padded, int count) {
      return std::vector<R>(padded.begin(), padded.begin() + count);
    };
    add("grid_u", "[T18] Section 3.4.3", 0, counted(work.u.at, work.u.count));
    add("grid_v", "[T18] Section 3.4.3", 0, counted(work.v.at, work.v.count));
    add("delta_u", "[T18] Section 3.4.3", 0, counted(work.u.length, work.u.count));
    add("delta_v", "[T18] Section 3.4.3", 0, counted(work.v.length, work.v.count));
    std::vector<R> solid;
    for (int k = 0; k < work.u.count; ++k)
      for (int l = 0; l < work.v.count; ++l) solid.push_back(solid_angle_of_cell(work, k, l));
    add("dB", "[T18] Eq 23, cell k l at k (2n + 1) + l", 0, std::move(solid));
    add_scaled("Omega", "[T18] Eq 22", -1, omega_, s_.unit);
  }

  R solid_angle_of_cell(const RiemannWorkspace<R>& work, int k, int l) const {
    const R &u = work.u.at[k], &v = work.v.at[l];
    const Vec3<R> twist = s_.along[k12] - s_.along[k03];
    const Vec3<R> along_u = s_.along[k01] + v * twist, along_v = s_.along[k03] + u * twist;
    const Vec3<R> x = s_.p[0] + u * s_.along[k01] + v * along_v;
    const R r = x.norm();
    return R(along_u.cross(along_v).dot(x)) / (r * r * r) * (work.u.length[k] * work.v.length[l]);
  }

  template <Scalar S>
  void add_solution(const PairFrame<S>& s, const SchemeParts<S>& parts) {
    const S& unit = s.unit;
    const auto one = [](const S& x) { return Eigen::Matrix<S, 1, 1>(x); };
    add_scaled("minimal_norm", "[T18] Eq 20, by Eq 28 with D = -|kappa|^2", -1, parts.minimal_norm, unit);
    add_scaled("lambda_uncorrected", "[T18] Eq 21 of Omega", -4, one(parts.lambda.uncorrected), unit);
    add_scaled("norm_correction", "[T18] Eq 24, second factor", 0, one(parts.lambda.correction), unit);
    add_scaled("lambda_printed", "[T18] Eq 24", -4, one(S(parts.lambda.uncorrected * parts.lambda.correction)), unit);
    add_scaled("trust", "ours: share of the correction that is taken", 0, one(parts.lambda.trust), unit);
    add_scaled("lambda", "what this evaluation takes", -4, one(parts.lambda.value()), unit);
    add_scaled("weights", "[T18] Algorithm 2 line 31", -1, parts.weights, unit);
    const Vec4<S> exact = unit * exact_weights<S>();
    add_scaled("exact_weights", "[T18] Eq 11, by line_form", -1, exact, unit);
    add_scaled("exact_lambda", "[T18] Eq 21", -4, one(S(exact.dot(parts.kappa) / parts.kappa.squaredNorm())), unit);
  }

  template <Scalar S>
  Vec4<S> exact_weights() const {
    std::array<Vec3<S>, 4> corners;
    for (int k = 0; k < 4; ++k) corners[k] = convert<S>(q_[k]);
    Result<S> result;
    evaluation_named("quad.mean_value", "line_form")(Query<S>{corners, convert<S>(point_)}, result);
    return {result.value[0], result.value[1], result.value[2], result.value[3]};
  }

  const Quad<R>& q_;
  Vec3<R> point_;
  int n_;
  PoleGuard guard_;
  PairFrame<R> s_;
  Vec4<R> kappa_;
  R u_{}, v_{};
  Vec4<R> omega_ = Vec4<R>::Zero();
  std::vector<Step<R>> steps_;
};

}  // namespace cageproof::adaptive_qmvc
