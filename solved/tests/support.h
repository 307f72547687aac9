// SPDX-License-Identifier: MIT
// Polygons, and functions whose boundary data are known exactly.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace cageproof::solved::test {

using Vec = Vec3<double>;
using Corners = std::vector<std::array<double, 2>>;

inline const Corners unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
inline const Corners convex_pentagon{{0, 0}, {2, 0}, {2.5, 1.25}, {1, 2}, {-0.5, 1}};
inline const Corners l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
inline const Corners triangle{{0, 0}, {1, 0}, {0.25, 0.75}};
inline const Corners rectangle{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
inline const Corners kite{{0, -1}, {0.5, 0}, {0, 0.5}, {-0.5, 0}};
inline const Corners thin_bar{{0, 0}, {1, 0}, {1, 0.015625}, {0, 0.015625}};
inline const Corners hexagon{{1, 0},  {0.5, 0.8660254037844386},   {-0.5, 0.8660254037844386},
                             {-1, 0}, {-0.5, -0.8660254037844386}, {0.5, -0.8660254037844386}};

/// Polygons of these corners, each in its order.
inline Cage polygons(const std::vector<Corners>& parts, double unit = 1, const Vec& at = Vec::Zero()) {
  std::vector<Vec> vertices;
  std::vector<Face> segments;
  for (const Corners& corners : parts) {
    const int first = static_cast<int>(vertices.size()), n = static_cast<int>(corners.size());
    for (int k = 0; k < n; ++k) {
      vertices.push_back(unit * Vec(corners[k][0], corners[k][1], 0) + at);
      segments.push_back({{first + k, first + (k + 1) % n, -1, -1}});
    }
  }
  return Cage::make_polygon("polygon", vertices, segments, {});
}

inline Cage polygon(const Corners& corners, double unit = 1, const Vec& at = Vec::Zero()) {
  return polygons({corners}, unit, at);
}

/// A square with a square hole.
inline Cage ring() { return polygons({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}); }

/// Every edge in n edges: data between the corners are then the user's own.
inline Corners subdivided(const Corners& corners, int n) {
  Corners finer;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % corners.size()];
    for (int i = 0; i < n; ++i) finer.push_back({a[0] + (b[0] - a[0]) * i / n, a[1] + (b[1] - a[1]) * i / n});
  }
  return finer;
}

/// \param parameters the first ones; the others are at their defaults
inline CageCoordinates coordinates(const Cage& cage, const char* kind, std::vector<double> parameters = {}) {
  const auto known = parameters_of(coordinate_kind_named(kind));
  for (std::size_t k = parameters.size(); k < known.size(); ++k) parameters.push_back(known[k].preset);
  return {cage, coordinate_kind_named(kind), CoordinateOptions{.parameters = std::move(parameters)}};
}

/// The values of all blocks, one after the other.
inline std::vector<double> values_at(const CageCoordinates& coordinates, const Vec& point) {
  std::vector<double> all;
  for (const Result<double>& block : coordinates.at<double>(point, 0))
    all.insert(all.end(), block.value.begin(), block.value.end());
  return all;
}

inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = a.size() == b.size() ? 0 : HUGE_VAL;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    worst = std::isnan(a[i] - b[i]) ? HUGE_VAL : std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

/// The largest errors of Eq 6 and Eq 5 of [W12] at a point, over the size of their terms, by order of derivatives; of
/// positions over the cage's size, too: a point's own place has no share in what rounding the cage costs.
/// \param expected 1 in the cage and on it, 0 outside
inline std::array<double, 3> affine_errors(const CageCoordinates& c, const Vec& point, int order, double expected = 1) {
  const auto found = c.at<double>(point, order);
  const auto& vertices = c.elements().vertices();
  double diameter = 0;
  for (const Vec& v : vertices) diameter = std::max(diameter, (v - vertices[0]).norm());
  std::array<double, 3> errors{};
  for (int o = 0; o <= order; ++o) {
    const std::size_t width = derivative_count(2, o);
    double terms = 0, size = 0, one = 0, positions = 0;
    for (std::size_t d = 0; d < width; ++d) {
      double sum = o == 0 ? -expected : 0;
      Vec x = Vec::Zero();
      if (o == 0) x = -expected * point;
      if (o == 1) x[static_cast<int>(d)] = -expected;
      for (int v = 0; v < c.blocks()[0].size; ++v) {
        const double a = found[0].of(o)[v * width + d];
        sum += a;
        terms += std::abs(a);
        x += a * vertices[v];
        size += std::abs(a) * vertices[v].norm();
      }
      for (int e = 0; c.blocks().size() > 1 && e < c.blocks()[1].size; ++e) {
        const double b = found[1].of(o)[e * width + d];
        x += b * c.elements().normals()[e];
        size += std::abs(b);
      }
      if (o == 0) size = std::max(size, diameter);
      one += std::abs(sum);
      positions += x.norm();
    }
    // Sums, which what is not a number does not leave.
    errors[o] = one / terms + positions / size;
  }
  return errors;
}

