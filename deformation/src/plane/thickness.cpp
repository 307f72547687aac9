// SPDX-License-Identifier: MIT
#include "thickness.h"

#include "../constraint_checks.h"
#include "../nearest_motion.h"
#include "../own_place.h"
#include "gauss_newton.h"
#include "posed_cage.h"
#include "solved_systems.h"
#include "thickness_rows.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

void check_thickness(const Cage& cage, const Constraints& constraints, const ThicknessOptions& options) {
  if (cage.dimension() != 2) throw InputError(fmt::format("{}: thickness is kept only in the plane", cage.name()));
  if (options.samples < 1) throw InputError(fmt::format("samples = {}: must be at least 1", options.samples));
  if (options.steps < 1) throw InputError(fmt::format("steps = {}: must be at least 1", options.steps));
  if (!constraints.orientations.empty() || !constraints.rotations.empty() || !constraints.hessians.empty())
    throw ConstraintError("thickness takes only positions");
  const auto& positions = constraints.positions;
  if (positions.empty()) throw ConstraintError("there are no positions");
  if (positions.size() > cage.vertices().size())
    throw ConstraintError(fmt::format("{} positions are more than the {} vertices that are to meet them",
                                      positions.size(), cage.vertices().size()));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    check_finite(fmt::format("positions[{}].at", i), positions[i].at, 2);
    check_finite(fmt::format("positions[{}].to", i), positions[i].to, 2);
  }
}

// Points as they are seen from a place.
template <Scalar R>
std::vector<Vec3<R>> seen_from_place(const std::vector<Vec3<double>>& points, const Vec3<double>& place) {
  std::vector<Vec3<R>> found;
  found.reserve(points.size());
  for (const Vec3<double>& p : points) found.push_back(convert<R>(p) - convert<R>(place));
  return found;
}

std::vector<Vec3<double>> places_of(const Constraints& constraints) {
  std::vector<Vec3<double>> places;
  places.reserve(constraints.positions.size());
  for (const Constraints::Position& position : constraints.positions) places.push_back(position.at);
  return places;
}

double largest_coordinate_of(const std::vector<Vec3<double>>& points) {
  double largest = 0;
  for (const Vec3<double>& p : points) largest = std::max(largest, p.head(2).cwiseAbs().maxCoeff());
  return largest;
}

// The other way round, Eigen's columns are components: numbers in the order of jacobian's rows and columns.
template <Scalar R>
Matrix<R> in_line(const Matrix<R>& points) {
  return points.transpose().reshaped();
}

}  // namespace

template <Scalar R>
struct Thickness<R>::Prepared {
  Prepared(const Cage& cage, Constraints given, const ThicknessOptions& chosen)
      : constraints((check_thickness(cage, given, chosen), std::move(given))),
        options(chosen),
        size(cage.size()),
        coordinates(cage, coordinate_kind_named("biharmonic_boundary"),
                    CoordinateOptions{.evaluation = options.evaluation, .parameters = options.coordinates}),
        thickness(thickness_rows<R>(coordinates, options.samples)),
        at_positions(position_rows<R>(coordinates, constraints.positions)),
        place(own_place(coordinates.elements().vertices())),
        rest(rows_of(seen_from_place<R>(coordinates.elements().vertices(), place), 2)),
        at(rows_of(seen_from_place<R>(places_of(constraints), place), 2)),
        at_rest(normals_at<R>(coordinates.elements(), rest, Matrix<R>::Zero(rest.rows(), 2))) {
    report = report_on(coordinates);
    const Matrix<R> k = jacobian(at_positions, at_rest), j = jacobian(thickness, at_rest);
    const GaussNewtonStep<R> there = gauss_newton<R>(Matrix<R>::Zero(j.rows(), 1), j, Matrix<R>::Zero(k.rows(), 1), k);
    if (there.rank < k.rows())
      report.warnings.push_back(
          fmt::format("the positions are not independent: rank {} of {}, so that some targets "
                      "cannot be met",
                      there.rank, k.rows()));
    Matrix<R> together(j.rows() + k.rows(), j.cols());
    together << R(size) * R(size) * j, k;
    const auto rank = static_cast<int>(least_squares<R>(together, Matrix<R>::Zero(together.rows(), 1)).second);
    report.systems.push_back(describe<R>("positions and thickness, at rest", together, rank,
                                         Matrix<R>::Zero(together.rows(), 1), Matrix<R>::Zero(together.cols(), 1)));
    if (rank < together.cols())
      report.warnings.push_back(fmt::format("the positions leave {} of {} unknowns free: steps of least norm are taken",
                                            together.cols() - rank, together.cols()));
  }

