// SPDX-License-Identifier: MIT
// Written with GCC's vector extensions, which Clang has, too: one source for all instruction sets. Vectors are passed
// by reference, since without AVX-512 there is no register to pass them in.
#include "gauss_kernels.h"

namespace cageproof::benchmarks {
namespace {

using Vector = double __attribute__((vector_size(8 * gauss_lanes)));
#define CAGEPROOF_INLINE inline __attribute__((always_inline))

constexpr double quarter_pi_inverse = 0.079577471545947667884;  // 1/(4 pi)

CAGEPROOF_INLINE void load(const double* from, Vector& to) { __builtin_memcpy(&to, from, sizeof(Vector)); }

CAGEPROOF_INLINE void add_to(double* to, const Vector& what) {
  Vector sum;
  load(to, sum);
  sum += what;
  __builtin_memcpy(to, &sum, sizeof(Vector));
}

// One square root and one division per point: the loop becomes one instruction of each.
CAGEPROOF_INLINE void inverse_root(const Vector& square, Vector& found) {
  double lanes[gauss_lanes];
  __builtin_memcpy(lanes, &square, sizeof lanes);
  for (double& lane : lanes) lane = 1 / __builtin_sqrt(lane);
  __builtin_memcpy(&found, lanes, sizeof lanes);
}

// x = y - eta at a node, and 1/r.
CAGEPROOF_INLINE void see(const double* y, const Vector* eta, Vector& inverse) {
  const Vector x0 = y[0] - eta[0], x1 = y[1] - eta[1], x2 = y[2] - eta[2];
  inverse_root(x0 * x0 + x1 * x1 + x2 * x2, inverse);
}

// The height x.n, the same all over the triangle.
CAGEPROOF_INLINE void height_of(const GaussTriangle& t, const Vector* eta, Vector& height) {
  height = t.normal[0] * (t.corners[0][0] - eta[0]) + t.normal[1] * (t.corners[0][1] - eta[1]) +
           t.normal[2] * (t.corners[0][2] - eta[2]);
}

template <bool Biharmonic>
CAGEPROOF_INLINE void layers(const GaussTask& task, const GaussTriangle& t, const Vector* eta, double* sums) {
  Vector phi0{}, phi1{}, phi2{}, psi{}, bar0{}, bar1{}, bar2{}, psibar{};
  const double* y = task.positions;
  const double* w = task.nodes.weights;
  for (int n = 0; n < task.nodes.count; ++n, y += 3, w += 4) {
    Vector inverse;
    see(y, eta, inverse);
    const Vector square = inverse * inverse, cube = square * inverse;
    phi0 += w[0] * cube;
    phi1 += w[1] * cube;
    phi2 += w[2] * cube;
    psi += w[3] * inverse;
    if constexpr (Biharmonic) {
      bar0 += w[0] * inverse;
      bar1 += w[1] * inverse;
      bar2 += w[2] * inverse;
      // r = r^2 / r, and r^2 takes no longer to compute than 1/r^2.
      const Vector x0 = y[0] - eta[0], x1 = y[1] - eta[1], x2 = y[2] - eta[2];
      psibar += w[3] * ((x0 * x0 + x1 * x1 + x2 * x2) * inverse);
    }
  }
  Vector height;
  height_of(t, eta, height);
  const double scale = quarter_pi_inverse * t.twice_area;
  const Vector turned = scale * height;
  add_to(sums + t.vertices[0] * gauss_lanes, turned * phi0);
  add_to(sums + t.vertices[1] * gauss_lanes, turned * phi1);
  add_to(sums + t.vertices[2] * gauss_lanes, turned * phi2);
  add_to(sums + (task.vertex_count + t.number) * gauss_lanes, scale * psi);
  if constexpr (Biharmonic) {
    double* const bars = sums + (task.vertex_count + task.triangle_count) * gauss_lanes;
    const Vector half = -0.5 * turned;
    add_to(bars + t.vertices[0] * gauss_lanes, half * bar0);
    add_to(bars + t.vertices[1] * gauss_lanes, half * bar1);
    add_to(bars + t.vertices[2] * gauss_lanes, half * bar2);
    add_to(bars + (task.vertex_count + t.number) * gauss_lanes, 0.5 * scale * psibar);
  }
}

// x is affine in the hat functions, x = sum_l G_l x_l, so that all of K and T follows from the integrals of
// G_k G_l / r^3, G_k G_l G_m / r^5 and 1/r: seventeen sums per node instead of 36.
CAGEPROOF_INLINE void somigliana(const GaussTask& task, const GaussTriangle& t, const Vector* eta, double* sums) {
  Vector inverses{}, pairs[6]{}, triples[10]{};
  const double* y = task.positions;
  const double* w = task.nodes.weights;
  for (int n = 0; n < task.nodes.count; ++n, y += 3, w += 17) {
    Vector inverse;
    see(y, eta, inverse);
    const Vector square = inverse * inverse, cube = square * inverse, fifth = square * cube;
    inverses += w[0] * inverse;
#pragma GCC unroll 6
    for (int i = 0; i < 6; ++i) pairs[i] += w[1 + i] * cube;
#pragma GCC unroll 10
    for (int i = 0; i < 10; ++i) triples[i] += w[7 + i] * fifth;
  }
  constexpr int pair_of[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  constexpr int triple_of[3][3][3] = {
      {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}, {{1, 3, 4}, {3, 6, 7}, {4, 7, 8}}, {{2, 4, 5}, {4, 7, 8}, {5, 8, 9}}};
  const double a = quarter_pi_inverse / task.shear, b = a / (4 * (1 - task.poisson));
  Vector x[3][3], height;
  height_of(t, eta, height);
  for (int l = 0; l < 3; ++l)
    for (int c = 0; c < 3; ++c) x[l][c] = t.corners[l][c] - eta[c];
  Vector first[3][3];  // [k]: the integral of G_k x / r^3
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c)
      first[k][c] = pairs[pair_of[k][0]] * x[0][c] + pairs[pair_of[k][1]] * x[1][c] + pairs[pair_of[k][2]] * x[2][c];
  double* const own = sums + (task.vertex_count + t.number) * 9 * gauss_lanes;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Vector entry = first[0][i] * x[0][j] + first[1][i] * x[1][j] + first[2][i] * x[2][j];
      entry *= b * t.twice_area;
      if (i == j) entry += (a - b) * t.twice_area * inverses;
      add_to(own + (3 * i + j) * gauss_lanes, entry);
    }
  const double turn = task.shear * (a - 2 * b) * t.twice_area, bend = 6 * task.shear * b * t.twice_area;
  for (int k = 0; k < 3; ++k) {
    const Vector moment = pairs[pair_of[k][0]] + pairs[pair_of[k][1]] + pairs[pair_of[k][2]];
    Vector second[3][3];  // [m]: the integral of G_k G_m x / r^5
    for (int m = 0; m < 3; ++m)
      for (int c = 0; c < 3; ++c)
        second[m][c] = triples[triple_of[k][m][0]] * x[0][c] + triples[triple_of[k][m][1]] * x[1][c] +
                       triples[triple_of[k][m][2]] * x[2][c];
    double* const to = sums + t.vertices[k] * 9 * gauss_lanes;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        Vector entry = second[0][i] * x[0][j] + second[1][i] * x[1][j] + second[2][i] * x[2][j];
        entry *= bend * height;
        if (i == j) entry += turn * height * moment;
        else entry += turn * (t.normal[i] * first[k][j] - t.normal[j] * first[k][i]);
        add_to(to + (3 * i + j) * gauss_lanes, entry);
      }
  }
}

