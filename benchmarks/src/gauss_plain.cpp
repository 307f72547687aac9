// SPDX-License-Identifier: MIT
#include "gauss_kernels.h"

#include <cmath>
#include <numbers>

namespace cageproof::benchmarks {
namespace {

// One node, of [T24] Eq 3, 9 and 15: phi, psi and with them, or not, phibar and psibar.
void add_layers(const GaussTask& task, const GaussTriangle& t, const double* hat, double weight, const double* x,
                double* sums) {
  constexpr double pi = std::numbers::pi;
  const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  const double height = x[0] * t.normal[0] + x[1] * t.normal[1] + x[2] * t.normal[2];
  const int both = task.vertex_count + task.triangle_count;
  for (int k = 0; k < 3; ++k) sums[t.vertices[k]] += weight * hat[k] * height / (4 * pi * r * r * r);
  sums[task.vertex_count + t.number] += weight / (4 * pi * r);
  if (task.kernels == GaussKernels::Green) return;
  for (int k = 0; k < 3; ++k) sums[both + t.vertices[k]] -= weight * hat[k] * height / (8 * pi * r);
  sums[both + task.vertex_count + t.number] += weight * r / (8 * pi);
}

// One node, of [T24] Eq 47-48.
void add_somigliana(const GaussTask& task, const GaussTriangle& t, const double* hat, double weight, const double* x,
                    double* sums) {
  const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  const double height = x[0] * t.normal[0] + x[1] * t.normal[1] + x[2] * t.normal[2];
  const double a = 1 / (4 * std::numbers::pi * task.shear), b = a / (4 * (1 - task.poisson));
  const double cube = r * r * r, fifth = cube * r * r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double same = i == j ? 1 : 0;
      sums[(task.vertex_count + t.number) * 9 + 3 * i + j] += weight * ((a - b) / r * same + b * x[i] * x[j] / cube);
      const double traction =
          task.shear * ((a - 2 * b) * (height * same + t.normal[i] * x[j] - t.normal[j] * x[i]) / cube +
                        6 * b * height * x[i] * x[j] / fifth);
      for (int k = 0; k < 3; ++k) sums[t.vertices[k] * 9 + 3 * i + j] += weight * hat[k] * traction;
    }
}

}  // namespace

void gauss_plainly(const GaussTask& task) {
  const int entries = gauss_entries(task);
  for (int p = 0; p < task.points; ++p)
    for (int e = 0; e < task.triangle_count; ++e) {
      const GaussTriangle& t = task.triangles[e];
      for (int n = 0; n < task.nodes.count; ++n) {
        const double* const hat = task.nodes.hats + 3 * n;
        double x[3];
        for (int c = 0; c < 3; ++c)
          x[c] = hat[0] * t.corners[0][c] + hat[1] * t.corners[1][c] + hat[2] * t.corners[2][c] - task.eta[3 * p + c];
        const double weight = task.nodes.plain[n] * t.twice_area;
        double* const sums = task.sums + static_cast<long>(p) * entries;
        if (task.kernels == GaussKernels::Somigliana) add_somigliana(task, t, hat, weight, x, sums);
        else add_layers(task, t, hat, weight, x, sums);
      }
    }
}

}  // namespace cageproof::benchmarks
