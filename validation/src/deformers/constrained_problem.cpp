// SPDX-License-Identifier: MIT
#include "deformers/constrained_problem.h"

#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/core/catalogue/unknown_name.h"
#include "deformer_campaign.h"
#include "run/fingerprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {

using deformation::ConstrainedDeformer;
using deformation::ConstraintMethod;

namespace {

constexpr int most_positions = 6, orientations = 1, rotations = 4, most_hessians = 60;

int power_of_length(std::string_view weight) { return weight == "gamma" ? 4 : 2; }

bool is_weight(std::string_view parameter) {
  return parameter == "alpha" || parameter == "beta" || parameter == "gamma";
}

// Positions, and of methods that take more an orientation, rotations and as many Hessians as hold all coefficients.
std::size_t positions_of(const ConstraintMethod& method, const Cage& cage) {
  if (!method.positions_alone) return most_positions;
  // One position leaves every turn about it free.
  return std::clamp<std::size_t>(cage.vertices().size() / 2, 2, 3);
}
std::size_t number_of_places(const ConstraintMethod& method, const Cage& cage, Triangulation rule) {
  const std::size_t positions = positions_of(method, cage);
  if (method.positions_alone) return positions;
  const std::size_t unknowns = 2 * (cage.vertices().size() + cage.parts(false, rule).elements.size());
  return positions + orientations + rotations +
         std::min<std::size_t>(most_hessians, unknowns / static_cast<std::size_t>(cage.dimension()));
}
Eigen::Matrix3d within(int d, Eigen::Matrix3d matrix) {
  if (d == 2) matrix.row(2).setZero(), matrix.col(2).setZero();
  return matrix;
}

}  // namespace

SpaceMap turn(int d) {
  const std::vector<SpaceMap> maps = space_maps(d);
  const auto posed = [&](std::string_view pose) { return *std::ranges::find(maps, pose, &SpaceMap::pose); };
  SpaceMap found = posed("rotation");
  found.shift = posed("shift").shift;
  return found;
}

std::vector<Vec3<double>> places_for(const ConstraintMethod& method, const Cage& cage, Triangulation rule) {
  return interior_points(cage, rule, 0, static_cast<int>(number_of_places(method, cage, rule)));
}

std::vector<ConstrainedVariant> variants_of(const ConstraintMethod& method) {
  std::vector<double> values;
  values.reserve(method.parameters.size());
  for (const KindParameter& p : method.parameters)
    values.push_back(p.name == "gamma" ? of_hessians : is_weight(p.name) ? of_jacobians : p.preset);
  const auto named = std::ranges::find_if(method.parameters, [](const KindParameter& p) { return !p.names.empty(); });
  // Parameters of the coordinates come after the method's own.
  if (method.positions_alone || named == method.parameters.end()) return {{&method, "", values}};
  std::vector<ConstrainedVariant> variants;
  variants.reserve(named->names.size());
  for (std::size_t value = 0; value < named->names.size(); ++value) {
    variants.push_back({&method, fmt::format("{}={}", named->name, named->names[value]), values});
    variants.back().parameters[named - method.parameters.begin()] = static_cast<double>(value);
  }
  return variants;
}

ConstrainedVariant variant_named(const ConstraintMethod& method, std::string_view name) {
  for (ConstrainedVariant& variant : variants_of(method))
    if (variant.name == name) return std::move(variant);
  throw unknown_name(fmt::format("variant of {}", method.name), name);
}

bool can_be_asked(const ConstraintMethod& method, const Cage& cage, Triangulation rule) {
  if (method.dimension != 0 && method.dimension != cage.dimension()) return false;
  const CoordinateKind& kind = coordinate_kind_named(method.kind.empty() ? "biharmonic" : method.kind);
  return accepts(kind, cage) && places_for(method, cage, rule).size() == number_of_places(method, cage, rule);
}

std::shared_ptr<const ConstrainedDeformer<double>> ConstrainedProblem::prepared(const ConstrainedVariant& variant,
                                                                                Triangulation rule, int steps,
                                                                                double tolerance) const {
  std::vector<double> values = variant.parameters;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string_view name = variant.method->parameters[k].name;
    if (is_weight(name)) values[k] *= std::pow(size, power_of_length(name));
    else if (name == "steps") values[k] = steps;
    else if (name == "tolerance") values[k] = tolerance;
  }
  return prepare_constrained(*variant.method, cage, constraints,
                             {.triangulation = rule, .parameters = std::move(values)});
}

ConstrainedProblem ConstrainedProblem::under(const SpaceMap& map, double length) const {
  const auto there = [&](const Vec3<double>& x) { return Vec3<double>(length * map(x, size)); };
  std::vector<Vec3<double>> vertices;
  vertices.reserve(cage.vertices().size());
  for (const Vec3<double>& v : cage.vertices()) vertices.push_back(there(v));
  ConstrainedProblem found{cage.with(vertices, cage.faces()), constraints, length * size};
  for (auto& [at, to] : found.constraints.positions) at = there(at), to = there(to);
  for (auto& [at, jacobian] : found.constraints.orientations)
    at = there(at), jacobian = Mat3<double>(map.linear * jacobian * map.linear.transpose());
  for (Vec3<double>& at : found.constraints.rotations) at = there(at);
  for (Vec3<double>& at : found.constraints.hessians) at = there(at);
  return found;
}

ConstrainedProblem constrained_problem(const ConstraintMethod& method, const Cage& cage,
                                       const std::vector<Vec3<double>>& places, std::string_view pose,
                                       Triangulation rule) {
  const int d = cage.dimension();
  const SpaceMap rigid = turn(d);
  const bool is_bent = pose == bent_pose;
  if (!is_bent && pose != rigid_pose) throw unknown_name("pose", pose);
  // Quads as triangles, whose diagonals rounding does not choose again where the cage is turned.
  const std::vector<Face> elements = cage.parts(false, rule).elements;
  ConstrainedProblem found{cage.with(cage.vertices(), elements), {}, cage.size()};
  const std::size_t positions = positions_of(method, cage);
  const std::string stream = fmt::format("constrained/{}", drawn_by(cage));
  for (std::size_t p = 0; p < positions; ++p) {
    Vec3<double> to = is_bent ? places[p] : rigid(places[p], cage.size());
    RandomStream random(0, stream, p);
    for (int c = 0; c < d && is_bent; ++c) to[c] += cage.size() * random.uniform(-0.05, 0.05);
    found.constraints.positions.push_back({places[p], to});
  }
  if (method.positions_alone) return found;
  Eigen::Matrix3d bent_jacobian;
  bent_jacobian << 1.1, 0.1, -0.05, 0.05, 0.9, 0.1, -0.1, 0.05, 1.05;
  auto place = places.begin() + static_cast<std::ptrdiff_t>(positions);
  found.constraints.orientations.push_back({*place++, within(d, is_bent ? bent_jacobian : rigid.linear)});
  for (int k = 0; k < rotations; ++k) found.constraints.rotations.push_back(*place++);
  found.constraints.hessians.assign(place, places.end());
  return found;
}

}  // namespace cageproof::validation
