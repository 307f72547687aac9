// SPDX-License-Identifier: MIT
#include "cageproof/validation/constrained_checks.h"

#include "cageproof/core/random_stream.h"
#include "cageproof/core/unknown_name.h"
#include "cageproof/validation/deformer_campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using deformation::ConstrainedDeformer;
using deformation::ConstraintMethod;
using deformation::Constraints;
using deformation::Images;

constexpr std::string_view rigid_pose = "rigid";
constexpr int most_positions = 6, orientations = 1, rotations = 4, most_hessians = 60;
// Of a cage of size one: with beta so small, rigid targets are met to rounding within the steps that they are given.
constexpr double of_jacobians = 1e-3, of_hessians = 1e-4;
constexpr int few_steps = 40, many_steps = 400;
constexpr double larger = 10;

int power_of_length(std::string_view weight) { return weight == "gamma" ? 4 : 2; }

bool is_weight(std::string_view parameter) {
  return parameter == "alpha" || parameter == "beta" || parameter == "gamma";
}

// Positions, and of methods that take more an orientation, rotations and as many Hessians as hold all coefficients.
std::size_t positions_of(const ConstraintMethod& method, const Cage& cage) {
  if (!method.positions_alone) return most_positions;
  return std::clamp<std::size_t>(cage.vertices().size() / 2, 1, 3);
}
std::size_t number_of_places(const ConstraintMethod& method, const Cage& cage, Triangulation rule) {
  const std::size_t positions = positions_of(method, cage);
  if (method.positions_alone) return positions;
  const std::size_t unknowns = 2 * (cage.vertices().size() + cage.parts(false, rule).elements.size());
  return positions + orientations + rotations +
         std::min<std::size_t>(most_hessians, unknowns / static_cast<std::size_t>(cage.dimension()));
}
std::vector<Vec3<double>> places_for(const ConstraintMethod& method, const Cage& cage, Triangulation rule) {
  return interior_points(cage, rule, 0, static_cast<int>(number_of_places(method, cage, rule)));
}

Eigen::Matrix3d within(int d, Eigen::Matrix3d matrix) {
  if (d == 2) matrix.row(2).setZero(), matrix.col(2).setZero();
  return matrix;
}

SpaceMap turn(int d) {
  const std::vector<SpaceMap> maps = space_maps(d);
  SpaceMap found = maps[2];
  found.shift = maps[1].shift;
  return found;
}

}  // namespace

std::vector<ConstrainedVariant> variants_of(const ConstraintMethod& method) {
  std::vector<double> values;
  values.reserve(method.parameters.size());
  for (const KindParameter& p : method.parameters)
    values.push_back(p.name == "gamma" ? of_hessians : is_weight(p.name) ? of_jacobians : p.preset);
  const auto named = std::ranges::find_if(method.parameters, [](const KindParameter& p) { return !p.names.empty(); });
  // Those of the coordinates come after the method's own.
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

// A cage, and what is asked of its map.
struct ConstrainedChecks::Problem {
  Cage cage;
  Constraints constraints;
  double size;  ///< of the cage before it was turned, in the cage's unit

  std::shared_ptr<const ConstrainedDeformer<double>> prepared(const ConstrainedVariant& variant, Triangulation rule,
                                                              int steps) const {
    std::vector<double> values = variant.parameters;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::string_view name = variant.method->parameters[k].name;
      if (is_weight(name)) values[k] *= std::pow(size, power_of_length(name));
      else if (name == "steps") values[k] = steps;
      // All steps, of methods that stop before.
      else if (name == "tolerance") values[k] = 0;
    }
    return prepare_constrained(*variant.method, cage, constraints,
                               {.triangulation = rule, .parameters = std::move(values)});
  }

  Problem under(const SpaceMap& map, double length) const {
    const auto there = [&](const Vec3<double>& x) { return Vec3<double>(length * map(x, size)); };
    std::vector<Vec3<double>> vertices;
    vertices.reserve(cage.vertices().size());
    for (const Vec3<double>& v : cage.vertices()) vertices.push_back(there(v));
    Problem found{cage.with(vertices, cage.faces()), constraints, length * size};
    for (auto& [at, to] : found.constraints.positions) at = there(at), to = there(to);
    for (auto& [at, jacobian] : found.constraints.orientations)
      at = there(at), jacobian = Mat3<double>(map.linear * jacobian * map.linear.transpose());
    for (Vec3<double>& at : found.constraints.rotations) at = there(at);
    for (Vec3<double>& at : found.constraints.hessians) at = there(at);
    return found;
  }
};

