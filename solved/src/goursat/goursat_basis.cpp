// SPDX-License-Identifier: MIT
#include "goursat_basis.h"

namespace cageproof::solved::goursat {

GoursatBasis::GoursatBasis(std::shared_ptr<const PolygonFrame> frame, Equation equation, int degree, int terms,
                           std::span<const std::complex<double>> points)
    : frame_(std::move(frame)), equation_(equation), polynomials_(points, degree) {
  size_ = (degree + 1) * (equation == Equation::Biharmonic ? 4 : 2);
  for (int k = 0; k < frame_->size(); ++k) {
    corners_.emplace_back(equation, frame_->corner(k).angle, terms);
    size_ += corners_.back().size();
  }
}

template <class R>
void GoursatBasis::rows_at(const SeenPoint<R>& point, int order, R* rows) const {
  using std::cos, std::sin;
  RowWriter<R> writer(rows, size_, order);
  const Complex<R> conjugate = conj(point.position);
  for (const auto& [q, dq, ddq] : polynomials_.at(point.position)) {
    writer.put_both(holomorphic(q, dq, ddq));
    if (equation_ == Equation::Biharmonic) writer.put_both(times_conjugate(conjugate, q, dq, ddq));
  }
  for (int k = 0; k < frame_->size(); ++k) {
    const R bisector(frame_->corner(k).bisector);
    const Complex<R> turn{R(cos(bisector)), R(-sin(bisector))};
    corners_[k].put<R>(point.offsets[k] * turn, point.angles[k], turn, writer);
  }
}

#define CAGEPROOF_INSTANTIATE(R) template void GoursatBasis::rows_at<R>(const SeenPoint<R>&, int, R*) const;
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::solved::goursat
