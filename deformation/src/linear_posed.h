// SPDX-License-Identifier: MIT
// Images that are sums of coordinates times data.
#pragma once

#include "row_products.h"

#include "cageproof/deformation/deformer.h"

#include <type_traits>

namespace cageproof::deformation {

/// Points as the rows of a matrix, in the space's dimension.
template <Scalar R>
Matrix<R> rows_of(const std::vector<Vec3<R>>& points, int dimension) {
  Matrix<R> rows(static_cast<Eigen::Index>(points.size()), dimension);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (int c = 0; c < dimension; ++c) rows(static_cast<Eigen::Index>(i), c) = points[i][c];
  return rows;
}

/// A pose as data of each block: f = sum over blocks of coordinates times data, a row of data a coordinate.
template <Scalar R>
class LinearPosed final : public Posed<R> {
 public:
  /// \param data of the coordinates' first blocks; blocks without have no share
  LinearPosed(std::vector<Matrix<R>> data, DeformationReport report)
      : data_(std::move(data)), report_(std::move(report)) {}

  const std::vector<Matrix<R>>& data() const { return data_; }
  const DeformationReport& report() const override { return report_; }

  Images<R> images(std::span<const CoordinateTable<R>> coordinates, std::size_t points, int order) const override {
    using Rows = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const int dimension = static_cast<int>(data_[0].cols());
    Images<R> images;
    for (int o = 0; o <= order; ++o) {
      const auto width = static_cast<Eigen::Index>(derivative_count(dimension, o));
      images.tensors[o].assign(points * dimension * width, R(0));
      for (std::size_t b = 0; b < data_.size(); ++b) {
        const CoordinateTable<R>& table = coordinates[b];
        const Eigen::Index count = data_[b].rows();
        if constexpr (std::is_same_v<R, double>) {
          if (o == 0) {
            if (dimension == 3) add_values<3>(data_[b], table, points, images.tensors[0]);
            else add_values<2>(data_[b], table, points, images.tensors[0]);
            continue;
          }
        }
        if (o == 0) {
          Eigen::Map<Rows> into(images.tensors[0].data(), static_cast<Eigen::Index>(points), dimension);
          into.noalias() +=
              Eigen::Map<const Rows>(table.tensors[0].data(), static_cast<Eigen::Index>(points), count) * data_[b];
          continue;
        }
        for (std::size_t p = 0; p < points; ++p) {
          Eigen::Map<Rows> into(&images.tensors[o][p * dimension * width], dimension, width);
          into.noalias() +=
              data_[b].transpose() * Eigen::Map<const Rows>(&table.tensors[o][p * table.stride[o]], count, width);
        }
      }
    }
    return images;
  }

 private:
  template <int D>
  static void add_values(const Matrix<R>& data, const CoordinateTable<R>& table, std::size_t points,
                         std::vector<R>& images) {
    static_assert(!Matrix<R>::IsRowMajor);
    std::array<const R*, D> columns;
    for (int c = 0; c < D; ++c) columns[c] = data.col(c).data();
    for (std::size_t p = 0; p < points; ++p)
      add_row_products<D>(std::span(table.tensors[0]).subspan(p * table.stride[0], data.rows()), columns,
                          &images[p * D]);
  }

  std::vector<Matrix<R>> data_;
  DeformationReport report_;
};

}  // namespace cageproof::deformation
