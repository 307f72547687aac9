// SPDX-License-Identifier: MIT
// The kernels of potentials on bilinear quads, and their derivatives, as sums of integrals along lines.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace cageproof::adaptive_qmvc {

/// The potentials whose kernels are odd powers of r ([T24] Eq 5, 9-18, 47-49; [C23] Eq 3, 4), with the measure du dv.
enum class Potential {
  SingleLayer,            ///< 1/r
  DoubleLayer,            ///< g/r^3
  BiharmonicSingleLayer,  ///< r/2
  BiharmonicDoubleLayer,  ///< -g/(2 r)
  KelvinDisplacement,     ///< (1 - beta) I/r + beta x x'/r^3
  KelvinTraction,         ///< (1 - 2 beta)(g I + N x' - x N')/r^3 + 6 beta g x x'/r^5
};

/// Factors of integrands, which are linear functions of a line's parameter. x = xi - eta, N = xi_u x xi_v, g = N.x;
/// M is N less the normal at the point that the lines are taken about. Vectors are numbered by their first component.
namespace line_factor {
inline constexpr int kX = 0, kN = 3, kHeight = 6, kAlongU = 7, kAlongV = 10, kTurn = 13, kTwist = 16, kStep = 19;
inline constexpr int kCount = 22;
}  // namespace line_factor

/// Which derivative of the bilinear basis functions an integrand has.
enum class BasisPart : std::uint8_t { Phi, PhiU, PhiV, PhiUV };

/// A polynomial in the line's parameter t: the product of an earlier polynomial and a factor.
struct LineFactor {
  int parent;      ///< -1: the polynomial is 1
  int factor;      ///< of line_factor
  int degree;      ///< in t
  bool is_linear;  ///< whether the factor depends on t
};

/// Integrals over lines, of a polynomial times a part of the basis functions over r^(2m + 1).
struct LineIntegrals {
  struct Integral {
    int polynomial;
    int m;
    BasisPart basis;
  };
  std::vector<LineFactor> polynomials;  ///< the first is 1
  std::vector<Integral> integrals;
  int top = -1;  ///< the largest m
};

/// A potential and its derivatives up to some order, as combinations of integrals over the quad's lines and around the
/// border.
struct KernelTape {
  /// A part of an entry of the tensors: a coefficient times the integral. Coefficients are a factor times one of two
  /// parameters, which depend on the elastic constants. Factors are counted in sixths: a third is no double.
  struct Part {
    int integral;
    int parameter;
    int sixths;
    bool around;   ///< of `around`, else of `across`
    bool divided;  ///< by the length of the normal at the lines' point
  };
  LineIntegrals across;  ///< of the lines u = 0 .. 1
  LineIntegrals around;  ///< of the border, counter-clockwise; `kStep` is dl
  /// For each order the entries of a corner's tensor, the index of derivatives the fastest, Hessians with all nine.
  std::array<std::vector<std::vector<Part>>, 3> entries;
  bool tangential = false;  ///< whether z is the direction of the normal at the lines' point
};

/// The tape of a potential up to an order of derivatives, 0 to 2: the kernel and its derivatives as they are. Next to
/// the quad, derivatives of these cancel by its size over the distance. Thread-safe; lives as long as the program.
const KernelTape& kernel_tape(Potential potential, int order);

/// The same with derivatives along the quad moved onto the basis functions and the border. Apart from logarithms, the
/// remaining integrands are bounded next to the quad, and nothing cancels. Coordinates have their z axis along the
/// normal at the point that lines are taken about. Equal to kernel_tape's where no order gains by it.
const KernelTape& tangential_tape(Potential potential, int order);

/// Entries of a corner's tensor: 1, or 9.
constexpr int entries_of(Potential potential) {
  return potential == Potential::KelvinDisplacement || potential == Potential::KelvinTraction ? 9 : 1;
}

/// Whether the kernel contains N, so that it changes sign with the orientation.
constexpr bool has_normal(Potential potential) {
  return potential == Potential::DoubleLayer || potential == Potential::BiharmonicDoubleLayer ||
         potential == Potential::KelvinTraction;
}

/// The power of length that the potential grows with.
constexpr int degree_of(Potential potential) {
  switch (potential) {
    case Potential::SingleLayer:
    case Potential::KelvinDisplacement: return -1;
    case Potential::BiharmonicSingleLayer: return 1;
    case Potential::BiharmonicDoubleLayer: return 2;
    default: return 0;
  }
}

}  // namespace cageproof::adaptive_qmvc
