// SPDX-License-Identifier: MIT
// Single and double layers of one quad at a point next to it.
#pragma once

#include "../kernels.h"
#include "../plans.h"

#include "quad/engine/local_frame.h"
#include "cageproof/core/numbers/linear.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof::adaptive_qmvc::batch {

/// Integrals over a quad with the measure du dv, one per corner.
struct QuadLayers {
  /// Of Phi_k N.x/r^3, Phi_k/r, Phi_k N.x/r and Phi_k r; the last two only where they are wanted.
  std::array<std::array<double, 4>, 4> of{};
};

/// Memory for one pair after the other. The quad is cut in strips that get shorter towards the point, and each takes as
/// many lines as the distances from its outermost ones ask for, a vector of lines at a time.
class NearQuadLayers {
 public:
  NearQuadLayers(const Kernels& kernels, bool biharmonic)
      : kernels_(kernels), plans_(Plans::of_layers()), biharmonic_(biharmonic) {}

  /// How near a point is: so that these lines have the digits for it, nearer, or so near that it may be on the quad.
  enum class Reach { Lines, Nearer, Touching };

  /// Adds to `layers` where it is Reach::Lines, and nothing otherwise. \param corners four
  Reach add(std::span<const Vec3<double>> corners, const Vec3<double>& point, QuadLayers& layers);

 private:
  struct Strip;
  bool cut(const LocalFrame<double>& local, double longest, double distance, const Strip& strip, int depth);
  void add_lines(const Strip& strip, int lines);

  const Kernels& kernels_;
  const Plans& plans_;
  bool biharmonic_;
  std::vector<double> step_, weight_;
};

}  // namespace cageproof::adaptive_qmvc::batch
