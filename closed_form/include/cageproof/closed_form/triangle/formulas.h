// SPDX-License-Identifier: MIT
// The catalogue's triangle formulas in terms of moments, whatever computes these: one struct a formula.
//
// Each: `components`, `degree` of homogeneity, `extra` (derivatives of the moments beyond the formula's own), `border_order` (the first
// derivative without a limit on the triangle's border), `on_border` (what happens to it there), `far_power` (the steepest power of r in its moments), and
// `compose(moments, parameters, out)` for the moments of EdgeForm or FarForm.
#pragma once

#include "cageproof/closed_form/taylor.h"
#include "cageproof/closed_form/triangle/edge_integrals.h"

#include <span>

namespace cageproof::closed_form {

/// What the first order without a limit does on the border: it depends on the direction of approach; it diverges like the logarithm of the
/// distance, all else having a limit from inside; or it does both.
enum class OnBorder { NoLimit, Logarithm, LogarithmAndDirection };

/// psi_t = int 1/(4 pi r) ([T24] Eq 5; edge form): a length. Finite everywhere; on the triangle its gradient is the limit from inside, on the
/// border infinite against the edges' outward normals.
struct SingleLayer {
  static constexpr int components = 1, degree = 1, extra = 0, border_order = 1, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::Logarithm;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 1>& out) {
    out[0].add(R(1) / (R(4) * constant_pi<R>()), s.J());
  }
};

/// phi_t^k = int Gamma_k x.n/(4 pi r^3), the harmonic double layer of the three hat functions ([T24] Eq 5; edge form): unitless.
/// On the triangle: the limit from inside, Gamma_k/2 within; derivatives have none on the border. The gradient is that of this one
/// triangle's phi, not the "curl form" that is right only summed over a closed cage.
struct DoubleLayer {
  static constexpr int components = 3, degree = 0, extra = 0, border_order = 1, far_power = -3;
  static constexpr OnBorder on_border = OnBorder::NoLimit;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto b = s.B();
    for (int k = 0; k < 3; ++k) out[k].add(R(1) / (R(4) * constant_pi<R>()), b[k]);
  }
};

/// omega_t = int x.n/r^3, the solid angle ([T24] Appendix A, sign after the errata; edge form): in (-2 pi, 2 pi], positive inside a cage.
/// On the triangle: the limit from inside, 2 pi within, pi on an edge, the corner's angle at a corner.
struct SolidAngle {
  static constexpr int components = 1, degree = 0, extra = 0, border_order = 1, far_power = -3;
  static constexpr OnBorder on_border = OnBorder::NoLimit;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 1>& out) {
    out[0].add(R(1), s.omega());
  }
};

/// psibar_t = int r/(8 pi) ([T24] Eq 9-14; edge form): a volume. Finite everywhere with its gradient and Hessian.
struct BiharmonicSingleLayer {
  static constexpr int components = 1, degree = 3, extra = 0, border_order = 3, far_power = 1;
  static constexpr OnBorder on_border = OnBorder::NoLimit;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 1>& out) {
    out[0].add(R(1) / (R(8) * constant_pi<R>()), s.I());
  }
};

/// phibar_t^k = int -Gamma_k x.n/(8 pi r) = d psi_t^k/2 ([T24] Eq 15-18; edge form): an area. Zero in the triangle's plane, with a finite
/// gradient everywhere; on the border the Hessian is infinite where the logarithm of the distance enters it, and NaN elsewhere.
struct BiharmonicDoubleLayer {
  static constexpr int components = 3, degree = 2, extra = 0, border_order = 2, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::LogarithmAndDirection;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto a = s.A();
    const R c = R(1) / (R(8) * constant_pi<R>());
    const auto& n = s.frame().n;
    for (int k = 0; k < 3; ++k) out[k].add_linear(c * s.frame().d, Vec3<R>(c * n[0], c * n[1], c * n[2]), a[k]);
  }
};

/// psi_t^k = int Gamma_k/(4 pi r), the single layer of the hat functions ([T24] Eq 43-46; edge form): a length. As psi_t on the triangle.
struct AffineSingleLayer {
  static constexpr int components = 3, degree = 1, extra = 0, border_order = 1, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::Logarithm;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto a = s.A();
    for (int k = 0; k < 3; ++k) out[k].add(R(1) / (R(4) * constant_pi<R>()), a[k]);
  }
};

/// The shares of [T24] Eq 48's constants: 2b/a = 1/(2 (1 - nu)) and (a - 2b)/a = (1 - 2 nu)/(2 (1 - nu)), each without cancellation; 0 and 1 in the
/// limit of an infinite Poisson ratio.
template <class R>
struct KelvinShares {
  R bulk, shear;

  explicit KelvinShares(const R& nu) : bulk(0), shear(1) {
    if (nu == nu + R(1)) return;
    bulk = R(1) / (R(2) * (R(1) - nu));
    shear = (R(1) - R(2) * nu) * bulk;
  }
};

