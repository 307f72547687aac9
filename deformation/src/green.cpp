// SPDX-License-Identifier: MIT
// The deformer of Green coordinates (Lipman et al. 2008): f = phi V' + psi N', N' the posed normals, stretched. On
// quads that are kept there is one per corner.
#include "kept_quads.h"
#include "linear_pose_derivative.h"
#include "normal_slopes.h"
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
    check_pose(coordinates_.elements(), pose, normals_owner(coordinates_));
    const int d = coordinates_.dimension();
    const auto normals = pose.normal_derivatives.empty()
                             ? stretched_normals(stretch_, coordinates_.elements(), pose.vertices)
                             : pose.normal_derivatives;
    DeformationReport report;
    if (pose.normal_derivatives.empty()) warn_of_orientation(coordinates_.elements(), pose.vertices, report.warnings);
    return std::make_unique<LinearPosed<R>>(std::vector<Matrix<R>>{rows_of(pose.vertices, d), rows_of(normals, d)},
                                            std::move(report));
  }
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    const CageElements& elements = coordinates_.elements();
    check_pose(elements, pose, normals_owner(coordinates_));
    return std::make_unique<LinearPoseDerivative<R>>(coordinates_.dimension(), pose.vertices.size(),
                                                     pose.normal_derivatives.empty()
                                                         ? stretched_normal_slopes(stretch_, elements, pose.vertices)
                                                         : RowSlopes<R>{.rows = pose.normal_derivatives.size()});
  }

 private:
  CageCoordinates coordinates_;
  Stretch stretch_;
};

std::string_view kind_of_green(bool keeps_quads) { return keeps_quads ? "quad_green" : "green"; }

template <Scalar R, bool KeepsQuads>
std::shared_ptr<const Deformer<R>> prepare(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Green<R>>(CageCoordinates(cage, coordinate_kind_named(kind_of_green(KeepsQuads)),
                                                    CoordinateOptions{options.evaluation, options.triangulation, {}}),
                                    options.parameters);
}

template <bool KeepsQuads>
DeformMethod method_of_green() {
  return {.name = kind_of_green(KeepsQuads),
          .source = KeepsQuads ? "Thiery, Boubekeur 2022" : "Lipman, Levin, Cohen-Or 2008; [T24] Section 2",
          .keeps = KeepsQuads ? "similarities (stretch=unit, product: rigid maps)"
                              : "similarities (stretch=unit: rigid maps)",
          .kind = kind_of_green(KeepsQuads),
          .parameters = {stretch_parameter("stretch", "of the posed normals", Stretch::Rms, KeepsQuads)},
          .takes_normal_derivatives = true,
          .has_pose_derivative = true,
          .refuses = KeepsQuads ? why_quads_are_refused : nullptr,
          .prepare = prepare<double, KeepsQuads>,
          .prepare_in_50_digits = prepare<Mp50, KeepsQuads>};
}

const RegisterDeformMethod green{method_of_green<false>()}, quad_green{method_of_green<true>()};

}  // namespace
}  // namespace cageproof::deformation
