// SPDX-License-Identifier: MIT
#include "regularisation.h"

#include "rounding_terms.h"
#include "solver.h"

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

template <Scalar R>
void put(Regularisation<R>& found, const Matrix<R>& solution, Eigen::Index vertices) {
  found.to_vertices = solution.leftCols(vertices);
  found.to_normals = solution.rightCols(solution.cols() - vertices);
}

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

}  // namespace

template <Scalar R>
Regularisation<R> one_three(const SampledLayers<R>& layers, const R& gamma_d, Account account) {
  using std::sqrt;
  Regularisation<R> found;
  const Eigen::Index vertices = layers.phi.cols(), elements = layers.psi.cols(), samples = layers.phi.rows();
  if (gamma_d == 0) {
    put(found, Matrix<R>(Matrix<R>::Zero(vertices + elements, vertices + elements)), vertices);
    found.terms = Matrix<double>::Zero(vertices + elements, vertices + elements);
    found.warnings.emplace_back("gamma_d = 0: Green coordinates, by definition; it is not the limit of small gamma_d");
    return found;
  }
  const R weight = sqrt(gamma_d);
  const Matrix<R> a = weight * beside(layers.phibar, layers.psibar);
  const Matrix<R> b = beside(Matrix<R>(layers.phi - layers.hats), layers.psi);
  Matrix<R> right = Matrix<R>::Zero(2 * samples, vertices + elements);
  right.topRows(samples) = weight * beside(Matrix<R>(layers.hats - layers.phi), Matrix<R>(-layers.psi));
  Solution<R> densities =
      solved_for(found, above(a, b), right, "(1,3), Eq 24: densities from values and Laplacians", account);
  put(found, densities.found, vertices);
  found.terms = std::move(densities.terms);
  return found;
}

template <Scalar R>
Regularisation<R> one_two(const SampledLayers<R>& layers, const std::array<Matrix<R>, 4>& slopes, Account account) {
  Regularisation<R> found;
  Matrix<R> own = Matrix<R>::Zero(layers.psi.rows(), layers.psi.cols());
  for (std::size_t s = 0; s < layers.samples.size(); ++s)
    own(static_cast<Eigen::Index>(s), layers.samples[s].element) = 1;
  const Matrix<R> matrix = above(beside(slopes[2], slopes[3]), beside(layers.phibar, layers.psibar));
  const Matrix<R> right = above(beside(Matrix<R>(-slopes[0]), Matrix<R>(own - slopes[1])),
                                beside(Matrix<R>(layers.hats - layers.phi), Matrix<R>(-layers.psi)));
  Solution<R> densities =
      solved_for(found, matrix, right, "(1,2), D.1: densities from normal derivatives and values", account);
  put(found, densities.found, layers.phi.cols());
  found.terms = std::move(densities.terms);
  return found;
}

template <Scalar R>
Regularisation<R> weber(const SampledLayers<R>& layers, Account account) {
  Regularisation<R> found;
  const Solution<R> slopes_of = solved_for(found, layers.psi, Matrix<R>(layers.hats - layers.phi),
                                           "D.2: the Laplacian's normal derivative from itself", account);
  const Matrix<R> k = layers.phibar + layers.psibar * slopes_of.found;
  const Solution<R> laplacian =
      solved_for(found, k, beside(Matrix<R>(layers.hats - layers.phi), Matrix<R>(-layers.psi)),
                 "D.2: the Laplacian from values", account);
  put(found, above(laplacian.found, Matrix<R>(slopes_of.found * laplacian.found)), layers.phi.cols());
  if (account == Account::Terms) {
    const Matrix<double> of_slopes = slopes_of.found.template cast<double>().cwiseAbs(),
                         of_laplacian = laplacian.found.template cast<double>().cwiseAbs();
    found.terms = above(laplacian.terms, Matrix<double>(of_slopes * laplacian.terms + slopes_of.terms * of_laplacian));
  }
  return found;
}

#define CAGEPROOF_INSTANTIATE(R)                                                                            \
  template Regularisation<R> one_three<R>(const SampledLayers<R>&, const R&, Account);                      \
  template Regularisation<R> one_two<R>(const SampledLayers<R>&, const std::array<Matrix<R>, 4>&, Account); \
  template Regularisation<R> weber<R>(const SampledLayers<R>&, Account);
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::deformation
