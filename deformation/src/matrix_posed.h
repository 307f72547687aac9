// SPDX-License-Identifier: MIT
// Images that are sums of matrices times data.
#pragma once

#include "linear_posed.h"

namespace cageproof::deformation {

/// A pose as data of each block: f = sum over blocks of coordinates, which are matrices, times data, one row per
/// coordinate.
template <Scalar R>
class MatrixPosed final : public Posed<R> {
 public:
  explicit MatrixPosed(std::vector<Matrix<R>> data, DeformationReport report = {})
      : data_(std::move(data)), report_(std::move(report)) {}

  const DeformationReport& report() const override { return report_; }

  Images<R> images(std::span<const CoordinateTable<R>> coordinates, std::size_t points, int order) const override {
    const auto dimension = static_cast<std::size_t>(data_[0].cols());
    Images<R> images;
    for (int o = 0; o <= order; ++o) {
      const std::size_t width = derivative_count(static_cast<int>(dimension), o);
      images.tensors[o].assign(points * dimension * width, R(0));
      for (std::size_t b = 0; b < data_.size(); ++b)
        for (std::size_t p = 0; p < points; ++p) {
          const R* from = &coordinates[b].tensors[o][p * coordinates[b].stride[o]];
          for (Eigen::Index k = 0; k < data_[b].rows(); ++k)
            for (std::size_t row = 0; row < dimension; ++row)
              for (Eigen::Index column = 0; column < data_[b].cols(); ++column)
                for (std::size_t i = 0; i < width; ++i)
                  images.tensors[o][(dimension * p + row) * width + i] += *from++ * data_[b](k, column);
        }
    }
    return images;
  }

 private:
  std::vector<Matrix<R>> data_;
  DeformationReport report_;
};

}  // namespace cageproof::deformation
