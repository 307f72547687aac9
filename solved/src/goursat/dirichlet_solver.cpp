// SPDX-License-Identifier: MIT
#include "dirichlet_solver.h"

#include "boundary_points.h"
#include "goursat_basis.h"
#include "least_squares.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/geometry/winding_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace cageproof::solved::goursat {
namespace {

using Matrix = Eigen::MatrixXd;

// The least pivot of the triangle, for columns of unit length. Below it, rounding takes more than functions give: at
// 1e-14 coefficients are so large that their rounding shows in sums, at 1e-12 residuals rise.
constexpr double kThreshold = 1e-13;
// The distance of points next to edges, over the largest coordinate: above the rounding of points, below any residual.
constexpr double kStep = 0x1p-51;

// Equations at points of the boundary: values, and of biharmonic functions normal derivatives and those along the edge,
// in the frame's unit, block by block.
struct Equations {
  Matrix functions, data;
};

// The kind of equation, and what is asked of solutions.
struct Problem {
  std::shared_ptr<const PolygonFrame> frame;
  Equation equation;
  int count;
  const BoundaryFunction* data;

  int rows_a_point() const { return equation == Equation::Biharmonic ? 3 : 1; }
};

Matrix data_at(const Problem& problem, std::span<const FramePoint> points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Matrix data = Matrix::Zero(problem.rows_a_point() * n, problem.count);
  std::array<std::vector<double>, 3> numbers;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (auto& row : numbers) row.assign(problem.count, 0.0);
    (*problem.data)(edge_point(*problem.frame, points[i]), BoundaryData{numbers[0], numbers[1], numbers[2]});
    for (int row = 0; row < problem.rows_a_point(); ++row)
      for (int p = 0; p < problem.count; ++p)
        data(row * n + i, p) = std::ldexp(numbers[row][p], row == 0 ? 0 : problem.frame->exponent());
  }
  return data;
}

// The point as whoever asks for it has it: rounded, and a few roundings inside.
SeenPoint<double> seen_nearby(const PolygonFrame& frame, const FramePoint& p, double step) {
  const EdgePoint on = edge_point(frame, p);
  return frame.see(Vec3<double>(on.point - step * on.normal));
}

// \param step 0: exactly on the edges; else points rounded, that far inside.
Matrix functions_at(const Problem& problem, const GoursatBasis& basis, std::span<const FramePoint> points,
                    double step = 0) {
  const auto n = static_cast<Eigen::Index>(points.size());
  const bool biharmonic = problem.equation == Equation::Biharmonic;
  Matrix functions(problem.rows_a_point() * n, basis.size());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(3, basis.size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const FramePoint& p = points[i];
    const SeenPoint<double> seen =
        step > 0 ? seen_nearby(*problem.frame, p, step) : problem.frame->see_on_edge(p.edge, p.from_start, p.from_end);
    basis.rows_at(seen, biharmonic ? 1 : 0, rows.data());
    functions.row(i) = rows.row(0);
    if (!biharmonic) continue;
    const Complex<double> e = problem.frame->edge(p.edge);
    const double x = e.re / problem.frame->length(p.edge), y = e.im / problem.frame->length(p.edge);
    functions.row(n + i) = y * rows.row(1) - x * rows.row(2);
    functions.row(2 * n + i) = x * rows.row(1) + y * rows.row(2);
  }
  return functions;
}

// Solutions by one basis.
struct Trial {
  std::shared_ptr<const GoursatBasis> basis;
  Matrix coefficients;  // by function and problem
  DirichletReport report;

  // How far it is from being good enough.
  double excess(const DirichletOptions& options) const {
    return std::max(report.value_residual / options.value_tolerance,
                    report.gradient_residual / options.gradient_tolerance);
  }
};

