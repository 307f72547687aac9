// SPDX-License-Identifier: MIT
#include "densities_route.h"

namespace cageproof::second_routes {
namespace {

class Densities {
 public:
  Densities(const CageCoordinates& layers, const DensityMethod& method, const Table<Wide>& vertices,
            const Table<Wide>& normals)
      : layers_(layers),
        elements_(layers.elements()),
        gamma_d_(method.gamma_d),
        vertices_(vertices),
        normals_(normals),
        samples_(centroids(elements_, method.level)),
        hats_(hat_functions(elements_, samples_)),
        values_(SampledLayerRows(layers, samples_, 0).derivatives.front()) {}

  // gamma_D |A X - b|^2 + |B X|^2, A = [phibar psibar], b = (M - phi) V' - psi N', B = [phi - M, psi].
  Table<Wide> by_values_and_laplacians() const {
    NormalEquations<Wide> squares = equations();
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      add_value(squares, s, gamma_d_);
      for (std::size_t i = 0; i < vertices_.rows; ++i) squares.row(i) = values_[0](s, i) - hats_(s, i);
      for (std::size_t j = 0; j < normals_.rows; ++j) squares.row(vertices_.rows + j) = values_[1](s, j);
      squares.add();
    }
    return squares.solution();
  }

  // |[phibar psibar] X - b|^2 + |d[phibar psibar] X - (M_N N' - d phi V' - d psi N')|^2, d along the rest normal.
  Table<Wide> by_values_and_slopes() const {
    const SampledLayerRows slopes(layers_, samples_, 1);
    NormalEquations<Wide> squares = equations();
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      add_value(squares, s, Wide(1));
      const Vec3<Wide> normal = unit_normal_of(elements_, elements_.vertices(), samples_[s].element);
      const auto slope = [&](std::size_t block, std::size_t i) {
        Wide sum = 0;
        for (std::size_t c = 0; c < slopes.derivatives.size(); ++c)
          sum += normal[c] * slopes.derivatives[c][block](s, i);
        return sum;
      };
      for (std::size_t i = 0; i < vertices_.rows; ++i) squares.row(i) = slope(2, i);
      for (std::size_t j = 0; j < normals_.rows; ++j) squares.row(vertices_.rows + j) = slope(3, j);
      for (std::size_t c = 0; c < vertices_.columns; ++c) {
        for (std::size_t i = 0; i < vertices_.rows; ++i) squares.value(c) -= slope(0, i) * vertices_(i, c);
        for (std::size_t j = 0; j < normals_.rows; ++j)
          squares.value(c) += ((is_own(s, j) ? 1 : 0) - slope(1, j)) * normals_(j, c);
      }
      squares.add();
    }
    return squares.solution();
  }

  // A_w = pinv(psi) (M - phi), K = phibar + psibar A_w, L' = pinv(K) ((M - phi) V' - psi N'), D' = A_w L'.
  Table<Wide> by_laplacians() const {
    const std::size_t n = vertices_.rows, m = normals_.rows;
    NormalEquations<Wide> of_normals(m, n);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      for (std::size_t j = 0; j < normals_.rows; ++j) of_normals.row(j) = values_[1](s, j);
      for (std::size_t i = 0; i < n; ++i) of_normals.value(i) = hats_(s, i) - values_[0](s, i);
      of_normals.add();
    }
    const Table<Wide> by_laplacian = of_normals.solution();
    NormalEquations<Wide> squares(n, vertices_.columns);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
      for (std::size_t i = 0; i < n; ++i) {
        squares.row(i) = values_[2](s, i);
        for (std::size_t j = 0; j < normals_.rows; ++j) squares.row(i) += values_[3](s, j) * by_laplacian(j, i);
      }
      for (std::size_t c = 0; c < vertices_.columns; ++c) squares.value(c) = missing(s, c);
      squares.add();
    }
    const Table<Wide> laplacians = squares.solution(), slopes = product(by_laplacian, laplacians);
    Table<Wide> both(n + m, vertices_.columns);
    for (std::size_t c = 0; c < vertices_.columns; ++c) {
      for (std::size_t i = 0; i < n; ++i) both(i, c) = laplacians(i, c);
      for (std::size_t j = 0; j < m; ++j) both(n + j, c) = slopes(j, c);
    }
    return both;
  }

 private:
  bool is_own(std::size_t s, std::size_t element) const {
    return element == static_cast<std::size_t>(samples_[s].element);
  }

  NormalEquations<Wide> equations() const { return {vertices_.rows + normals_.rows, vertices_.columns}; }

  // Error of the value at a sample, with no densities.
  Wide missing(std::size_t s, std::size_t column) const {
    Wide sum = 0;
    for (std::size_t i = 0; i < vertices_.rows; ++i) sum += (hats_(s, i) - values_[0](s, i)) * vertices_(i, column);
    for (std::size_t j = 0; j < normals_.rows; ++j) sum -= values_[1](s, j) * normals_(j, column);
    return sum;
  }

  void add_value(NormalEquations<Wide>& squares, std::size_t s, const Wide& weight) const {
    for (std::size_t i = 0; i < vertices_.rows; ++i) squares.row(i) = values_[2](s, i);
    for (std::size_t j = 0; j < normals_.rows; ++j) squares.row(vertices_.rows + j) = values_[3](s, j);
    for (std::size_t c = 0; c < vertices_.columns; ++c) squares.value(c) = missing(s, c);
    squares.add(weight);
  }

  const CageCoordinates& layers_;
  const CageElements& elements_;
  const Wide& gamma_d_;
  const Table<Wide>&vertices_, &normals_;
  std::vector<Touching> samples_;
  Table<Wide> hats_;
  LayerRows values_;
};

}  // namespace

Table<Wide> densities_by_data(const CageCoordinates& layers, const DensityMethod& method) {
  // Data that are one at a vertex, or of an element, and zero elsewhere.
  const std::size_t n = layers.elements().vertices().size(), m = layers.elements().count();
  Table<Wide> vertices(n, n + m), normals(m, n + m);
  for (std::size_t k = 0; k < n; ++k) vertices(k, k) = 1;
  for (std::size_t k = 0; k < m; ++k) normals(k, n + k) = 1;
  const Densities densities(layers, method, vertices, normals);
  switch (method.required) {
    case Required::ValuesAndSlopes: return densities.by_values_and_slopes();
    case Required::ValuesByLaplacians: return densities.by_laplacians();
    case Required::ValuesAndLaplacians: break;
  }
  return densities.by_values_and_laplacians();
}

}  // namespace cageproof::second_routes
