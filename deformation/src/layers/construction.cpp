// SPDX-License-Identifier: MIT
#include "construction.h"

#include "../more_digits.h"

#include "cageproof/deformation/stretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::deformation {
namespace {

// Double solves as long as roundings times the condition stay below 1e-10 of the data.
constexpr double most_in_double = 1e6;

// Along the rest normals of the samples' elements, of all four layers.
template <Scalar R>
std::array<Matrix<R>, 4> normal_slopes(const CageCoordinates& coordinates, const std::vector<Touching>& samples) {
  const auto tables = checked_limits<R>(coordinates, samples, 1);
  const int d = coordinates.dimension();
  const std::vector<Vec3<R>> normals =
      stretched_normals(Stretch::Unit, coordinates.elements(), vertices_in<R>(coordinates.elements()));
  std::array<Matrix<R>, 4> found;
  for (std::size_t b = 0; b < 4; ++b) {
    found[b] = Matrix<R>::Zero(static_cast<Eigen::Index>(samples.size()), coordinates.blocks()[b].size);
    for (int c = 0; c < d; ++c) {
      const Matrix<R> along = component(tables[b], samples.size(), 1, d, c);
      for (std::size_t s = 0; s < samples.size(); ++s) {
        const auto row = static_cast<Eigen::Index>(s);
        // Flat elements have one normal each.
        found[b].row(row) += normals[samples[s].element][c] * along.row(row);
      }
    }
  }
  return found;
}

// Normal derivatives at samples: one column per element, or one per corner, multiplied with the corner's hat function.
template <Scalar R>
Matrix<R> normals_at(const CageCoordinates& coordinates, const SampledLayers<R>& layers) {
  const CageElements& elements = coordinates.elements();
  const Owner owner = normals_owner(coordinates);
  Matrix<R> found = Matrix<R>::Zero(layers.neumann.rows(), layers.neumann.cols());
  for (std::size_t s = 0; s < layers.samples.size(); ++s) {
    const int element = layers.samples[s].element;
    const auto shares = elements.shares_of(element, owner), vertices = elements.vertices_of(element);
    const auto row = static_cast<Eigen::Index>(s);
    for (std::size_t k = 0; k < shares.size(); ++k)
      found(row, shares[k]) = shares.size() == 1 ? R(1) : layers.hats(row, vertices[k]);
  }
  return found;
}

}  // namespace

KindParameter level_parameter() {
  return {{.name = "level", .preset = 1, .lowest = -1, .highest = 6, .whole = true},
          "times that elements are split for samples: 4^level a triangle, or a quad that is kept"};
}

KindParameter neumann_parameter() {
  return {{.name = "neumann", .preset = 0, .lowest = -1, .highest = 2, .whole = true},
          "normal derivatives of an element: one, or one per corner, affine between them",
          {"constant", "affine"}};
}

std::vector<KindParameter> weight_parameters(Construction construction) {
  if (construction != Construction::OneThree) return {};
  return {{{.name = "gamma_d", .preset = 1, .lowest = kBelowZero, .highest = 1e300},
           "weight of values against Laplacians; has the unit of one over the fourth power of a length"},
          {{.name = "gamma_rel", .preset = 0, .lowest = kBelowZero, .highest = 1e300},
           "the same over the fourth power of the rest cage's size; in place of gamma_d where it is not zero"}};
}

template <Scalar R>
Regularisation<R> regularisation_by(Construction construction, const CageCoordinates& coordinates, int level,
                                    std::span<const double> weights, Account account) {
  const SampledLayers<R> layers = layers_at<R>(coordinates, level);
  switch (construction) {
    case Construction::OneTwo:
      return one_two<R>(layers, normal_slopes<R>(coordinates, layers.samples), normals_at<R>(coordinates, layers),
                        account);
    case Construction::Weber: return weber<R>(layers, account);
    case Construction::OneThree: break;
  }
  return one_three<R>(layers, one_three_weight<R>(weights, layers), account);
}

bool takes_50_digits(Construction construction, const CageCoordinates& layers, int level,
                     const std::function<std::vector<SolvedSystem>()>& solved_in_double) {
  if (!layers.is_exact_in(ScalarKind::Digits50) || !can_have_50_digits(layers.elements(), level)) return false;
  if (wants_50_digits(layers.elements(), level, construction == Construction::OneTwo)) return true;
  // Systems that are solved one after the other enlarge each other's roundings.
  double condition = 1;
  for (const SolvedSystem& system : solved_in_double()) condition *= system.condition;
  return condition > most_in_double;
}

template <Scalar R>
R weight_in(double gamma_d, double unit) {
  if (gamma_d == 0) return R(0);
  const R square = R(unit) * R(unit), weight = R(gamma_d) * square * square;
  // Rows without any weight at all would be another method.
  return std::clamp<R>(weight, R(std::numeric_limits<double>::min()), R(std::numeric_limits<double>::max()));
}

template double weight_in<double>(double, double);
template Mp50 weight_in<Mp50>(double, double);

template Regularisation<double> regularisation_by<double>(Construction, const CageCoordinates&, int,
                                                          std::span<const double>, Account);
template Regularisation<Mp50> regularisation_by<Mp50>(Construction, const CageCoordinates&, int,
                                                      std::span<const double>, Account);

}  // namespace cageproof::deformation