ConstrainedChecks::ConstrainedChecks(std::shared_ptr<const Cage> cage, ConstrainedVariant variant, Triangulation rule)
    : cage_(std::move(cage)),
      variant_(std::move(variant)),
      rule_(rule),
      places_(places_for(*variant_.method, *cage_, rule)) {}

ConstrainedChecks::Problem ConstrainedChecks::problem(std::string_view pose) const {
  const int d = cage_->dimension();
  const SpaceMap rigid = turn(d);
  const bool is_bent = pose == bent_pose;
  if (!is_bent && pose != rigid_pose) throw unknown_name("pose", pose);
  // Quads as triangles, whose diagonals rounding does not choose again where the cage is turned.
  const std::vector<Face> elements = cage_->parts(false, rule_).elements;
  Problem found{cage_->with(cage_->vertices(), elements), {}, cage_->size()};
  const std::size_t positions = positions_of(*variant_.method, *cage_);
  for (std::size_t p = 0; p < positions; ++p) {
    Vec3<double> to = is_bent ? places_[p] : rigid(places_[p], cage_->size());
    RandomStream random(0, fmt::format("constrained/{}", cage_->name()), p);
    for (int c = 0; c < d && is_bent; ++c) to[c] += cage_->size() * random.uniform(-0.05, 0.05);
    found.constraints.positions.push_back({places_[p], to});
  }
  if (variant_.method->positions_alone) return found;
  Eigen::Matrix3d bent_jacobian;
  bent_jacobian << 1.1, 0.1, -0.05, 0.05, 0.9, 0.1, -0.1, 0.05, 1.05;
  auto place = places_.begin() + static_cast<std::ptrdiff_t>(positions);
  found.constraints.orientations.push_back({*place++, within(d, is_bent ? bent_jacobian : rigid.linear)});
  for (int k = 0; k < rotations; ++k) found.constraints.rotations.push_back(*place++);
  found.constraints.hessians.assign(place, places_.end());
  return found;
}

std::vector<ConstrainedChecks::Question> ConstrainedChecks::questions() const {
  const std::string bent_name(bent_pose), rigid_name(rigid_pose);
  std::vector<Question> all{{"energy_falls", bent_name}, {"rigid_energy", rigid_name}};
  if (!variant_.method->positions_alone) all.push_back({"energy_is_flat", bent_name});
  // In the plane biharmonic layers have logarithms, times what no layer is: maps in other units are others.
  const bool has_biharmonic_logarithms =
      cage_->dimension() == 2 && problem(bent_pose).prepared(variant_, rule_, 1)->coordinates().blocks().size() > 2;
  if (!has_biharmonic_logarithms) all.push_back({"constrained_unit", bent_name});
  all.push_back({"constrained_motion", bent_name});
  return all;
}

std::vector<DeformerError> ConstrainedChecks::ask(const Question& question,
                                                  std::span<const Vec3<double>> points) const {
  const Problem asked = problem(question.pose);
  if (question.check == "constrained_motion") return moved(asked, turn(cage_->dimension()), 1, points);
  if (question.check == "constrained_unit") return moved(asked, SpaceMap{}, larger, points);
  if (question.check == "energy_is_flat") return {flatness(asked)};
  const bool falls = question.check == "energy_falls";
  if (!falls && question.check != "rigid_energy") throw unknown_name("check", question.check);
  const auto posed = asked.prepared(variant_, rule_, falls ? few_steps : many_steps)->pose();
  const deformation::DeformationReport& report = posed->report();
  if (!falls) {
    // Positions have the unit of an area, second derivatives that of one over it.
    const double size = cage_->size(), energy = report.energies.back();
    const double found = variant_.method->positions_alone ? energy * size * size : energy / size / size;
    return {{found, found}};
  }
  const std::vector<double>& fallen = report.merits.empty() ? report.energies : report.merits;
  double worst = 0;
  for (std::size_t k = 1; k < fallen.size(); ++k) {
    // Where nothing is left, nothing falls.
    const double rise = fallen[k] == fallen[k - 1] ? 0 : fallen[k] / fallen[k - 1] - 1;
    if (!(rise <= worst)) worst = rise;
  }
  return {{worst, worst}};
}