/// K_t = int (a - b)/r I + b x x'/r^3 = a J I - b Hess I, row by row ([T24] Eq 47-49, [C23] Eq 3; edge form): a length over a modulus.
/// Parameters mu > 0 and nu < 1/2, with the limits 1/2 and +-infinity. Finite everywhere; on the border
/// the gradient is infinite where the logarithm of the distance enters it, and NaN elsewhere.
struct KelvinDisplacement {
  static constexpr int components = 9, degree = 1, extra = 2, border_order = 1, far_power = -1;
  static constexpr OnBorder on_border = OnBorder::LogarithmAndDirection;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R> parameters, std::array<Taylor<R, N>, 9>& out) {
    const R a = R(1) / (R(4) * constant_pi<R>() * parameters[0]);
    const R b = a * KelvinShares<R>(parameters[1]).bulk / R(2);
    const auto j = s.J();
    const auto i = s.I();
    for (int row = 0; row < 3; ++row) {
      const auto slope = derivative(i, row);
      for (int column = row; column < 3; ++column) {
        Taylor<R, N>& entry = out[3 * row + column];
        entry.add(-b, derivative(slope, column));
        if (row == column) entry.add(a, j);
        out[3 * column + row] = entry;
      }
    }
  }
};

/// The limit from inside of d Hess J on the triangle's border, where the edge form leaves it out: K3 d^2 and S3 |d| of the edges that the point lies
/// on remain. Zero elsewhere.
template <class R>
std::array<R, 9> border_height_hessian(const Frame<R>& f) {
  std::array<R, 9> m{};
  for (const FrameEdge<R>& e : f.edges) {
    if (!on_edge(e)) continue;
    const bool starts = e.r0 == R(0), ends = e.r1 == R(0);
    const R across(starts || ends ? 1 : 2);
    const R along = R(starts ? 1 : ends ? -1 : 0) / R(2);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        m[3 * i + j] += across * (f.n[i] * e.nu[j] + e.nu[i] * f.n[j]) + along * (e.nu[i] * e.u[j] + e.u[i] * e.nu[j]);
  }
  return m;
}

/// T_t^k = int Gamma_k mu ((a-2b)(x.n I + n x' - x n')/r^3 + 6b x.n x x'/r^5)
///       = mu (a B I + (a - 2b)(n (grad A)' - (grad A) n') - 2b d Hess A), row by row ([T24] Eq 47-49 with the factor mu of the errata, [C23]
/// Eq 4; edge form): unitless, independent of mu. Parameters as K_t. On the triangle: the limit from inside; on its border the entries
/// that the logarithm of the distance enters are infinite, the others limits from inside. Summed over a closed cage the logarithms cancel.
struct KelvinTraction {
  static constexpr int components = 27, degree = 0, extra = 2, border_order = 0, far_power = -3;
  static constexpr OnBorder on_border = OnBorder::Logarithm;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R> parameters, std::array<Taylor<R, N>, 27>& out) {
    const KelvinShares<R> shares(parameters[1]);
    const R c = R(1) / (R(4) * constant_pi<R>());
    const R shear = c * shares.shear, bulk = -c * shares.bulk;
    const auto& n = s.frame().n;
    const Vec3<R> tilt(bulk * n[0], bulk * n[1], bulk * n[2]);
    const auto a = s.A();
    const auto b = s.B();
    const std::array<R, 9> border = border_height_hessian(s.frame());
    for (int k = 0; k < 3; ++k) {
      const std::array slope{derivative(a[k], 0), derivative(a[k], 1), derivative(a[k], 2)};
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
          Taylor<R, N>& entry = out[9 * k + 3 * row + column];
          entry.c[0] += bulk * s.frame().hat(k) * border[3 * row + column];
          entry.add_linear(bulk * s.frame().d, tilt, derivative(slope[row], column));
          if (row == column) {
            entry.add(c, b[k]);
          } else {
            entry.add(shear * n[row], slope[column]);
            entry.add(-shear * n[column], slope[row]);
          }
        }
    }
  }
};

/// w_t^k = int Gamma_k x.n/r^4, the unnormalised mean value weights ([T18] Eq 11; equal to Eq 12-14): 1/length. On the triangle they diverge:
/// infinite where the hat function is positive, and their ratios tend to the hat functions. In the plane outside it they are zero.
struct MeanValue {
  static constexpr int components = 3, degree = -1, extra = 0, border_order = 0, far_power = -4;
  static constexpr OnBorder on_border = OnBorder::NoLimit;
  template <class S, class R, int N>
  static void compose(const S& s, std::span<const R>, std::array<Taylor<R, N>, 3>& out) {
    const auto w = s.mean_value();
    for (int k = 0; k < 3; ++k) out[k].add(R(1), w[k]);
  }
};

}  // namespace cageproof::closed_form
