// SPDX-License-Identifier: MIT
#include "constrained_checks.h"

#include "deformers/constrained_problem.h"
#include "deformers/constrained_route.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cageproof::validation {
namespace {

using deformation::Images;

// A problem's solution, and how well it is determined.
struct SolvedProblem {
  std::shared_ptr<const deformation::ConstrainedDeformer<double>> model;
  std::unique_ptr<const deformation::Posed<double>> posed;

  double condition() const {
    double worst = 1;
    for (const auto& report : {model->prepared(), posed->report()})
      for (const SolvedSystem& system : report.systems)
        if (!system.is_singular()) worst = std::max(worst, system.condition);
    return worst;
  }
};

constexpr int few_steps = 40, many_steps = 4000;

// With many steps, iteration goes on as long as the energy falls at all.
constexpr double any_decrease = std::numeric_limits<double>::min();
constexpr double larger = 10;

// The sums over components and their derivatives of an error times a block's coordinates: one row per coordinate, one
// column per component of what it multiplies.
// \param tensors [coordinate][entry][derivative] \param error [derivative][component]
Eigen::MatrixXd products(const CoordinateBlock& block, const std::vector<double>& tensors,
                         const Eigen::MatrixXd& error) {
  const Eigen::Map<const Eigen::MatrixXd> entries(tensors.data(), error.rows(), block.size * block.entries());
  Eigen::MatrixXd all = entries.transpose() * error;
  if (block.shape.rows == 1) return all;
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(block.size, error.cols());
  for (Eigen::Index k = 0; k < found.rows(); ++k)
    for (Eigen::Index row = 0; row < error.cols(); ++row)
      for (Eigen::Index c = 0; c < error.cols(); ++c)
        found(k, c) += all((k * error.cols() + row) * error.cols() + c, row);
  return found;
}

// Where a cage far off lies, in numbers so round that steps from there to its points are doubles: nowhere where an axis
// has it next to the origin.
Vec3<double> round_place(const Vec3<double>& vertex, double size) {
  const double unit = std::exp2(std::ilogb(size) + 1);
  Vec3<double> place = Vec3<double>::Zero();
  for (int c = 0; c < 3; ++c)
    if (std::abs(vertex[c]) > 8 * unit) place[c] = std::trunc(vertex[c] / unit) * unit;
  return place;
}

// A problem seen from a place.
ConstrainedProblem seen_from(const Vec3<double>& place, ConstrainedProblem problem) {
  const double size = std::exchange(problem.size, 1);
  ConstrainedProblem found = problem.under({.shift = -place}, 1);
  found.size = size;
  return found;
}

}  // namespace

ConstrainedChecks::ConstrainedChecks(std::shared_ptr<const Cage> cage, ConstrainedVariant variant, Triangulation rule)
    : cage_(std::move(cage)),
      variant_(std::move(variant)),
      rule_(rule),
      places_(places_for(*variant_.method, *cage_, rule)) {}

ConstrainedProblem ConstrainedChecks::problem(std::string_view pose) const {
  return constrained_problem(*variant_.method, *cage_, places_, pose, rule_);
}

Question<PointAt> ConstrainedChecks::question(std::string_view check, std::string_view pose, Ask ask) const {
  Question<PointAt> question;
  question.key = {RowKey::Section::Deformer,
                  std::string(variant_.method->name),
                  variant_.name,
                  std::string(name_of(ScalarKind::Double)),
                  cage_->name(),
                  std::string(check),
                  std::string(pose),
                  0};
  question.unit = "cage sizes";
  question.orders = {0, 0};
  question.ask = [ask = std::move(ask)](const PointAt& at) {
    const DeformerError error = ask(at.point);
    return std::array<Finding, 3>{Finding{Finding::Status::Measured, error.error, error.plain}};
  };
  return question;
}

Question<PointAt> ConstrainedChecks::energy(std::string_view check, std::string_view pose,
                                            double (ConstrainedChecks::*find)(std::string_view) const) const {
  Question<PointAt> asked = question(check, pose, [this, pose, find](const Vec3<double>&) {
    const double found = (this->*find)(pose);
    return DeformerError{found, found};
  });
  asked.unit = "energies";
  asked.once = true;
  return asked;
}

