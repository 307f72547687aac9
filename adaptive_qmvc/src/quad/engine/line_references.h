// SPDX-License-Identifier: MIT
// The points of a bilinear quad that its lines are taken about.
#pragma once

#include "quad/engine/local_frame.h"
#include "quad/engine/quad_frame.h"
#include "quad/engine/singular_pairs.h"
#include "cageproof/core/numbers/scalar.h"

#include <boost/container/static_vector.hpp>

namespace cageproof::adaptive_qmvc {

/// A point that lines are taken about.
template <class R>
struct LineReference {
  LocalFrame<R> q;
  LineArea<R> area;
  R ahead;                                    ///< the base's line less this one's: steps from here are that much longer
  R past;                                     ///< this one's place on a line less the base's
  double distance2, across2, along2, twist2;  ///< squares of lengths: of a, b, e and w

  LineReference(const LocalFrame<R>& frame, const R& ahead_of, const R& past_base)
      : q(frame),
        area(frame.a, frame.e, frame.w, frame.n, frame.n_v),
        ahead(ahead_of),
        past(past_base),
        distance2(static_cast<double>(R(frame.a.dot(frame.a)))),
        across2(static_cast<double>(R(frame.b.dot(frame.b)))),
        along2(static_cast<double>(R(frame.e.dot(frame.e)))),
        twist2(static_cast<double>(R(frame.w.dot(frame.w)))) {}

  /// The square of the roundings of points of a line next to this one, in units of a rounding: of its own point, and of
  /// its direction.
  /// \param length2 the square of the line's length
  double roundings2(double s, double length2) const {
    const double step = s + static_cast<double>(ahead), square = step * step;
    return (distance2 + square * across2) * (1 + (along2 + square * twist2) / length2);
  }

  /// The same of the side across the lines where they end, or start.
  double side_roundings2(bool far, double length2) const {
    const auto step = static_cast<double>(far ? q.last : q.first);
    const double square = step * step;
    return (distance2 + square * along2) * (1 + (across2 + square * twist2) / length2);
  }
};

/// A rule's point, next to which its lines are dense; and, of a quad with sides of unequal lengths, the corners. There
/// lines may end next to eta that are a thousand times as long as they are away from it, so that their ends, seen from
/// another place, are known to a rounding of the length.
template <class R>
class LineReferences {
 public:
  /// \param base the frame about the rule's point
  explicit LineReferences(const LocalFrame<R>& base) { references_.emplace_back(base, R(0), R(0)); }

  LineReferences(const LocalFrame<R>& base, const QuadFrame<R>& q) : LineReferences(base) {
    // The digits of multiprecision scalars are more than asked for.
    if constexpr (!is_multiprecision<R>) {
      if (!is_uneven(q)) return;
      first_ = q.e;
      last_ = q.e1;
      near2_ = static_cast<double>(R(q.b.dot(q.b)));
      far2_ = static_cast<double>(R(q.b1.dot(q.b1)));
      for (int k = 0; k < 4; ++k) {
        const bool far = k == 1 || k == 2, first = k < 2;
        references_.emplace_back(LocalFrame<R>(q, far ? R(1) : R(0), first ? R(0) : R(1), q.seen[k]),
                                 first ? base.v0 : R(-base.above), far ? base.last : base.first);
      }
    }
  }

  const LocalFrame<R>& base() const { return references_.front().q; }

  /// The best for the line at a step from the base's.
  const LineReference<R>& at(const R& s) const {
    if (references_.size() == 1) return references_.front();
    const auto step = static_cast<double>(s);
    const R v = base().v0 + s;
    const Vec3<R> e = (1 - v) * first_ + v * last_;
    const auto length2 = static_cast<double>(R(e.dot(e)));
    return least([&](const LineReference<R>& reference) { return reference.roundings2(step, length2); });
  }

  /// The best for the side across the lines where they end, or start.
  const LineReference<R>& beside(bool far) const {
    if (references_.size() == 1) return references_.front();
    return least(
        [&](const LineReference<R>& reference) { return reference.side_roundings2(far, far ? far2_ : near2_); });
  }

 private:
  template <class Roundings>
  const LineReference<R>& least(const Roundings& roundings) const {
    const LineReference<R>* best = nullptr;
    double fewest = 0;
    for (const LineReference<R>& reference : references_)
      if (const double now = roundings(reference); !best || now < fewest) {
        best = &reference;
        fewest = now;
      }
    return *best;
  }

  boost::container::static_vector<LineReference<R>, 5> references_;
  Vec3<R> first_, last_;         ///< the directions of the outermost lines
  double near2_ = 0, far2_ = 0;  ///< squares of lengths: of the sides across the lines where they start and end
};

}  // namespace cageproof::adaptive_qmvc
