// SPDX-License-Identifier: MIT
// Roundings that faces leave in weights of mean value coordinates and their derivatives, and how much of them
// derivatives of coordinates allow, for a vector of points at a time.
#pragma once

#include "base_face.h"
#include "cancelling.h"
#include "fast.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Errors of a face's weights and their derivatives, by order, in roundings.
template <int O>
struct Roundings {
  Lanes of[O + 1];
};

/// Larger than all roundings, with its square.
inline constexpr double kBeyond = 1e150;

/// Roundings summed over faces, with what they are held to and limits beyond which faces are left to others, by order.
template <int O>
struct HeldRoundings {
  Lanes squares[O + 1] = {}, most[O + 1] = {}, limit[O + 1];

  HeldRoundings() {
    for (Lanes& one : limit) one = splat(kBeyond);
  }
  void add(const Roundings<O>& roundings, Mask but) {
    for (int o = 0; o <= O; ++o) squares[o] += select(but, Lanes{}, roundings.of[o] * roundings.of[o]);
  }
  Mask exceeded(const Roundings<O>& roundings) const {
    Mask found{};
    for (int o = 0; o <= O; ++o) found |= roundings.of[o] > limit[o];
    return found;
  }
  /// Where too much is left.
  Mask many() const {
    Mask found{};
    for (int o = 0; o <= O; ++o) found |= squares[o] > most[o] * most[o];
    return found;
  }
  void lower(Mask points, Lanes faces) {
    const Lanes over = 1 / root(faces);
    for (int o = 0; o <= O; ++o) {
      const Mask mine = points & (squares[o] > most[o] * most[o]);
      // Totals as for values (Steepness::lower): an even share leaves too much in cages with a small face.
      limit[o] = select(mine, most[o] * (o == 0 ? splat(1 / 16.) : over), limit[o]);
    }
  }
};

/// The root of the sum of squares may be this much of the weights' total and, by order, of all weights' derivatives.
inline constexpr double kSteepOrders[3] = {8, 32, 64};
/// At points seen from a face, the root of the sum of squares may be this much of the error that coordinates allow.
inline constexpr double kSteeperMost = 16;
/// Faces count as steeper when they are this much steeper than the face that a point is seen from. Others leave no more
/// than that face's hat functions allow.
inline constexpr double kSteeper = 4;

/// Sums the roundings of faces.
template <int O>
class SteepDerivatives {
 public:
  /// Before faces are summed, again. \param total the weights of those that take rules \param from the faces that
  /// points are seen from
  void start(const CageTables& cage, Lanes total, Lanes from) {
    for (Lanes& squares : all_.squares) squares = Lanes{};
    for (Lanes& squares : steeper_.squares) squares = Lanes{};
    total_ = total;
    for (int i = 0; i < kLanes; ++i) steep_[i] = from[i] < 0 ? kBeyond : cage.face[static_cast<int>(from[i])].steep;
  }
  /// Counts a face. \param but points that it is not added for in double \param total its weights'
  void count(double steep, Mask but, const Roundings<O>& roundings, Lanes total) {
    all_.add(roundings, but);
    const Mask steeper = is_steeper(steep);
    if (any(steeper)) steeper_.add(roundings, but | ~steeper);
    total_ += total;
  }
  Mask exceeded(double steep, const Roundings<O>& roundings) const {
    return all_.exceeded(roundings) | (is_steeper(steep) & steeper_.exceeded(roundings));
  }
  /// Once faces are summed: finds what roundings are held to. Seen from a face at the height d, with hat functions as
  /// steep as s, coordinates are these and d times what other faces' weights w leave. Of that gradients have w itself,
  /// and Hessians w's gradient; all of them are over d W, where the hat functions' own derivatives are s and, about,
  /// its square.
  void hold(const Block& block) {
    const BaseFace& base = *static_cast<const BaseFace*>(block.measured);
    const Lanes whole = magnitude(total_), low = magnitude(base.height.value) * whole;
    all_.most[0] = kSteepOrders[0] * whole;
    constexpr int kept[3] = {1, 3, 6};
    for (int o = 1; o <= O; ++o) all_.most[o] = kSteepOrders[o] * (norm_of(block, o, 0, kept[o]) + base.beside[o - 1]);
    // Points are not seen from faces that are left to others.
    const auto held = [&](int o, Lanes most) {
      steeper_.most[o] = select(base.seen, kSteeperMost * most, splat(kBeyond));
    };
    Lanes power = steep_;
    for (int o = 0; o < O; ++o, power *= steep_) held(o, low * power);
    held(O, O == 1 ? whole * steep_ : whole * steep_ * steep_);
  }
  /// Where too much is left.
  Mask many() const { return all_.many() | steeper_.many(); }
  /// Sets limits for points, so that it no longer is when faces are summed again. \param faces how many are near
  void lower(Mask points, Lanes faces) {
    if (!any(points)) return;
    all_.lower(points, faces);
    steeper_.lower(points, faces);
  }

 private:
  Mask is_steeper(double steep) const { return splat(steep) > kSteeper * steep_; }

  HeldRoundings<O> all_, steeper_;
  Lanes total_{}, steep_{};  // the latter beyond all others where points are seen from no face
};

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
