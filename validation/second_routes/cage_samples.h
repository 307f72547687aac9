// SPDX-License-Identifier: MIT
// Points of a cage that densities and energies are sampled at, and what layers are there: [T24] Section 4.1.
#pragma once

#include "elimination.h"

#include "cageproof/core/coordinates/coordinates.h"

#include <array>
#include <vector>

namespace cageproof::second_routes {

/// The layers' systems use four times the digits of their input, so that squared conditions cost none of these.
using Wide = Mp200;

/// Elements split so often at their midpoints, and the parts' centroids, in basis functions: all but that of the vertex
/// with the lowest number are rounded to multiples of 2^-52, and they sum to one. \pre triangles or segments
std::vector<Touching> centroids(const CageElements& elements, int level);

/// The basis functions of a sample's corners, which sum to one exactly.
std::vector<Wide> basis_of(const CageElements& elements, const Touching& sample);

/// One row per sample: the hat functions of the vertices there.
Table<Wide> hat_functions(const CageElements& elements, const std::vector<Touching>& samples);

/// Rows that [T24] calls phi, psi, phibar and psibar, one row per sample.
using LayerRows = std::array<Table<Wide>, 4>;

/// All derivatives of one order, `derivatives[k]` the k-th component.
struct SampledLayerRows {
  std::vector<LayerRows> derivatives;
  SampledLayerRows(const CageCoordinates& layers, const std::vector<Touching>& samples, int order);
};

/// The outward unit normal of an element whose vertices are elsewhere, from its edges.
Vec3<Wide> unit_normal_of(const CageElements& elements, const std::vector<Vec3<double>>& vertices, std::size_t element);

}  // namespace cageproof::second_routes
