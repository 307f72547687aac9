// SPDX-License-Identifier: MIT
// The four layers with densities that the user gives ([T24] Eq 19).
#include "layer_deformer.h"

namespace cageproof::deformation {
namespace {

template <Scalar R>
class Direct final : public LayerDeformer<R> {
 public:
  Direct(const Cage& cage, const DeformOptions& options)
      : LayerDeformer<R>(cage, options), stretch_(static_cast<Stretch>(static_cast<int>(options.parameters[0]))) {}

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const CageElements& elements = this->coordinates().elements();
    check_pose(elements, pose);
    DeformationReport report;
    const int d = elements.dimension();
    std::vector<Matrix<R>> data{rows_of(pose.vertices, d), rows_of(pose.normal_derivatives, d),
                                rows_of(pose.laplacians, d), rows_of(pose.laplacian_derivatives, d)};
    if (pose.normal_derivatives.empty()) {
      warn_of_orientation(elements, pose.vertices, report.warnings);
      data[1] = rows_of(stretched_normals(stretch_, elements, pose.vertices), d);
    }
    if (pose.laplacians.empty()) data[2] = Matrix<R>::Zero(data[0].rows(), d);
    if (pose.laplacian_derivatives.empty()) data[3] = Matrix<R>::Zero(data[1].rows(), d);
    return std::make_unique<LinearPosed<R>>(std::move(data), std::move(report));
  }

 private:
  Stretch stretch_;
};

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_direct(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Direct<R>>(cage, options);
}

const RegisterDeformMethod direct{
    {.name = "biharmonic_direct",
     .source = "[T24] Eq 19",
     .keeps = "rigid maps, without densities (normals=rms, mean, area: similarities)",
     .kind = "biharmonic",
     .parameters = {{{.name = "normals", .preset = 3, .lowest = -1, .highest = 4, .whole = true},
                     "how long posed normals are",
                     stretch_names()}},
     .takes_normal_derivatives = true,
     .takes_laplacians = true,
     .prepare = prepare_direct<double>,
     .prepare_in_50_digits = prepare_direct<Mp50>}};

}  // namespace
}  // namespace cageproof::deformation
