// SPDX-License-Identifier: MIT
#include "variational.h"

#include "../constraint_checks.h"
#include "../linear_posed.h"
#include "../matrix_posed.h"
#include "../nearest_motion.h"
#include "../own_place.h"
#include "../somigliana/pole.h"
#include "constraint_rows.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

namespace cageproof::deformation {
namespace {

const CoordinateKind& kind_of_subspace(Subspace subspace) {
  constexpr std::array<std::string_view, 3> kinds{"green", "biharmonic", "somigliana"};
  return coordinate_kind_named(kinds[static_cast<std::size_t>(subspace)]);
}

// Refuses constraints that are wrong in themselves before it makes the coordinates, because evaluations do not refuse
// points.
CageCoordinates checked_coordinates(const Cage& cage, const Constraints& constraints,
                                    const VariationalOptions& options) {
  check_constraints(constraints, options, cage.dimension());
  const CoordinateKind& kind = kind_of_subspace(options.subspace);
  if (const std::string reason = why_refused(kind, cage); !reason.empty())
    throw InputError(fmt::format("{}: {}", cage.name(), reason));
  // The shear modulus is the unit of tractions.
  std::vector<double> parameters;
  if (options.subspace == Subspace::Elastic) parameters = {1, options.nu};
  return {cage, kind, CoordinateOptions{options.evaluation, options.triangulation, std::move(parameters)}};
}

}  // namespace

template <Scalar R>
struct Variational<R>::Prepared {
  Prepared(const Cage& cage, Constraints given, const VariationalOptions& chosen)
      : constraints(std::move(given)),
        options(chosen),
        coordinates(checked_coordinates(cage, constraints, options)),
        rows(constraint_rows<R>(coordinates, constraints, options, cage.size())),
        factors(rows.matrix) {
    const CageElements& elements = coordinates.elements();
    const std::vector<Vec3<R>> vertices = vertices_in<R>(elements);
    place = own_place(elements.vertices());
    size = cage.size();
    from_place = rows_of(vertices, dimension()).rowwise() - convert<R>(place).head(dimension()).transpose();
    normals = rows_of(stretched_normals(Stretch::Unit, elements, vertices), dimension());
  }

  using Turn = SpaceMatrix<R>;

  int dimension() const { return coordinates.dimension(); }
  SolvedSystem described(const Matrix<R>& right, const Matrix<R>& solution) const {
    return describe<R>("Eq 37-40: coefficients of least energy", rows.matrix, factors.rank(), right, solution);
  }
  Eigen::Index free_unknowns() const { return rows.matrix.cols() - factors.rank(); }

  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    if (options.subspace == Subspace::Elastic) warn_of_pole(options.nu, all);
    if (constraints.positions.empty()) all.emplace_back("there is no positional constraint: translations are free");
    if (free_unknowns() > 0)
      all.push_back(fmt::format("the constraints leave {} of {} unknowns free: the map next to a rigid motion is taken",
                                free_unknowns(), rows.matrix.cols()));
    return all;
  }

  // A linear map about the place has as coefficients vertices' images, then normal derivatives or, for shear modulus 1,
  // an elastic body's tractions.
  Matrix<R> coefficients_of(const Turn& map) const {
    Matrix<R> found = Matrix<R>::Zero(rows.units.size(), dimension());
    found.topRows(from_place.rows()) = from_place * map.transpose();
    auto block = found.middleRows(from_place.rows(), normals.rows());
    if (options.subspace == Subspace::Elastic) {
      const R lambda = std::isinf(options.nu) ? R(-1) : R(2 * R(options.nu) / R(1 - 2 * R(options.nu)));
      block = lambda * map.trace() * normals + normals * (map + map.transpose());
    } else {
      block = normals * map.transpose();
    }
    return found;
  }

  // A right side: targets of all rows less what the motion makes there. Its values and derivatives are known without
  // sums of layers, whose roundings the equations' condition would multiply. Rows of rotations are for those as given.
  Matrix<R> targets(const std::vector<Vec3<double>>& positions, const Motion<R>& motion) const {
    const int d = dimension();
    Matrix<R> right = Matrix<R>::Zero(rows.matrix.rows() / rows.components, d);
    const auto step = [d](const Vec3<double>& to, const Vec3<double>& from) {
      return in<R>(d, convert<R>(to) - convert<R>(from));
    };
    for (std::size_t p = 0; p < positions.size(); ++p)
      right.row(static_cast<Eigen::Index>(p)) =
          (step(positions[p], motion.to) - motion.turn * step(constraints.positions[p].at, motion.from)).transpose();
    for (std::size_t p = 0; p < constraints.orientations.size(); ++p)
      right.middleRows(rows.orientations + d * static_cast<Eigen::Index>(p), d) =
          rows.root_alpha *
          (constraints.orientations[p].jacobian.topLeftCorner(d, d).template cast<R>() - motion.turn).transpose();
    return rows.stacked(right);
  }