  // A pose as what its vertices and normals have more than those at rest, where f is the identity: it does not bend,
  // and leaves positions where they are. Sums for it would be rounded by parts of second derivatives, which are large
  // at short edges.
  struct State {
    Matrix<R> moved;
    NormalsAt<R> normals;
    Matrix<R> bending, misfit;

    R energy() const { return bending.squaredNorm(); }
    R merit(const R& weight) const { return energy() + weight * misfit.norm(); }
    R missed() const { return misfit.cwiseAbs().maxCoeff(); }
  };
  State state(const Matrix<R>& moved, const Matrix<R>& targets) const {
    State found{moved, normals_at<R>(coordinates.elements(), rest, moved), {}, {}};
    const Matrix<R> turned = found.normals.normals - at_rest.normals;
    found.bending = in_line<R>(thickness.at(moved, turned));
    found.misfit = in_line<R>(at_positions.at(moved, turned) - (targets - at));
    if (!std::isfinite(static_cast<double>(found.merit(R(0)))) || !found.misfit.allFinite())
      throw ConstraintError("the targets are too large: the energy is not finite");
    return found;
  }

  // How steps went with one weight.
  struct Run {
    State last;
    std::vector<double> merits = {}, energies = {};
    int steps = 0;
    bool converged = false, is_hidden = false;  ///< or as far as rounding shows
    R change = R(0), gradient = R(0);           ///< the last step, and the projected gradient
    R wanted = R(0);  ///< a weight that the constraints' multipliers ask for, where this one is less
  };

  // 8192 roundings of double, which poses are wanted to in 50 digits, too.
  static constexpr double rounding = 0x1p-40;

  // \param rounded how far targets may be off by rounding
  Run run(const Matrix<R>& targets, const R& weight, double rounded, const StepWatcher& watch) const {
    Run run{state(Matrix<R>::Zero(rest.rows(), 2), targets)};
    run.merits.push_back(static_cast<double>(run.last.merit(weight)));
    run.energies.push_back(static_cast<double>(run.last.energy()));
    // Nothing bends less than rest does.
    run.converged = run.last.missed() <= R(rounded);
    while (run.steps < options.steps && !run.converged) {
      const Matrix<R> j = jacobian(thickness, run.last.normals), k = jacobian(at_positions, run.last.normals);
      const GaussNewtonStep<R> next = gauss_newton<R>(run.last.bending, j, run.last.misfit, k);
      // A lesser weight would let the energy fall at the constraints' cost.
      if (next.multiplier > weight) {
        run.wanted = 4 * next.multiplier;
        return run;
      }
      run.change = next.step.cwiseAbs().maxCoeff();
      run.gradient = next.projected_gradient;
      // The gradient is 2 J^T g, and g, which F makes, is rounded.
      const R of_gradient = R(rounding) * j.norm() * (run.last.bending.norm() + j.norm() * R(size));
      const bool meets = run.last.missed() <= R(rounding) * R(size);
      run.converged = meets && run.change <= R(rounding) * R(size) && next.projected_gradient <= of_gradient;
      const R merit = run.last.merit(weight), most = merit * (1 + 64 * unit_roundoff<R>());
      R part = 1;
      const Matrix<R> step = next.step.reshaped(2, rest.rows()).transpose();
      State there = state(run.last.moved + step, targets);
      while (!run.converged && part > R(1e-9) && there.merit(weight) > most) {
        part /= 2;
        there = state(run.last.moved + part * step, targets);
      }
      // No part of the step lowers the merit. Next to a minimum, whose distance a merit shows only by its square,
      // rounding is all that is left; elsewhere the step is of no use.
      if (!run.converged && there.merit(weight) > most) {
        run.is_hidden = run.converged = meets && run.change <= R(std::sqrt(rounding)) * R(size);
        break;
      }
      run.last = std::move(there);
      ++run.steps;
      run.merits.push_back(static_cast<double>(run.last.merit(weight)));
      run.energies.push_back(static_cast<double>(run.last.energy()));
      if (watch) watch(run.steps, run.energies.back());
      // The map may come to rest without meeting its targets.
      if (run.change <= unit_roundoff<R>() * R(size)) break;
    }
    return run;
  }

