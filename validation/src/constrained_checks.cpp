// SPDX-License-Identifier: MIT
#include "cageproof/validation/constrained_checks.h"

#include "constrained_problem.h"

#include "cageproof/core/unknown_name.h"

#include <algorithm>
#include <cmath>

namespace cageproof::validation {
namespace {

using deformation::Images;

constexpr int few_steps = 40, many_steps = 400;
constexpr double larger = 10;

}  // namespace

ConstrainedChecks::ConstrainedChecks(std::shared_ptr<const Cage> cage, ConstrainedVariant variant, Triangulation rule)
    : cage_(std::move(cage)),
      variant_(std::move(variant)),
      rule_(rule),
      places_(places_for(*variant_.method, *cage_, rule)) {}

ConstrainedProblem ConstrainedChecks::problem(std::string_view pose) const {
  return constrained_problem(*variant_.method, *cage_, places_, pose, rule_);
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
  const ConstrainedProblem asked = problem(question.pose);
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

std::vector<DeformerError> ConstrainedChecks::moved(const ConstrainedProblem& here, const SpaceMap& map, double length,
                                                    std::span<const Vec3<double>> points) const {
  const ConstrainedProblem other = here.under(map, length);
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
DeformerError ConstrainedChecks::flatness(const ConstrainedProblem& problem) const {
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