  // The rows of the identity, less those of the motion.
  Matrix<R> identity(const Motion<R>& motion) const {
    const int d = dimension();
    const Turn back = Turn::Identity(d, d) - motion.turn;
    Matrix<R> found = Matrix<R>::Zero(rows.matrix.rows() / rows.components, d);
    for (std::size_t p = 0; p < constraints.positions.size(); ++p) {
      const Vec3<R> at = convert<R>(constraints.positions[p].at);
      found.row(static_cast<Eigen::Index>(p)) =
          (in<R>(d, at - convert<R>(motion.to)) - motion.turn * in<R>(d, at - convert<R>(motion.from))).transpose();
    }
    const auto put = [&](Eigen::Index first, std::size_t count, const R& root) {
      for (std::size_t p = 0; p < count; ++p)
        found.middleRows(first + d * static_cast<Eigen::Index>(p), d) = root * back.transpose();
    };
    put(rows.orientations, constraints.orientations.size(), rows.root_alpha);
    put(rows.rotations, constraints.rotations.size(), rows.root_beta);
    return rows.stacked(found);
  }

  // Puts the rotation or similarity nearest to each Jacobian among the targets. Returns the first point where it is not
  // unique. Rows hold sqrt(beta) times derivatives; with beta = 0 they say nothing, and any rotation does.
  // \param made the map's rows, less the motion's
  std::optional<std::size_t> turn(const Matrix<R>& made, const Motion<R>& motion, Matrix<R>& right) const {
    const int d = dimension();
    std::optional<std::size_t> ambiguous;
    if (rows.root_beta == 0) return ambiguous;
    for (std::size_t p = 0; p < constraints.rotations.size(); ++p) {
      const Eigen::Index count = d * rows.components,
                         first = rows.rotations * rows.components + count * static_cast<Eigen::Index>(p);
      const Turn jacobian = motion.turn + Turn(rows.table(made.middleRows(first, count)).transpose() / rows.root_beta);
      const NearestRotation<R> nearest = nearest_rotation<R>(jacobian, R(1e-10));
      if (!nearest.is_unique && !ambiguous) ambiguous = p;
      const R factor = options.nearest == Nearest::Similarity ? R(nearest.signed_values.sum() / d) : R(1);
      right.middleRows(first, count) =
          rows.stacked(rows.root_beta * (factor * nearest.rotation - motion.turn).transpose());
    }
    return ambiguous;
  }

  double energy(const Matrix<R>& made, const Matrix<R>& right) const {
    const auto found = static_cast<double>(R((made - right).squaredNorm()));
    if (!std::isfinite(found))
      throw ConstraintError("the constraints' targets are too large: the energy is not finite");
    return found;
  }

  // The energy of a map that misses its targets, as seen from the cage, by so many roundings of them.
  double energy_of_roundings(double count, const std::vector<Vec3<double>>& positions) const {
    R sum = R(options.beta) * R(dimension() * static_cast<double>(constraints.rotations.size()));
    for (const Vec3<double>& to : positions) sum += (convert<R>(to) - convert<R>(place)).squaredNorm();
    for (const auto& [at, jacobian] : constraints.orientations) sum += R(options.alpha) * R(jacobian.squaredNorm());
    const R rounding = R(count) * unit_roundoff<R>();
    return static_cast<double>(R(rounding * rounding * sum));
  }

  // The motion, and the solution on top of it.
  std::unique_ptr<const Posed<R>> posed(const Matrix<R>& solution, const Motion<R>& motion,
                                        DeformationReport report) const {
    const Matrix<R> coefficients = coefficients_of(motion.turn) + rows.units.asDiagonal() * rows.table(solution);
    std::vector<Matrix<R>> data;
    Eigen::Index first = 0;
    for (const CoordinateBlock& block : coordinates.blocks()) {
      data.emplace_back(coefficients.middleRows(first, block.size));
      first += block.size;
    }
    std::unique_ptr<const Posed<R>> found;
    if (rows.components == 1) found = std::make_unique<LinearPosed<R>>(std::move(data), std::move(report));
    else found = std::make_unique<MatrixPosed<R>>(std::move(data), std::move(report));
    return shifted<R>(std::move(found), motion.to, dimension());
  }

  // The identity, on top of the motion.
  Matrix<R> rest_from(const Motion<R>& motion) const {
    Matrix<R> found = coefficients_of(Turn::Identity(dimension(), dimension())) - coefficients_of(motion.turn);
    const Vec3<R> shift = convert<R>(motion.from) - convert<R>(motion.to);
    found.topRows(from_place.rows()).rowwise() += shift.head(dimension()).transpose();
    for (Eigen::Index k = 0; k < found.rows(); ++k) found.row(k) /= rows.units[k];
    return rows.stacked(found);
  }

