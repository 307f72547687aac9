// SPDX-License-Identifier: MIT
#include "cageproof/core/coordinates/coordinates.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/catalogue/named_parameters.h"
#include "cageproof/core/numbers/scalar_text.h"
#include "cageproof/core/catalogue/unknown_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cageproof {
namespace {

// c of [C23], below Eq 7, and [T24], below Eq 49: the traction of the identity map is c n. It grows without bound
// towards nu = 1/2, and is zero in the plane for an infinite nu.
double identity_traction(std::span<const double> p, int dimension) {
  const double mu = p[0], nu = p[1];
  return 2 * mu * (1 + (std::isinf(nu) ? -dimension / 2. : dimension * nu / (1 - 2 * nu)));
}

SummedBlock of_normals(SummedBlock block) {
  block.one_a_normal = true;
  return block;
}

// Sums of catalogue formulas; other rooms add kinds that compute differently.
std::list<CoordinateKind> summed_kinds() {
  const SummedBlock phi{"phi", "double_layer", Reproduces::Vertices}, psi{"psi", "single_layer", Reproduces::Normals};
  return {
      {.name = "mean_value",
       .source = "[T18] Eq 9-14",
       .blocks = {{"lambda", "mean_value", Reproduces::Vertices}},
       .normalised = true},
      {.name = "quad_mean_value",
       .source = "[T18] Eq 9-11, Algorithm 2",
       .blocks = {{"lambda", "mean_value", Reproduces::Vertices}},
       .normalised = true,
       .keeps_quads = true},
      {.name = "green", .source = "[T24] Eq 7", .blocks = {phi, psi}, .extends = true},
      {.name = "biharmonic",
       .source = "[T24] Eq 1, 3",
       .blocks = {phi,
                  psi,
                  {"phibar", "biharmonic_double_layer", Reproduces::Nothing},
                  {"psibar", "biharmonic_single_layer", Reproduces::Nothing}}},
      {.name = "biharmonic_affine",
       .source = "[T24] Eq 1, 42-43",
       .blocks =
           {phi,
            {.label = "psi", .kernel = "affine_single_layer", .reproduces = Reproduces::Normals, .one_a_corner = true},
            {"phibar", "biharmonic_double_layer", Reproduces::Nothing},
            {"psibar", "biharmonic_single_layer", Reproduces::Nothing}}},
      {.name = "somigliana",
       .source = "[T24] Eq 47-49, [C23] Eq 8",
       .blocks = {{"T", "kelvin_traction", Reproduces::Vertices},
                  {"K", "kelvin_displacement", Reproduces::Normals, identity_traction}}},
      {.name = "quad_green",
       .source = "[T24] Eq 7 on bilinear faces",
       .blocks = {phi, of_normals(psi)},
       .keeps_quads = true},
      {.name = "quad_biharmonic",
       .source = "[T24] Eq 1, 3 on bilinear faces",
       .blocks = {phi,
                  of_normals(psi),
                  {"phibar", "biharmonic_double_layer", Reproduces::Nothing},
                  of_normals({"psibar", "biharmonic_single_layer", Reproduces::Nothing})},
       .keeps_quads = true},
      {.name = "quad_somigliana",
       .source = "[T24] Eq 47-49, [C23] Eq 8 on bilinear faces",
       .blocks = {{"T", "kelvin_traction", Reproduces::Vertices},
                  of_normals({"K", "kelvin_displacement", Reproduces::Normals, identity_traction})},
       .keeps_quads = true},
  };
}

struct Kinds {
  std::list<CoordinateKind> all = summed_kinds();
  const std::size_t own = all.size();
};

// Made when first asked for, so that kinds may be added from any file before main.
Kinds& kinds() {
  static Kinds instance;
  return instance;
}

// The kinds of elements that a kind of coordinates meets in a cage.
std::vector<ElementKind> elements_in(const CoordinateKind& kind, const Cage& cage) {
  std::vector<ElementKind> found;
  for (const Face& element : cage.parts(kind.keeps_quads, Triangulation::Fan).elements)
    if (std::ranges::find(found, element.kind()) == found.end()) found.push_back(element.kind());
  std::ranges::sort(found);
  return found;
}

}  // namespace

