// SPDX-License-Identifier: MIT
#include "conventions/samples.h"

#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/validation/regime.h"

#include <algorithm>
#include <cmath>

namespace cageproof::judge {
namespace {

using validation::Sample;

constexpr std::uint64_t kSamples = 24;

double drawn(const Parameter& parameter, RandomStream& random) {
  if (parameter.whole) return parameter.preset;
  const double low = std::max(parameter.lowest, parameter.lowest == 0 ? 0.125 : -8.0);
  const double high = std::min(parameter.highest, 8.0);
  return random.uniform(low + (high - low) / 16, high - (high - low) / 16);
}

void move_away(Sample& sample, RandomStream& random, int dim) {
  Vec3<double> centre = Vec3<double>::Zero(), way = Vec3<double>::Zero();
  for (const auto& corner : sample.corners) centre += corner / static_cast<double>(sample.corners.size());
  double size = 0;
  for (const auto& corner : sample.corners) size = std::max(size, (corner - centre).norm());
  while (way.norm() < 0.5)
    for (int i = 0; i < dim; ++i) way[i] = random.uniform(-1, 1);
  sample.point = centre + 16 * size * way.normalized();
}

}  // namespace

Sample on_element(Sample sample, ElementKind element) {
  for (auto& corner : sample.corners)
    for (double& x : corner) x = std::round(64 * x) / 64;
  const auto& c = sample.corners;
  if (element == ElementKind::Segment) sample.point = 0.375 * c[0] + 0.625 * c[1];
  else sample.point = 0.25 * c[0] + 0.5 * c[1] + 0.25 * c[2];
  return sample;
}

std::vector<Sample> convention_samples(const Formula& formula, std::uint64_t seed, bool far, bool presets) {
  std::vector<Sample> samples;
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    samples.push_back(make_sample(formula, *validation::find_regime("generic"), seed, i));
    Sample& sample = samples.back();
    RandomStream random(seed, "convention", i);
    sample.parameters.clear();
    for (const Parameter& parameter : formula.parameters)
      sample.parameters.push_back(presets ? parameter.preset : drawn(parameter, random));
    if (far) move_away(sample, random, formula.dim());
  }
  return samples;
}

}  // namespace cageproof::judge