  std::unique_ptr<const Posed<R>> run(const std::vector<Vec3<double>>& positions, const StepWatcher& watch) const {
    const Motion<R> motion = nearest_motion<R>(constraints, positions, place, size, dimension());
    Matrix<R> right = targets(positions, motion), solution = rest_from(motion), made = identity(motion);
    DeformationReport report;
    report.warnings = warnings();
    double decrease = 0;
    // Without rotations the problem is linear, and the first step solves it.
    const bool linear = constraints.rotations.empty() || options.beta == 0;
    const Matrix<R> nothing = Matrix<R>::Zero(rows.matrix.cols(), right.cols());
    // Rows of rotations are still zero, which the motion itself makes there.
    const bool is_motion =
        energy(Matrix<R>::Zero(made.rows(), made.cols()), right) <= energy_of_roundings(8, positions);
    bool converged = false, told = false;
    for (int step = 1; step <= (linear ? 1 : options.steps); ++step) {
      if (const auto ambiguous = turn(made, motion, right); ambiguous && !told) {
        report.warnings.push_back(
            fmt::format("rotations[{}]: the nearest rotation is not unique in step {}", *ambiguous, step));
        told = true;
      }
      report.energies.push_back(energy(made, right));
      if (is_motion)
        right.middleRows(rows.rotations * rows.components, (rows.hessians - rows.rotations) * rows.components)
            .setZero();
      Matrix<R> next = is_motion ? nothing : factors.solve(right);
      Matrix<R> makes = rows.matrix * next;
      const double after = energy(makes, right);
      // The least cannot be more than what there was, but by the rounding of what is asked for.
      if (after > report.energies.back() * (1 + 1e-9) + energy_of_roundings(1e4, positions)) {
        report.warnings.push_back(
            fmt::format("step {} would raise the energy from {:.2g} to {:.2g}: the weights are too uneven for the "
                        "precision, and the map is the one before it",
                        step, report.energies.back(), after));
        report.energies.push_back(report.energies.back());
        converged = true;
        break;
      }
      solution = std::move(next);
      made = std::move(makes);
      report.energies.push_back(after);
      if (watch) watch(step, report.energies.back());
      // From global step to global step; the first one has its own local step before it.
      const double before = report.energies[report.energies.size() - (step == 1 ? 2 : 3)];
      decrease = before > 0 ? 1 - report.energies.back() / before : 0;
      converged = linear || is_motion || !(decrease > options.tolerance) ||
                  report.energies.back() <= energy_of_roundings(8, positions);
      if (converged && (options.tolerance > 0 || is_motion)) break;
    }
    const std::size_t steps = report.energies.size() / 2;
    if (!converged)
      report.warnings.push_back(
          fmt::format("not converged: step {} still lowered the energy by {:.2g} of it", steps, decrease));
    report.systems.push_back(described(right, solution));
    report.figures = {{"energy", report.energies.back()},
                      {"steps", static_cast<double>(steps)},
                      {"last relative decrease", decrease}};
    return posed(solution, motion, std::move(report));
  }

  Constraints constraints;
  VariationalOptions options;
  CageCoordinates coordinates;
  ConstraintRows<R> rows;
  LeastSquares<R> factors;                    ///< of the rows' matrix
  Vec3<double> place = Vec3<double>::Zero();  ///< next to the cage
  double size = 0;
  Matrix<R> from_place;  ///< vertices, one per row
  Matrix<R> normals;     ///< of unit length, one per row
};

template <Scalar R>
Variational<R>::Variational(const Cage& cage, Constraints constraints, const VariationalOptions& options)
    : prepared_(std::make_shared<const Prepared>(cage, std::move(constraints), options)) {}

template <Scalar R>
const CageCoordinates& Variational<R>::coordinates() const {
  return prepared_->coordinates;
}

template <Scalar R>
DeformationReport Variational<R>::prepared() const {
  const Matrix<R> none = Matrix<R>::Zero(prepared_->rows.matrix.rows(), 1);
  DeformationReport report;
  report.systems.push_back(prepared_->described(none, Matrix<R>::Zero(prepared_->rows.matrix.cols(), 1)));
  report.warnings = prepared_->warnings();
  return report;
}

template <Scalar R>
std::unique_ptr<const Posed<R>> Variational<R>::pose(const StepWatcher& watch) const {
  return prepared_->run(targets_of(prepared_->constraints), watch);
}

template <Scalar R>
std::unique_ptr<const Posed<R>> Variational<R>::pose_to(const std::vector<Vec3<double>>& targets,
                                                        const StepWatcher& watch) const {
  check_targets(targets, prepared_->constraints, prepared_->dimension());
  return prepared_->run(targets, watch);
}

template class Variational<double>;
template class Variational<Mp50>;

}  // namespace cageproof::deformation
