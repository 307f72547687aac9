// SPDX-License-Identifier: MIT
#include "cageproof/deformation/constrained.h"

#include "more_digits.h"
#include "own_place.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cageproof::deformation {
namespace {

std::list<DeformMethod>& known() {
  static std::list<DeformMethod> methods;
  return methods;
}

std::list<ConstraintMethod>& known_of_constraints() {
  static std::list<ConstraintMethod> methods;
  return methods;
}

std::vector<double> checked(std::string_view method, const std::vector<KindParameter>& parameters,
                            std::vector<double> given) {
  if (given.size() > parameters.size())
    throw InputError(fmt::format("{} takes {} parameters, not {}", method, parameters.size(), given.size()));
  while (given.size() < parameters.size()) given.push_back(parameters[given.size()].preset);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!parameters[i].allows(given[i]))
      throw InputError(fmt::format("{}: {} = {} is out of range", method, parameters[i].name, given[i]));
  return given;
}

}  // namespace

const std::list<DeformMethod>& deform_methods() { return known(); }

RegisterDeformMethod::RegisterDeformMethod(DeformMethod method) {
  const auto after = std::ranges::upper_bound(known(), method.name, {}, &DeformMethod::name);
  known().insert(after, std::move(method));
}

const DeformMethod& deform_method_named(std::string_view name) {
  const auto found = std::ranges::find(known(), name, &DeformMethod::name);
  if (found == known().end()) {
    std::vector<std::string_view> names;
    for (const DeformMethod& method : known()) names.push_back(method.name);
    for (const ConstraintMethod& method : constraint_methods()) names.push_back(method.name);
    throw unknown_single_name("deformer", name, names);
  }
  return *found;
}

const DeformMethod& keeping_quads(const DeformMethod& method) {
  if (coordinate_kind_named(method.kind).keeps_quads) return method;
  constexpr std::string_view prefix = "quad_";
  std::vector<std::string_view> others;
  for (const DeformMethod& other : known()) {
    if (!other.name.starts_with(prefix)) continue;
    others.push_back(other.name.substr(prefix.size()));
    if (others.back() == method.name) return other;
  }
  throw InputError(fmt::format("{}: there is no such deformer of bilinear quads; there is of {}", method.name,
                               fmt::join(others, ", ")));
}

std::vector<KindParameter> parameters_of(const DeformMethod& method) {
  std::vector<KindParameter> all = method.parameters;
  if (method.with_parameters_of_kind)
    for (KindParameter& p : cageproof::parameters_of(coordinate_kind_named(method.kind))) all.push_back(std::move(p));
  return all;
}

bool decides_coordinates(const DeformMethod& method, std::string_view parameter) {
  const auto is_that = [&](const KindParameter& p) { return p.name == parameter; };
  if (std::ranges::none_of(method.parameters, is_that)) return true;
  return std::ranges::find(method.coordinate_parameters, parameter) != method.coordinate_parameters.end();
}

std::string why_refused(const DeformMethod& method, const Cage& cage) {
  const CoordinateKind& kind = coordinate_kind_named(method.kind);
  if (!exists_on(kind, cage)) return fmt::format("{} does not exist on cages of this dimension", method.name);
  if (!accepts(kind, cage)) return cageproof::why_refused(kind, cage);
  return method.refuses ? method.refuses(cage) : "";
}

const std::list<ConstraintMethod>& constraint_methods() {
  // Kinds may register after methods do.
  static const bool completed = [] {
    for (ConstraintMethod& method : known_of_constraints())
      if (!method.kind.empty())
        for (KindParameter& p : cageproof::parameters_of(coordinate_kind_named(method.kind)))
          method.parameters.push_back(std::move(p));
    return true;
  }();
  static_cast<void>(completed);
  return known_of_constraints();
}

RegisterConstraintMethod::RegisterConstraintMethod(ConstraintMethod method) {
  const auto after = std::ranges::upper_bound(known_of_constraints(), method.name, {}, &ConstraintMethod::name);
  known_of_constraints().insert(after, std::move(method));
}

