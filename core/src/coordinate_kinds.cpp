// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates.h"

#include <algorithm>
#include <cmath>

namespace cageproof {
namespace {

// c of [T24], below Eq 49: the traction of the identity map is c n. It grows without bound towards nu = 1/2.
double identity_traction(std::span<const double> p) {
  const double mu = p[0], nu = p[1];
  return std::isinf(nu) ? -mu : 2 * mu * (1 + 3 * nu / (1 - 2 * nu));
}

// Sums of catalogue formulas; other rooms add kinds that compute differently.
std::vector<CoordinateKind> summed_kinds() {
  using Reproduces = CoordinateBlock::Reproduces;
  const CoordinateBlock phi{"phi", "triangle.double_layer", Reproduces::Vertices};
  const CoordinateBlock psi{"psi", "triangle.single_layer", Reproduces::Normals};
  return {
      {"mean_value", "[T18] Eq 9-14", {{"lambda", "triangle.mean_value", Reproduces::Vertices}}, true},
      {"quad_mean_value",
       "[T18] Eq 9-11, Algorithm 2",
       {{"lambda", "triangle.mean_value", Reproduces::Vertices, nullptr, "quad.mean_value"}},
       true},
      {"green", "[T24] Eq 7", {phi, psi}, false},
      {"biharmonic",
       "[T24] Eq 1, 3",
       {phi,
        psi,
        {"phibar", "triangle.biharmonic_double_layer", Reproduces::Nothing},
        {"psibar", "triangle.biharmonic_single_layer", Reproduces::Nothing}},
       false},
      {"somigliana",
       "[T24] Eq 47-49, [C23] Eq 8",
       {{"T", "triangle.kelvin_traction", Reproduces::Vertices},
        {"K", "triangle.kelvin_displacement", Reproduces::Normals, identity_traction}},
       false},
  };
}

struct Kinds {
  std::vector<CoordinateKind> all = summed_kinds();
  const std::size_t summed = all.size();
};

Kinds& kinds() {
  static Kinds instance;
  return instance;
}

}  // namespace

std::span<const CoordinateKind> coordinate_kinds() { return kinds().all; }

RegisterCoordinateKind::RegisterCoordinateKind(CoordinateKind kind) {
  // By name, so that reports do not hang on the order of linking.
  auto& all = kinds().all;
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(kinds().summed);
  all.insert(std::ranges::lower_bound(first, all.end(), kind.name, {}, &CoordinateKind::name), std::move(kind));
}

bool accepts(const CoordinateKind& kind, const Cage& cage) {
  return !kind.keeps_quads() || cage.allows_invalid_quads() || invalid_quads(cage).empty();
}

const std::vector<Parameter>& parameters_of(const CoordinateKind& kind) {
  return find_formula(kind.blocks.front().formula)->parameters;
}

const CoordinateKind* find_coordinate_kind(std::string_view name) {
  for (const CoordinateKind& kind : coordinate_kinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

}  // namespace cageproof
