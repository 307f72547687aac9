// SPDX-License-Identifier: MIT
// Deformation by Cauchy coordinates of the plane, f = sum C_j f_j in complex numbers.
#include "../linear_posed.h"
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
                                   .prepare = prepare_cauchy<double>,
                                   .prepare_in_50_digits = prepare_cauchy<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
