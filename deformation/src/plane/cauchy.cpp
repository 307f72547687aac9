// SPDX-License-Identifier: MIT
// Deformation by Cauchy coordinates of the plane, f = sum C_j f_j in complex numbers.
#include "../linear_pose_derivative.h"
#include "../posed_orientation.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {
namespace {

template <Scalar R>
class Cauchy final : public Deformer<R> {
 public:
  Cauchy(const Cage& cage, const DeformOptions& options)
      : coordinates_(cage, coordinate_kind_named("cauchy"),
                     CoordinateOptions{options.evaluation, options.triangulation, {}}) {}

  const CageCoordinates& coordinates() const override { return coordinates_; }
  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose);
    const Matrix<R> vertices = rows_of(pose.vertices, 2);
    // Imaginary parts multiply the vertices times i.
    Matrix<R> turned(vertices.rows(), 2);
    turned << -vertices.col(1), vertices.col(0);
    DeformationReport report;
    warn_of_orientation(coordinates_.elements(), pose.vertices, report.warnings);
    return std::make_unique<LinearPosed<R>>(std::vector<Matrix<R>>{vertices, turned}, std::move(report));
  }
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose);
    Mat3<R> quarter = Mat3<R>::Zero();
    quarter(0, 1) = -1;
    quarter(1, 0) = 1;
    RowSlopes<R> turned{.rows = pose.vertices.size()};
    for (std::size_t v = 0; v < pose.vertices.size(); ++v) turned.parts.push_back({v, static_cast<int>(v), quarter});
    return std::make_unique<LinearPoseDerivative<R>>(2, pose.vertices.size(), std::move(turned));
  }

 private:
  CageCoordinates coordinates_;
};

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_cauchy(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Cauchy<R>>(cage, options);
}

const RegisterDeformMethod cauchy{{.name = "cauchy",
                                   .source = "Weber, Ben-Chen, Gotsman 2009; [W12] Section 5.2 after the errata",
                                   .keeps = "similarities",
                                   .kind = "cauchy",
                                   .has_pose_derivative = true,
                                   .prepare = prepare_cauchy<double>,
                                   .prepare_in_50_digits = prepare_cauchy<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