std::vector<DeformerError> ConstrainedChecks::moved(const Problem& here, const SpaceMap& map, double length,
                                                    std::span<const Vec3<double>> points) const {
  const Problem other = here.under(map, length);
  const double size = cage_->size();
  const int d = cage_->dimension();
  const auto model = here.prepared(variant_, rule_, few_steps), there = other.prepared(variant_, rule_, few_steps);
  const auto posed = model->pose(), posed_there = there->pose();
  double condition = 1;
  for (const auto& report : {model->prepared(), posed->report()})
    for (const SolvedSystem& system : report.systems)
      if (!system.is_singular()) condition = std::max(condition, system.condition);
  std::vector<DeformerError> errors;
  errors.reserve(points.size());
  for (const Vec3<double>& point : points) {
    const Vec3<double> to = length * map(point, size);
    const Images<double> a = model->images(*posed, std::span(&point, 1), 0),
                         b = there->images(*posed_there, std::span(&to, 1), 0);
    Vec3<double> image = Vec3<double>::Zero(), difference = Vec3<double>::Zero();
    for (int c = 0; c < d; ++c) image[c] = a.tensors[0][c];
    const Vec3<double> expected = map(image, size);
    for (int c = 0; c < d; ++c) difference[c] = b.tensors[0][c] / length - expected[c];
    errors.push_back(error_over_condition(difference.norm() / size, condition));
  }
  return errors;
}

// Half the gradient of the energy in the coefficients, in a unit in which the cage's size is one, by loops over
// constraints: in the first step rotations are those nearest to the identity.
DeformerError ConstrainedChecks::flatness(const Problem& problem) const {
  const auto model = problem.prepared(variant_, rule_, 1);
  const auto posed = model->pose();
  const CageCoordinates& coordinates = model->coordinates();
  const int d = cage_->dimension();
  const double size = cage_->size();
  double after = 0, before = 0;
  std::vector<Eigen::MatrixXd> of_map, of_rest;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    of_map.emplace_back(Eigen::MatrixXd::Zero(block.size, d));
    of_rest.emplace_back(of_map.back());
  }
  // Column c of target and identity: derivatives of component c.
  const auto add = [&](const Vec3<double>& at, int order, double weight, const Eigen::MatrixXd& target,
                       const Eigen::MatrixXd& identity) {
    const auto width = static_cast<Eigen::Index>(derivative_count(d, order));
    const Images<double> images = model->images(*posed, std::span(&at, 1), order);
    const Eigen::MatrixXd found = Eigen::Map<const Eigen::MatrixXd>(images.tensors[order].data(), width, d);
    const auto tables = coordinates.at<double>(std::span(&at, 1), order);
    for (std::size_t b = 0; b < tables.size(); ++b) {
      const Eigen::Map<const Eigen::MatrixXd> rows(tables[b].tensors[order].data(), width, of_map[b].rows());
      of_map[b] += weight * rows.transpose() * (found - target);
      of_rest[b] += weight * rows.transpose() * (identity - target);
    }
  };
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(d, d), none = Eigen::MatrixXd::Zero(d * d, d);
  const double first = of_jacobians * size * size, second = of_hessians * std::pow(size, 4);
  for (const auto& [at, to] : problem.constraints.positions)
    add(at, 0, 1, to.head(d).transpose(), at.head(d).transpose());
  for (const auto& [at, jacobian] : problem.constraints.orientations)
    add(at, 1, first, jacobian.topLeftCorner(d, d).transpose(), unit);
  for (const Vec3<double>& at : problem.constraints.rotations) add(at, 1, first, unit, unit);
  for (const Vec3<double>& at : problem.constraints.hessians) add(at, 2, second, none, none);
  for (std::size_t b = 0; b < of_map.size(); ++b) {
    const double length = std::pow(size, -2 * coordinates.blocks()[b].degree);
    after += length * of_map[b].squaredNorm();
    before += length * of_rest[b].squaredNorm();
  }
  const double found = std::sqrt(after / before);
  return {found, found};
}

}  // namespace cageproof::validation
