// SPDX-License-Identifier: MIT
// The derivative of the corotational deformer's images by the posed vertices.
#pragma once

#include "corotation_slopes.h"
#include "parts.h"

#include <memory>
#include <optional>

namespace cageproof::deformation {

/// x' = T^-1 y, with T = sum R_i T_i R_i^t, y = sum R_i T_i R_i^t v'_i + sum R_j K_j R_j^t s'_j. So T dx' is
///   sum M_i dv'_i + theta_i x (M_i z_i) - M_i (theta_i x z_i), with M_i = R_i T_i R_i^t and z_i = v'_i - x',
/// and the same of M_j = R_j K_j R_j^t, ds'_j and z_j = s'_j.
template <Scalar R>
class SomiglianaDerivative final : public PoseDerivative<R> {
 public:
  /// \param nu of coordinates that are made of its parts
  SomiglianaDerivative(int dimension, std::vector<Vec3<R>> vertices, const Corotation<R>& pose,
                       CorotationSlopes<R> slopes, std::optional<double> nu)
      : shared_(std::make_shared<const Shared>(dimension, nu,
                                               Block{rotations_of(pose.of_vertices), std::move(vertices)},
                                               Block{rotations_of(pose.of_normals), pose.tractions})),
        slopes_(std::move(slopes)) {}

  std::unique_ptr<const Posed<R>> along(const std::vector<Vec3<R>>& change) const override {
    const auto rows = slopes_.along(change);
    return std::make_unique<Along>(
        shared_, std::array<Changes, 2>{Changes{rows.of_vertices, change}, Changes{rows.of_normals, rows.tractions}});
  }

  // Weights of the rotations and of the data, of vertices and then of normals.
  std::vector<Matrix<R>> nothing() const override {
    std::vector<Matrix<R>> found;
    for (const Block& block : shared_->blocks)
      found.insert(found.end(), 2, Matrix<R>::Zero(static_cast<Eigen::Index>(block.data.size()), 3));
    return found;
  }

  void gather(std::span<const CoordinateTable<R>> given, std::size_t points, std::span<const R> weights,
              std::vector<Matrix<R>>& gathered) const override {
    std::vector<CoordinateTable<R>> made;
    const auto coordinates = shared_->coordinates(given, made);
    const int d = shared_->dimension;
    for (std::size_t p = 0; p < points; ++p) {
      Vec3<R> weight = Vec3<R>::Zero();
      for (int c = 0; c < d; ++c) weight[c] = weights[p * static_cast<std::size_t>(d) + static_cast<std::size_t>(c)];
      if (weight == Vec3<R>::Zero()) continue;
      const Place at(*shared_, coordinates, p);
      const Vec3<R> by_sums = Eigen::PartialPivLU<Mat3<R>>(at.whole.transpose()).solve(weight);
      for (std::size_t b = 0; b < 2; ++b)
        for (std::size_t i = 0; i < at.matrices[b].size(); ++i) {
          const Mat3<R>& matrix = at.matrices[b][i];
          const Vec3<R> z = shared_->moved(b, i, at.image), back = matrix.transpose() * by_sums;
          const auto row = static_cast<Eigen::Index>(i);
          gathered[2 * b].row(row) += ((matrix * z).cross(by_sums) - z.cross(back)).transpose();
          gathered[2 * b + 1].row(row) += back.transpose();
        }
    }
  }

  std::vector<Vec3<R>> back(const std::vector<Matrix<R>>& gathered) const override {
    const auto rows = [](const Matrix<R>& matrix) {
      std::vector<Vec3<R>> found;
      for (Eigen::Index i = 0; i < matrix.rows(); ++i) found.push_back(matrix.row(i).transpose());
      return found;
    };
    std::vector<Vec3<R>> vertices = rows(gathered[1]);
    slopes_.add_back({rows(gathered[0]), rows(gathered[2]), rows(gathered[3])}, vertices);
    return vertices;
  }

 private:
  struct Block {
    std::vector<Mat3<R>> rotations;
    std::vector<Vec3<R>> data;  // vertices, or tractions
  };
  struct Changes {
    std::vector<Vec3<R>> turns, data;
  };