const ConstraintMethod* find_constraint_method(std::string_view name) {
  const auto found = std::ranges::find(constraint_methods(), name, &ConstraintMethod::name);
  return found == constraint_methods().end() ? nullptr : &*found;
}

std::shared_ptr<const ConstrainedDeformer<double>> prepare_constrained(const ConstraintMethod& method, const Cage& cage,
                                                                       const Constraints& constraints,
                                                                       DeformOptions options) {
  options.parameters = checked(method.name, method.parameters, std::move(options.parameters));
  if (method.dimension != 0 && method.dimension != cage.dimension())
    throw InputError(fmt::format("{}: {} does not exist on cages of this dimension", cage.name(), method.name));
  if (method.positions_alone) {
    const auto refuse = [&](std::string_view what, bool any) {
      if (any) throw ConstraintError(fmt::format("{} takes only positions, not \"{}\"", method.name, what));
    };
    refuse("orientations", !constraints.orientations.empty());
    refuse("rotations", !constraints.rotations.empty());
    refuse("hessians", !constraints.hessians.empty());
  }
  return method.prepare(cage, constraints, options);
}

template <Scalar R>
std::shared_ptr<const Deformer<R>> prepare_deformer(const DeformMethod& method, const Cage& cage,
                                                    DeformOptions options) {
  options.parameters = checked(method.name, parameters_of(method), std::move(options.parameters));
  if (const std::string reason = why_refused(method, cage); !reason.empty())
    throw InputError(fmt::format("{}: {}", cage.name(), reason));
  if constexpr (std::same_as<R, double>) return in_own_place<R>(prepared_in_digits_enough(method, cage, options));
  else return in_own_place<R>(method.prepare_in_50_digits(cage, options));
}

template <Scalar R>
std::shared_ptr<const Deformer<R>> with_other_parameters(const DeformMethod& method, const Deformer<R>& deformer,
                                                         const std::vector<double>& parameters) {
  auto found = deformer.with_parameters(checked(method.name, parameters_of(method), parameters));
  if (!found)
    throw InputError(fmt::format("{}: other parameters than it was prepared for take other coordinates", method.name));
  return found;
}

template <Scalar R>
std::unique_ptr<const PoseDerivative<R>> pose_derivative(const DeformMethod& method, const Deformer<R>& deformer,
                                                         const Pose<R>& pose) {
  if (auto found = deformer.derivative(pose)) return found;
  std::vector<std::string_view> names;
  for (const DeformMethod& other : known())
    if (other.has_pose_derivative) names.push_back(other.name);
  throw InputError(fmt::format("{}: images have no derivatives by posed vertices{} yet; those of {} have", method.name,
                               method.has_pose_derivative ? " with these parameters" : "", fmt::join(names, ", ")));
}

template std::unique_ptr<const PoseDerivative<double>> pose_derivative<double>(const DeformMethod&,
                                                                               const Deformer<double>&,
                                                                               const Pose<double>&);
template std::unique_ptr<const PoseDerivative<Mp50>> pose_derivative<Mp50>(const DeformMethod&, const Deformer<Mp50>&,
                                                                           const Pose<Mp50>&);
template std::shared_ptr<const Deformer<double>> with_other_parameters<double>(const DeformMethod&,
                                                                               const Deformer<double>&,
                                                                               const std::vector<double>&);
template std::shared_ptr<const Deformer<Mp50>> with_other_parameters<Mp50>(const DeformMethod&, const Deformer<Mp50>&,
                                                                           const std::vector<double>&);
template std::shared_ptr<const Deformer<double>> prepare_deformer<double>(const DeformMethod&, const Cage&,
                                                                          DeformOptions);
template std::shared_ptr<const Deformer<Mp50>> prepare_deformer<Mp50>(const DeformMethod&, const Cage&, DeformOptions);

}  // namespace cageproof::deformation
