// SPDX-License-Identifier: MIT
// The kernels of segments' formulas and their integrals, in 100 digits: the truth of closed forms.
#pragma once

#include "cageproof/closed_form/arithmetic/jet.h"
#include "segment_samples.h"

#include <algorithm>

namespace cageproof::closed_form::segment {

// The parts of derivative order o, one number after the other.
template <Scalar R, int C>
std::vector<R> part(const Jet<R, C, 2>& jet, int order) {
  std::vector<R> x;
  for (int c = 0; c < C; ++c) {
    if (order == 0) x.push_back(jet.value[c]);
    for (int i = 0; i < 2; ++i) {
      if (order == 1) x.push_back(jet.gradient[c][i]);
      for (int j = 0; order == 2 && j < 2; ++j) x.push_back(jet.hessian[c](i, j));
    }
  }
  return x;
}

template <Scalar R>
R norm(const std::vector<R>& x) {
  R sum = 0;
  for (const R& y : x) sum += y * y;
  using std::sqrt;
  return sqrt(sum);
}

template <Scalar R, Scalar S>
std::vector<R> difference(const std::vector<R>& a, const std::vector<S>& b) {
  std::vector<R> d;
  for (std::size_t i = 0; i < a.size(); ++i) d.push_back(R(a[i]) - R(b[i]));
  return d;
}

// The kernels, times 2 pi, and their derivatives with respect to the point; x = xi - eta.
struct SingleKernel {
  static constexpr int components = 1;
  static void add(const Mp100& weight, const Mp100&, const Mp100& x, const Mp100& y, const Mp100&, const Mp100&,
                  Jet<Mp100, 1, 2>& sum) {
    const Mp100 q = 1 / (x * x + y * y);
    sum.value[0] += weight * log(q) / 2;
    sum.gradient[0] += weight * q * Eigen::Matrix<Mp100, 2, 1>(x, y);
    const Mp100 d = weight * q * q * (x * x - y * y), m = weight * q * q * 2 * x * y;
    sum.hessian[0](0, 0) += d;
    sum.hessian[0](1, 1) -= d;
    sum.hessian[0](0, 1) += m;
    sum.hessian[0](1, 0) += m;
  }
};
struct HeightKernel {
  static void add(const Mp100& weight, const Mp100&, const Mp100& x, const Mp100& y, const Mp100& nx, const Mp100& ny,
                  Jet<Mp100, 1, 2>& sum) {
    const Mp100 q = 1 / (x * x + y * y), height = x * nx + y * ny;
    const std::array<Mp100, 2> v{x, y}, n{nx, ny};
    sum.value[0] += weight * height * q;
    for (int i = 0; i < 2; ++i) {
      sum.gradient[0][i] -= weight * q * (n[i] - 2 * height * v[i] * q);
      for (int j = 0; j < 2; ++j)
        sum.hessian[0](i, j) +=
            weight * q * q *
            (8 * height * v[i] * v[j] * q - 2 * (n[i] * v[j] + n[j] * v[i]) - (i == j ? 2 * height : Mp100(0)));
    }
  }
};
struct AngleKernel {
  static constexpr int components = 1;
  static void add(const Mp100& weight, const Mp100& t, const Mp100& x, const Mp100& y, const Mp100& nx, const Mp100& ny,
                  Jet<Mp100, 1, 2>& sum) {
    HeightKernel::add(weight * 2 * pi<Mp100>(), t, x, y, nx, ny, sum);
  }
};
struct MeanValueKernel {
  static void add(const Mp100& weight, const Mp100&, const Mp100& x, const Mp100& y, const Mp100& nx, const Mp100& ny,
                  Jet<Mp100, 1, 2>& sum) {
    const Mp100 q = 1 / (x * x + y * y), height = x * nx + y * ny, part = weight * 2 * pi<Mp100>() * q * sqrt(q);
    const std::array<Mp100, 2> v{x, y}, n{nx, ny};
    sum.value[0] += part * height;
    for (int i = 0; i < 2; ++i) {
      sum.gradient[0][i] -= part * (n[i] - 3 * height * v[i] * q);
      for (int j = 0; j < 2; ++j)
        sum.hessian[0](i, j) +=
            part * q *
            (15 * height * v[i] * v[j] * q - 3 * (n[i] * v[j] + n[j] * v[i]) - (i == j ? 3 * height : Mp100(0)));
    }
  }
};
struct BiharmonicKernel {
  static constexpr int components = 1;
  static void add(const Mp100& weight, const Mp100&, const Mp100& x, const Mp100& y, const Mp100&, const Mp100&,
                  Jet<Mp100, 1, 2>& sum) {
    const Mp100 square = x * x + y * y, logarithm = log(square), part = weight / 4;
    const std::array<Mp100, 2> v{x, y};
    sum.value[0] -= part * square * (logarithm / 2 - 1);
    for (int i = 0; i < 2; ++i) {
      sum.gradient[0][i] += part * v[i] * (logarithm - 1);
      for (int j = 0; j < 2; ++j)
        sum.hessian[0](i, j) -= part * ((i == j ? Mp100(logarithm - 1) : Mp100(0)) + 2 * v[i] * v[j] / square);
    }
  }
};
struct BiharmonicHeightKernel {
  static void add(const Mp100& weight, const Mp100&, const Mp100& x, const Mp100& y, const Mp100& nx, const Mp100& ny,
                  Jet<Mp100, 1, 2>& sum) {
    const Mp100 q = 1 / (x * x + y * y), logarithm = -log(q), height = x * nx + y * ny, part = weight / 4;
    const std::array<Mp100, 2> v{x, y}, n{nx, ny};
    sum.value[0] += part * height * (logarithm - 1);
    for (int i = 0; i < 2; ++i) {
      sum.gradient[0][i] -= part * (n[i] * (logarithm - 1) + 2 * height * q * v[i]);
      for (int j = 0; j < 2; ++j)
        sum.hessian[0](i, j) +=
            2 * part * q *
            (n[i] * v[j] + v[i] * n[j] + height * ((i == j ? Mp100(1) : Mp100(0)) - 2 * q * v[i] * v[j]));
    }
  }
};
// A kernel weighted with the hat functions.
template <class K>
struct OfHats {
  static constexpr int components = 2;
  static void add(const Mp100& weight, const Mp100& t, const Mp100& x, const Mp100& y, const Mp100& nx, const Mp100& ny,
                  Jet<Mp100, 2, 2>& sum) {
    Jet<Mp100, 1, 2> one;
    K::add(weight, t, x, y, nx, ny, one);
    for (int k = 0; k < 2; ++k) {
      const Mp100 hat = k == 0 ? Mp100(1 - t) : t;
      sum.value[k] += hat * one.value[0];
      sum.gradient[k] += hat * one.gradient[0];
      sum.hessian[k] += hat * one.hessian[0];
    }
  }
};
using DoubleKernel = OfHats<HeightKernel>;

// The integral over panels that double away from the point of the segment that is nearest. Their integrands are
// analytic one panel's length around.
template <class K>
Jet<Mp100, K::components, 2> integral(const SegmentSample& sample, const K& kernel = {}) {
  const auto& rule = gauss_legendre<Mp100>(60);
  const Vec3<Mp100> a = convert<Mp100>(sample.s[0]), e = convert<Mp100>(sample.s[1]) - a,
                    from = convert<Mp100>(sample.point) - a;
  const Mp100 length = sqrt(Mp100(e.dot(e))), nx = e[1] / length, ny = -e[0] / length;
  const Mp100 nearest = std::clamp(Mp100(from.dot(e) / e.dot(e)), Mp100(0), Mp100(1));
  const Vec3<Mp100> arm = from - nearest * e;
  const Mp100 first = sqrt(Mp100(arm.dot(arm))) / length;
  Jet<Mp100, K::components, 2> sum;
  for (const int side : {-1, 1}) {
    const Mp100 whole = side > 0 ? Mp100(1 - nearest) : nearest;
    Mp100 begin = 0, width = first;
    while (begin < whole) {
      const Mp100 end = std::min(Mp100(begin + width), whole);
      for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
        const Mp100 step = side * (begin + (end - begin) * rule.nodes[j]), t = nearest + step;
        // From the nearest point, where differences are small.
        kernel.add(rule.weights[j] * (end - begin) * length, t, step * e[0] - arm[0], step * e[1] - arm[1], nx, ny,
                   sum);
      }
      begin = end;
      width *= 2;
    }
  }
  const Mp100 turn = 1 / (2 * pi<Mp100>());
  for (int c = 0; c < K::components; ++c) {
    sum.value[c] *= turn;
    sum.gradient[c] *= turn;
    sum.hessian[c] *= turn;
  }
  return sum;
}

}  // namespace cageproof::closed_form::segment
