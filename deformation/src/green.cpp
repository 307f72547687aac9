// SPDX-License-Identifier: MIT
// The deformer of Green coordinates (Lipman et al. 2008): f = phi V' + psi N', N' the posed normals, stretched.
#include "linear_posed.h"
#include "posed_orientation.h"

#include "cageproof/deformation/stretch.h"

namespace cageproof::deformation {
namespace {

template <Scalar R>
class Green final : public Deformer<R> {
 public:
  Green(CageCoordinates coordinates, const std::vector<double>& parameters)
      : coordinates_(std::move(coordinates)), stretch_(static_cast<Stretch>(static_cast<int>(parameters[0]))) {}

  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    return std::make_shared<Green>(coordinates_, parameters);
  }

  const CageCoordinates& coordinates() const override { return coordinates_; }
  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    check_pose(coordinates_.elements(), pose);
    const int d = coordinates_.dimension();
    const auto normals = pose.normal_derivatives.empty()
                             ? stretched_normals(stretch_, coordinates_.elements(), pose.vertices)
                             : pose.normal_derivatives;
    DeformationReport report;
    if (pose.normal_derivatives.empty()) warn_of_orientation(coordinates_.elements(), pose.vertices, report.warnings);
    return std::make_unique<LinearPosed<R>>(std::vector<Matrix<R>>{rows_of(pose.vertices, d), rows_of(normals, d)},
                                            std::move(report));
  }

 private:
  CageCoordinates coordinates_;
  Stretch stretch_;
};

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Green<R>>(CageCoordinates(cage, coordinate_kind_named("green"),
                                                    CoordinateOptions{options.evaluation, options.triangulation, {}}),
                                    options.parameters);
}

const RegisterDeformMethod green{
    {.name = "green",
     .source = "Lipman, Levin, Cohen-Or 2008; [T24] Section 2",
     .keeps = "similarities (stretch=unit: rigid maps)",
     .kind = "green",
     .parameters = {{{.name = "stretch", .preset = 0, .lowest = -1, .highest = 4, .whole = true},
                     "of the posed normals",
                     stretch_names()}},
     .takes_normal_derivatives = true,
     .prepare = prepare<double>,
     .prepare_in_50_digits = prepare<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
