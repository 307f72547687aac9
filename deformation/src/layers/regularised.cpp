// SPDX-License-Identifier: MIT
// [T24]'s regularised biharmonic deformers with posed normals: (1,3), (1,2) and Weber's construction.
#include "layer_deformer.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

enum class Construction { OneThree, OneTwo, Weber };

// Along the rest normals of the samples' elements, of all four layers.
template <Scalar R>
std::array<Matrix<R>, 4> normal_slopes(const CageCoordinates& coordinates, const std::vector<Touching>& samples) {
  const auto tables = checked_limits<R>(coordinates, samples, 1);
  const int d = coordinates.dimension();
  std::array<Matrix<R>, 4> found;
  for (std::size_t b = 0; b < 4; ++b) {
    found[b] = Matrix<R>::Zero(static_cast<Eigen::Index>(samples.size()), coordinates.blocks()[b].size);
    for (int c = 0; c < d; ++c) {
      const Matrix<R> along = component(tables[b], samples.size(), 1, d, c);
      for (std::size_t s = 0; s < samples.size(); ++s) {
        const auto row = static_cast<Eigen::Index>(s);
        found[b].row(row) += R(coordinates.elements().normals()[samples[s].element][c]) * along.row(row);
      }
    }
  }
  return found;
}

double size_of(const CageElements& elements) {
  Vec3<double> low = elements.vertices()[0], high = low;
  for (const Vec3<double>& v : elements.vertices()) low = low.cwiseMin(v), high = high.cwiseMax(v);
  return (high - low).norm();
}

template <Scalar R, Construction C>
class Regularised final : public LayerDeformer<R> {
 public:
  Regularised(const Cage& cage, const DeformOptions& options)
      : LayerDeformer<R>(cage, options), stretch_(static_cast<Stretch>(static_cast<int>(options.parameters[1]))) {
    const SampledLayers<R> layers = layers_at<R>(this->coordinates(), static_cast<int>(options.parameters[0]));
    if constexpr (C == Construction::OneThree) {
      // NaN: the one that is not given.
      const double gamma = options.parameters[2], relative = options.parameters[3];
      const double size = size_of(this->coordinates().elements());
      this->regularise(one_three<R>(layers, relative >= 0 ? R(relative) / R(std::pow(size, 4)) : R(gamma)));
    } else if constexpr (C == Construction::OneTwo) {
      this->regularise(one_two<R>(layers, normal_slopes<R>(this->coordinates(), layers.samples)));
    } else {
      this->regularise(weber<R>(layers));
    }
  }

  std::unique_ptr<const Posed<R>> pose(const Pose<R>& pose) const override {
    const CageElements& elements = this->coordinates().elements();
    check_pose(elements, pose.vertices);
    DeformationReport report;
    warn_of_orientation(elements, pose.vertices, report.warnings);
    const int d = elements.dimension();
    const auto normals = pose.normal_derivatives.empty() ? stretched_normals(stretch_, elements, pose.vertices)
                                                         : pose.normal_derivatives;
    return this->with(rows_of(pose.vertices, d), rows_of(normals, d), std::move(report));
  }

 private:
  Stretch stretch_;
};

template <Construction C, Scalar R>
std::shared_ptr<const Deformer<R>> prepare(const Cage& cage, const DeformOptions& options) {
  return std::make_shared<Regularised<R, C>>(cage, options);
}

std::vector<KindParameter> parameters(bool with_gamma) {
  std::vector<KindParameter> all{{{.name = "level", .preset = 1, .lowest = -1, .highest = 6, .whole = true},
                                  "times that elements are split for samples: 4^level a triangle"},
                                 {{.name = "normals", .preset = 3, .lowest = -1, .highest = 4, .whole = true},
                                  "how long posed normals are",
                                  stretch_names()}};
  if (!with_gamma) return all;
  all.push_back({{.name = "gamma_d", .preset = 1, .lowest = -1e-300, .highest = 1e300},
                 "weight of values against Laplacians; has the unit of one over the fourth power of a length"});
  all.push_back(
      {{.name = "gamma_rel", .preset = -1, .lowest = -1.5, .highest = 1e300},
       "the same over the fourth power of the rest cage's size; in place of gamma_d where it is not negative"});
  return all;
}

template <Construction C>
DeformMethod method(std::string_view name, std::string_view source) {
  return {.name = name,
          .source = source,
          .keeps = "rigid maps (normals=rms, mean, area: similarities)",
          .kind = "biharmonic",
          .parameters = parameters(C == Construction::OneThree),
          .takes_normal_derivatives = true,
          .takes_derivatives_on_cage = C == Construction::OneTwo,
          .prepare = prepare<C, double>,
          .prepare_in_50_digits = prepare<C, Mp50>};
}

const RegisterDeformMethod one_three_method{
    method<Construction::OneThree>("biharmonic_1_3", "[T24] Section 4.1, Eq 20-30")};
const RegisterDeformMethod one_two_method{
    method<Construction::OneTwo>("biharmonic_1_2", "[T24] Appendix D.1, after the errata")};
const RegisterDeformMethod weber_method{
    method<Construction::Weber>("biharmonic_weber", "[T24] Appendix D.2, after the errata")};

}  // namespace
}  // namespace cageproof::deformation
