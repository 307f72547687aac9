// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/field_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace cageproof {
namespace {

const std::vector<FieldWord>& all_field_words() {
  static const std::vector<FieldWord> words{
      {"affine-green", {"biharmonic_affine"}},
      {"apply", {"deform"}},
      {"arap", {}, "as-rigid-as-possible energies need a mesh of the inside; variational asks for rotations at points"},
      {"arb", {"certified"}},
      {"as-affine-as-possible", {"aaap"}},
      {"as-harmonic-as-possible", {"ahap"}},
      {"asap", {}, "as-similar-as-possible energies need a mesh of the inside; variational has rotations=similar"},
      {"barycentric", {"mean_value", "maximum_entropy", "harmonic"}},
      {"bbw", {}, "bounded biharmonic weights need a mesh of the inside; harmonic of the plane is never negative"},
      {"bem", {"harmonic", "elastic", "biharmonic_boundary", "triharmonic_boundary"}},
      {"benchmark", {"bench"}},
      {"bgc", {"biharmonic", "biharmonic_1_3"}},
      {"bhc", {"biharmonic", "biharmonic_1_3"}},
      {"biharmonic", {"biharmonic", "biharmonic_1_3", "biharmonic_double_layer", "biharmonic_single_layer"}},
      // Deformers and coordinates of one construction have names of their own.
      {"biharmonic-1-2", {"biharmonic_1_2", "regularised_1_2"}},
      {"biharmonic-1-3", {"biharmonic_1_3", "regularised_1_3"}},
      {"biharmonic-green", {"biharmonic", "biharmonic_1_3"}},
      {"biharmonic-weber", {"biharmonic_weber", "regularised_weber"}},
      {"boundary-element", {"harmonic", "elastic", "biharmonic_boundary", "triharmonic_boundary"}},
      {"bounded-biharmonic", {}, "these weights need a mesh of the inside; harmonic of the plane is never negative"},
      {"cages", {"list"}},
      {"catalog", {"list"}},
      {"catalogue", {"list"}},
      {"cauchy-green", {"cauchy"}},
      {"cgc", {"cauchy"}},
      {"check", {"verify"}},
      {"complex-barycentric", {"cauchy"}},
      {"compute", {"coordinates", "eval"}},
      {"coords", {"coordinates"}},
      {"corotational", {"somigliana"}},
      {"cubic-mean-value",
       {},
       "cubic mean value coordinates are not there; biharmonic_boundary meets derivatives, too"},
      {"cubic-mvc", {}, "cubic mean value coordinates are not there; biharmonic_boundary meets derivatives, too"},
      {"diff", {"compare"}},
      {"dipole", {"double_layer"}},
      {"docs", {"man"}},
      {"elasticity", {"elastic", "somigliana"}},
      {"elastostatic", {"elastic", "somigliana"}},
      {"evaluate", {"eval"}},
      {"exact", {"certified", "multiprecision"}},
      {"fuzz", {"hunt"}},
      {"gbc", {"mean_value", "maximum_entropy", "harmonic"}},
      {"gc", {"green"}},
      {"gordon-wixom", {}, "Gordon-Wixom coordinates are not there; mean_value is the nearest kind of the plane"},
      {"gravity", {"single_layer"}},
      {"green-quad", {"quad_green"}},
      {"greens", {"green"}},
      {"gwn", {"solid_angle", "winding_angle"}},
      {"harmonic", {"harmonic", "harmonic_goursat"}},
      {"hc", {"harmonic"}},
      {"interval", {"certified"}},
      {"joshi", {"harmonic"}},
      {"kelvin", {"kelvin_displacement", "kelvin_traction"}},
      {"kelvinlet", {"kelvin_displacement"}},
      {"kinds", {"list"}},
      {"lbc", {}, "local barycentric coordinates need a mesh of the inside; maximum_entropy is never negative"},
      {"lbs", {}, "linear blend skinning moves a mesh by bones, which cages do without; deform has methods for cages"},
      {"linear-blend-skinning",
       {},
       "skinning moves a mesh by bones, which cages do without; deform has methods for cages"},
      {"lipman", {"green"}},
      {"local-barycentric", {}, "these coordinates need a mesh of the inside; maximum_entropy is never negative"},
      {"lscm", {}, "least squares conformal maps flatten a surface; cauchy is the conformal kind of the plane"},
      {"manual", {"man"}},
      {"maxent", {"maximum_entropy"}},
      {"maximum-entropy", {"maximum_entropy"}},
      {"mean-value", {"mean_value"}},
      {"meanvalue", {"mean_value"}},
      {"mec", {"maximum_entropy"}},
      {"methods", {"list"}},
      {"mls", {}, "moving least squares coordinates are not there; mean_value is the nearest kind"},
      {"monopole", {"single_layer"}},
      {"mp", {"multiprecision"}},
      {"mpfr", {"multiprecision"}},
      {"mv", {"mean_value"}},
      {"mvc", {"mean_value"}},
      {"newton", {"single_layer"}},
      {"newtonian", {"single_layer"}},
      {"p2p",
       {},
       "point-to-point Cauchy coordinates are not there; variational and thickness take positions of points"},
      {"phi", {"double_layer"}},
      {"phibar", {"biharmonic_double_layer"}},
      {"pmvc", {"positive_mean_value"}},
      {"point-to-point",
       {},
       "these Cauchy coordinates are not there; variational and thickness take positions of points"},
      {"polyharmonic", {"polyharmonic_single_layer", "polyharmonic_double_layer", "triharmonic_boundary"}},
      {"pose", {"deform"}},
      {"positive-mean-value", {"positive_mean_value"}},
      {"psi", {"single_layer"}},
      {"psibar", {"biharmonic_single_layer"}},
      {"qgc", {"quad_green"}},
      {"qmvc", {"quad_mean_value"}},
      {"quad-mvc", {"quad_mean_value"}},
      {"regress", {"replay"}},
      {"regularised-1-2", {"biharmonic_1_2", "regularised_1_2"}},
      {"regularised-1-3", {"biharmonic_1_3", "regularised_1_3"}},
      {"regularised-weber", {"biharmonic_weber", "regularised_weber"}},
      {"sibson", {}, "Sibson's coordinates belong to scattered points; mean_value is the nearest kind of cages"},
      {"single-layer-potential", {"single_layer"}},
      {"skinning", {}, "skinning moves a mesh by bones, which cages do without; deform has methods for cages"},
      {"smvc", {"spherical_mean_value"}},
      {"spherical", {"spherical_mean_value"}},
      {"szego", {}, "Szego coordinates are not there; cauchy is the kind of the same paper that is"},
      {"thin-plate", {"tp"}},
      {"traction", {"kelvin_traction"}},
      {"vhm", {"variational"}},
      {"wachspress", {}, "Wachspress coordinates need convex cages, and are not there; mean_value takes any cage"},
      {"warp", {"deform"}},
      {"weights", {"coordinates"}},
      {"winding", {"solid_angle", "winding_angle"}},
      {"winding-number", {"solid_angle", "winding_angle"}},
  };
  return words;
}

std::string plain_word(std::string_view word) {
  std::string text(word.substr(word.rfind('.') + 1));
  for (char& c : text) c = c == '_' || c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// A formula's name stands behind its element, and its word has none.
bool is_named(std::string_view known, std::string_view here) {
  return known == here || known.substr(known.rfind('.') + 1) == here;
}

}  // namespace

std::span<const FieldWord> field_words() { return all_field_words(); }

const FieldWord* find_field_word(std::string_view word) {
  const std::string text = plain_word(word);
  constexpr std::array<std::string_view, 4> behind{"", "-coordinates", "-weights", "-coords"};
  for (const std::string_view end : behind) {
    if (!text.ends_with(end)) continue;
    const std::string_view stem = std::string_view(text).substr(0, text.size() - end.size());
    const auto found = std::ranges::find(field_words(), stem, &FieldWord::word);
    if (found != field_words().end()) return &*found;
  }
  return nullptr;
}

std::string called_here(std::string_view what, std::string_view word, const std::vector<std::string_view>& known) {
  const FieldWord* entry = find_field_word(word);
  if (entry == nullptr) return {};
  if (entry->here.empty()) return fmt::format("; {}", entry->missing);
  std::vector<std::string> names;
  for (const std::string_view one : known) {
    const std::string name = fmt::format("'{}'", one);
    const bool meant = std::ranges::any_of(entry->here, [&](std::string_view here) { return is_named(one, here); });
    // A kind and a method may have one name.
    if (meant && std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  if (!names.empty()) return fmt::format("; it is called {} here", fmt::join(names, " or "));
  return fmt::format("; here that is '{}', and no {}", fmt::join(entry->here, "' or '"), what);
}

}  // namespace cageproof
