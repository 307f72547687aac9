// SPDX-License-Identifier: MIT
#include "peers.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace cageproof::benchmarks {
namespace {

double cross(const Vec3<double>& a, const Vec3<double>& b) { return a[0] * b[1] - a[1] * b[0]; }

struct Segment {
  int from, to;
  Vec3<double> along, outward;
  double length;
};

std::vector<Segment> segments_of(const CageElements& elements) {
  std::vector<Segment> segments;
  segments.reserve(elements.count());
  for (std::size_t s = 0; s < elements.count(); ++s) {
    const auto of = elements.vertices_of(s);
    const Vec3<double> edge = elements.vertices()[of[1]] - elements.vertices()[of[0]];
    const double length = edge.norm();
    const Vec3<double> along = edge / length;
    segments.push_back({of[0], of[1], along, Vec3<double>(along[1], -along[0], 0), length});
  }
  return segments;
}

}  // namespace

// Lipman, Levin and Cohen-Or 2008, in the plane: two logarithms and an angle per segment.
PeerFill plane_green_by_edges(const CageElements& elements) {
  const std::size_t vertices = elements.vertices().size(), width = vertices + elements.count();
  return [segments = segments_of(elements), corners = elements.vertices(), vertices, width](
             std::span<const Vec3<double>> points, std::span<double> values) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      double* const row = values.data() + p * width;
      std::fill_n(row, width, 0.);
      for (std::size_t s = 0; s < segments.size(); ++s) {
        const Segment& segment = segments[s];
        const Vec3<double> a = corners[segment.from] - points[p], b = corners[segment.to] - points[p];
        const double height = segment.outward.dot(a), start = segment.along.dot(a), end = segment.along.dot(b);
        const double angle = std::atan2(cross(a, b), a.dot(b));
        const double log_a = std::log(a.squaredNorm()) / 2, log_b = std::log(b.squaredNorm()) / 2;
        const double second = (height * (log_b - log_a) - start * angle) / (2 * std::numbers::pi * segment.length);
        row[segment.to] += second;
        row[segment.from] += angle / (2 * std::numbers::pi) - second;
        row[vertices + s] = -(end * log_b - start * log_a - segment.length + height * angle) / (2 * std::numbers::pi);
      }
    }
  };
}

// Hormann and Floater 2006: a tangent of half an angle per segment.
PeerFill plane_mean_value_by_tangents(const CageElements& elements) {
  return [segments = segments_of(elements), corners = elements.vertices()](std::span<const Vec3<double>> points,
                                                                           std::span<double> values) {
    const std::size_t count = corners.size();
    std::vector<Vec3<double>> to(count);
    std::vector<double> distance(count);
    for (std::size_t p = 0; p < points.size(); ++p) {
      double* const row = values.data() + p * count;
      std::fill_n(row, count, 0.);
      for (std::size_t v = 0; v < count; ++v) {
        to[v] = corners[v] - points[p];
        distance[v] = to[v].norm();
      }
      for (const Segment& segment : segments) {
        const int a = segment.from, b = segment.to;
        const double tangent = (distance[a] * distance[b] - to[a].dot(to[b])) / cross(to[a], to[b]);
        row[a] += tangent / distance[a];
        row[b] += tangent / distance[b];
      }
      double sum = 0;
      for (std::size_t v = 0; v < count; ++v) sum += row[v];
      for (std::size_t v = 0; v < count; ++v) row[v] /= sum;
    }
  };
}

// Weber, Ben-Chen and Gotsman 2009: a complex logarithm per segment.
PeerFill cauchy_by_logarithms(const CageElements& elements) {
  using Complex = std::complex<double>;
  return [segments = segments_of(elements), corners = elements.vertices()](std::span<const Vec3<double>> points,
                                                                           std::span<double> values) {
    const std::size_t count = corners.size();
    for (std::size_t p = 0; p < points.size(); ++p) {
      double* const real = values.data() + 2 * p * count;
      double* const imaginary = real + count;
      std::fill_n(real, 2 * count, 0.);
      for (const Segment& segment : segments) {
        const Vec3<double> a = corners[segment.from] - points[p], b = corners[segment.to] - points[p];
        const Complex start(a[0], a[1]), end(b[0], b[1]);
        const Complex slope = std::log(end / start) / ((end - start) * Complex(0, 2 * std::numbers::pi));
        const Complex from = end * slope, to = -start * slope;
        real[segment.from] += from.real();
        imaginary[segment.from] += from.imag();
        real[segment.to] += to.real();
        imaginary[segment.to] += to.imag();
      }
    }
  };
}

}  // namespace cageproof::benchmarks
