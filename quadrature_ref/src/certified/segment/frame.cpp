// SPDX-License-Identifier: MIT
#include "frame.h"

#include "../exact_input.h"

namespace cageproof::quadrature_ref::certified {
namespace {

using Vector2 = std::array<Real, 2>;

Real dot(const Vector2& a, const Vector2& b) { return a[0] * b[0] + a[1] * b[1]; }

// The exact numbers of a frame: sums and products of the coordinates, without rounding.
struct ExactSegment {
  Vector2 edge;                // end 1 minus end 0
  Real length_squared, cross;  // cross: x . (edge turned to the right), the same for both ends
  Vector2 along, squares;      // x . edge and x . x of the ends
  Real difference;             // squares[1] - squares[0]
  Real cosine;                 // the ends' scalar product
};

template <Scalar R>
std::optional<ExactSegment> exact_segment(const Query<R>& query) {
  const auto input = exact_input<2>(query);
  if (!input) return std::nullopt;
  const WorkingBits exact = WorkingBits::exact();
  std::array<Vector2, 2> ends;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i) ends[k][i] = (*input)[k][i] - (*input)[2][i];
  ExactSegment e;
  for (int i = 0; i < 2; ++i) e.edge[i] = (*input)[1][i] - (*input)[0][i];
  e.length_squared = dot(e.edge, e.edge);
  if (e.length_squared.is_zero()) return std::nullopt;
  e.cross = ends[0][0] * e.edge[1] - ends[0][1] * e.edge[0];
  for (int k = 0; k < 2; ++k) {
    e.along[k] = dot(ends[k], e.edge);
    e.squares[k] = dot(ends[k], ends[k]);
  }
  e.difference = e.squares[1] - e.squares[0];
  e.cosine = dot(ends[0], ends[1]);
  return e;
}

int sign_of(const Real& exact) { return arb_is_positive(exact.raw()) ? 1 : arb_is_negative(exact.raw()) ? -1 : 0; }

}  // namespace

template <Scalar R>
std::optional<SegmentFrame> segment_frame_of(const Query<R>& query) {
  const auto exact = exact_segment(query);
  if (!exact) return std::nullopt;
  const ExactSegment& e = *exact;
  SegmentFrame f;
  f.length = sqrt(e.length_squared);
  f.axes[0] = {e.edge[0] / f.length, e.edge[1] / f.length};
  f.axes[1] = {f.axes[0][1], -f.axes[0][0]};
  f.height = e.cross / f.length;
  f.on_line = e.cross.is_zero();
  f.squares = e.squares;
  for (int k = 0; k < 2; ++k) {
    f.s[k] = e.along[k] / f.length;
    f.at_end[k] = e.squares[k].is_zero();
    f.logarithms[k] = log(e.squares[k]) / 2;
  }
  f.log_ratio = log1p(e.difference / e.squares[0]) / 2;
  arb_atan2(f.angle.raw(), e.cross.raw(), e.cosine.raw(), working_bits);
  if (f.on_line) {
    arb_indeterminate(f.angle.raw());
    f.side = sign_of(e.along[0]) == sign_of(e.along[1]) ? sign_of(e.along[0]) : 0;
    f.on_segment = f.side == 0;
  }
  return f;
}

template std::optional<SegmentFrame> segment_frame_of<float>(const Query<float>&);
template std::optional<SegmentFrame> segment_frame_of<double>(const Query<double>&);
template std::optional<SegmentFrame> segment_frame_of<Mp50>(const Query<Mp50>&);
template std::optional<SegmentFrame> segment_frame_of<Mp100>(const Query<Mp100>&);
template std::optional<SegmentFrame> segment_frame_of<Mp200>(const Query<Mp200>&);

}  // namespace cageproof::quadrature_ref::certified
