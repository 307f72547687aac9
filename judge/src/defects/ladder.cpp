// SPDX-License-Identifier: MIT
#include "defects/ladder.h"

#include "conventions/samples.h"
#include "conventions/tensors.h"

#include <algorithm>
#include <cmath>

namespace cageproof::judge {
namespace {

using validation::Sample;

constexpr int kFarthest = 6, kNearest = -14;  // powers of two of the element's size

double relative_error(const Study& study, const Sample& sample, int order) {
  const Tensors ours = reference_of(study.formula(), sample, order);
  const Result<double> theirs = study.ask(sample, order);
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < ours[order].size(); ++i) {
    difference = std::max(difference, std::abs(theirs.of(order)[i] - ours[order][i]));
    size = std::max(size, std::abs(ours[order][i]));
  }
  return size > 0 ? difference / size : 0;
}

// Straight down to a point of the element's interior. Points stay off it.
bool rises(const Study& study, Sample sample, int order) {
  const ElementType& type = type_of(study.formula().element);
  const auto& c = sample.corners;
  Vec3<double> foot = Vec3<double>::Zero();
  for (std::size_t k = 0; k < c.size(); ++k) foot += c[k] * (k == 0 ? 0.4 : 0.6 / static_cast<double>(c.size() - 1));
  const Vec3<double> normal = type.normal(c, {0.25, 0.25, 0.25, 0.25}).normalized() * (c[1] - c[0]).norm();
  std::vector<double> errors;
  for (int power = kFarthest; power >= kNearest; --power) {
    sample.point = foot + std::ldexp(1.0, power) * normal;
    errors.push_back(relative_error(study, sample, order));
  }
  constexpr double rounding = 1e-10;
  const auto between = std::ranges::count_if(errors, [](double e) { return e > rounding && e < 1e-2; });
  const auto seen = std::ranges::count_if(errors, [](double e) { return e > rounding; });
  const double largest = *std::ranges::max_element(errors);
  return errors.front() < rounding && errors.back() > 1e-8 && between > 0 && seen > 2 &&
         errors.back() >= std::min(largest / 2, 1e-2);
}

}  // namespace

bool errors_rise_towards(const Study& study, int order, std::uint64_t seed) {
  const auto samples = convention_samples(study.formula(), seed, false, true);
  int rising = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (rises(study, samples[i], order)) ++rising;
  return rising >= 3;
}

}  // namespace cageproof::judge