const std::list<CoordinateKind>& coordinate_kinds() { return kinds().all; }

RegisterCoordinateKind::RegisterCoordinateKind(CoordinateKind kind) {
  // By name, so that reports do not hang on the order of linking.
  auto& all = kinds().all;
  const auto first = std::next(all.begin(), static_cast<std::ptrdiff_t>(kinds().own));
  all.insert(std::find_if(first, all.end(), [&](const CoordinateKind& k) { return k.name > kind.name; }),
             std::move(kind));
}

bool exists_on(const CoordinateKind& kind, const Cage& cage) {
  if (!kind.is_sum()) return kind.own_dimension == 0 || kind.own_dimension == cage.dimension();
  for (const ElementKind element : elements_in(kind, cage))
    for (const SummedBlock& block : kind.blocks)
      if (!find_formula(element, block.kernel)) return false;
  return true;
}

bool accepts(const CoordinateKind& kind, const Cage& cage) {
  return exists_on(kind, cage) && why_refused(kind, cage).empty();
}

std::string why_refused(const CoordinateKind& kind, const Cage& cage) {
  if (kind.refuses != nullptr)
    if (std::string reason = kind.refuses(cage); !reason.empty()) return reason;
  if (!kind.keeps_quads || cage.allows_invalid_quads()) return {};
  const std::vector<std::string> faults = invalid_quads(cage);
  return faults.empty() ? "" : faults.front() + " (faces counted from 0, corners within the face)";
}

std::vector<const Formula*> formulas_of(const CoordinateKind& kind, const Cage& cage) {
  std::vector<const Formula*> found;
  for (const ElementKind element : elements_in(kind, cage))
    for (const SummedBlock& block : kind.blocks)
      if (const Formula* formula = find_formula(element, block.kernel)) found.push_back(formula);
  return found;
}

std::vector<KindParameter> parameters_of(const CoordinateKind& kind) {
  if (!kind.is_sum()) return kind.parameters;
  for (const SummedBlock& block : kind.blocks)
    for (const ElementKind element : element_kinds)
      if (const Formula* formula = find_formula(element, block.kernel)) return parameters_of(*formula);
  return {};
}

std::optional<double> KindParameter::value_of(std::string_view text) const {
  if (!names.empty()) {
    const auto named = std::ranges::find(names, text);
    if (named == names.end()) return std::nullopt;
    return static_cast<double>(named - names.begin());
  }
  return parse_scalar<double>(text);
}

const CoordinateKind* find_coordinate_kind(std::string_view name) {
  for (const CoordinateKind& kind : coordinate_kinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

const CoordinateKind& coordinate_kind_named(std::string_view name) {
  const CoordinateKind* found = find_coordinate_kind(name);
  if (found == nullptr) {
    std::vector<std::string_view> known;
    for (const CoordinateKind& kind : coordinate_kinds()) known.push_back(kind.name);
    throw unknown_single_name("kind of coordinates", name, known);
  }
  return *found;
}

const CoordinateKind& keeping_quads(const CoordinateKind& kind) {
  if (kind.keeps_quads) return kind;
  if (const CoordinateKind* found = find_coordinate_kind(fmt::format("quad_{}", kind.name))) return *found;
  std::vector<std::string_view> known;
  for (const CoordinateKind& k : coordinate_kinds())
    if (k.keeps_quads && k.name.starts_with("quad_")) known.push_back(k.name.substr(5));
  throw InputError(
      fmt::format("{}: the kind has no formulas on bilinear quads; {} have", kind.name, fmt::join(known, ", ")));
}

}  // namespace cageproof
