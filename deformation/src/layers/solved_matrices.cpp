// SPDX-License-Identifier: MIT
#include "cageproof/deformation/solved_matrices.h"

#include "../linear_posed.h"
#include "../more_digits.h"
#include "../own_place.h"
#include "../pose_roundings.h"
#include "construction.h"

#include <optional>

namespace cageproof::deformation {
namespace {

std::optional<Construction> construction_named(std::string_view kind) {
  if (kind == "regularised_1_3") return Construction::OneThree;
  if (kind == "regularised_1_2") return Construction::OneTwo;
  if (kind == "regularised_weber") return Construction::Weber;
  return std::nullopt;
}

// Collects matrices, rounded to double.
class Matrices {
 public:
  template <class Values>
  void add(std::string name, const Values& values) {
    all_.push_back({std::move(name), Matrix<double>(values.template cast<double>())});
  }
  std::vector<NamedMatrix> take() { return std::move(all_); }

 private:
  std::vector<NamedMatrix> all_;
};

template <Scalar R>
void add_samples(Matrices& to, const CageElements& elements, const SampledLayers<R>& layers) {
  const int d = elements.dimension();
  const auto count = static_cast<Eigen::Index>(layers.samples.size());
  Matrix<R> owners(count, 1), normals(count, d);
  for (Eigen::Index s = 0; s < count; ++s) {
    const auto e = static_cast<std::size_t>(layers.samples[static_cast<std::size_t>(s)].element);
    owners(s, 0) = R(static_cast<double>(e));
    for (int c = 0; c < d; ++c) normals(s, c) = R(elements.normals()[e][c]);
  }
  std::vector<Vec3<R>> vertices;
  for (const Vec3<double>& v : elements.vertices()) vertices.push_back(convert<R>(v));
  to.add("samples", Matrix<R>(layers.hats * rows_of(vertices, d)));
  to.add("sample_elements", owners);
  to.add("sample_normals", normals);
}

template <Scalar R>
void add_all(Matrices& to, Construction construction, const CageCoordinates& coordinates, int level,
             std::span<const double> weights) {
  const SampledLayers<R> layers = layers_at<R>(coordinates, level);
  const R unit(layers.unit);
  add_samples(to, coordinates.elements(), layers);
  to.add("M_V", layers.hats);
  to.add("Phi_V", layers.phi);
  to.add("Psi_V", Matrix<R>(unit * layers.psi));
  to.add("Phibar_V", Matrix<R>(unit * unit * layers.phibar));
  to.add("Psibar_V", Matrix<R>(unit * unit * unit * layers.psibar));
  const Regularisation<R> found = regularisation_by<R>(construction, coordinates, level, weights, Account::None);
  const Eigen::Index vertices = layers.phi.cols(), elements = layers.psi.cols();
  to.add("C_11", Matrix<R>(found.to_vertices.topRows(vertices)));
  to.add("C_12", Matrix<R>(found.to_vertices.bottomRows(elements)));
  to.add("C_21", Matrix<R>(found.to_normals.topRows(vertices)));
  to.add("C_22", Matrix<R>(found.to_normals.bottomRows(elements)));
  if (construction != Construction::OneThree) return;
  const R weight = one_three_weight<R>(weights, layers);
  const Matrix<R> right = one_three_inverse<R>(layers, weight);
  to.add("C_L", Matrix<R>(right.topRows(vertices) / unit / unit));
  to.add("C_D", Matrix<R>(right.bottomRows(elements) / unit / unit / unit));
  to.add("gamma_D", Matrix<R>(Matrix<R>::Constant(1, 1, weight / unit / unit / unit / unit)));
}

}  // namespace

std::vector<NamedMatrix> solved_matrices(std::string_view kind, const Cage& cage, const CoordinateOptions& options) {
  const std::optional<Construction> construction = construction_named(kind);
  if (!construction) return {};
  const CageCoordinates layers(cage, coordinate_kind_named("biharmonic"),
                               CoordinateOptions{options.evaluation, options.triangulation, {}});
  const int level = static_cast<int>(options.parameters[0]);
  const auto weights = std::span(options.parameters).subspan(1);
  Matrices matrices;
  // As the coordinates themselves are solved.
  const auto in_double = [&] {
    return regularisation_by<double>(*construction, layers, level, weights, Account::Systems).solved;
  };
  if (takes_50_digits(*construction, layers, level, in_double))
    add_all<Mp50>(matrices, *construction, layers, level, weights);
  else add_all<double>(matrices, *construction, layers, level, weights);
  return matrices.take();
}

std::vector<NamedMatrix> layer_data(const CageCoordinates& coordinates, const Posed<double>& posed) {
  const auto [own, place] = without_shift(posed);
  const auto* const sum = dynamic_cast<const LinearPosed<double>*>(&without_report(*own));
  if (sum == nullptr || coordinates.blocks().size() != 4) return {};
  std::vector<NamedMatrix> found;
  for (std::size_t b = 0; b < sum->data().size(); ++b) found.push_back({std::string(1, "VNLD"[b]), sum->data()[b]});
  // phi sums to one: shifting what it multiplies shifts images.
  for (Eigen::Index c = 0; c < found[0].values.cols(); ++c)
    found[0].values.col(c).array() += place[static_cast<int>(c)];
  return found;
}

}  // namespace cageproof::deformation
