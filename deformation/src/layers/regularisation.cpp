// SPDX-License-Identifier: MIT
#include "regularisation.h"

#include "rounding_terms.h"
#include "solver.h"

#include <fmt/format.h>

#include <cmath>

namespace cageproof::deformation {
namespace {

template <Scalar R>
Matrix<R> beside(const Matrix<R>& left, const Matrix<R>& right) {
  Matrix<R> both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

template <Scalar R>
Matrix<R> above(const Matrix<R>& upper, const Matrix<R>& lower) {
  Matrix<R> both(upper.rows() + lower.rows(), upper.cols());
  both << upper, lower;
  return both;
}

// Takes a solution, and its terms where they are asked for, from the layers' unit to the user's: L' has the unit of one
// over a length, D' of one over its square.
template <Scalar R>
void put(Regularisation<R>& found, const SampledLayers<R>& layers, Matrix<R> solution, Matrix<double> terms) {
  const Eigen::Index vertices = layers.phi.cols(), elements = layers.psi.cols(), normals = layers.neumann.cols();
  const auto scale = [&](auto& matrix, const auto& unit) {
    if (matrix.size() == 0) return;
    matrix.topRows(vertices) /= unit;
    matrix.bottomRows(elements) /= unit * unit;
    matrix.leftCols(vertices) /= unit;
  };
  scale(solution, R(layers.unit));
  scale(terms, layers.unit);
  found.to_vertices = solution.leftCols(vertices);
  found.to_normals = solution.rightCols(normals);
  found.terms = std::move(terms);
}

// The least gamma_d times the fourth power of the cage's size: below, the condition grows like one over its root.
constexpr double least_harmless = 1e-8;

// A system's solution, and the sizes of what it is rounded by where they are asked for.
template <Scalar R>
struct Solution {
  Matrix<R> found;
  Matrix<double> terms;
};

template <Scalar R>
Solution<R> solved_for(Regularisation<R>& of, const Matrix<R>& matrix, const Matrix<R>& right, const char* name,
                       Account account) {
  const LeastSquares<R> factors(matrix);
  Solution<R> solution{factors.solve(right), {}};
  if (account == Account::Systems)
    of.solved.push_back(describe<R>(name, matrix, factors.rank(), right, solution.found));
  if (account == Account::Terms)
    solution.terms = rounding_terms(matrix.template cast<double>(), right.template cast<double>(),
                                    solution.found.template cast<double>());
  if (factors.rank() < matrix.cols())
    of.warnings.push_back(std::string(name) + ": of deficient rank, the solution of least norm is taken");
  return solution;
}

// A and B of Eq 24, the first times the root of gamma_D.
template <Scalar R>
Matrix<R> one_three_matrix(const SampledLayers<R>& layers, const R& weight) {
  return above(Matrix<R>(weight * beside(layers.phibar, layers.psibar)),
               beside(Matrix<R>(layers.phi - layers.hats), layers.psi));
}

}  // namespace

template <Scalar R>
Matrix<R> one_three_inverse(const SampledLayers<R>& layers, const R& gamma) {
  using std::sqrt;
  const Eigen::Index samples = layers.phi.rows(), densities = layers.phi.cols() + layers.psi.cols();
  if (gamma == 0) return Matrix<R>::Zero(densities, samples);
  const R weight = sqrt(gamma);
  Matrix<R> right = Matrix<R>::Zero(2 * samples, samples);
  right.diagonal().setConstant(weight);
  return LeastSquares<R>(one_three_matrix(layers, weight)).solve(right);
}

template <Scalar R>
Regularisation<R> one_three(const SampledLayers<R>& layers, const R& gamma, Account account) {
  using std::sqrt;
  Regularisation<R> found;
  const Eigen::Index vertices = layers.phi.cols(), densities = vertices + layers.psi.cols(),
                     data = vertices + layers.neumann.cols(), samples = layers.phi.rows();
  if (gamma == 0) {
    put(found, layers, Matrix<R>(Matrix<R>::Zero(densities, data)), Matrix<double>::Zero(densities, data));
    found.warnings.emplace_back("gamma_d = 0: Green coordinates, by definition; it is not the limit of small gamma_d");
    return found;
  }
  const double over_size = static_cast<double>(gamma) * std::pow(layers.size, 4);
  if (over_size < least_harmless)
    found.warnings.push_back(
        fmt::format("gamma_d is {:.1e} over the fourth power of the cage's size: the condition "
                    "grows like one over its root, and digits are lost",
                    over_size));
  const R weight = sqrt(gamma);
  Matrix<R> right = Matrix<R>::Zero(2 * samples, data);
  right.topRows(samples) = weight * beside(Matrix<R>(layers.hats - layers.phi), Matrix<R>(-layers.neumann));
  Solution<R> solved = solved_for(found, one_three_matrix(layers, weight), right,
                                  "(1,3), Eq 24: densities from values and Laplacians", account);
  put(found, layers, std::move(solved.found), std::move(solved.terms));
  return found;
}

template <Scalar R>
Regularisation<R> one_two(const SampledLayers<R>& layers, const std::array<Matrix<R>, 4>& slopes,
                          const Matrix<R>& normals, Account account) {
  Regularisation<R> found;
  // Slopes are numbers and values lengths, and weigh against each other as they do in the user's unit.
  const R unit(layers.unit);
  const Matrix<R> matrix = above(beside(Matrix<R>(slopes[2] / unit), Matrix<R>(slopes[3] / unit / unit)),
                                 Matrix<R>(unit * beside(layers.phibar, layers.psibar)));
  const Matrix<R> right =
      above(beside(Matrix<R>(-unit * slopes[0]), Matrix<R>(normals - slopes[1])),
            Matrix<R>(unit * beside(Matrix<R>(layers.hats - layers.phi), Matrix<R>(-layers.neumann))));
  Solution<R> densities =
      solved_for(found, matrix, right, "(1,2), D.1: densities from normal derivatives and values", account);
  put(found, layers, std::move(densities.found), std::move(densities.terms));
  return found;
}

template <Scalar R>
Regularisation<R> weber(const SampledLayers<R>& layers, Account account) {
  Regularisation<R> found;
  const Solution<R> slopes_of = solved_for(found, layers.psi, Matrix<R>(layers.hats - layers.phi),
                                           "D.2: the Laplacian's normal derivative from itself", account);
  const Matrix<R> k = layers.phibar + layers.psibar * slopes_of.found;
  const Solution<R> laplacian =
      solved_for(found, k, beside(Matrix<R>(layers.hats - layers.phi), Matrix<R>(-layers.neumann)),
                 "D.2: the Laplacian from values", account);
  Matrix<double> terms;
  // The slopes' own roundings are common to all columns.
  if (account == Account::Terms)
    terms =
        above(laplacian.terms, Matrix<double>(slopes_of.found.template cast<double>().cwiseAbs() * laplacian.terms));
  put(found, layers, above(laplacian.found, Matrix<R>(slopes_of.found * laplacian.found)), std::move(terms));
  return found;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                                    \
  template Matrix<R> one_three_inverse<R>(const SampledLayers<R>&, const R&);                                       \
  template Regularisation<R> one_three<R>(const SampledLayers<R>&, const R&, Account);                              \
  template Regularisation<R> one_two<R>(const SampledLayers<R>&, const std::array<Matrix<R>, 4>&, const Matrix<R>&, \
                                        Account);                                                                   \
  template Regularisation<R> weber<R>(const SampledLayers<R>&, Account);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
