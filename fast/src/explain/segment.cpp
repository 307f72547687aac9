// SPDX-License-Identifier: MIT
// The segment's closed forms in numbers that count: as the triangle's, geometry is taken over as a whole.
#include "cageproof/adaptive_qmvc/counted_rule.h"
#include "cageproof/closed_form/explain.h"
#include "cageproof/closed_form/segment/affine_single_layer.h"
#include "cageproof/closed_form/segment/biharmonic_double_layer.h"
#include "cageproof/closed_form/segment/biharmonic_single_layer.h"
#include "cageproof/closed_form/segment/double_layer.h"
#include "cageproof/closed_form/segment/kelvin_displacement.h"
#include "cageproof/closed_form/segment/kelvin_traction.h"
#include "cageproof/closed_form/segment/mean_value.h"
#include "cageproof/closed_form/segment/polyharmonic_double_layer.h"
#include "cageproof/closed_form/segment/polyharmonic_single_layer.h"
#include "cageproof/closed_form/segment/single_layer.h"
#include "cageproof/closed_form/segment/winding_angle.h"
#include "segment/hybrid.h"

namespace cageproof::closed_form::segment {

template <>
Counted shifted<Counted>(const Counted& x, int exponent) {
  return ldexp(x, exponent);
}

namespace {

constexpr const char* kFile = "closed_form/include/cageproof/closed_form/segment/engine/exact_frame.h";

Counted seen(double value, const Mp200& exact, const char* name) { return Counted::seen(value, exact, name, kFile); }

}  // namespace

template <>
Counted scaled_exponential<Counted>(long double x, int shift) {
  const auto high = static_cast<double>(x), low = static_cast<double>(x - high);
  return Counted::seen(scaled_exponential<double>(x, shift), ldexp(exp(Mp200(Mp200(high) + Mp200(low))), shift),
                       "constant: where the kernel vanishes",
                       "closed_form/include/cageproof/closed_form/segment/engine/radial_moments.h");
}

// Frames of 200 digits have the exponents zero.
template <>
Frame<Counted>::Frame(const Segment<Counted>& segment, const Vec3<Counted>& eta) {
  const auto plain = [](const Vec3<Counted>& v) { return Vec3<double>(v[0].value, v[1].value, v[2].value); };
  const std::array<Vec3<double>, 3> v{plain(segment[0]), plain(segment[1]), plain(eta)};
  const Frame<double> f({v[0], v[1]}, v[2]);
  const Frame<Mp200> x({convert<Mp200>(v[0]), convert<Mp200>(v[1])}, convert<Mp200>(v[2]));
  const auto in_units = [&f](const Mp200& number) { return ldexp(number, -f.exponent); };
  for (int i = 0; i < 2; ++i) {
    u[i] = seen(f.u[i], x.u[i], "frame: u");
    s[i] = seen(f.s[i], in_units(x.s[i]), "frame: s");
    r[i] = seen(f.r[i], in_units(x.r[i]), "frame: r");
    log_r[i] = seen(f.log_r[i], Mp200(x.log_r[i] - f.exponent * MpConstants<200>::ln_two()), "frame: log_r");
  }
  n = {u[1], -u[0]};
  way = f.way;
  length = seen(f.length, in_units(x.length), "frame: length");
  sum = seen(f.sum, in_units(x.sum), "frame: sum");
  h = seen(f.h, in_units(x.h), "frame: h");
  log_ratio = seen(f.log_ratio, x.log_ratio, "frame: log_ratio");
  angle = seen(f.angle, x.angle, "frame: angle");
  exponent = f.exponent;
  near_end = f.near_end;
  at_end = f.at_end;
  // Of two ends that are all but equally near, 200 digits may take the other one.
  const Mp200& distance = x.r[near_end];
  const Complex<Mp200> direction =
      near_end == x.near_end ? x.near : Complex<Mp200>{x.s[near_end] / distance, -x.h / distance};
  near = {seen(f.near.re, direction.re, "frame: near.re"), seen(f.near.im, direction.im, "frame: near.im")};
  near_mantissa = seen(f.near_mantissa, ldexp(distance, -f.near_exponent), "frame: near_mantissa");
  near_exponent = f.near_exponent;
}

}  // namespace cageproof::closed_form::segment

namespace cageproof::fast::segment {

using namespace closed_form;

namespace {

template <class F, int O>
Explanation explain_order(const Query<double>& query, std::span<const double> values,
                          std::optional<std::size_t> entry) {
  const Segment<double> ends{query.corners[0], query.corners[1]};
  Explanation explanation;
  if (!hybrid<F, O>(SeenSegment(ends, query.point), query.parameters, query.finite_part)) {
    explanation.route = "none in double: the point is extreme";
    choose_none(explanation, values, entry);
    return explanation;
  }
  const CountedTape tape;
  const FarFrame<Counted> frame({convert<Counted>(ends[0]), convert<Counted>(ends[1])}, convert<Counted>(query.point));
  const auto jet = jet_at<F, O>(frame, query.parameters, query.finite_part);
  std::vector<Counted> counted;
  counted.reserve(values.size());
  for (int c = 0; c < F::components; ++c) {
    if (O == 0) counted.push_back(jet.value[c]);
    for (int i = 0; i < 2; ++i) {
      if (O == 1) counted.push_back(jet.gradient[c][i]);
      for (int j = 0; O == 2 && j < 2; ++j) counted.push_back(jet.hessian[c](i, j));
    }
  }
  choose(explanation, tape, counted, 0, values, entry);
  explanation.route = frame.is_far() ? "the form far away, in double" : "the form nearby, in double";
  return explanation;
}

template <class F>
Explanation explain_form(const Query<double>& query, std::span<const double> values, std::optional<std::size_t> entry) {
  if (query.order == 0) return explain_order<F, 0>(query, values, entry);
  if (query.order == 1) return explain_order<F, 1>(query, values, entry);
  return explain_order<F, 2>(query, values, entry);
}

const RegisterExplainer explainers[] = {
    {"segment.single_layer", &explain_form<SingleLayer>},
    {"segment.double_layer", &explain_form<DoubleLayer>},
    {"segment.affine_single_layer", &explain_form<AffineSingleLayer>},
    {"segment.biharmonic_single_layer", &explain_form<BiharmonicSingleLayer>},
    {"segment.biharmonic_double_layer", &explain_form<BiharmonicDoubleLayer>},
    {"segment.kelvin_displacement", &explain_form<KelvinDisplacement>},
    {"segment.kelvin_traction", &explain_form<KelvinTraction>},
    {"segment.mean_value", &explain_form<MeanValue>},
    {"segment.polyharmonic_single_layer", &explain_form<PolyharmonicSingleLayer>},
    {"segment.polyharmonic_double_layer", &explain_form<PolyharmonicDoubleLayer>},
    {"segment.winding_angle", &explain_form<WindingAngle>},
};

}  // namespace
}  // namespace cageproof::fast::segment
