// SPDX-License-Identifier: MIT
#include "cageproof/core/catalogue/formula.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace cageproof {
namespace {

constexpr Laplacian kHarmonic{Laplacian::Kind::Zero};
constexpr Laplacian kUnknown{};

// Elasticity: mu > 0, -1 < nu < 1/2; nu = 1/2 is the incompressible limit, nu = +-infinity that of [C23] Figure 7.
std::vector<Parameter> elastic() {
  return {
      {.name = "mu", .preset = 1, .lowest = 0, .highest = std::numeric_limits<double>::infinity()},
      {.name = "nu", .preset = 0.3, .lowest = -1, .highest = 0.5, .includes_highest = true, .includes_infinity = true}};
}

// -(a - b) of [C23] Eq 3 stands before the logarithm.
Behaviour displacement_behaviour(std::span<const double> p) {
  return {1, {.factor = -(1 - 1 / (4 * (1 - p[1]))) / (2 * std::numbers::pi * p[0])}};
}

// The order of polyharmonic layers.
std::vector<Parameter> order() { return {{.name = "order", .preset = 3, .lowest = 0, .highest = 7, .whole = true}}; }

// a_s of [W12] Appendix B: 1/(4^(s - 1) ((s - 1)!)^2).
double leading_factor(double order) { return std::pow(4, 1 - order) / std::pow(std::tgamma(order), 2); }

Behaviour polyharmonic_single_behaviour(std::span<const double> p) {
  const int s = static_cast<int>(p[0]);
  return {2 * s - 1, {.factor = -leading_factor(s) / (2 * std::numbers::pi), .squares = s - 1}};
}

Behaviour polyharmonic_double_behaviour(std::span<const double> p) {
  const int s = static_cast<int>(p[0]);
  if (s == 1) return {.degree = 0, .face_jump = {.number = 1}};
  return {2 * s - 2, {.factor = (s - 1) * leading_factor(s) / std::numbers::pi, .squares = s - 2, .height = true}};
}

constexpr Laplacian laplacian_is(std::string_view formula) { return {Laplacian::Kind::Formula, formula}; }

// x = xi - eta, r = |x|, n the outward normal, Gamma_k the hat function of corner k, G1 = -1/(4 pi r), G2 = -r/(8 pi).
std::list<Formula> own_rows() {
  return {
      Formula{.name = "triangle.single_layer",
              .symbol = "psi_t",
              .source = "[T24] Eq 5; edge form",
              .definition = "int_t 1/(4 pi r)",
              .element = ElementKind::Triangle,
              .shape = {},
              .degree = 1,
              .flip_sign = 1,
              .laplacian = kHarmonic,
              .face_jump = {},
              .parameters = {}},
      Formula{.name = "triangle.double_layer",
              .symbol = "phi_t^k",
              .source = "[T24] Eq 5; edge form",
              .definition = "int_t Gamma_k x.n/(4 pi r^3)",
              .element = ElementKind::Triangle,
              .shape = {.per_corner = true},
              .degree = 0,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kHarmonic,
              .face_jump = {.number = 1},
              .parameters = {},
              .side_relation = {"triangle.single_layer", 1, 4, -1}},
      Formula{.name = "triangle.solid_angle",
              .symbol = "omega_t",
              .source = "[T24] Appendix A, sign after the errata; edge form",
              .definition = "int_t x.n/r^3",
              .element = ElementKind::Triangle,
              .shape = {},
              .degree = 0,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kHarmonic,
              .face_jump = {.pi_multiple = 4},
              .parameters = {}},
      Formula{.name = "triangle.biharmonic_single_layer",
              .symbol = "psibar_t",
              .source = "[T24] Eq 9-14; edge form",
              .definition = "int_t r/(8 pi)",
              .element = ElementKind::Triangle,
              .shape = {},
              .degree = 3,
              .flip_sign = 1,
              .laplacian = laplacian_is("triangle.single_layer"),
              .face_jump = {},
              .parameters = {}},
      Formula{.name = "triangle.biharmonic_double_layer",
              .symbol = "phibar_t^k",
              .source = "[T24] Eq 15-18; edge form",
              .definition = "int_t -Gamma_k x.n/(8 pi r)",
              .element = ElementKind::Triangle,
              .shape = {.per_corner = true},
              .degree = 2,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .gradient_cancels_above = true,
              .laplacian = laplacian_is("triangle.double_layer"),
              .face_jump = {},
              .parameters = {},
              .side_relation = {"triangle.biharmonic_single_layer", 3, 8, 1}},
      Formula{.name = "triangle.affine_single_layer",
              .symbol = "psi_t^k",
              .source = "[T24] Eq 43-46; edge form",
              .definition = "int_t Gamma_k/(4 pi r)",
              .element = ElementKind::Triangle,
              .shape = {.per_corner = true},
              .degree = 1,
              .flip_sign = 1,
              .laplacian = kHarmonic,
              .face_jump = {},
              .parameters = {}},
      Formula{.name = "triangle.kelvin_displacement",
              .symbol = "K_t",
              .source = "[T24] Eq 47-49; [C23] Eq 3, 8; edge form",
              .definition = "int_t (a-b)/r I + b x x'/r^3, a = 1/(4 pi mu), b = a/(4(1-nu))",
              .element = ElementKind::Triangle,
              .shape = {.rows = 3, .columns = 3},
              .degree = 1,
              .flip_sign = 1,
              .laplacian = kUnknown,
              .face_jump = {},
              .parameters = elastic()},
      Formula{.name = "triangle.kelvin_traction",
              .symbol = "T_t^k",
              .source = "[T24] Eq 47-49, factor mu after the errata; [C23] Eq 4, 8; edge form",
              .definition = "int_t Gamma_k mu ((a-2b)(x.n I + n x' - x n')/r^3 + 6b x.n x x'/r^5)",
              .element = ElementKind::Triangle,
              .shape = {.per_corner = true, .rows = 3, .columns = 3},
              .degree = 0,
              .flip_sign = -1,
              .laplacian = kUnknown,
              .face_jump = {.number = 1},
              .parameters = elastic()},
      Formula{.name = "triangle.mean_value",
              .symbol = "w_t^k",
              .source = "[T18] Eq 11-14",
              .definition = "int_t Gamma_k x.n/r^4",
              .element = ElementKind::Triangle,
              .shape = {.per_corner = true},
              .degree = -1,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kUnknown,
              .face_jump = {.diverges = true},
              .parameters = {}},
      Formula{.name = "quad.mean_value",
              .symbol = "w_q^k",
              .source = "[T18] Eq 11, 15-17; line form",
              .definition = "int_q Phi_k x.n/r^4, Phi_k bilinear: int Phi_k(u,v) N(u,v).x/r^4 du dv, N = xi_u x xi_v",
              .element = ElementKind::Quad,
              .shape = {.per_corner = true},
              .degree = -1,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kUnknown,
              .face_jump = {.diverges = true},
              .parameters = {}},
      Formula{
          .name = "quad.single_layer",
          .symbol = "psi_q^k",
          .source = "[T24] Eq 5 on bilinear faces; line form",
          .definition = "int_q Phi_k(u,v)/(4 pi r) du dv: no area element, since N du dv is what Green's identity has",
          .element = ElementKind::Quad,
          .shape = {.per_corner = true},
          .degree = -1,
          .flip_sign = 1,
          .laplacian = kHarmonic,
          .face_jump = {},
          .parameters = {},
          .by_parameters = true},
      Formula{.name = "quad.double_layer",
              .symbol = "phi_q^k",
              .source = "[T24] Eq 5 on bilinear faces; line form",
              .definition = "int_q Phi_k(u,v) N(u,v).x/(4 pi r^3) du dv, N = xi_u x xi_v",
              .element = ElementKind::Quad,
              .shape = {.per_corner = true},
              .degree = 0,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kHarmonic,
              .face_jump = {.number = 1},
              .parameters = {},
              .side_relation = {"quad.single_layer", 1, 4, -1}},
      Formula{.name = "quad.solid_angle",
              .symbol = "omega_q",
              .source = "[T24] Appendix A on bilinear faces; two triangles",
              .definition = "int_q N(u,v).x/r^3 du dv, N = xi_u x xi_v",
              .element = ElementKind::Quad,
              .shape = {},
              .degree = 0,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kHarmonic,
              .face_jump = {.pi_multiple = 4},
              .parameters = {}},
      Formula{.name = "quad.biharmonic_single_layer",
              .symbol = "psibar_q^k",
              .source = "[T24] Eq 9-14 on bilinear faces; line form",
              .definition = "int_q Phi_k(u,v) r/(8 pi) du dv",
              .element = ElementKind::Quad,
              .shape = {.per_corner = true},
              .degree = 1,
              .flip_sign = 1,
              .laplacian = laplacian_is("quad.single_layer"),
              .face_jump = {},
              .parameters = {},
              .by_parameters = true},
      Formula{.name = "quad.biharmonic_double_layer",
              .symbol = "phibar_q^k",
              .source = "[T24] Eq 15-18 on bilinear faces; line form",
              .definition = "int_q -Phi_k(u,v) N(u,v).x/(8 pi r) du dv, N = xi_u x xi_v",
              .element = ElementKind::Quad,
              .shape = {.per_corner = true},
              .degree = 2,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = laplacian_is("quad.double_layer"),
              .face_jump = {},
              .parameters = {},
              .side_relation = {"quad.biharmonic_single_layer", 3, 8, 1}},
      Formula{.name = "quad.kelvin_displacement",
              .symbol = "K_q^k",
              .source = "[T24] Eq 47-49; [C23] Eq 3, 8 on bilinear faces; line form",
              .definition = "int_q Phi_k(u,v) ((a-b)/r I + b x x'/r^3) du dv, a = 1/(4 pi mu), b = a/(4(1-nu))",
              .element = ElementKind::Quad,
              .shape = {.per_corner = true, .rows = 3, .columns = 3},
              .degree = -1,
              .flip_sign = 1,
              .laplacian = kUnknown,
              .face_jump = {},
              .parameters = elastic(),
              .by_parameters = true},
      Formula{.name = "quad.kelvin_traction",
              .symbol = "T_q^k",
              .source = "[T24] Eq 47-49, factor mu after the errata; [C23] Eq 4, 8 on bilinear faces; line form",
              .definition = "int_q Phi_k(u,v) mu ((a-2b)(x.N I + N x' - x N')/r^3 + 6b x.N x x'/r^5) du dv, "
                            "N = xi_u x xi_v",
              .element = ElementKind::Quad,
              .shape = {.per_corner = true, .rows = 3, .columns = 3},
              .degree = 0,
              .flip_sign = -1,
              .laplacian = kUnknown,
              .face_jump = {.number = 1},
              .parameters = elastic()},
      Formula{.name = "segment.single_layer",
              .symbol = "psi_s",
              .source = "[W12] Section 3, sign of G1 after the errata",
              .definition = "int_s -ln r/(2 pi)",
              .element = ElementKind::Segment,
              .shape = {},
              .degree = 1,
              .flip_sign = 1,
              .laplacian = kHarmonic,
              .face_jump = {},
              .parameters = {},
              .logarithmic = {.factor = -1 / (2 * std::numbers::pi)}},
      Formula{.name = "segment.double_layer",
              .symbol = "phi_s^k",
              .source = "[W12] Section 4.2, Appendix A after the errata",
              .definition = "int_s Gamma_k x.n/(2 pi r^2)",
              .element = ElementKind::Segment,
              .shape = {.per_corner = true},
              .degree = 0,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kHarmonic,
              .face_jump = {.number = 1},
              .parameters = {}},
      Formula{.name = "segment.affine_single_layer",
              .symbol = "psi_s^k",
              .source = "[T24] Eq 43 with the plane's G1, [W12] Section 3 after the errata",
              .definition = "int_s -Gamma_k ln r/(2 pi)",
              .element = ElementKind::Segment,
              .shape = {.per_corner = true},
              .degree = 1,
              .flip_sign = 1,
              .laplacian = kHarmonic,
              .face_jump = {},
              .parameters = {},
              .logarithmic = {.factor = -1 / (2 * std::numbers::pi)}},
      Formula{.name = "segment.biharmonic_single_layer",
              .symbol = "psibar_s",
              .source = "[W12] Section 4.1, Appendix A, sign of G2 after the errata",
              .definition = "int_s -r^2 (ln r - 1)/(8 pi)",
              .element = ElementKind::Segment,
              .shape = {},
              .degree = 3,
              .flip_sign = 1,
              .laplacian = laplacian_is("segment.single_layer"),
              .face_jump = {},
              .parameters = {},
              .logarithmic = {.factor = -1 / (8 * std::numbers::pi), .squares = 1}},
      Formula{.name = "segment.biharmonic_double_layer",
              .symbol = "phibar_s^k",
              .source = "[W12] Section 4.1, Appendix A after the errata",
              .definition = "int_s Gamma_k x.n (2 ln r - 1)/(8 pi)",
              .element = ElementKind::Segment,
              .shape = {.per_corner = true},
              .degree = 2,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = laplacian_is("segment.double_layer"),
              .face_jump = {},
              .parameters = {},
              .logarithmic = {.factor = 1 / (4 * std::numbers::pi), .height = true}},
      Formula{.name = "segment.kelvin_displacement",
              .symbol = "K_s",
              .source = "[C23] Eq 3, 8 in the plane",
              .definition = "int_s -(a-b) ln r I + b x x'/r^2, a = 1/(2 pi mu), b = a/(4(1-nu))",
              .element = ElementKind::Segment,
              .shape = {.rows = 2, .columns = 2},
              .degree = 1,
              .flip_sign = 1,
              .laplacian = kUnknown,
              .face_jump = {},
              .parameters = elastic(),
              .behaviour_of = displacement_behaviour},
      Formula{.name = "segment.kelvin_traction",
              .symbol = "T_s^k",
              .source = "[C23] Eq 4, 8 in the plane",
              .definition = "int_s Gamma_k mu ((a-2b)(x.n I + n x' - x n')/r^2 + 4b x.n x x'/r^4)",
              .element = ElementKind::Segment,
              .shape = {.per_corner = true, .rows = 2, .columns = 2},
              .degree = 0,
              .flip_sign = -1,
              .laplacian = kUnknown,
              .face_jump = {.number = 1},
              .parameters = elastic()},
      Formula{.name = "segment.polyharmonic_single_layer",
              .symbol = "psi_s,i",
              .source = "[W12] Appendix B, exponent and b_i after the errata",
              .definition = "int_s -G_i, G_i = r^(2(i-1)) (a_i ln r - b_i)/(2 pi), i = order",
              .element = ElementKind::Segment,
              .shape = {},
              .degree = 5,
              .flip_sign = 1,
              .laplacian = {Laplacian::Kind::LowerOrder},
              .face_jump = {},
              .parameters = order(),
              .behaviour_of = polyharmonic_single_behaviour},
      Formula{.name = "segment.polyharmonic_double_layer",
              .symbol = "phi_s,i^k",
              .source = "[W12] Appendix B, exponent and b_i after the errata",
              .definition = "int_s Gamma_k dG_i/dn, G_i = r^(2(i-1)) (a_i ln r - b_i)/(2 pi), i = order",
              .element = ElementKind::Segment,
              .shape = {.per_corner = true},
              .degree = 4,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = {Laplacian::Kind::LowerOrder},
              .face_jump = {},
              .parameters = order(),
              .behaviour_of = polyharmonic_double_behaviour},
      Formula{.name = "segment.mean_value",
              .symbol = "w_s^k",
              .source = "[T18] Eq 11 in the plane",
              .definition = "int_s Gamma_k x.n/r^3",
              .element = ElementKind::Segment,
              .shape = {.per_corner = true},
              .degree = -1,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kUnknown,
              .face_jump = {.diverges = true},
              .parameters = {}},
      Formula{.name = "segment.winding_angle",
              .symbol = "omega_s",
              .source = "[T24] Appendix A in the plane",
              .definition = "int_s x.n/r^2",
              .element = ElementKind::Segment,
              .shape = {},
              .degree = 0,
              .flip_sign = -1,
              .vanishes_in_plane = true,
              .laplacian = kHarmonic,
              .face_jump = {.pi_multiple = 2},
              .parameters = {}},
  };
}

struct Rows {
  std::list<Formula> all = own_rows();
  const std::size_t own = all.size();
};

// Made when first asked for, so that rows may be added from any file before main.
Rows& rows() {
  static Rows instance;
  return instance;
}

}  // namespace

const std::list<Formula>& catalogue() { return rows().all; }

const Formula* find_formula(std::string_view name) {
  for (const Formula& formula : catalogue())
    if (formula.name == name) return &formula;
  return nullptr;
}

const Formula* find_formula(ElementKind element, std::string_view kernel) {
  for (const Formula& formula : catalogue())
    if (formula.element == element && formula.kernel() == kernel) return &formula;
  return nullptr;
}

std::size_t rank_of(std::string_view formula) {
  const auto& all = catalogue();
  return static_cast<std::size_t>(std::distance(all.begin(), std::ranges::find(all, formula, &Formula::name)));
}

RegisterFormula::RegisterFormula(Formula formula) {
  auto& all = rows().all;
  const std::string name(formula.name);
  if (find_formula(formula.name)) throw std::logic_error("two formulas are called " + name);
  if (!formula.name.starts_with(std::string(name_of(formula.element)) + "."))
    throw std::logic_error("a formula's name begins with its element's, which " + name + " does not");
  const auto first = std::next(all.begin(), static_cast<std::ptrdiff_t>(rows().own));
  all.insert(std::find_if(first, all.end(), [&](const Formula& f) { return f.name > formula.name; }),
             std::move(formula));
}

}  // namespace cageproof