  // Why the last pose is no solution.
  std::string why_unsolved(const Run& run) const {
    const auto missed = static_cast<double>(run.last.missed()), change = static_cast<double>(run.change);
    std::string text = fmt::format(
        "not converged after {} steps: the last changed vertices by {:.2g}, positions are missed by {:.2g}, the "
        "projected gradient is {:.2g}",
        run.steps, change, missed, static_cast<double>(run.gradient));
    if (run.steps == options.steps) return text + "; more steps may do, or targets nearer to a rigid motion";
    if (missed > rounding * size)
      return text + "; no pose was found that meets all positions: leave some out, or move them less";
    return text + "; roundings hide where the energy falls: the cage's edges differ too much in length";
  }

  template <Scalar To>
  std::unique_ptr<const Posed<To>> posed_to(const std::vector<Vec3<double>>& targets, const StepWatcher& watch) const {
    // The energy knows no rigid motions. Seen from the one that is nearest to the targets, steps are as short as they
    // can be, and a motion itself takes none.
    const Motion<R> motion = nearest_motion<R>(constraints, targets, place, size, 2);
    const Matrix<R> rows = motion.turned_back(rows_of(seen_from_place<R>(targets, motion.to), 2));
    const double rounded = 8 * unit_roundoff<double>() *
                           std::max(largest_coordinate_of(targets), largest_coordinate_of(places_of(constraints)));
    // Begins anew whenever the weight has to grow, so that merits of one weight are compared.
    Run found = run(rows, R(1) / R(size) / R(size) / R(size), rounded, watch);
    for (int again = 0; again < 60 && found.wanted > 0; ++again) found = run(rows, R(found.wanted), rounded, watch);
    DeformationReport said;
    if (!found.converged) said.unsolved = why_unsolved(found);
    else if (found.is_hidden)
      said.warnings.push_back(fmt::format(
          "rounding hides where the energy falls from here on: the last step would have changed vertices by {:.2g}",
          static_cast<double>(found.change)));
    const auto energy = static_cast<double>(found.last.energy());
    said.figures = {{"energy", energy},
                    {"energy a sample", energy / static_cast<double>(thickness.of_vertices.rows())},
                    {"steps", found.steps},
                    {"constraint misfit", static_cast<double>(found.last.missed())},
                    {"projected gradient", static_cast<double>(found.gradient)}};
    said.energies = std::move(found.energies);
    said.merits = std::move(found.merits);
    const Matrix<R> vertices = motion.turned(rest + found.last.moved),
                    normals = motion.turned(found.last.normals.normals);
    return shifted<To>(
        std::make_unique<PosedCage<To>>(vertices.template cast<To>(), normals.template cast<To>(), std::move(said)),
        motion.to, 2);
  }

  Constraints constraints;
  ThicknessOptions options;
  double size;
  CageCoordinates coordinates;
  BoundaryRows<R> thickness, at_positions;
  Vec3<double> place;  ///< what all is solved from, so that misfits are rounded by parts of the cage
  Matrix<R> rest, at;  ///< vertices and positions, from there
  NormalsAt<R> at_rest;
  DeformationReport report;
};

template <Scalar R>
Thickness<R>::Thickness(const Cage& cage, Constraints constraints, const ThicknessOptions& options)
    : prepared_(std::make_shared<const Prepared>(cage, std::move(constraints), options)) {}

template <Scalar R>
const CageCoordinates& Thickness<R>::coordinates() const {
  return prepared_->coordinates;
}

template <Scalar R>
DeformationReport Thickness<R>::prepared() const {
  return prepared_->report;
}

template <Scalar R>
template <Scalar To>
std::unique_ptr<const Posed<To>> Thickness<R>::pose_in(const std::vector<Vec3<double>>& targets,
                                                       const StepWatcher& watch) const {
  check_targets(targets, prepared_->constraints, 2);
  return prepared_->template posed_to<To>(targets, watch);
}

template <Scalar R>
std::unique_ptr<const Posed<R>> Thickness<R>::pose(const StepWatcher& watch) const {
  return pose_to(targets_of(prepared_->constraints), watch);
}

template <Scalar R>
std::unique_ptr<const Posed<R>> Thickness<R>::pose_to(const std::vector<Vec3<double>>& targets,
                                                      const StepWatcher& watch) const {
  return pose_in<R>(targets, watch);
}

template class Thickness<double>;
template class Thickness<Mp50>;
template std::unique_ptr<const Posed<double>> Thickness<Mp50>::pose_in<double>(const std::vector<Vec3<double>>&,
                                                                               const StepWatcher&) const;

}  // namespace cageproof::deformation
