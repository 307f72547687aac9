// SPDX-License-Identifier: MIT
#include "quad_cells.h"
#include "polynomial_zeros.h"

#include <complex>
#include <numbers>

namespace cageproof::quadrature_ref {
namespace {

using Complex = std::complex<double>;

constexpr int kDeepest = 200;
// Points of the largest rule.
constexpr double kMostPoints = 256;
// Points of a cell with a zero of r^2 in it, for all that doubles can say.
constexpr double kCannot = 1e18;
// Where zeros are looked at on the other variable's range.
constexpr std::array<double, 5> kSamples{0, .25, .5, .75, 1};

double number(const Mp50& x) { return static_cast<double>(x); }

// The largest ellipse with foci lo and hi without asinh(zero) of any branch.
double ellipse(const std::vector<Complex>& zeros, double lo, double hi) {
  double least = 1e6;
  const double middle = (lo + hi) / 2, half = (hi - lo) / 2;
  if (!(half > 0)) return least;
  const auto look = [&](const Complex& zero) {
    const Complex y = (zero - middle) / half;
    const double sum = std::abs(y + std::sqrt(y - 1.) * std::sqrt(y + 1.));
    least = std::min(least, std::max(sum, 1 / sum));
  };
  for (const Complex& zero : zeros) {
    look(zero);
    look(Complex(-zero.real(), std::acos(-1.) - std::abs(zero.imag())));
  }
  return least;
}

// log sinh x
double log_sinh(double x) { return x + std::log1p(-std::exp(-2 * x)) - std::numbers::ln2; }

// Gauss-Legendre's n for an integrand with poles at the ellipse, which inside grows like the sixth power of sinh: as a
// polynomial in short cells, and exponentially in long ones.
// Cells that hold a near-singularity must cost the more the nearer it is, or halving them would seem to gain nothing.
double points(double digits, double half, double largest) {
  double least = kCannot;
  for (double excess = .85 * (largest - 1); excess > 0; excess *= .7) {
    const double sum = 1 + excess;
    const double axis = half * (sum + 1 / sum) / 2;
    const double growth = half > 0 ? 6 * (log_sinh(axis) - log_sinh(half)) : 0;
    least = std::min(least, (digits + .4343 * growth) / (2 * std::log10(sum)));
    if (excess < .01) break;
  }
  return std::max(least, 4.);
}

class Planner {
 public:
  Planner(const PolarQuadFrame<Mp50>& frame, double digits, double longest, std::size_t most)
      : frame_(frame), digits_(digits), longest_(longest), most_(most) {}

  std::vector<PlannedCell> cells() {
    for (std::size_t k = 0; k < frame_.sectors.size(); ++k) {
      const double length = number(frame_.sectors[k].tau_length);
      const int count = std::max(1, static_cast<int>(std::ceil(length / longest_)));
      for (int i = 0; i < count; ++i)
        add_panel({.sector = static_cast<int>(k), .t_lo = fraction(i, count), .t_hi = fraction(i + 1, count)});
    }
    return std::move(cells_);
  }

 private:
  static double fraction(int i, int count) { return static_cast<double>(i) / count; }

  void add_panel(QuadCell panel) {
    double reach = 0;
    for (const double t : {0., .5, 1.}) reach = std::max(reach, number(length(ray(panel, t).direction)));
    panel.delta = number(frame_.distance) / reach;
    // Beyond that sinh is linear; and an edge of no length has no reach.
    if (!(panel.delta < 1e3)) panel.delta = 1e3;
    const int count = std::max(1, static_cast<int>(std::ceil(w_range(panel) / longest_)));
    for (int i = 0; i < count; ++i) {
      panel.w_lo = fraction(i, count);
      panel.w_hi = fraction(i + 1, count);
      plan(panel, 0);
    }
  }

  struct Ray {
    Vec3<Mp50> direction;
    Mp50 duv;
  };
  Ray ray(const QuadCell& cell, double t) const {
    const auto& sector = frame_.sectors[cell.sector];
    Mp50 sinh_tau, cosh_tau;
    sinh_cosh(Mp50(sector.tau + sector.tau_length * (cell.t_lo + t * (cell.t_hi - cell.t_lo))), sinh_tau, cosh_tau);
    const Mp50 s = sector.eps * sinh_tau;
    return {sector.to_edge + sector.edge * s, (sector.du + s * sector.step_u) * (sector.dv + s * sector.step_v)};
  }
  static double w_range(const QuadCell& cell) { return std::asinh(1 / cell.delta); }

  // Zeros of r^2 in w on a ray.
  void add_zeros_in_w(const QuadCell& cell, double t, std::vector<Complex>& zeros) const {
    const Ray r = ray(cell, t);
    const Vec3<Mp50>& x = frame_.at.base;
    const Vec3<Mp50>& d = r.direction;
    const Vec3<Mp50> bend = frame_.at.twist * r.duv;
    std::array<Mp50, 5> c{dot(x, x), 2 * dot(x, d), dot(d, d) + 2 * dot(x, bend), 2 * dot(d, bend), dot(bend, bend)};
    Mp50 scale = 1 / c[0];
    for (Mp50& coefficient : c) {
      coefficient *= scale;
      scale *= cell.delta;
    }
    for (const Complex& zero : polynomial_zeros(rounded(c))) zeros.push_back(std::asinh(off_axis(c, zero)));
  }

