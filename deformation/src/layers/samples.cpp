// SPDX-License-Identifier: MIT
#include "samples.h"

#include "../own_unit.h"
#include "../thinness.h"

#include "cageproof/core/input_error.h"
#include "cageproof/deformation/stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof::deformation {
namespace {

using Basis = std::array<double, 4>;

// The most numbers of one of the layers' matrices: a gigabyte, for each of several matrices.
constexpr double most_numbers = 1.3e8;

// A part's corners, in the whole element's basis functions.
using Corners = std::array<Basis, 4>;

// A sum of halves of halves over the number of corners, rounded so that what such numbers leave of one is a double.
double share_of_centroid(double sum, int corners) {
  constexpr double unit = 0x1p-52;
  return std::round(sum / corners / unit) * unit;
}

// \param rest the corner whose basis function is what the others leave of one: the same vertex whichever corner an
// element is said to begin with, so that samples are the same
void add_centroids(const ElementType& type, const Corners& part, int level, int element, int rest,
                   std::vector<Touching>& samples) {
  if (level > 0) {
    for (const ElementPart& smaller : type.parts) {
      Corners within{};
      for (int k = 0; k < type.corners; ++k)
        for (int j = 0; j < type.corners; ++j)
          for (int i = 0; i < type.corners; ++i) within[k][i] += smaller[k][j] * part[j][i];
      add_centroids(type, within, level - 1, element, rest, samples);
    }
    return;
  }
  Touching sample{element, {}};
  sample.basis[rest] = 1;
  for (int i = 0; i < type.corners; ++i) {
    if (i == rest) continue;
    double sum = 0;
    for (int k = 0; k < type.corners; ++k) sum += part[k][i];
    sample.basis[i] = share_of_centroid(sum, type.corners);
    sample.basis[rest] -= sample.basis[i];
  }
  samples.push_back(sample);
}

double count_of_samples(const CageElements& elements, int level) {
  double count = 0;
  for (std::size_t e = 0; e < elements.count(); ++e)
    count += std::pow(static_cast<double>(elements.type(e).parts.size()), level);
  return count;
}

// One column per element, made of affine layers, which have one per corner. Of quads that are kept each corner has a
// density of its own, as it has a normal derivative.
template <Scalar R>
Matrix<R> of_densities(const Matrix<R>& columns, const CageElements& elements, Owner owner) {
  if (owner != Owner::Corner) return columns;
  Matrix<R> found = Matrix<R>::Zero(columns.rows(), static_cast<Eigen::Index>(elements.count()));
  for (std::size_t e = 0; e < elements.count(); ++e)
    for (const int corner : elements.shares_of(e, owner))
      found.col(static_cast<Eigen::Index>(e)) += columns.col(corner);
  return found;
}

// \throws InputError where its cube or that of its inverse is no normal number
double unit_of_layers(double size) {
  const double unit = unit_next_to(size);
  if (!std::isnormal(unit * unit * unit) || !std::isnormal(1 / unit / unit / unit))
    throw InputError(fmt::format("layers of a cage of size {:.3g} leave the range of double", size));
  return unit;
}

// \param what "values" or "derivatives", which leave so much of a sum that is exactly zero
std::string why_no_limits(const CageCoordinates& coordinates, int element, std::string_view what, double left) {
  if (coordinates.is_exact_in(ScalarKind::Digits50)) {
    const Thinness thinness = thinness_of(coordinates.elements());
    return fmt::format(
        "double has no digits left of {} on element {} of the cage (counted from 0), from which densities "
        "are solved: their sum is 0, and {:.2g} of their size is left of it; element {} {}",
        what, element, left, thinness.element, thinness.what);
  }
  return fmt::format("'{}' has no limits of {} on the cage, from which densities are solved", coordinates.evaluation(),
                     what);
}

// Basis functions as limits are taken with them: all but the first are the sample's doubles, and they sum to one in any
// scalar.
template <Scalar R>
std::array<R, 4> basis_in(const Touching& sample, std::size_t corners) {
  std::array<R, 4> basis{R(1), R(0), R(0), R(0)};
  for (std::size_t k = 1; k < corners; ++k) {
    basis[k] = R(sample.basis[k]);
    basis[0] -= basis[k];
  }
  return basis;
}

}  // namespace

