// SPDX-License-Identifier: MIT
// A segment cut at its point nearest to eta into arms, along which the distance grows.
//
// With c that nearest point and e the direction of an arm, x = (c - eta) + tau e, 0 <= tau <= the arm's length, tau =
// distance sinh w. As (c - eta).e >= 0, r^2 = tau^2 + 2 tau (c - eta).e + distance^2 has no cancellation; its zeros are
// at sinh w = -cos a +- i sin a, a the angle between c - eta and the arm.
#pragma once

#include "../elementary.h"
#include "../panels.h"
#include "segment_frame.h"

namespace cageproof::quadrature_ref {

/// The part of the segment from c to one of its ends.
template <Scalar R>
struct Arm {
  Vec3<R> direction;       ///< unit, away from c
  R w_length;              ///< w at the end
  std::array<R, 2> slope;  ///< derivative of each hat function along it
};

template <Scalar R>
struct ArmFrame {
  Vec3<R> base;          ///< c - eta
  Vec3<R> normal;        ///< unit, outward
  R height;              ///< x . normal of every x on the segment
  R distance;            ///< |base|, > 0
  std::array<R, 2> hat;  ///< hat functions at c
  boost::container::static_vector<Arm<R>, 2> arms;
  Singularities singular;  ///< of the integrand as a function of w
  int exponent = 0;        ///< lengths are in units of 2^exponent
};

/// Where a point exactly on the segment sits.
struct OnSegment {
  bool yes = false;
  bool border = false;  ///< on an end
  Mp200 clearance = 0;  ///< distance to the nearest end that it is not
};

OnSegment on_segment(const SegmentFrame<Mp200>& s);

/// The frame of a point off the segment, or of one on it after moving it by `inward` > 0 along minus the normal.
ArmFrame<Mp200> arm_frame(const SegmentFrame<Mp200>& s, const Mp200& inward);

template <Scalar To>
ArmFrame<To> convert(const ArmFrame<Mp200>& from) {
  const auto number = [](const Mp200& x) { return static_cast<To>(x); };
  ArmFrame<To> to{cageproof::convert<To>(from.base),
                  cageproof::convert<To>(from.normal),
                  number(from.height),
                  number(from.distance),
                  {number(from.hat[0]), number(from.hat[1])},
                  {},
                  from.singular,
                  from.exponent};
  for (const Arm<Mp200>& arm : from.arms)
    to.arms.push_back(
        {cageproof::convert<To>(arm.direction), number(arm.w_length), {number(arm.slope[0]), number(arm.slope[1])}});
  return to;
}

}  // namespace cageproof::quadrature_ref