CAGEPROOF_INLINE void place(const GaussTask& task, const GaussTriangle& t) {
  double* to = task.positions;
  const double* hat = task.nodes.hats;
  for (int n = 0; n < task.nodes.count; ++n, hat += 3)
    for (int c = 0; c < 3; ++c) *to++ = hat[0] * t.corners[0][c] + hat[1] * t.corners[1][c] + hat[2] * t.corners[2][c];
}

// Nodes are placed once per triangle, for all points of the block.
CAGEPROOF_INLINE void on_vectors(const GaussTask& task) {
  const int entries = gauss_entries(task), vectors = task.points / gauss_lanes;
  for (const GaussTriangle* t = task.triangles; t != task.triangles + task.triangle_count; ++t) {
    place(task, *t);
    for (int v = 0; v < vectors; ++v) {
      Vector eta[3];
      for (int c = 0; c < 3; ++c) load(task.eta + (3 * v + c) * gauss_lanes, eta[c]);
      double* const sums = task.sums + static_cast<long>(v) * entries * gauss_lanes;
      if (task.kernels == GaussKernels::Green) layers<false>(task, *t, eta, sums);
      else if (task.kernels == GaussKernels::Biharmonic) layers<true>(task, *t, eta, sums);
      else somigliana(task, *t, eta, sums);
    }
  }
}

void on_any(const GaussTask& task) { on_vectors(task); }

#if defined(__x86_64__)
#if defined(__clang__)
#define CAGEPROOF_AVX512 "avx512f,avx512dq,avx512vl,fma"
#else
#define CAGEPROOF_AVX512 "avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512"
#endif
__attribute__((target(CAGEPROOF_AVX512))) void on_avx512(const GaussTask& task) { on_vectors(task); }
__attribute__((target("avx2,fma"))) void on_avx2(const GaussTask& task) { on_vectors(task); }
#endif

}  // namespace

int gauss_entries(const GaussTask& task) {
  const int both = task.vertex_count + task.triangle_count;
  return task.kernels == GaussKernels::Green ? both : task.kernels == GaussKernels::Biharmonic ? 2 * both : 9 * both;
}

void gauss_on_vectors(const GaussTask& task) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return on_avx512(task);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return on_avx2(task);
#endif
  on_any(task);
}

}  // namespace cageproof::benchmarks
