// SPDX-License-Identifier: MIT
#include "entropy_route.h"

#include "elimination.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace cageproof::second_routes {
namespace {

// An affine function c + t.d of offsets, and the four numbers that a vertex multiplies its unknowns with.
using Affine = std::array<Mp100, 4>;

Affine factors_of(const Vec3<Mp100>& offset) { return {Mp100(1), offset[0], offset[1], offset[2]}; }

Mp100 value_at(const Affine& unknowns, const Vec3<Mp100>& offset) {
  const Affine factors = factors_of(offset);
  Mp100 sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += unknowns[k] * factors[k];
  return sum;
}

std::vector<std::size_t> vertices_with_prior(const EntropyProblem& problem) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < problem.prior.size(); ++i)
    if (problem.prior[i] > 0) found.push_back(i);
  return found;
}

// The affine function with these values at the vertices, from the four of them that span the largest simplex greedily.
std::optional<Affine> affine_through(const EntropyProblem& problem, const std::vector<std::size_t>& vertices,
                                     const std::vector<Mp100>& values) {
  Table<Mp100> matrix(4, 4), right(4, 1);
  std::vector<Affine> left;  // the rest of each vertex's factors, orthogonal to those taken
  left.reserve(vertices.size());
  for (const std::size_t v : vertices) left.push_back(factors_of(problem.offsets[v]));
  const auto dot = [](const Affine& a, const Affine& b) {
    Mp100 sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += a[k] * b[k];
    return sum;
  };
  for (std::size_t taken = 0; taken < 4; ++taken) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < left.size(); ++i)
      if (dot(left[i], left[i]) > dot(left[best], left[best])) best = i;
    const Affine axis = left[best], factors = factors_of(problem.offsets[vertices[best]]);
    const Mp100 square = dot(axis, axis);
    if (!(square > Mp100("1e-60"))) return std::nullopt;
    for (std::size_t k = 0; k < 4; ++k) matrix(taken, k) = factors[k];
    right(taken, 0) = values[best];
    for (Affine& of : left) {
      const Mp100 along = dot(of, axis) / square;
      for (std::size_t k = 0; k < 4; ++k) of[k] -= along * axis[k];
    }
  }
  const Table<Mp100> found = eliminated(matrix, right);
  return Affine{found(0, 0), found(1, 0), found(2, 0), found(3, 0)};
}

}  // namespace

EntropyProblem::EntropyProblem(std::span<const Vec3<double>> vertices, std::vector<Mp100> prior_of_vertices,
                               const Vec3<double>& point, double size)
    : prior(std::move(prior_of_vertices)) {
  for (const Vec3<double>& v : vertices)
    offsets.emplace_back((convert<Mp100>(v) - convert<Mp100>(point)) / Mp100(size));
}

std::vector<Mp100> entropy_coordinates(const EntropyProblem& problem) {
  constexpr int steps = 300;
  const Mp100 enough("1e-80");
  const std::vector<std::size_t> vertices = vertices_with_prior(problem);
  std::vector<Mp100> lambda(problem.prior.size());
  Mp100 total = 0;
  for (const std::size_t v : vertices) total += problem.prior[v];
  Affine unknowns{Mp100(-log(total)), Mp100(0), Mp100(0), Mp100(0)};
  for (int step = 0; step < steps; ++step) {
    Table<Mp100> matrix(4, 4), right(4, 1);
    right(0, 0) = 1;
    for (const std::size_t v : vertices) {
      const Affine factors = factors_of(problem.offsets[v]);
      lambda[v] = problem.prior[v] * exp(value_at(unknowns, problem.offsets[v]));
      for (std::size_t k = 0; k < 4; ++k) {
        right(k, 0) -= lambda[v] * factors[k];
        for (std::size_t j = 0; j < 4; ++j) matrix(k, j) += lambda[v] * factors[k] * factors[j];
      }
    }
    if (std::ranges::all_of(right.entries, [&](const Mp100& x) { return abs(x) < enough; })) return lambda;
    const Table<Mp100> found = eliminated(matrix, right);
    const Affine change{found(0, 0), found(1, 0), found(2, 0), found(3, 0)};
    Mp100 largest = 0;
    for (const std::size_t v : vertices) largest = std::max(largest, abs(value_at(change, problem.offsets[v])));
    if (!isfinite(largest)) break;
    // Steps of this length lessen the dual function whatever comes; near the minimum Newton's own converge.
    const Mp100 length = largest > 0.25 ? Mp100(1 / (1 + largest)) : Mp100(1);
    for (std::size_t k = 0; k < 4; ++k) unknowns[k] += length * change[k];
  }
  return std::vector<Mp100>(problem.prior.size(), std::numeric_limits<Mp100>::quiet_NaN());
}

double unmet_optimality(const EntropyProblem& problem, std::span<const Mp100> lambda) {
  const std::vector<std::size_t> vertices = vertices_with_prior(problem);
  Mp100 sum = -1;
  Vec3<Mp100> mean = Vec3<Mp100>::Zero();
  std::vector<Mp100> logarithms;
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    if (isnan(lambda[i])) return std::numeric_limits<double>::quiet_NaN();
    if (problem.prior[i] > 0 ? !(lambda[i] > 0) : lambda[i] != 0) return std::numeric_limits<double>::infinity();
    sum += lambda[i];
    mean += lambda[i] * problem.offsets[i];
  }
  logarithms.reserve(vertices.size());
  for (const std::size_t v : vertices) logarithms.push_back(log(Mp100(lambda[v] / problem.prior[v])));
  Mp100 worst = std::max(Mp100(abs(sum)), Mp100(sqrt(Mp100(mean.dot(mean)))));
  // Where the vertices with a prior lie in a plane, the others' conditions hold there or nowhere.
  if (const auto affine = affine_through(problem, vertices, logarithms))
    for (std::size_t i = 0; i < vertices.size(); ++i)
      worst = std::max(worst, Mp100(abs(logarithms[i] - value_at(*affine, problem.offsets[vertices[i]]))));
  return static_cast<double>(worst);
}

}  // namespace cageproof::second_routes
