// SPDX-License-Identifier: MIT
#include "defects/closed_sum.h"

#include "conventions/tensors.h"

#include <algorithm>
#include <cmath>

namespace cageproof::judge {
namespace {

using validation::Sample;

const std::vector<Vec3<double>> kVertices{{0, 0, 0}, {1, 0.1, 0}, {0.2, 0.9, 0.1}, {0.1, 0.2, 0.8}};
const std::vector<std::vector<std::size_t>> kTriangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
const std::vector<std::vector<std::size_t>> kSegments{{0, 1}, {1, 2}, {2, 0}};

Sample sample_of(const Formula& formula, const std::vector<std::size_t>& face, const Vec3<double>& point) {
  Sample sample{.point = point};
  for (const std::size_t v : face) {
    sample.corners.push_back(kVertices[v]);
    if (formula.dim() == 2) sample.corners.back()[2] = 0;
  }
  for (const Parameter& parameter : formula.parameters) sample.parameters.push_back(parameter.preset);
  return sample;
}

double largest_error(const Evaluation& ours, const std::vector<std::size_t>& face, const Vec3<double>& point,
                     int order) {
  const Sample sample = sample_of(ours.formula(), face, point);
  const auto theirs = tensors_of(ours, sample, order)[order],
             right = reference_of(ours.formula(), sample, order)[order];
  double off = 0;
  for (std::size_t i = 0; i < right.size(); ++i) off = std::max(off, std::abs(theirs[i] - right[i]));
  return off;
}

// The sum at each vertex, one after the other; with one tensor per element all are at the first.
template <class Tensor>
std::vector<double> summed(const Formula& formula, const std::vector<std::vector<std::size_t>>& faces,
                           const Vec3<double>& point, Tensor&& tensor_of) {
  const auto tensors = static_cast<std::size_t>(formula.tensors());
  std::vector<double> sum;
  for (const auto& face : faces) {
    const std::vector<double> tensor = tensor_of(sample_of(formula, face, point));
    const std::size_t block = tensor.size() / tensors;
    sum.resize(kVertices.size() * block);
    for (std::size_t i = 0; i < tensor.size(); ++i)
      sum[(formula.shape.per_corner ? face[i / block] * block : 0) + i % block] += tensor[i];
  }
  return sum;
}

}  // namespace

bool closed_sum_is_right(const Evaluation& ours, int order) {
  const Formula& formula = ours.formula();
  if (formula.element == ElementKind::Quad) return false;
  const auto& faces = formula.dim() == 3 ? kTriangles : kSegments;
  for (const double height : {0.2, -1.5}) {
    const Vec3<double> point(0.3, 0.31, formula.dim() == 3 ? height : 0);
    const auto theirs =
        summed(formula, faces, point, [&](const Sample& s) { return tensors_of(ours, s, order)[order]; });
    const auto right =
        summed(formula, faces, point, [&](const Sample& s) { return reference_of(formula, s, order)[order]; });
    double sum_off = 0;
    for (std::size_t i = 0; i < right.size(); ++i) sum_off = std::max(sum_off, std::abs(theirs[i] - right[i]));
    if (!(sum_off <= 1e-3 * largest_error(ours, faces[0], point, order))) return false;
  }
  return true;
}

}  // namespace cageproof::judge