  struct Shared {
    int dimension;
    std::optional<double> nu;
    std::array<Block, 2> blocks;

    Shared(int d, std::optional<double> of, Block vertices, Block normals)
        : dimension(d), nu(of), blocks{std::move(vertices), std::move(normals)} {}
    std::span<const CoordinateTable<R>> coordinates(std::span<const CoordinateTable<R>> given,
                                                    std::vector<CoordinateTable<R>>& made) const {
      if (!nu) return given;
      made = assembled(given, *nu);
      return made;
    }
    Vec3<R> moved(std::size_t block, std::size_t i, const Vec3<R>& image) const {
      return block == 0 ? Vec3<R>(blocks[0].data[i] - image) : blocks[1].data[i];
    }
  };

  // A point's matrices M, T and image.
  struct Place {
    std::array<std::vector<Mat3<R>>, 2> matrices;
    Mat3<R> whole = Mat3<R>::Zero();
    Vec3<R> image = Vec3<R>::Zero();

    Place(const Shared& shared, std::span<const CoordinateTable<R>> coordinates, std::size_t p) {
      const auto d = static_cast<std::size_t>(shared.dimension);
      if (d == 2) whole(2, 2) = 1;
      for (std::size_t b = 0; b < 2; ++b)
        for (std::size_t i = 0; i < shared.blocks[b].data.size(); ++i) {
          Mat3<R> matrix = Mat3<R>::Zero();
          const R* from = &coordinates[b].tensors[0][p * coordinates[b].stride[0] + i * d * d];
          for (std::size_t r = 0; r < d; ++r)
            for (std::size_t c = 0; c < d; ++c) matrix(static_cast<int>(r), static_cast<int>(c)) = from[r * d + c];
          const Mat3<R>& rotation = shared.blocks[b].rotations[i];
          matrix = Mat3<R>(rotation * matrix * rotation.transpose());
          image += matrix * shared.blocks[b].data[i];
          if (b == 0) whole += matrix;
          matrices[b].push_back(matrix);
        }
      image = Vec3<R>(Eigen::PartialPivLU<Mat3<R>>(whole).solve(image));
    }
  };

  class Along final : public Posed<R> {
   public:
    Along(std::shared_ptr<const Shared> shared, std::array<Changes, 2> changes)
        : shared_(std::move(shared)), changes_(std::move(changes)) {}

    const DeformationReport& report() const override { return report_; }
    Images<R> images(std::span<const CoordinateTable<R>> given, std::size_t points, int /*order*/) const override {
      std::vector<CoordinateTable<R>> made;
      const auto coordinates = shared_->coordinates(given, made);
      Images<R> images;
      for (std::size_t p = 0; p < points; ++p) {
        const Place at(*shared_, coordinates, p);
        Vec3<R> sum = Vec3<R>::Zero();
        for (std::size_t b = 0; b < 2; ++b)
          for (std::size_t i = 0; i < at.matrices[b].size(); ++i) {
            const Mat3<R>& matrix = at.matrices[b][i];
            const Vec3<R> z = shared_->moved(b, i, at.image), &turn = changes_[b].turns[i];
            sum += turn.cross(Vec3<R>(matrix * z)) + matrix * (changes_[b].data[i] - turn.cross(z));
          }
        const Vec3<R> found = Eigen::PartialPivLU<Mat3<R>>(at.whole).solve(sum);
        images.tensors[0].insert(images.tensors[0].end(), found.data(), found.data() + shared_->dimension);
      }
      return images;
    }

   private:
    std::shared_ptr<const Shared> shared_;
    std::array<Changes, 2> changes_;
    DeformationReport report_;
  };

  static std::vector<Mat3<R>> rotations_of(const std::vector<SpaceMatrix<R>>& given) {
    std::vector<Mat3<R>> found;
    found.reserve(given.size());
    for (const SpaceMatrix<R>& rotation : given) found.push_back(in_three<R>(rotation));
    return found;
  }

  std::shared_ptr<const Shared> shared_;
  CorotationSlopes<R> slopes_;
};

}  // namespace cageproof::deformation
