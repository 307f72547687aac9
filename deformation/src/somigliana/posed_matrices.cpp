// SPDX-License-Identifier: MIT
#include "posed_matrices.h"

#include <algorithm>
#include <array>

namespace cageproof::deformation {
namespace {

constexpr std::size_t kEntries = 9;
using Entries = std::array<double, kEntries>;
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Adds products entry by entry.
void add_entries(std::span<const double> matrices, const std::vector<double>& factors, Entries& products) {
  for (std::size_t i = 0; i < factors.size(); i += kEntries)
    for (std::size_t k = 0; k < kEntries; ++k) products[k] += matrices[i + k] * factors[i + k];
}

void add_entries(std::span<const double> matrices, Entries& sums) {
  for (std::size_t i = 0; i < matrices.size(); i += kEntries)
    for (std::size_t k = 0; k < kEntries; ++k) sums[k] += matrices[i + k];
}

}  // namespace

PosedMatrices::Block PosedMatrices::block_of(const Data& data) {
  Block block;
  for (const SpaceMatrix<double>& rotation : data.rotations) block.rotations.emplace_back(rotation);
  for (const SpaceVector<double>& turned : data.turned) {
    block.turned.emplace_back(turned);
    for (int row = 0; row < 3; ++row) block.thrice.insert(block.thrice.end(), turned.data(), turned.data() + 3);
  }
  return block;
}

PosedMatrices::PosedMatrices(const Data& vertices, const Data& tractions)
    : vertices_(block_of(vertices)), tractions_(block_of(tractions)) {
  const auto is_first = [&](const Mat3<double>& rotation) { return rotation == vertices_.rotations.front(); };
  is_one_rotation_ =
      std::ranges::all_of(vertices_.rotations, is_first) && std::ranges::all_of(tractions_.rotations, is_first);
}

Vec3<double> PosedMatrices::image(std::span<const double> of_vertices, std::span<const double> of_tractions) const {
  Mat3<double> whole = Mat3<double>::Zero();
  Vec3<double> image = Vec3<double>::Zero();
  if (is_one_rotation_) {
    Entries sums{}, products{};
    add_entries(of_vertices, sums);
    add_entries(of_vertices, vertices_.thrice, products);
    add_entries(of_tractions, tractions_.thrice, products);
    const Mat3<double>& rotation = vertices_.rotations.front();
    whole = rotation * Eigen::Map<const RowMajor>(sums.data()) * rotation.transpose();
    image = rotation * Eigen::Map<const RowMajor>(products.data()).rowwise().sum();
  } else {
    for (std::size_t v = 0; v < vertices_.turned.size(); ++v) {
      const Mat3<double> turned = vertices_.rotations[v] * Eigen::Map<const RowMajor>(&of_vertices[kEntries * v]);
      whole += turned * vertices_.rotations[v].transpose();
      image += turned * vertices_.turned[v];
    }
    for (std::size_t i = 0; i < tractions_.turned.size(); ++i)
      image +=
          tractions_.rotations[i] * (Eigen::Map<const RowMajor>(&of_tractions[kEntries * i]) * tractions_.turned[i]);
  }
  return Eigen::PartialPivLU<Mat3<double>>(whole).solve(image);
}

}  // namespace cageproof::deformation
