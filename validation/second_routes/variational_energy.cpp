// SPDX-License-Identifier: MIT
#include "variational_energy.h"

#include <array>

namespace cageproof::second_routes {
namespace {

// Sums of squares over points, components and derivatives. \param targets empty for zeros
Mp50 squares(const std::vector<MapTensor>& tensors, const std::vector<MapTensor>& targets) {
  Mp50 sum = 0;
  for (std::size_t p = 0; p < tensors.size(); ++p)
    for (std::size_t k = 0; k < tensors[p].size(); ++k) {
      const Mp50 misfit = targets.empty() ? tensors[p][k] : Mp50(tensors[p][k] - targets[p][k]);
      sum += misfit * misfit;
    }
  return sum;
}

std::vector<MapTensor> moved(std::vector<MapTensor> tensors, const std::vector<MapTensor>& by, const Mp50& factor) {
  for (std::size_t p = 0; p < tensors.size(); ++p)
    for (std::size_t k = 0; k < tensors[p].size(); ++k) tensors[p][k] += factor * by[p][k];
  return tensors;
}

MapAtConstraints moved(const MapAtConstraints& map, const MapAtConstraints& by, const Mp50& factor) {
  return {moved(map.positions, by.positions, factor), moved(map.orientations, by.orientations, factor),
          moved(map.rotations, by.rotations, factor), moved(map.hessians, by.hessians, factor)};
}

// The unit quaternion (w, v) that makes sum R_cj J_cj = w^2 t + 2 w z.v + v.(J + J^T - t) v largest, t = trace J.
std::array<Mp50, 4> best_quaternion(const MapTensor& j) {
  const Mp50 trace = j[0] + j[4] + j[8];
  const std::array<Mp50, 3> turning{j[7] - j[5], j[2] - j[6], j[3] - j[1]};
  using Form = std::array<std::array<Mp50, 4>, 4>;
  Form form;
  Mp50 size = 0;
  form[0][0] = trace;
  for (std::size_t a = 0; a < 3; ++a) {
    form[0][a + 1] = form[a + 1][0] = turning[a];
    for (std::size_t b = 0; b < 3; ++b) form[a + 1][b + 1] = j[3 * a + b] + j[3 * b + a] - (a == b ? trace : Mp50(0));
  }
  for (const auto& row : form)
    for (const Mp50& x : row) size += x * x;
  // Positive, so that its powers come to be those of the largest eigenvalue.
  for (std::size_t a = 0; a < 4; ++a) form[a][a] += sqrt(size);
  constexpr int squarings = 24;
  for (int k = 0; k < squarings; ++k) {
    Form next;
    Mp50 sum = 0;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b) {
        for (std::size_t c = 0; c < 4; ++c) next[a][b] += form[a][c] * form[c][b];
        if (a == b) sum += next[a][a];
      }
    for (auto& row : next)
      for (Mp50& x : row) x /= sum;
    form = next;
  }
  std::size_t longest = 0;
  for (std::size_t a = 1; a < 4; ++a)
    if (form[a][a] > form[longest][longest]) longest = a;
  std::array<Mp50, 4> found = form[longest];
  for (Mp50& x : found) x /= sqrt(form[longest][longest]);
  return found;
}

}  // namespace

Mp50 VariationalEnergy::of(const MapAtConstraints& map) const {
  return squares(map.positions, targets) + alpha * squares(map.orientations, jacobians) +
         beta * squares(map.rotations, turns) + gamma * squares(map.hessians, {});
}

Mp50 VariationalEnergy::slope(const MapAtConstraints& map, const MapAtConstraints& direction) const {
  const Mp50 step = 1e-3;
  return (of(moved(map, direction, step)) - of(moved(map, direction, -step))) / (2 * step);
}

MapTensor nearest_turn(const MapTensor& jacobian, int dimension, bool similar) {
  MapTensor turn(jacobian.size());
  if (dimension == 2) {
    const Mp50 cosine = jacobian[0] + jacobian[3], sine = jacobian[2] - jacobian[1],
               size = sqrt(Mp50(cosine * cosine + sine * sine));
    turn = {cosine / size, -sine / size, sine / size, cosine / size};
  } else {
    const auto [w, x, y, z] = best_quaternion(jacobian);
    turn = {w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
            2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
            2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
  }
  Mp50 sum = 0;
  for (std::size_t k = 0; k < turn.size(); ++k) sum += turn[k] * jacobian[k];
  for (Mp50& entry : turn)
    if (similar) entry *= sum / dimension;
  return turn;
}

}  // namespace cageproof::second_routes
