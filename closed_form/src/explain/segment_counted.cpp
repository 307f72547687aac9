// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/segment/engine/counted.h"

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
  // If both ends are almost equally near, the computation in 200 digits may choose the other one.
  const Mp200& distance = x.r[near_end];
  const Complex<Mp200> direction =
      near_end == x.near_end ? x.near : Complex<Mp200>{x.s[near_end] / distance, -x.h / distance};
  near = {seen(f.near.re, direction.re, "frame: near.re"), seen(f.near.im, direction.im, "frame: near.im")};
  near_mantissa = seen(f.near_mantissa, ldexp(distance, -f.near_exponent), "frame: near_mantissa");
  near_exponent = f.near_exponent;
}

Frame<Counted> as_tracked(const Frame<Counted>& seen) {
  Frame<Counted> f = seen;
  for (int i = 0; i < 2; ++i) f.log_r[i] = log(f.r[i]);
  f.h = -f.near.im * f.r[f.near_end];
  f.set_angle_and_ratio();
  return f;
}

}  // namespace cageproof::closed_form::segment
