// SPDX-License-Identifier: MIT
#include "deformers/deformer_route.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cageproof::validation {

using namespace second_routes;

namespace {

// A variant's parameters by their names.
class Given {
 public:
  explicit Given(const DeformerVariant& variant)
      : variant_(variant), parameters_(deformation::parameters_of(*variant.method)) {}

  double number(std::string_view parameter, double otherwise) const {
    const std::size_t i = place_of(parameter);
    return i < parameters_.size() ? variant_.parameters[i] : otherwise;
  }
  std::string_view name(std::string_view parameter, std::string_view otherwise) const {
    const std::size_t i = place_of(parameter);
    return i < parameters_.size() ? parameters_[i].names.at(static_cast<std::size_t>(variant_.parameters[i]))
                                  : otherwise;
  }

 private:
  std::size_t place_of(std::string_view parameter) const {
    return std::ranges::find(parameters_, parameter, [](const KindParameter& p) { return std::string_view(p.name); }) -
           parameters_.begin();
  }

  const DeformerVariant& variant_;
  std::vector<KindParameter> parameters_;
};

}  // namespace

std::optional<LayerMethod> layer_method_of(const DeformerVariant& variant, double cage_size) {
  static const std::map<std::string_view, Required> constructions{
      {"biharmonic_1_3", Required::ValuesAndLaplacians},
      {"biharmonic_1_2", Required::ValuesAndSlopes},
      {"biharmonic_weber", Required::ValuesByLaplacians},
  };
  static const std::map<std::string_view, Squares> energies{
      {"ahap", Squares::Laplacians}, {"aaap", Squares::Hessians}, {"tp", Squares::AlongNormal}};
  static const std::map<std::string_view, NormalLength> lengths{{"unit", NormalLength::Unit},
                                                                {"rms", NormalLength::Rms},
                                                                {"mean", NormalLength::Mean},
                                                                {"area", NormalLength::Area}};
  static const std::map<std::string_view, Along> alignments{
      {"hard", Along::Hard}, {"soft", Along::Soft}, {"free", Along::Free}, {"nonnegative", Along::NonNegative}};
  const auto construction = constructions.find(variant.method->name);
  const auto energy = energies.find(variant.method->name);
  if (construction == constructions.end() && energy == energies.end()) return std::nullopt;
  const Given given(variant);
  // Affine normal derivatives are turned with vertices, which is another matter.
  if (given.name("neumann", "constant") != "constant") return std::nullopt;
  const double relative = given.number("gamma_rel", 0);
  LayerMethod method{
      .densities = {.required = energy == energies.end() ? construction->second : Required::ValuesAndLaplacians,
                    .level = static_cast<int>(given.number("level", 1)),
                    .gamma_d =
                        relative != 0 ? Wide(relative / std::pow(cage_size, 4)) : Wide(given.number("gamma_d", 1))},
      .length = lengths.at(given.name("normals", "unit"))};
  if (energy != energies.end())
    method.alignment = AlignmentMethod{.squares = energy->second,
                                       .level = static_cast<int>(given.number("energy_level", 1)),
                                       .along = alignments.at(given.name("alignment", "hard")),
                                       .gamma_a = Wide(given.number("gamma_a", 1))};
  return method;
}

}  // namespace cageproof::validation
