// SPDX-License-Identifier: MIT
#include "row_residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

// A sum of coordinates as a matrix, a number as that multiple of the identity, and of coordinates times their data.
struct RowSums {
  Mat3<double> ones = Mat3<double>::Zero();
  Vec3<double> positions = Vec3<double>::Zero();
};

// Adds coordinates that are numbers. \return their sum: how often the identity, or the quarter turn, is in it
double add_numbers(std::span<const double> values, const std::array<std::vector<double>, 3>& data, RowSums& sums) {
  double one = 0, x = sums.positions[0], y = sums.positions[1], z = sums.positions[2];
  for (std::size_t i = 0; i < values.size(); ++i) {
    one += values[i];
    x += values[i] * data[0][i];
    y += values[i] * data[1][i];
    z += values[i] * data[2][i];
  }
  sums.positions = {x, y, z};
  return one;
}

// Adds coordinates that are matrices, [coordinate][row][column].
template <int D>
Mat3<double> add_matrices(std::span<const double> values, const std::array<std::vector<double>, 3>& data,
                          RowSums& sums) {
  std::array<double, D * D> ones{};
  std::array<double, D> positions;
  for (int row = 0; row < D; ++row) positions[row] = sums.positions[row];
  const double* from = values.data();
  for (std::size_t i = 0; i < values.size() / (D * D); ++i)
    for (int row = 0; row < D; ++row)
      for (int column = 0; column < D; ++column, ++from) {
        ones[row * D + column] += *from;
        positions[row] += *from * data[column][i];
      }
  Mat3<double> matrix = Mat3<double>::Zero();
  for (int row = 0; row < D; ++row) {
    sums.positions[row] = positions[row];
    for (int column = 0; column < D; ++column) matrix(row, column) = ones[row * D + column];
  }
  return matrix;
}

// A residual that is no number is infinitely wrong.
double or_infinite(double error) { return std::isfinite(error) ? error : std::numeric_limits<double>::infinity(); }

}  // namespace

RowResiduals::RowResiduals(const CageCoordinates& coordinates, const Cage& cage, std::size_t per_value)
    : dimension_(coordinates.dimension()), size_(cage.size()) {
  std::size_t first = 0;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    const std::size_t size = static_cast<std::size_t>(block.size) * block.entries();
    Block& mine = blocks_.emplace_back(Block{first, size, block.entries(), block.reproduces, {}});
    first += size * per_value;
    for (int i = 0; i < block.size && block.reproduces != Reproduces::Nothing; ++i) {
      Vec3<double> v = block.reproduces == Reproduces::Normals
                           ? Vec3<double>(block.normal_factor * coordinates.elements().normal_of(i, block.owner))
                           : cage.vertices()[i];
      if (block.reproduces == Reproduces::TurnedVertices) v = Vec3<double>(-v[1], v[0], 0);
      for (int axis = 0; axis < 3; ++axis) mine.data[axis].push_back(v[axis]);
    }
  }
}

Residuals RowResiduals::of(std::span<const double> row, const Vec3<double>& point, double expected) const {
  Residuals found;
  // Zero unless one of the values is not finite.
  double products = 0;
  for (const Block& block : blocks_)
    for (const double x : row.subspan(block.first, block.size)) products += 0 * x;
  if (products != 0 || std::isnan(products)) {
    for (const Block& block : blocks_)
      for (const double x : row.subspan(block.first, block.size)) {
        found.has_nan = found.has_nan || std::isnan(x);
        found.has_infinity = found.has_infinity || std::isinf(x);
      }
    return found;
  }
  RowSums sums;
  double identity = 0, turned = 0;
  bool is_multiple = true;
  for (const Block& block : blocks_) {
    if (block.reproduces == Reproduces::Nothing) continue;
    const std::span<const double> values = row.subspan(block.first, block.size);
    if (block.entries > 1) {
      const Mat3<double> ones =
          dimension_ == 3 ? add_matrices<3>(values, block.data, sums) : add_matrices<2>(values, block.data, sums);
      if (block.reproduces == Reproduces::Normals) continue;
      sums.ones += ones;
      is_multiple = false;
      continue;
    }
    const double one = add_numbers(values, block.data, sums);
    if (block.reproduces == Reproduces::Vertices) identity += one;
    if (block.reproduces == Reproduces::TurnedVertices) turned += one;
  }
  if (is_multiple && turned == 0) {
    found.partition = or_infinite(std::abs(identity - expected));
  } else {
    for (int i = 0; i < dimension_; ++i) sums.ones(i, i) += identity - expected;
    sums.ones(0, 1) -= turned;
    sums.ones(1, 0) += turned;
    found.partition = or_infinite(sums.ones.reshaped().stableNorm() / std::sqrt(static_cast<double>(dimension_)));
  }
  const double off = or_infinite((sums.positions - expected * point).stableNorm());
  found.reproduction = off == 0 ? 0 : off / size_;
  return found;
}

}  // namespace cageproof::validation