std::vector<Question<PointAt>> ConstrainedChecks::questions() const {
  std::vector<Question<PointAt>> all{energy("energy_falls", bent_pose, &ConstrainedChecks::largest_rise),
                                     energy("rigid_energy", rigid_pose, &ConstrainedChecks::what_is_left)};
  all.push_back(question("keeps_rigid", rigid_pose, kept(turn(cage_->dimension()))));
  all.push_back(energy("second_route", bent_pose, &ConstrainedChecks::slope_left));
  if (!variant_.method->positions_alone)
    all.push_back(energy("energy_is_flat", bent_pose, &ConstrainedChecks::flatness));
  // In the plane biharmonic layers have logarithms times other functions, so maps differ with the unit of length.
  const bool has_biharmonic_logarithms =
      cage_->dimension() == 2 && problem(bent_pose).prepared(variant_, rule_, 1)->coordinates().blocks().size() > 2;
  if (!has_biharmonic_logarithms)
    all.push_back(question("constrained_unit", bent_pose, moved(bent_pose, SpaceMap{}, larger)));
  all.push_back(question("constrained_motion", bent_pose, moved(bent_pose, turn(cage_->dimension()), 1)));
  for (const SpaceMap& offset : offsets(cage_->dimension())) {
    all.push_back(question(offset.check, offset.pose, kept_far_off(offset)));
    all.back().unit = "roundings";
  }
  return all;
}

double ConstrainedChecks::largest_rise(std::string_view pose) const {
  const auto posed = problem(pose).prepared(variant_, rule_, few_steps)->pose();
  const deformation::DeformationReport& report = posed->report();
  const std::vector<double>& fallen = report.merits.empty() ? report.energies : report.merits;
  double worst = 0;
  for (std::size_t k = 1; k < fallen.size(); ++k) {
    // Where nothing is left, nothing falls.
    const double rise = fallen[k] == fallen[k - 1] ? 0 : fallen[k] / fallen[k - 1] - 1;
    if (!(rise <= worst)) worst = rise;
  }
  return worst;
}

double ConstrainedChecks::slope_left(std::string_view pose) const {
  // Turned, so that no component of a normal is zero.
  const double plain = unmet_stationarity(problem(pose).under(turn(cage_->dimension()), 1), variant_, rule_);
  return plain / Excuses{.rounding = rounding_of_coordinates(*cage_)}.factor();
}

double ConstrainedChecks::what_is_left(std::string_view pose) const {
  SolvedProblem found{problem(pose).prepared(variant_, rule_, many_steps, any_decrease), {}};
  found.posed = found.model->pose();
  const double energy = found.posed->report().energies.back();
  // Positions have the unit of an area, second derivatives that of one over it.
  const double size = cage_->size();
  const double plain = variant_.method->positions_alone ? energy * size * size : energy / size / size;
  // Energies are squares of errors.
  return plain / std::pow(Excuses{found.condition(), rounding_of_coordinates(*cage_)}.factor(), 2);
}

ConstrainedChecks::Ask ConstrainedChecks::moved(std::string_view pose, const SpaceMap& map, double length) const {
  const auto solved = [this](const ConstrainedProblem& asked) {
    SolvedProblem found{asked.prepared(variant_, rule_, few_steps), {}};
    found.posed = found.model->pose();
    return found;
  };
  const auto both = std::make_shared<const Lazy<std::array<SolvedProblem, 2>>>([this, solved, pose, map, length] {
    const ConstrainedProblem here = problem(pose);
    return std::array{solved(here), solved(here.under(map, length))};
  });
  return [this, both, map, length](const Vec3<double>& point) {
    const auto& [here, there] = both->get();
    const double size = cage_->size();
    const int d = cage_->dimension();
    const Vec3<double> to = length * map(point, size);
    const Images<double> a = here.model->images(*here.posed, std::span(&point, 1), 0),
                         b = there.model->images(*there.posed, std::span(&to, 1), 0);
    Vec3<double> image = Vec3<double>::Zero(), difference = Vec3<double>::Zero();
    for (int c = 0; c < d; ++c) image[c] = a.tensors[0][c];
    const Vec3<double> expected = map(image, size);
    for (int c = 0; c < d; ++c) difference[c] = b.tensors[0][c] / length - expected[c];
    return excused(difference.norm() / size, {here.condition(), rounding_of_coordinates(*cage_)});
  };
}

