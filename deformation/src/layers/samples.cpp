// SPDX-License-Identifier: MIT
#include "samples.h"

namespace cageproof::deformation {
namespace {

using Basis = std::array<double, 4>;

// A part's corners, in the whole element's basis functions.
using Corners = std::array<Basis, 4>;

void add_centroids(const ElementType& type, const Corners& part, int level, int element,
                   std::vector<Touching>& samples) {
  if (level > 0) {
    for (const ElementPart& smaller : type.parts) {
      Corners within{};
      for (int k = 0; k < type.corners; ++k)
        for (int j = 0; j < type.corners; ++j)
          for (int i = 0; i < type.corners; ++i) within[k][i] += smaller[k][j] * part[j][i];
      add_centroids(type, within, level - 1, element, samples);
    }
    return;
  }
  Touching sample{element, {}};
  double rest = 1;
  for (int i = 1; i < type.corners; ++i) {
    for (int k = 0; k < type.corners; ++k) sample.basis[i] += part[k][i];
    sample.basis[i] /= type.corners;
    rest -= sample.basis[i];
  }
  sample.basis[0] = rest;
  samples.push_back(sample);
}

}  // namespace

std::vector<Touching> samples_of(const CageElements& elements, int level) {
  std::vector<Touching> samples;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const ElementType& type = elements.type(e);
    Corners whole{};
    for (int k = 0; k < type.corners; ++k) whole[k][k] = 1;
    add_centroids(type, whole, level, static_cast<int>(e), samples);
  }
  return samples;
}

template <Scalar R>
SampledLayers<R> layers_at(const CageCoordinates& coordinates, int level) {
  const CageElements& elements = coordinates.elements();
  SampledLayers<R> found;
  found.samples = samples_of(elements, level);
  const std::size_t count = found.samples.size();
  found.hats = Matrix<R>::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(elements.vertices().size()));
  for (std::size_t s = 0; s < count; ++s) {
    const auto corners = elements.vertices_of(found.samples[s].element);
    for (std::size_t k = 0; k < corners.size(); ++k)
      found.hats(static_cast<Eigen::Index>(s), corners[k]) = R(found.samples[s].basis[k]);
  }
  const auto tables = coordinates.limits_at<R>(found.samples, 0);
  found.phi = component(tables[0], count, 0, 1, 0);
  found.psi = component(tables[1], count, 0, 1, 0);
  found.phibar = component(tables[2], count, 0, 1, 0);
  found.psibar = component(tables[3], count, 0, 1, 0);
  return found;
}

template SampledLayers<double> layers_at<double>(const CageCoordinates&, int);
template SampledLayers<Mp50> layers_at<Mp50>(const CageCoordinates&, int);

}  // namespace cageproof::deformation