Trial solved_with(const Problem& problem, int degree, int terms) {
  Trial trial;
  const auto positions = [&](std::span<const FramePoint> points) {
    std::vector<std::complex<double>> found;
    for (const FramePoint& p : points) {
      const Complex<double> z = problem.frame->see_on_edge(p.edge, p.from_start, p.from_end).position;
      found.emplace_back(z.re, z.im);
    }
    return found;
  };
  int unknowns = (degree + 1) * (problem.equation == Equation::Biharmonic ? 4 : 2);
  for (int k = 0; k < problem.frame->size(); ++k)
    unknowns += CornerFunctions(problem.equation, problem.frame->corner(k).angle, terms).size();
  // Three equations to an unknown, so that nothing oscillates between the points: biharmonic data give three at a point
  // (the value and two derivatives), harmonic ones one.
  const int least = problem.equation == Equation::Biharmonic ? unknowns : 3 * unknowns;
  const std::vector<FramePoint> points = boundary_points(*problem.frame, least, 0.5);
  trial.basis = std::make_shared<const GoursatBasis>(problem.frame, problem.equation, degree, terms, positions(points));
  Matrix data = data_at(problem, points);
  const std::vector<FramePoint> between = boundary_points(*problem.frame, 3 * least / 2, 0.29);
  Matrix expected = data_at(problem, between);
  // Each problem over its largest number, so that residuals are relative.
  Eigen::RowVectorXd scale = data.cwiseAbs().colwise().maxCoeff();
  // Values are measured by the largest value: slopes along a short edge are large, and would hide what values miss.
  Eigen::RowVectorXd of_values = data.topRows(static_cast<Eigen::Index>(points.size())).cwiseAbs().colwise().maxCoeff();
  for (Eigen::Index k = 0; k < scale.size(); ++k) {
    if (!(scale[k] > 0)) scale[k] = 1;
    of_values[k] = of_values[k] > 0 ? scale[k] / of_values[k] : 1;
  }
  data *= scale.cwiseInverse().asDiagonal();
  expected *= scale.cwiseInverse().asDiagonal();
  Matrix functions = functions_at(problem, *trial.basis, points);
  LeastSquares found = solve_least_squares(functions, data, kThreshold);
  functions = functions_at(problem, *trial.basis, between, kStep * problem.frame->largest_coordinate());
  const Matrix left = (functions * found.solution - expected).cwiseAbs();
  const auto n = static_cast<Eigen::Index>(between.size());
  trial.report = {.degree = degree,
                  .terms = terms,
                  .equations = static_cast<int>(data.rows()),
                  .unknowns = trial.basis->size(),
                  .rank = found.rank,
                  .condition = found.condition,
                  .residual = found.residual,
                  .value_residual = (left.topRows(n) * of_values.asDiagonal()).maxCoeff(),
                  .gradient_residual = left.rows() > n ? left.bottomRows(left.rows() - n).maxCoeff() : 0};
  trial.coefficients = found.solution * scale.asDiagonal();
  return trial;
}

// Exponents of each corner, so that all corners together take about half of the unknowns, or a third: of biharmonic
// functions there are two to an exponent, of harmonic ones one.
int terms_of(const Problem& problem, const DirichletOptions& options) {
  constexpr int kFewest = 3, kMost = 20;
  const int share = problem.equation == Equation::Biharmonic ? 4 : 3;
  return std::clamp(options.most_unknowns / (share * problem.frame->size()) + 2, kFewest, kMost);
}

// About how many times as long as wide the polygon and its limbs are: the layers at their ends, as wide as they are,
// take polynomials of more than the first degrees.
double slenderness(const PolygonFrame& frame) {
  double area = 0, perimeter = 0;
  for (int k = 0; k < frame.size(); ++k) {
    area += (conj(frame.corner(k).position) * frame.corner(frame.next(k)).position).im / 2;
    perimeter += frame.length(k);
  }
  return perimeter * perimeter / (4 * area) / 4;
}

Trial best_of(const Problem& problem, const DirichletOptions& options) {
  if (options.degree > 0) return solved_with(problem, options.degree, options.terms);
  const int terms = terms_of(problem, options);
  std::optional<Trial> best;
  const bool slender =
      problem.equation == Equation::Biharmonic && problem.frame->size() <= 8 && slenderness(*problem.frame) > 16;
  for (const int degree : {40, 80, 160, 240}) {
    if (slender && degree < 160) continue;
    Trial trial = solved_with(problem, degree, terms);
    const double excess = trial.excess(options), before = best ? best->excess(options) : HUGE_VAL;
    const int unknowns = trial.report.unknowns;
    if (!best || excess < before) best = std::move(trial);
    // Refinement that helps little now will not help much later.
    if (excess <= 1 || excess > before / 4 || 2 * unknowns > options.most_unknowns) break;
  }
  return std::move(*best);
}

}  // namespace