ConstrainedChecks::Ask ConstrainedChecks::kept(const SpaceMap& map) const {
  const auto solution = std::make_shared<const Lazy<SolvedProblem>>([this] {
    SolvedProblem found{problem(rigid_pose).prepared(variant_, rule_, many_steps, any_decrease), {}};
    found.posed = found.model->pose();
    return found;
  });
  return [this, solution, map](const Vec3<double>& point) {
    const SolvedProblem& solved = solution->get();
    const Images<double> images = solved.model->images(*solved.posed, std::span(&point, 1), 0);
    Vec3<double> difference = Vec3<double>::Zero();
    const Vec3<double> expected = map(point, cage_->size());
    for (int c = 0; c < cage_->dimension(); ++c) difference[c] = images.tensors[0][c] - expected[c];
    // A motion is not solved for: no condition excuses it.
    return excused(difference.norm() / cage_->size(), {.rounding = rounding_of_coordinates(*cage_)});
  };
}

ConstrainedChecks::Ask ConstrainedChecks::kept_far_off(const SpaceMap& offset) const {
  const std::vector<Vec3<double>> vertices = posed_by(offset, *cage_);
  const Vec3<double> place = round_place(vertices.front(), cage_->size());
  const auto solved = [this](const ConstrainedProblem& asked) {
    SolvedProblem found{asked.prepared(variant_, rule_, many_steps, any_decrease), {}};
    found.posed = found.model->pose();
    return found;
  };
  const auto both = std::make_shared<const Lazy<std::array<SolvedProblem, 2>>>([this, solved, offset, place] {
    // Far off, places and targets are rounded. Both problems have these roundings, because the way back is exact.
    const ConstrainedProblem there = problem(rigid_pose).under(offset, 1);
    return std::array{solved(there), solved(seen_from(place, there))};
  });
  // A turn about the origin takes targets further off where the cage is far away.
  double largest = largest_coordinate(vertices);
  for (const Vec3<double>& v : posed_by(turn(cage_->dimension()), *cage_))
    largest = std::max(largest, offset(v, cage_->size()).cwiseAbs().maxCoeff());
  const double rounding = unit_roundoff<double>() * largest;
  return [this, offset, place, rounding, both](const Vec3<double>& point) {
    const auto& [there, here] = both->get();
    const Vec3<double> far = offset(point, cage_->size()), near = far - place;
    const Images<double> a = there.model->images(*there.posed, std::span(&far, 1), 0),
                         b = here.model->images(*here.posed, std::span(&near, 1), 0);
    Vec3<double> difference = Vec3<double>::Zero();
    for (int c = 0; c < cage_->dimension(); ++c) difference[c] = (a.tensors[0][c] - place[c]) - b.tensors[0][c];
    return excused(difference.norm() / rounding, {there.condition()});
  };
}

// Half the gradient of the energy in the coefficients, in a unit in which the cage's size is one, by loops over
// constraints: in the first step rotations are those nearest to the identity.
double ConstrainedChecks::flatness(std::string_view pose) const {
  const ConstrainedProblem asked = problem(pose);
  const auto model = asked.prepared(variant_, rule_, 1);
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
      of_map[b] += weight * products(coordinates.blocks()[b], tables[b].tensors[order], found - target);
      of_rest[b] += weight * products(coordinates.blocks()[b], tables[b].tensors[order], identity - target);
    }
  };
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(d, d), none = Eigen::MatrixXd::Zero(d * d, d);
  const double first = of_jacobians * size * size, second = of_hessians * std::pow(size, 4);
  for (const auto& [at, to] : asked.constraints.positions)
    add(at, 0, 1, to.head(d).transpose(), at.head(d).transpose());
  for (const auto& [at, jacobian] : asked.constraints.orientations)
    add(at, 1, first, jacobian.topLeftCorner(d, d).transpose(), unit);
  for (const Vec3<double>& at : asked.constraints.rotations) add(at, 1, first, unit, unit);
  for (const Vec3<double>& at : asked.constraints.hessians) add(at, 2, second, none, none);
  for (std::size_t b = 0; b < of_map.size(); ++b) {
    const double length = std::pow(size, -2 * coordinates.blocks()[b].degree);
    after += length * of_map[b].squaredNorm();
    before += length * of_rest[b].squaredNorm();
  }
  return std::sqrt(after / before) / Excuses{.rounding = rounding_of_coordinates(*cage_)}.factor();
}

}  // namespace cageproof::validation