/// A function's data at vertices, then at the middles of edges.
template <class Function>
std::vector<double> values_and_slopes(const Function& f, const CageElements& elements) {
  std::vector<double> all;
  for (const Vec& v : elements.vertices()) all.push_back(f.value(v));
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto ends = elements.corners(e);
    all.push_back(f.derivative((ends[0] + ends[1]) / 2, elements.normals()[e]));
  }
  return all;
}

/// A function of the plane with its gradient: Re(conj(z) g(z) + h(z)), which every biharmonic function is.
struct Goursat {
  using C = std::complex<double>;
  std::string name;
  C (*g)(C);
  C (*dg)(C);
  C (*h)(C);
  C (*dh)(C);

  double value(const Vec& p) const {
    const C z(p[0], p[1]);
    return (std::conj(z) * g(z) + h(z)).real();
  }
  /// In that direction.
  double derivative(const Vec& p, const Vec& direction) const {
    const C z(p[0], p[1]), n(direction[0], direction[1]);
    return (std::conj(n) * g(z) + (std::conj(z) * dg(z) + dh(z)) * n).real();
  }
  std::vector<double> data(const CageElements& elements) const { return values_and_slopes(*this, elements); }
};

/// Poles and cuts lie outside the polygons above.
inline const std::vector<Goursat>& manufactured() {
  using C = std::complex<double>;
  static const C pole(-1.5, -1);
  static const std::vector<Goursat> all{
      {"x^2 + y^2", [](C z) { return z; }, [](C) { return C(1); }, [](C) { return C(0); }, [](C) { return C(0); }},
      {"x^3 - 3 x y^2 + x (x^2 + y^2)", [](C z) { return z * z; }, [](C z) { return 2. * z; },
       [](C z) { return z * z * z; }, [](C z) { return 3. * z * z; }},
      // |z - p|^2 ln |z - p| = Re((conj z - conj p) (z - p) ln (z - p)).
      {"r^2 ln r", [](C z) { return (z - pole) * std::log(z - pole); }, [](C z) { return std::log(z - pole) + 1.; },
       [](C z) { return -std::conj(pole) * (z - pole) * std::log(z - pole); },
       [](C z) { return -std::conj(pole) * (std::log(z - pole) + 1.); }},
      {"Re (conj(z) / (z - p) + 1 / (z - p)^2)", [](C z) { return 1. / (z - pole); },
       [](C z) { return -1. / ((z - pole) * (z - pole)); }, [](C z) { return 1. / ((z - pole) * (z - pole)); },
       [](C z) { return -2. / ((z - pole) * (z - pole) * (z - pole)); }}};
  return all;
}

/// Coordinates times data.
inline double interpolated(const CageCoordinates& coordinates, const std::vector<double>& data, const Vec& point) {
  const std::vector<double> all = values_at(coordinates, point);
  double sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) sum += all[i] * data[i];
  return sum;
}

/// The largest error at the points of each function, whose data are exact.
template <class Functions>
std::vector<double> largest_errors(const CageCoordinates& coordinates, const Functions& functions,
                                   const std::vector<Vec>& points) {
  std::vector<double> errors;
  for (const auto& f : functions) {
    const std::vector<double> data = f.data(coordinates.elements());
    double worst = 0;
    for (const Vec& p : points) worst = std::max(worst, std::abs(interpolated(coordinates, data, p) - f.value(p)));
    errors.push_back(worst);
  }
  return errors;
}

}  // namespace cageproof::solved::test