std::vector<Touching> samples_of(const CageElements& elements, int level) {
  std::vector<Touching> samples;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const ElementType& type = elements.type(e);
    Corners whole{};
    for (int k = 0; k < type.corners; ++k) whole[k][k] = 1;
    const auto vertices = elements.vertices_of(e);
    const auto rest = static_cast<int>(std::ranges::min_element(vertices) - vertices.begin());
    add_centroids(type, whole, level, static_cast<int>(e), rest, samples);
  }
  return samples;
}

template <Scalar R>
std::vector<CoordinateTable<R>> checked_limits(const CageCoordinates& coordinates, std::span<const Touching> samples,
                                               int order) {
  using std::abs;
  // Quadrature that misses a limit is off by parts of one; rounding by parts of 1e15.
  const R tolerance(1e-8);
  auto tables = coordinates.limits_at<R>(samples, order);
  const CoordinateTable<R>& phi = tables[0];
  for (int o = 0; o <= order; ++o) {
    const std::size_t width = derivative_count(coordinates.dimension(), o);
    for (std::size_t s = 0; s < samples.size(); ++s)
      for (std::size_t k = 0; k < width; ++k) {
        R sum = o == 0 ? R(-1) : R(0), size = 0;
        for (std::size_t i = k; i < phi.stride[o]; i += width) {
          sum += phi.tensors[o][s * phi.stride[o] + i];
          size += abs(phi.tensors[o][s * phi.stride[o] + i]);
        }
        if (abs(sum) <= tolerance * size || size == 0) continue;
        // How often the cage winds around the sample. Samples of why_overlap_is_refused may have missed it.
        const double winding = static_cast<double>(R(sum + R(1)));
        if (o == 0 && std::round(winding) != 1 && std::abs(winding - std::round(winding)) < 1e-6)
          throw InputError(
              fmt::format("the cage overlaps itself: on element {} of its triangles and quads that are kept (counted "
                          "from 0) values sum to {:.0f}, not to 1, from which no densities can be solved; make one "
                          "surface of it (a union), or take green or mean_value",
                          samples[s].element, winding));
        throw InputError(why_no_limits(coordinates, samples[s].element, o == 0 ? "values" : "derivatives",
                                       static_cast<double>(R(abs(sum) / size))));
      }
  }
  return tables;
}

template <Scalar R>
SampledLayers<R> layers_at(const CageCoordinates& coordinates, int level) {
  const CageElements& elements = coordinates.elements();
  SampledLayers<R> found;
  const double size = size_of(elements);
  found.unit = unit_of_layers(size);
  const Owner neumann = normals_owner(coordinates);
  const double wanted = count_of_samples(elements, level);
  const std::size_t columns = elements.vertices().size() + elements.count(neumann);
  if (wanted * static_cast<double>(columns) > most_numbers)
    throw InputError(fmt::format(
        "{:.0f} samples times {} vertices and normal derivatives are more numbers than {:.0e}: a lower level "
        "will do",
        wanted, columns, most_numbers));
  found.samples = samples_of(elements, level);
  const std::size_t count = found.samples.size();
  found.hats = Matrix<R>::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(elements.vertices().size()));
  for (std::size_t s = 0; s < count; ++s) {
    const auto corners = elements.vertices_of(found.samples[s].element);
    const std::array<R, 4> basis = basis_in<R>(found.samples[s], corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) found.hats(static_cast<Eigen::Index>(s), corners[k]) = basis[k];
  }
  const auto tables = checked_limits<R>(coordinates, found.samples, 0);
  found.size = size / found.unit;
  const R unit(found.unit);
  found.phi = component(tables[0], count, 0, 1, 0);
  found.neumann = component(tables[1], count, 0, 1, 0) / unit;
  found.psi = of_densities(found.neumann, elements, neumann);
  found.phibar = component(tables[2], count, 0, 1, 0) / unit / unit;
  found.psibar = component(tables[3], count, 0, 1, 0) / unit / unit / unit;
  return found;
}

template std::vector<CoordinateTable<double>> checked_limits<double>(const CageCoordinates&, std::span<const Touching>,
                                                                     int);
template std::vector<CoordinateTable<Mp50>> checked_limits<Mp50>(const CageCoordinates&, std::span<const Touching>,
                                                                 int);
template SampledLayers<double> layers_at<double>(const CageCoordinates&, int);
template SampledLayers<Mp50> layers_at<Mp50>(const CageCoordinates&, int);

}  // namespace cageproof::deformation