  static std::array<double, 5> rounded(const std::array<Mp50, 5>& c) {
    return {number(c[0]), number(c[1]), number(c[2]), number(c[3]), number(c[4])};
  }

  // A zero next to the real axis as its own foot there sees it: doubles hold eight digits of two that all but coincide.
  static Complex off_axis(const std::array<Mp50, 5>& c, Complex zero) {
    if (!(std::abs(zero.imag()) < 1e-5 * std::abs(zero.real()))) return zero;
    Mp50 foot = zero.real();
    double imaginary = zero.imag();
    for (int step = 0; step < 4; ++step) {
      std::array<Mp50, 5> shifted = c;  // the polynomial about the foot
      for (int i = 0; i < 4; ++i)
        for (int k = 3; k >= i; --k) shifted[k] += foot * shifted[k + 1];
      const std::array<double, 5> local = rounded(shifted);
      if (local[0] == 0) return {zero.real(), 0};
      const std::vector<Complex> near = polynomial_zeros(local);
      if (near.empty()) return zero;
      const Complex nearest = *std::ranges::min_element(near, {}, [](const Complex& z) { return std::abs(z); });
      foot += nearest.real();
      imaginary = nearest.imag();
      if (std::abs(nearest.real()) < std::abs(imaginary)) break;
    }
    return {number(foot), imaginary};
  }

  // Zeros of r^2 in tau at a radius.
  void add_zeros_in_t(const QuadCell& cell, double w, std::vector<Complex>& zeros) const {
    const auto& sector = frame_.sectors[cell.sector];
    const Mp50 rho = cell.delta * std::sinh(w_range(cell) * (cell.w_lo + w * (cell.w_hi - cell.w_lo)));
    const Mp50 square = rho * rho;
    const Vec3<Mp50> x = frame_.at.base + sector.to_edge * rho + frame_.at.twist * Mp50(square * sector.du * sector.dv);
    const Vec3<Mp50> d =
        sector.edge * rho + frame_.at.twist * Mp50(square * (sector.du * sector.step_v + sector.dv * sector.step_u));
    const Mp50 dd = dot(d, d);
    if (dd == 0) return;
    const Mp50 unit = dd * sector.eps;
    const double real = number(Mp50(-dot(x, d) / unit)),
                 imaginary = number(Mp50(length(Vec3<Mp50>(x.cross(d))) / unit));
    zeros.push_back(std::asinh(Complex(real, imaginary)));
  }

  void plan(const QuadCell& cell, int depth) {
    std::vector<Complex> zeros_w, zeros_t;
    for (const double s : kSamples) {
      add_zeros_in_w(cell, s, zeros_w);
      add_zeros_in_t(cell, s, zeros_t);
    }
    const double range = w_range(cell), w_lo = range * cell.w_lo, w_hi = range * cell.w_hi;
    const auto& sector = frame_.sectors[cell.sector];
    const double start = number(sector.tau), length = number(sector.tau_length);
    const double t_lo = start + length * cell.t_lo, t_hi = start + length * cell.t_hi;
    PlannedCell planned{cell, (t_hi - t_lo) / 2, (w_hi - w_lo) / 2, ellipse(zeros_t, t_lo, t_hi),
                        ellipse(zeros_w, w_lo, w_hi)};
    const auto gain = [&](const std::vector<Complex>& zeros, double lo, double hi, double whole) {
      const double middle = (lo + hi) / 2, half = (hi - lo) / 4;
      return (points(digits_, half, ellipse(zeros, lo, middle)) + points(digits_, half, ellipse(zeros, middle, hi))) /
             points(digits_, 2 * half, whole);
    };
    const double gain_t = gain(zeros_t, t_lo, t_hi, planned.ellipse_t);
    const double gain_w = gain(zeros_w, w_lo, w_hi, planned.ellipse_w);
    if (std::min(gain_t, gain_w) > .95 || depth > kDeepest || cells_.size() > most_) {
      cells_.push_back(planned);
      return;
    }
    QuadCell first = cell, second = cell;
    if (gain_t < gain_w) first.t_hi = second.t_lo = (cell.t_lo + cell.t_hi) / 2;
    else first.w_hi = second.w_lo = (cell.w_lo + cell.w_hi) / 2;
    plan(first, depth + 1);
    plan(second, depth + 1);
  }

  const PolarQuadFrame<Mp50>& frame_;
  double digits_, longest_;
  std::size_t most_;
  std::vector<PlannedCell> cells_;
};

}  // namespace

std::vector<PlannedCell> quad_cells(const PolarQuadFrame<Mp50>& frame, double digits, double longest,
                                    std::size_t most) {
  return Planner(frame, digits, longest, most).cells();
}

QuadPoints points_for(const PlannedCell& cell, double digits, int step) {
  const auto rounded = [step](double n) {
    const int least = static_cast<int>(std::ceil(std::min(n, kMostPoints)));
    return least <= 12 ? least : (least + step - 1) / step * step;
  };
  const double t = points(digits, cell.half_t, cell.ellipse_t), w = points(digits, cell.half_w, cell.ellipse_w);
  return {rounded(t), rounded(w), t <= kMostPoints && w <= kMostPoints};
}

}  // namespace cageproof::quadrature_ref
