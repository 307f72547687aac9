// SPDX-License-Identifier: MIT
// [T24]'s regularised biharmonic deformers with posed normals: (1,3), (1,2) and Weber's construction, and (1,3) on
// quads that are kept.
#include "../kept_quads.h"
#include "construction.h"
#include "layer_deformer.h"
#include "overlap.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

namespace cageproof::deformation {
namespace {

// The parameters' order: the construction's weights, of which some have none, before `neumann`.
enum : std::size_t { kLevel, kNormals, kWeights };

template <Construction C>
std::size_t place_of_neumann() {
  return kWeights + weight_parameters(C).size();
}

// The parameters that decide the regularisation.
template <Construction C>
std::vector<double> construction_of(const std::vector<double>& parameters) {
  std::vector<double> found{parameters[kLevel]};
  const auto weights = std::span(parameters).subspan(kWeights, weight_parameters(C).size());
  found.insert(found.end(), weights.begin(), weights.end());
  return found;
}

// \param KeepsQuads whether the layers are those of bilinear quads, whose normal derivatives are bilinear, neither
// constant nor affine
template <Scalar R, Construction C, bool KeepsQuads>
class Regularised final : public LayerDeformer<R> {
 public:
  Regularised(CageCoordinates layers, const std::vector<double>& parameters)
      : LayerDeformer<R>(std::move(layers)),
        stretch_(stretch_by(parameters)),
        construction_(construction_of<C>(parameters)) {
    this->regularise(regularisation_by<R>(C, this->coordinates(), static_cast<int>(parameters[kLevel]),
                                          std::span(construction_).subspan(1), Account::Systems));
  }

  std::shared_ptr<const Deformer<R>> with_parameters(const std::vector<double>& parameters) const override {
    if (!KeepsQuads && normals_by(parameters[place_of_neumann<C>()]) != this->normals_of()) return nullptr;
    if (construction_of<C>(parameters) != construction_)
      return std::make_shared<Regularised>(this->coordinates(), parameters);
    // Only the posed normals differ.
    auto same = std::make_shared<Regularised>(*this);
    same->stretch_ = stretch_by(parameters);
    return same;
  }

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const CageElements& elements = this->coordinates().elements();
    check_pose(elements, pose, this->normals_of());
    DeformationReport report;
    const std::vector<Vec3<R>> normals =
        pose.normal_derivatives.empty() ? this->own_normals(stretch_, pose.vertices, report) : pose.normal_derivatives;
    const int d = elements.dimension();
    const Matrix<R> vertices = rows_of(pose.vertices, d);
    return this->with(vertices, rows_of(normals, d), this->similar_to(vertices), std::move(report));
  }
  std::unique_ptr<const PoseDerivative<R>> derivative(const Pose<R>& pose) const override {
    const Regularisation<R>& maps = this->regularisation();
    return std::make_unique<LinearPoseDerivative<R>>(this->coordinates().dimension(), pose.vertices.size(),
                                                     this->normal_slopes_at(stretch_, pose),
                                                     DensityMaps<R>{maps.to_vertices, maps.to_normals});
  }

 private:
  static Stretch stretch_by(const std::vector<double>& parameters) {
    return static_cast<Stretch>(static_cast<int>(parameters[kNormals]));
  }

  Stretch stretch_;
  std::vector<double> construction_;
};

template <Construction C, bool KeepsQuads, Scalar R>
std::shared_ptr<const Deformer<R>> prepare(const Cage& cage, const DeformOptions& options) {
  CageCoordinates layers = KeepsQuads ? quad_layers_of(cage, options)
                                      : layers_of(cage, options, normals_by(options.parameters[place_of_neumann<C>()]));
  return std::make_shared<Regularised<R, C, KeepsQuads>>(std::move(layers), options.parameters);
}

std::vector<KindParameter> parameters(Construction construction, bool keeps_quads) {
  std::vector<KindParameter> all{
      level_parameter(), stretch_parameter("normals", "how long posed normals are", Stretch::Unit, keeps_quads)};
  for (KindParameter& p : weight_parameters(construction)) all.push_back(std::move(p));
  if (!keeps_quads) all.push_back(neumann_parameter());
  return all;
}

template <Construction C, bool KeepsQuads = false>
DeformMethod method(std::string_view name, std::string_view source) {
  DeformMethod found{.name = name,
                     .source = source,
                     .keeps = "rigid maps (normals=rms, mean, area: similarities)",
                     .kind = KeepsQuads ? "quad_biharmonic" : "biharmonic",
                     .parameters = parameters(C, KeepsQuads),
                     .takes_normal_derivatives = true,
                     .takes_derivatives_on_cage = C == Construction::OneTwo,
                     .has_pose_derivative = true,
                     .refuses = KeepsQuads ? why_kept_overlap_is_refused : why_overlap_is_refused,
                     .prepare = prepare<C, KeepsQuads, double>,
                     .prepare_in_50_digits = prepare<C, KeepsQuads, Mp50>};
  if (!KeepsQuads) found.coordinate_parameters = {"neumann"};
  return found;
}

const RegisterDeformMethod one_three_method{
    method<Construction::OneThree>("biharmonic_1_3", "[T24] Section 4.1, Eq 20-30")};
const RegisterDeformMethod quad_one_three_method{
    method<Construction::OneThree, true>("quad_biharmonic_1_3", "[T24] Section 4.1, Eq 20-30, on bilinear faces")};
const RegisterDeformMethod one_two_method{
    method<Construction::OneTwo>("biharmonic_1_2", "[T24] Appendix D.1, after the errata")};
const RegisterDeformMethod weber_method{
    method<Construction::Weber>("biharmonic_weber", "[T24] Appendix D.2, after the errata")};

}  // namespace
}  // namespace cageproof::deformation