struct DirichletSolution::State {
  std::shared_ptr<const PolygonFrame> frame;
  std::shared_ptr<const GoursatBasis> basis;
  Eigen::MatrixXd coefficients;  // by function and problem
  DirichletReport report;
};

std::string why_no_dirichlet_solution(const Cage& cage) { return why_not_solved(cage); }

DirichletSolution::DirichletSolution(const Cage& cage, Equation equation, int problems, const BoundaryFunction& data,
                                     const DirichletOptions& options) {
  const auto frame = std::make_shared<const PolygonFrame>(cage);
  Trial best = best_of({frame, equation, problems, &data}, options);
  if (!best.coefficients.allFinite())
    throw InputError(
        fmt::format("{}: lengths leave the range in which its equation can be solved in double", cage.name()));
  state_ = std::make_unique<const State>(State{frame, best.basis, std::move(best.coefficients), best.report});
}

DirichletSolution::~DirichletSolution() = default;
DirichletSolution::DirichletSolution(DirichletSolution&&) noexcept = default;

int DirichletSolution::problems() const { return static_cast<int>(state_->coefficients.cols()); }

const DirichletReport& DirichletSolution::report() const { return state_->report; }

PointPlace DirichletSolution::place(const Vec3<double>& point) const {
  const std::optional<int> winding = winding_number(state_->frame->segments(), point);
  if (winding) return *winding == 1 ? PointPlace::Inside : PointPlace::Outside;
  for (const Segment<double>& s : state_->frame->segments())
    if (s[0] == point) return PointPlace::OnCorner;
  return PointPlace::OnEdge;
}

template <Scalar R>
std::array<std::vector<R>, 3> DirichletSolution::at(const Vec3<R>& point, int order) const {
  const PolygonFrame& frame = *state_->frame;
  const GoursatBasis& basis = *state_->basis;
  const Matrix& coefficients = state_->coefficients;
  std::array<std::vector<R>, 3> found;
  for (int o = 0; o <= order; ++o) found[o].assign(problems() << o, std::numeric_limits<R>::quiet_NaN());
  const Vec3<double> rounded = convert<double>(point);
  const PointPlace where = place(rounded);
  if (where == PointPlace::Outside || where == PointPlace::OnCorner) return found;
  SeenPoint<R> seen;
  if (where == PointPlace::Inside) {
    seen = frame.see(point);
  } else {
    int edge = 0;
    while (!frame.is_on(edge, rounded)) ++edge;
    const Segment<double>& s = frame.segments()[edge];
    const auto distance = [&](const Vec3<double>& end) {
      using std::ldexp, std::sqrt;
      const R x = ldexp(R(point[0] - R(end[0])), -frame.exponent()),
              y = ldexp(R(point[1] - R(end[1])), -frame.exponent());
      return R(sqrt(R(x * x + y * y)));
    };
    const R from = distance(s[0]), to = distance(s[1]);
    seen = frame.see_on_edge(edge, R(from / (from + to)), R(to / (from + to)));
  }
  const int rows = rows_of_order(order), n = basis.size();
  std::vector<R> functions(static_cast<std::size_t>(rows) * n);
  basis.rows_at(seen, order, functions.data());
  const auto entry = [&](int row, int problem) {
    R sum(0);
    for (int j = 0; j < n; ++j) sum += functions[row * n + j] * R(coefficients(j, problem));
    return sum;
  };
  using std::ldexp;
  for (int p = 0; p < problems(); ++p) {
    found[0][p] = entry(0, p);
    for (int i = 0; order >= 1 && i < 2; ++i) found[1][2 * p + i] = ldexp(entry(1 + i, p), -frame.exponent());
    if (order < 2) continue;
    for (int i = 0; i < 3; ++i) {
      const R second = ldexp(entry(3 + i, p), -2 * frame.exponent());
      found[2][4 * p + (i == 2 ? 3 : i)] = second;
      if (i == 1) found[2][4 * p + 2] = second;
    }
  }
  return found;
}

#define CAGEPROOF_INSTANTIATE(R) \
  template std::array<std::vector<R>, 3> DirichletSolution::at<R>(const Vec3<R>&, int) const;
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::solved::goursat
