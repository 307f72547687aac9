// SPDX-License-Identifier: MIT
#include "alignment_route.h"

#include <stdexcept>

namespace cageproof::second_routes {
namespace {

// Lam_V and Lam_N side by side: the energy's rows for each vertex and each normal derivative.
Table<Wide> energy_rows(const CageCoordinates& layers, const Table<Wide>& densities, const AlignmentMethod& method) {
  const CageElements& elements = layers.elements();
  const std::size_t n = elements.vertices().size(), m = elements.count();
  const int d = layers.dimension();
  const std::vector<Touching> samples = centroids(elements, method.level);
  const SampledLayerRows second(layers, samples, 2);
  const std::size_t each = method.squares == Squares::Hessians ? second.derivatives.size() : 1;
  // The operator of all four layers, one column per coordinate of each.
  Table<Wide> of_data(each * samples.size(), n + m), of_densities = of_data;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const Vec3<Wide> normal = unit_normal_of(elements, elements.vertices(), samples[s].element);
    for (int i = 0; i < d; ++i)
      for (int j = 0; j < d; ++j) {
        const std::size_t which = i * d + j, row = each * s + (each > 1 ? which : 0);
        Wide factor = 1;
        if (method.squares == Squares::AlongNormal) factor = normal[i] * normal[j];
        if (method.squares == Squares::Laplacians && i != j) factor = 0;
        const LayerRows& of = second.derivatives[which];
        for (std::size_t k = 0; k < n; ++k) {
          of_data(row, k) += factor * of[0](s, k);
          of_densities(row, k) += factor * of[2](s, k);
        }
        for (std::size_t k = 0; k < m; ++k) {
          of_data(row, n + k) += factor * of[1](s, k);
          of_densities(row, n + k) += factor * of[3](s, k);
        }
      }
  }
  const Table<Wide> free = product(of_densities, densities);
  for (std::size_t k = 0; k < free.entries.size(); ++k) of_data.entries[k] += free.entries[k];
  return of_data;
}

// G = Lam_N^T Lam_N, and Lam_N^T Lam_V V'.
struct Normalised {
  Table<Wide> gram, pull;

  Normalised(const Table<Wide>& rows, const Table<Wide>& vertices)
      : gram(rows.columns - vertices.rows, rows.columns - vertices.rows), pull(gram.rows, vertices.columns) {
    const std::size_t n = vertices.rows;
    for (std::size_t r = 0; r < rows.rows; ++r)
      for (std::size_t t = 0; t < gram.rows; ++t) {
        const Wide& factor = rows(r, n + t);
        for (std::size_t k = 0; k < gram.rows; ++k) gram(t, k) += factor * rows(r, n + k);
        for (std::size_t c = 0; c < vertices.columns; ++c)
          for (std::size_t i = 0; i < n; ++i) pull(t, c) += factor * rows(r, i) * vertices(i, c);
      }
  }
};

// (G (x) I + gamma_a blockdiag(I - n' n'^T)) N' = -Lam_N^T Lam_V V' on stacked unknowns.
Table<Wide> softly(const Normalised& given, const Wide& gamma_a, const Table<Wide>& units) {
  const std::size_t m = units.rows, d = units.columns;
  Table<Wide> matrix(d * m, d * m), right(d * m, 1);
  for (std::size_t t = 0; t < m; ++t)
    for (std::size_t c = 0; c < d; ++c) {
      right(d * t + c, 0) = -given.pull(t, c);
      for (std::size_t k = 0; k < m; ++k) matrix(d * t + c, d * k + c) += given.gram(t, k);
      for (std::size_t k = 0; k < d; ++k)
        matrix(d * t + c, d * t + k) += gamma_a * ((c == k ? Wide(1) : Wide(0)) - units(t, c) * units(t, k));
    }
  Table<Wide> found = eliminated(matrix, right);
  found.rows = m, found.columns = d;
  return found;
}

// (G o n' n'^T) sigma = -sum over coordinates of n' (Lam_N^T Lam_V V'), entry by entry.
Table<Wide> along_units(const Normalised& given, const Table<Wide>& units, bool not_negative) {
  const std::size_t m = units.rows, d = units.columns;
  Table<Wide> matrix(m, m), right(m, 1), normals(m, d);
  for (std::size_t t = 0; t < m; ++t)
    for (std::size_t c = 0; c < d; ++c) {
      right(t, 0) -= units(t, c) * given.pull(t, c);
      for (std::size_t k = 0; k < m; ++k) matrix(t, k) += given.gram(t, k) * units(t, c) * units(k, c);
    }
  const Table<Wide> sigma = not_negative ? least_not_negative(matrix, right) : eliminated(matrix, right);
  for (std::size_t t = 0; t < m; ++t)
    for (std::size_t c = 0; c < d; ++c) normals(t, c) = sigma(t, 0) * units(t, c);
  return normals;
}

}  // namespace

Table<Wide> aligned_normals(const CageCoordinates& layers, const Table<Wide>& densities, const AlignmentMethod& method,
                            const Table<Wide>& vertices, const Table<Wide>& units) {
  const Normalised given(energy_rows(layers, densities, method), vertices);
  if (method.along == Along::Free) return softly(given, Wide(0), units);
  if (method.along == Along::Soft) return softly(given, method.gamma_a, units);
  return along_units(given, units, method.along == Along::NonNegative);
}

Table<Wide> least_not_negative(const Table<Wide>& gram, const Table<Wide>& pull) {
  const std::size_t count = gram.rows;
  for (std::size_t set = 0; set < std::size_t{1} << count; ++set) {
    // Rows of unknowns that are zero say so.
    Table<Wide> matrix = gram, right = pull;
    for (std::size_t k = 0; k < count; ++k) {
      if (set >> k & 1) continue;
      for (std::size_t j = 0; j < count; ++j) matrix(k, j) = j == k ? 1 : 0;
      right(k, 0) = 0;
    }
    Table<Wide> found = eliminated(matrix, right);
    const Table<Wide> slope = product(gram, found);
    bool is_least = true;
    for (std::size_t k = 0; k < count; ++k)
      is_least = is_least && (set >> k & 1 ? found(k, 0) >= 0 : slope(k, 0) >= pull(k, 0));
    if (is_least) return found;
  }
  throw std::logic_error("a positive definite form has a least value over numbers that are not negative");
}

}  // namespace cageproof::second_routes
