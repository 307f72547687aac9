// SPDX-License-Identifier: MIT
// The errata of the papers: what is printed, what is right, and which evaluations show it.
#pragma once

#include "cageproof/closed_form/published/misprint.h"

#include <vector>

namespace cageproof::closed_form::published {

/// A formula and derivative order that a misprint changes.
struct Affected {
  std::string_view formula;
  int order;
};

/// One misprint. Where nothing is affected no formula of the catalogue shows it, and `as_printed` is None.
struct Erratum {
  std::string_view source;  ///< paper key and equation
  std::string_view printed;
  std::string_view correct;
  Misprint as_printed = Misprint::None;
  std::string_view regime = {};  ///< where it shows
  std::vector<Affected> affected = {};
};

/// All known errata, in the order of the papers' text.
inline const std::vector<Erratum>& errata() {
  using enum Misprint;
  static const std::vector<Erratum> all{
      {"[T24] display above Eq 2", "(G_{k+1}) = lambda_{k+1} Laplacian(r^(2k-1)) = ... = G_k",
       "Laplacian G_{k+1} = ... = G_k"},
      {"[T24] Eq 18, line 8",
       "sum a_e/6 (zeta_0 U^r_0 - zeta_1 U^r_1), which line 9 has too",
       "sum a_e/6 (u_e.r) (U_0 - U_1) on line 8",
       Equation18,
       "generic",
       {{"triangle.biharmonic_double_layer", 2}, {"triangle.affine_single_layer", 2}, {"triangle.kelvin_traction", 0}}},
      {"[T24] Section 4.1.2",
       "gamma_D = 0 gives the Green coordinates, as only harmonic functions interpolate their Laplacian",
       "constant Laplacians, and linear ones by (V; N), are interpolated too: at 0 Green coordinates are a choice"},
      {"[T24] list before Eq 35", "Phi_C := Laplacian Phi_C, the same for Psi_C",
       "Phi_C = Laplacian Phibar_C, Psi_C = Laplacian Psibar_C"},
      {"[T24] Eq 42", "sum over i in T", "sum over t in T"},
      {"[T24] Eq 48 and [C23] Eq 3",
       "b = a/4(1 - nu), read from left to right",
       "b = a/(4 (1 - nu))",
       Equation48,
       "generic",
       {{"triangle.kelvin_displacement", 0}, {"triangle.kelvin_traction", 0}}},
      {"[T24] Eq 49, T",
       "no factor mu, though Eq 48 has one",
       "all three terms times mu",
       Equation49,
       "generic",
       {{"triangle.kelvin_traction", 0}}},
      {"[T24] Appendix A",
       "omega_t has the sign of d_t, and the angle omegabar is positive",
       "omega_t has the sign of -d_t, and omegabar is minus a solid angle",
       AppendixA,
       "generic",
       {{"triangle.solid_angle", 0},
        {"triangle.biharmonic_single_layer", 0},
        {"triangle.biharmonic_single_layer", 1},
        {"triangle.biharmonic_single_layer", 2},
        {"triangle.kelvin_displacement", 0}}},
      {"[T24] Eq 51 and 52", "lower limits -beta - gamma and -tan(gamma - beta)", "gamma - beta and tan(gamma - beta)"},
      {"[T24] Appendix A, F_3, line 3", "(a + sqrt(d^2 S^2 + a^2 (1 + S^2/C^2)))^2", "(a |C| + sqrt(d^2 S^2 + a^2))^2"},
      {"[T24] Appendix A, F_3, line 5", "log((q - a C)/(q - a |C|))",
       "log((q - a C)/(q + a C)), q = sqrt(d^2 S^2 + a^2)"},
      {"[T24] Appendix A, F_3, line 7", "(1 S_i - delta_i S_i C_i)^2", "(l_i S_i - delta_i S_i C_i)^2"},
      {"[T24] Appendix A, sum of F_1", "-d^3/3 beta - F_1 - F_1", "-d^3/3 beta - (F_1 + F_1)/3"},
      {"[T24] Appendix C, C_e",
       "log((l_0 + l_0 + |e|)/(l_0 + l_0 - |e|))",
       "log((l_0 + l_1 + |e|)/(l_0 + l_1 - |e|))",
       AppendixC,
       "on-face",
       {{"triangle.single_layer", 0}}},
      {"[T24] Appendix C, psibar inside",
       "sum a^3/6 (log - l_1 zeta_1 + l_0 zeta_0)",
       "-lambda_2 sum a/6 (a^2 log - l_1 zeta_1 + l_0 zeta_0)",
       AppendixC,
       "on-face",
       {{"triangle.biharmonic_single_layer", 0}}},
      {"[T24] Appendix C, n.grad phi inside",
       "det(n x sum e C_e; e^i; n)/(2|t|), the curl form, right only for closed cages' sums",
       "that + Gamma_i n.grad omega/(4 pi)",
       AppendixC,
       "on-face",
       {{"triangle.double_layer", 1}}},
      {"[T24] Appendix C, n.grad phibar inside",
       "D_e^2 log",
       "3 D_e^2 log",
       AppendixC,
       "on-face",
       {{"triangle.biharmonic_double_layer", 1}}},
      {"[T24] Appendix C, C_e at a vertex",
       "l_0 + l_0, as inside",
       "l_0 + l_1",
       AppendixC,
       "on-vertex",
       {{"triangle.single_layer", 0}}},
      {"[T24] Appendix C, phi at a vertex",
       "omega_t delta",
       "omega_t/(4 pi) delta",
       AppendixC,
       "on-vertex",
       {{"triangle.double_layer", 0}}},
      {"[T24] Appendix C, psibar at a vertex",
       "a/6 (log - l_1 zeta_1 + l_0 zeta_0)",
       "-lambda_2 a/6 (a^2 log - l_1 zeta_1 + l_0 zeta_0)",
       AppendixC,
       "on-vertex",
       {{"triangle.biharmonic_single_layer", 0}}},
      {"[T24] Appendix D.1", "right-hand vector (V'; D')", "(V'; N')"},
      {"[T24] Eq 64", "(I - Phi_V) V'", "(M_V - Phi_V) V'"},
      {"[W12] Section 4.1, G^H and G^BH", "-ln r/(2 pi) and -r^2 (ln r - 1)/(8 pi)",
       "both without the minus sign, or Eq 12 to 14 give -f for outward normals"},
      {"[W12] Section 5.2, C_j", "alpha_j + i (beta_{j-1}/l_{j-1}) - beta_j/l_j",
       "alpha_j - i (beta_{j-1}/l_{j-1} - beta_j/l_j) with Appendix A's outward normals"},
      {"[W12] Eq 20 in discrete form", "|l|^2", "an approximation: lengths and the mass matrix of l are left out"},
      {"[W12] Appendix A, hat-phi^BH",
       "the bracket over 16 pi c closes after the first line",
       "all four terms are over 16 pi c",
       AppendixA,
       "generic",
       {{"segment.biharmonic_double_layer", 0}}},
      {"[W12] Appendix B, Green's identity", "sum over i <= s of int Laplacian^(i-1) G_i d(Laplacian^(s-i) u)/dn - ...",
       "Laplacian^(s-1) u = sum over i <= r - s + 1 of int Laplacian^(s+i-2) u dG_i/dn - G_i d(Laplacian^(s+i-2) "
       "u)/dn"},
      {"[W12] Appendix B, G_i", "r^(i-1)", "r^(2(i-1))"},
      {"[W12] Appendix B, b_i", "a_(i-1)/(4 (i-1)^2) (a_(i-1)/(i-1) + b_(i-1))",
       "(a_(i-1)/(i-1) + b_(i-1))/(4 (i-1)^2)"},
      {"[C23] Eq 1", "mu Laplacian u + mu/(1 - 2 nu) grad div u = b", "= -b, as Eq 3 and 5 have it"},
  };
  return all;
}

}  // namespace cageproof::closed_form::published
