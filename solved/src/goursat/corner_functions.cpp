// SPDX-License-Identifier: MIT
#include "corner_functions.h"

#include <numbers>

namespace cageproof::solved::goursat {
namespace {

// At such an angle the solutions that vanish on both sides are polynomials.
bool is_flat(double angle) { return std::abs(angle - std::numbers::pi) < 1e-9; }

// A CornerExponent's function. z^(mu - 1) and w^(mu - 1) are given as p and q; with s = 1 for even functions, -1 for
// odd ones, and half = 1/2 or 1/(2 i):
//   r^(mu + 1) C((mu + 1) psi) = half (z^(mu + 1) + s w^(mu + 1)), r^(mu + 1) C((mu - 1) psi) = half z w (p + s q).
template <class R>
GoursatJet<R> clamped(const CornerExponent& e, const Complex<R>& z, const Complex<R>& p, const Complex<R>& q,
                      int order) {
  const Complex<R> mu{R(e.mu.real()), R(e.mu.imag())}, w = conj(z);
  const Complex<R> half = e.odd ? Complex<R>(R(0), R(-0.5)) : Complex<R>(R(0.5));
  const Complex<R> outer = half * Complex<R>(R(e.outer.real()), R(e.outer.imag()));
  const Complex<R> inner = half * Complex<R>(R(e.inner.real()), R(e.inner.imag()));
  const Complex<R> sq = e.odd ? -q : q, one(R(1));
  const Complex<R> zp = z * p, wq = w * sq;
  GoursatJet<R> f;
  f.value = outer * (z * zp + w * wq) + inner * (w * zp + z * wq);
  if (order >= 1) {
    f.z = outer * (mu + one) * zp + inner * (w * (mu * p) + wq);
    f.w = outer * (mu + one) * wq + inner * (zp + z * (mu * sq));
  }
  if (order >= 2) {
    const Complex<R> outward = outer * (mu + one) * mu, inward = inner * mu * (mu - one);
    f.zz = outward * p + inward * (w * p / z);
    f.zw = inner * mu * (p + sq);
    f.ww = outward * sq + inward * (z * sq / w);
  }
  return f;
}

}  // namespace

CornerFunctions::CornerFunctions(Equation equation, double angle, int terms)
    : equation_(equation), angle_(angle), terms_(terms) {
  if (equation == Equation::Biharmonic) {
    size_ = 2;
    if (!is_flat(angle)) exponents_ = clamped_exponents(angle, terms * std::numbers::pi / angle);
    for (const CornerExponent& e : exponents_) size_ += e.is_real() ? 1 : 2;
  } else {
    with_logarithm_ = std::abs(angle - std::numbers::pi) < 0.5;
    if (is_flat(angle)) terms_ = 0;
    size_ = terms_ + (with_logarithm_ ? 2 : 0);
  }
}

template <class R>
void CornerFunctions::put_biharmonic(const Complex<R>& z, const Complex<R>& log, const Complex<R>& turn,
                                     RowWriter<R>& rows) const {
  // psi Re z and psi Im z are the real parts of -i log(z) (z + w)/2 and -log(z) (z - w)/2.
  const Complex<R> w = conj(z), one(R(1)), half(R(0.5)), inverse = one / z, square = inverse * inverse;
  const Complex<R> minus_i(R(0), R(-1));
  for (const bool imaginary : {false, true}) {
    const Complex<R> factor = imaginary ? -half : minus_i * half;
    const R s = imaginary ? R(-1) : R(1);
    GoursatJet<R> f;
    f.value = factor * log * (z + s * w);
    f.z = factor * (log + inverse * (z + s * w));
    f.w = factor * (s * log);
    f.zz = factor * (R(2) * inverse - square * (z + s * w));
    f.zw = factor * (s * inverse);
    rows.put(in_frame(f, turn));
  }
  for (const CornerExponent& e : exponents_) {
    const Complex<R> power{R(e.mu.real() - 1), R(e.mu.imag())};
    const Complex<R> p = exp(power * log), q = e.is_real() ? conj(p) : exp(power * conj(log));
    const GoursatJet<R> f = in_frame(clamped(e, z, p, q, rows.order()), turn);
    if (e.is_real()) rows.put(f);
    else rows.put_both(f);
  }
}

template <class R>
void CornerFunctions::put_harmonic(const Complex<R>& z, const Complex<R>& log, const Complex<R>& turn,
                                   RowWriter<R>& rows) const {
  const Complex<R> one(R(1)), inverse = one / z;
  if (with_logarithm_) rows.put_both(in_frame(holomorphic(z * log, log + one, inverse), turn));
  // Im of (z exp(i omega/2))^lambda.
  const Complex<R> from_side = log + Complex<R>(R(0), R(angle_ / 2));
  for (int k = 1; k <= terms_; ++k) {
    const R lambda = R(k) * R(std::numbers::pi / angle_);
    const Complex<R> f = Complex<R>(R(0), R(-1)) * exp(lambda * from_side), df = lambda * (f * inverse);
    rows.put(in_frame(holomorphic(f, df, R(lambda - 1) * (df * inverse)), turn));
  }
}

template <class R>
void CornerFunctions::put(const Complex<R>& offset, const R& angle, const Complex<R>& turn, RowWriter<R>& rows) const {
  using std::log, std::sqrt;
  const Complex<R> logarithm{R(log(R(offset.re * offset.re + offset.im * offset.im)) / 2), angle};
  if (equation_ == Equation::Biharmonic) put_biharmonic(offset, logarithm, turn, rows);
  else put_harmonic(offset, logarithm, turn, rows);
}

#define CAGEPROOF_INSTANTIATE(R) \
  template void CornerFunctions::put<R>(const Complex<R>&, const R&, const Complex<R>&, RowWriter<R>&) const;
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::solved::goursat
