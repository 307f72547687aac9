// SPDX-License-Identifier: MIT
// Registers the solid angle of a bilinear quad.
#include "solid_angle.h"

#include "quad/mean_value/line_form/line_form.h"
#include "quad/potentials/potential_form.h"
#include "cageproof/core/catalogue/evaluation.h"
#include "inside_step.h"
#include "line_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cageproof::adaptive_qmvc {
namespace {

std::array<Vec3<Mp50>, 4> in_50_digits(std::span<const Vec3<double>> corners) {
  std::array<Vec3<Mp50>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = convert<Mp50>(corners[k]);
  return wide;
}

// Values that are smaller than their terms by more than this factor are taken in 50 digits.
constexpr double kNextToZero = 16;

// The value: the sum of the two triangles that the point sees under the quad's own solid angle. Where they cancel in
// double, as next to a twisted quad's zeros, it is taken in 50 digits.
template <Scalar R>
R value_of(std::span<const Vec3<R>> corners, const Vec3<R>& point, bool other) {
  static const Evaluation triangle =
      *EvaluationRegister::instance().with_role("triangle.solid_angle", Role::Recommended);
  thread_local Result<R> part;
  R sum = R(0), sizes = R(0);
  for (int t = 0; t < 2; ++t) {
    // 0 1 2 and 0 2 3, or 1 2 3 and 1 3 0.
    const int first = other ? 1 : 0;
    const std::array<Vec3<R>, 3> of{corners[first], corners[first + 1 + t], corners[(first + 2 + t) % 4]};
    triangle(Query<R>{.corners = of, .point = point}, part);
    sum += part.value[0];
    sizes += part.value[0] < R(0) ? R(-part.value[0]) : part.value[0];
  }
  if constexpr (std::same_as<R, double>)
    if (std::abs(sum) < sizes / kNextToZero)
      return static_cast<double>(value_of<Mp50>(in_50_digits(corners), convert<Mp50>(point), other));
  return sum;
}

template <class R>
struct SolidAngle {
  R value;
  Vec3<R> gradient;
  Eigen::Matrix<R, 3, 3> hessian;
};

// The product of a side's start, seen from the point, and the side, in the frame's units. Doubles lose it next to the
// side's line.
template <class R>
Vec3<R> across_side(std::span<const Vec3<R>> corners, const Vec3<R>& point, const QuadFrame<R>& q, int k,
                    const Vec3<R>& side) {
  constexpr double enough = 0x1p-8;
  const Vec3<R>& start = q.seen[k];
  Vec3<R> rough = start.cross(side);
  if constexpr (std::same_as<R, double>)
    if (rough.squaredNorm() < enough * enough * start.squaredNorm() * side.squaredNorm()) {
      const auto wide = [&](int i) { return convert<Mp200>(corners[q.unit.corner[i]]); };
      const Vec3<Mp200> first = wide(k), from = first - convert<Mp200>(point), along = wide((k + 1) % 4) - first;
      return convert<double>(Vec3<Mp200>(from.cross(along) * ldexp(Mp200(1), -2 * q.unit.exponent)));
    }
  return rough;
}

// How many times as large as their sum the sides' parts may be: multiprecision has digits to spare.
template <class R>
R most_cancelled() {
  if constexpr (std::same_as<R, Mp800>) return ldexp(R(1), 2000);
  return std::same_as<R, double> ? R(16) : std::same_as<R, Mp50> ? R(1e10) : std::same_as<R, Mp100> ? R(1e40) : R(1e90);
}

// Around the sides. False where their parts are more than `most` times as large as their sum.
template <class R>
bool derive_by_sides(std::span<const Vec3<R>> corners, const Vec3<R>& point, const QuadFrame<R>& q, int order,
                     SolidAngle<R>& result, const R& most = most_cancelled<R>()) {
  using std::isfinite, std::ldexp;
  constexpr double digits = std::same_as<R, double>  ? 17
                            : std::same_as<R, Mp50>  ? 48
                            : std::same_as<R, Mp100> ? 98
                                                     : 198;
  const std::array<Vec3<R>, 4> sides{q.e, q.b1, Vec3<R>(-q.e1), Vec3<R>(-q.b)};
  result.gradient.setZero();
  result.hessian.setZero();
  R gradients(0), hessians(0);
  for (int k = 0; k < 4; ++k) {
    const Vec3<R>&start = q.seen[k], &end = q.seen[(k + 1) % 4];
    Vec3<R> gradient = Vec3<R>::Zero();
    Eigen::Matrix<R, 3, 3> hessian = Eigen::Matrix<R, 3, 3>::Zero();
    const bool turned = end.dot(end) < start.dot(start);
    const Vec3<R> c = across_side<R>(corners, point, q, k, sides[k]);
    add_side_to_solid_angle<R>(turned ? end : start, turned ? Vec3<R>(-sides[k]) : sides[k], turned ? Vec3<R>(-c) : c,
                               order, digits, gradient, hessian);
    gradients += gradient.cwiseAbs().sum();
    hessians += hessian.cwiseAbs().sum();
    result.gradient += turned ? Vec3<R>(-gradient) : gradient;
    result.hessian += turned ? Eigen::Matrix<R, 3, 3>(-hessian) : hessian;
  }
  // A sum that overflows keeps no digits.
  const auto keeps = [&most](const R& terms, const R& sum) { return isfinite(terms) && terms <= most * sum; };
  const bool kept = keeps(gradients, R(result.gradient.cwiseAbs().sum())) &&
                    (order < 2 || keeps(hessians, R(result.hessian.cwiseAbs().sum())));
  result.gradient *= ldexp(R(q.unit.sign), -q.unit.exponent);
  result.hessian *= ldexp(R(q.unit.sign), -2 * q.unit.exponent);
  return kept;
}

// By sides in 800 digits, for derivatives that are all but zero by the quad's symmetry: what cancels to the last of
// these digits is zero.
template <Scalar R>
void derive_by_sides_in_800_digits(std::span<const Vec3<R>> corners, const Vec3<R>& point, int order,
                                   SolidAngle<R>& result) {
  std::array<Vec3<Mp800>, 4> wide;
  for (int k = 0; k < 4; ++k) wide[k] = corners[k].template cast<Mp800>();
  const Vec3<Mp800> from = point.template cast<Mp800>();
  const auto frame = quad_frame<Mp800>(wide, from);
  if (!frame) return;
  SolidAngle<Mp800> derived;
  for (int o = 1; o <= order; ++o) {
    const bool kept = derive_by_sides<Mp800>(wide, from, *frame, o, derived);
    if (o == 1) result.gradient = kept ? Vec3<R>(derived.gradient.template cast<R>()) : Vec3<R>(Vec3<R>::Zero());
    else result.hessian = derived.hessian.template cast<R>();
    if (o == 2 && !kept) result.hessian.setZero();
  }
}

// As 4 pi times the sum of the double layer's four numbers.
// \returns how many times as large as a derivative these are
template <Scalar R>
double derive_by_lines(std::span<const Vec3<R>> corners, const Vec3<R>& point, int order, SolidAngle<R>& result,
                       double digits = own_digits<R>()) {
  const PotentialTask<R> task{Potential::DoubleLayer, order, digits, {R(1), R(1)}};
  PotentialTensors<R> layers;
  potential_form<R>(corners, point, task, layers);
  const auto sum = [&](int o, int i) {
    const int size = static_cast<int>(layers.of[o].size()) / 4;
    return R(R(layers.of[o][i] + layers.of[o][size + i]) + R(layers.of[o][2 * size + i] + layers.of[o][3 * size + i]));
  };
  result.value = sum(0, 0);
  for (int i = 0; order >= 1 && i < 3; ++i) result.gradient[i] = sum(1, i);
  for (int i = 0; order >= 2 && i < 9; ++i) result.hessian(i / 3, i % 3) = sum(2, i);
  if constexpr (std::same_as<R, double>) {
    const bool finite = (order < 1 || result.gradient.allFinite()) && (order < 2 || result.hessian.allFinite());
    if (!finite) {
      // Corners may be infinite with different signs where their sum's sign is known.
      std::array<Vec3<Mp100>, 4> wide_corners;
      for (int k = 0; k < 4; ++k) wide_corners[k] = convert<Mp100>(corners[k]);
      SolidAngle<Mp100> wide;
      derive_by_lines<Mp100>(wide_corners, convert<Mp100>(point), order, wide, digits);
      if (order >= 1) result.gradient = convert<double>(wide.gradient);
      for (int i = 0; order >= 2 && i < 9; ++i)
        result.hessian(i / 3, i % 3) = static_cast<double>(wide.hessian(i / 3, i % 3));
      return 1;
    }
  }
  const auto cancelled = [&](int o, const R& of) {
    R terms(0);
    for (const R& x : layers.of[o]) terms += x < R(0) ? R(-x) : x;
    return terms > R(0) ? static_cast<double>(R(terms / of)) : 1.0;
  };
  double most = 1;
  if (order >= 1) most = std::max(most, cancelled(1, result.gradient.cwiseAbs().sum()));
  if (order >= 2) most = std::max(most, cancelled(2, result.hessian.cwiseAbs().sum()));
  return most;
}

// As derive_by_lines, and in more digits where the corners' derivatives cancel. \pre the point is off the quad
template <Scalar R>
void derive_by_lines_or_more(std::span<const Vec3<R>> corners, const Vec3<R>& point, int order, SolidAngle<R>& result) {
  constexpr double enough = std::same_as<R, double> ? 16 : 1e6;
  if (derive_by_lines<R>(corners, point, order, result) > enough)
    derive_by_sides_in_800_digits<R>(corners, point, order, result);
}

void round_derivatives(const SolidAngle<Mp50>& wide, int order, SolidAngle<double>& result) {
  if (order >= 1) result.gradient = convert<double>(wide.gradient);
  for (int i = 0; order >= 2 && i < 9; ++i)
    result.hessian(i / 3, i % 3) = static_cast<double>(wide.hessian(i / 3, i % 3));
}

// By lines in 50 digits, rounded once: where heights are roundings in double, or no doubles, as in a plane of three
// corners and at the ends of the exponent range. \pre the point is off the quad
void by_lines_in_50_digits(std::span<const Vec3<double>> corners, const Vec3<double>& point, int order,
                           SolidAngle<double>& result) {
  const bool in_plane = is_in_plane<double>(corners, point);
  result.value = 0;
  if (in_plane && order == 0) return;
  SolidAngle<Mp50> wide;
  derive_by_lines_or_more<Mp50>(in_50_digits(corners), convert<Mp50>(point), order, wide);
  if (!in_plane) result.value = static_cast<double>(wide.value);
  round_derivatives(wide, order, result);
}

// Derivatives depend on the border only: they are taken by sides, in more digits where these cancel, and then by lines.
template <Scalar R>
void derive(std::span<const Vec3<R>> corners, const Vec3<R>& point, const QuadFrame<R>& q, int order,
            SolidAngle<R>& result) {
  if (derive_by_sides<R>(corners, point, q, order, result)) return;
  if constexpr (std::same_as<R, double>) {
    const Mp50 enough(1e30);
    const auto wide_corners = in_50_digits(corners);
    const Vec3<Mp50> wide_point = convert<Mp50>(point);
    SolidAngle<Mp50> wide;
    const auto frame = quad_frame<Mp50>(wide_corners, wide_point);
    if (frame && derive_by_sides<Mp50>(wide_corners, wide_point, *frame, order, wide, enough))
      return round_derivatives(wide, order, result);
  }
  derive_by_lines_or_more<R>(corners, point, order, result);
}

template <Scalar R>
void solid_angle(std::span<const Vec3<R>> corners, const Vec3<R>& point, int order, SolidAngle<R>& result) {
  const Exponents exponents = exponents_of(corners, point);
  const auto q = quad_frame<R>(corners, point);
  // On the quad limits from inside; where exponents are far apart the lines have the digits and the range.
  const bool far_apart = exponents.are_extreme() || exponents.are_distant();
  const auto on = place_on_quad<R>(corners, point);
  if (!q || far_apart || on) {
    if (q && !on) {
      if constexpr (std::same_as<R, double>) by_lines_in_50_digits(corners, point, order, result);
      else derive_by_lines_or_more<R>(corners, point, order, result);
    } else {
      derive_by_lines<R>(corners, point, order, result);
      // Off the border derivatives do not jump.
      const bool within = q && on && std::ranges::all_of(on->basis, [](double x) { return x > 0; });
      if (order > 0 && within && !far_apart) derive<R>(corners, point, *q, order, result);
    }
    return;
  }
  using W = std::conditional_t<std::same_as<R, double>, double, Mp200>;
  Quad<W> quad;
  for (int k = 0; k < 4; ++k) quad[k] = convert<W>(corners[k]);
  if (order > 0) derive<R>(corners, point, *q, order, result);
  const SeenTriangles seen = seen_triangles(quad, convert<W>(point));
  if (seen != SeenTriangles::Coplanar) {
    const R value = value_of<R>(corners, point, seen == SeenTriangles::Diagonal13);
    // A triangle without area has none.
    if (value - value == R(0)) {
      result.value = value;
      return;
    }
  }
  if constexpr (std::same_as<R, double>) {
    SolidAngle<double> value;
    by_lines_in_50_digits(corners, point, 0, value);
    result.value = value.value;
  } else {
    SolidAngle<R> by_lines;
    derive_by_lines<R>(corners, point, 0, by_lines);
    result.value = by_lines.value;
  }
}

/// \param digits of the lines' form, where it is asked for; else the recommended evaluation
template <Scalar R>
void batch_of(const Batch<R>& batch, std::optional<double> digits, const BatchOutput<R>& output) {
  using W = std::conditional_t<std::same_as<R, float>, double, R>;
  std::array<Vec3<W>, 4> corners;
  for (int k = 0; k < 4; ++k) corners[k] = convert<W>(batch.corners[k]);
  SolidAngle<W> result;
  for (std::size_t p = 0; p < batch.points.size(); ++p) {
    const Vec3<W> point = convert<W>(batch.points[p]);
    if (digits) derive_by_lines<W>(corners, point, batch.order, result, *digits);
    else solid_angle<W>(corners, point, batch.order, result);
    const R value = static_cast<R>(result.value);
    output.put(p, 0, {&value, 1});
    output.state(p, {});
    if (batch.order < 1) continue;
    std::array<R, 9> numbers;
    for (int i = 0; i < 3; ++i) numbers[i] = static_cast<R>(result.gradient[i]);
    output.put(p, 1, {numbers.data(), 3});
    if (batch.order < 2) continue;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) numbers[3 * i + j] = static_cast<R>(result.hessian(i, j));
    output.put(p, 2, numbers);
  }
}

void set_solid_angle(Evaluation& made, std::optional<double> digits) {
  for (const ScalarKind kind : scalar_kinds)
    with_scalar(kind, [&]<Scalar R>() {
      made.set_batch<R>(
          [digits](const Batch<R>& batch, const BatchOutput<R>& output) { batch_of<R>(batch, digits, output); });
    });
}

const RegisterEvaluation closed_form{
    single_family("quad.solid_angle", "closed_form",
                  {.description = "two triangles, the diagonal by an exact predicate; derivatives around the sides",
                   .role = Role::Recommended,
                   .cost = CostClass::Direct,
                   .substitutes = {"", "", "line-14"}},
                  true, [](Evaluation& made) { set_solid_angle(made, std::nullopt); })};

const RegisterEvaluation of_digits{
    line_rule("quad.solid_angle", "4 pi times the double layer's line form to that many digits", &set_solid_angle)};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
