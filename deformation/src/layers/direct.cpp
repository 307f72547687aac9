// SPDX-License-Identifier: MIT
// The four layers with densities that the user gives ([T24] Eq 19).
#include "construction.h"
#include "layer_deformer.h"

namespace cageproof::deformation {
namespace {

template <Scalar R>
class Direct final : public LayerDeformer<R> {
 public:
  Direct(CageCoordinates layers, const std::vector<double>& parameters)
      : LayerDeformer<R>(std::move(layers)), stretch_(static_cast<Stretch>(static_cast<int>(parameters[0]))) {}

  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    if (normals_by(parameters[1]) != this->normals_of()) return nullptr;
    return std::make_shared<Direct>(this->coordinates(), parameters);
  }

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const CageElements& elements = this->coordinates().elements();
    check_pose(elements, pose, this->normals_of());
    DeformationReport report;
    const int d = elements.dimension();
    std::vector<Matrix<R>> data{rows_of(pose.vertices, d), rows_of(pose.normal_derivatives, d),
                                rows_of(pose.laplacians, d), rows_of(pose.laplacian_derivatives, d)};
    if (pose.normal_derivatives.empty()) data[1] = rows_of(this->own_normals(stretch_, pose.vertices, report), d);
    // Layers that nothing multiplies may be beyond the range of double.
    if (pose.laplacians.empty() && pose.laplacian_derivatives.empty()) data.resize(2);
    else if (pose.laplacians.empty()) data[2] = Matrix<R>::Zero(data[0].rows(), d);
    else if (pose.laplacian_derivatives.empty())
      data[3] = Matrix<R>::Zero(static_cast<Eigen::Index>(elements.count()), d);
    return std::make_unique<LinearPosed<R>>(std::move(data), std::move(report));
  }
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    return std::make_unique<LinearPoseDerivative<R>>(this->coordinates().dimension(), pose.vertices.size(),
                                                     this->normal_slopes_at(stretch_, pose));
  }

 private:
  Stretch stretch_;
};

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_direct(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Direct<R>>(layers_of(cage, options, normals_by(options.parameters[1])), options.parameters);
}

const RegisterDeformMethod direct{
    {.name = "biharmonic_direct",
     .source = "[T24] Eq 19",
     .keeps = "rigid maps, without densities (normals=rms, mean, area: similarities)",
     .kind = "biharmonic",
     .parameters = {{{.name = "normals", .preset = 3, .lowest = -1, .highest = 4, .whole = true},
                     "how long posed normals are",
                     stretch_names()},
                    neumann_parameter()},
     .coordinate_parameters = {"neumann"},
     .takes_normal_derivatives = true,
     .takes_laplacians = true,
     .has_pose_derivative = true,
     .prepare = prepare_direct<double>,
     .prepare_in_50_digits = prepare_direct<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
