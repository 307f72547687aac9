// SPDX-License-Identifier: MIT
#include "polygon_frame.h"

#include "cageproof/core/geometry/box.h"
#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/linear.h"
#include "cageproof/core/geometry/orientation.h"
#include "dirichlet_solver.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace cageproof::solved::goursat {
namespace {

// The faces in the order that the polygon of the first runs through them.
std::vector<int> first_polygon(const Cage& cage) {
  std::vector<int> face_from(cage.vertices().size());
  for (int f = 0; f < static_cast<int>(cage.faces().size()); ++f) face_from[cage.faces()[f].vertices[0]] = f;
  std::vector<int> faces;
  int face = 0;
  do {
    faces.push_back(face);
    face = face_from[cage.faces()[face].vertices[1]];
  } while (face != 0);
  return faces;
}

double cross(const Complex<double>& a, const Complex<double>& b) { return (conj(a) * b).im; }
double dot(const Complex<double>& a, const Complex<double>& b) { return (conj(a) * b).re; }

}  // namespace

std::string why_not_solved(const Cage& cage) {
  if (cage.dimension() != 2) return "it is no polygon";
  const std::size_t first = first_polygon(cage).size();
  if (first == cage.faces().size() && first > most_edges)
    return fmt::format("it has {} edges, more than {}, each of whose corners needs functions of its own", first,
                       most_edges);
  if (first == cage.faces().size()) return {};
  return fmt::format(
      "it has holes or several parts ({} of {} segments form the first polygon), around which functions of the Goursat "
      "basis would need several values",
      first, cage.faces().size());
}

PolygonFrame::PolygonFrame(const Cage& cage) {
  if (const std::string reason = why_not_solved(cage); !reason.empty())
    throw InputError(fmt::format("{}: {}", cage.name(), reason));
  faces_ = first_polygon(cage);
  const auto& vertices = cage.vertices();
  const auto [low, high] = box_of(vertices);
  centre_ = low / 2 + high / 2;
  largest_ = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  std::frexp(cage.size(), &exponent_);
  --exponent_;
  for (int k = 0; k < static_cast<int>(faces_.size()); ++k) {
    const auto& ends = cage.faces()[faces_[k]].vertices;
    const Vec3<double> at = vertices[ends[0]] - centre_;
    corners_.push_back({{std::ldexp(at[0], -exponent_), std::ldexp(at[1], -exponent_)}, 0, 0, ends[0]});
    segments_.push_back({vertices[ends[0]], vertices[ends[1]]});
    const auto& lowest = corners_[extreme_].position;
    const auto& here = corners_.back().position;
    if (std::pair(here.im, here.re) < std::pair(lowest.im, lowest.re)) extreme_ = k;
  }
  for (int k = 0; k < size(); ++k) {
    const Complex<double> out = edge(k), back = -edge(k == 0 ? size() - 1 : k - 1);
    double angle = std::atan2(cross(out, back), dot(out, back));
    if (angle <= 0) angle += 2 * std::numbers::pi;
    corners_[k].angle = angle;
    corners_[k].bisector = std::atan2(out.im, out.re) + angle / 2;
  }
  // On its own edge a corner sees the angle -angle/2 from its bisector; sums along the polygon differ from that by
  // whole turns.
  shifts_.assign(size(), 0.0);
  std::vector<double> shifts;
  for (int k = 0; k < size(); ++k) {
    const double wanted = -corners_[k].angle / 2, summed = see_on_edge(k, 0.5, 0.5).angles[k];
    shifts.push_back(2 * std::numbers::pi * std::round((wanted - summed) / (2 * std::numbers::pi)));
  }
  shifts_ = std::move(shifts);
}

double PolygonFrame::length(int k) const {
  const Complex<double> e = edge(k);
  return std::hypot(e.re, e.im);
}

bool PolygonFrame::is_on(int k, const Vec3<double>& point) const {
  const Segment<double>& s = segments_[k];
  const auto between = [&](int c) {
    return std::min(s[0][c], s[1][c]) <= point[c] && point[c] <= std::max(s[0][c], s[1][c]);
  };
  return side_of_line(s, point) == 0 && between(0) && between(1);
}

// log(z - v_k) cut along the polygon, from v_k to a corner of the convex hull, and from there to infinity outside: the
// sum of log((z - v_j)/(z - v_(j-1))), each of which is cut along one edge.
template <class R>
void PolygonFrame::set_angles(SeenPoint<R>& seen, const Vec3<double>* point, int on_edge) const {
  using std::abs, std::atan2, std::cos, std::sin;
  const int n = size();
  seen.angles.resize(n);
  const Corner& first = corners_[extreme_];
  const Complex<R> turn{R(cos(R(first.bisector))), R(-sin(R(first.bisector)))};
  const Complex<R> from_first = seen.offsets[extreme_] * turn;
  R absolute = atan2(from_first.im, from_first.re) + R(first.bisector);
  for (int i = 0; i < n; ++i) {
    const int k = (extreme_ + i) % n, before = k == 0 ? n - 1 : k - 1;
    if (i > 0 && before == on_edge) {
      absolute += R(std::numbers::pi);
    } else if (i > 0) {
      const Complex<R> between = conj(seen.offsets[before]) * seen.offsets[k];
      R sine = between.im;
      // Next to the edge rounding must not decide on which side of it the point lies.
      if (point != nullptr && between.re < R(0))
        sine = side_of_line(segments_[before], *point) <= 0 ? R(abs(sine)) : R(-abs(sine));
      absolute += R(atan2(sine, between.re));
    }
    seen.angles[k] = absolute - R(corners_[k].bisector) + R(shifts_[k]);
  }
}

template <class R>
SeenPoint<R> PolygonFrame::see(const Vec3<R>& point) const {
  using std::ldexp;
  SeenPoint<R> seen;
  const auto own = [&](const Vec3<double>& from) {
    return Complex<R>{R(ldexp(R(point[0] - R(from[0])), -exponent_)), R(ldexp(R(point[1] - R(from[1])), -exponent_))};
  };
  seen.position = own(centre_);
  for (const Segment<double>& s : segments_) seen.offsets.push_back(own(s[0]));
  const Vec3<double> rounded = convert<double>(point);
  set_angles(seen, &rounded, -1);
  return seen;
}

template <class R>
SeenPoint<R> PolygonFrame::see_on_edge(int k, const R& from_start, const R& from_end) const {
  SeenPoint<R> seen;
  const Complex<R> along = converted<R>(edge(k));
  const Complex<R> start = from_start * along, end = R(-from_end) * along;
  const bool near_start = from_start < from_end;
  seen.position =
      near_start ? converted<R>(corners_[k].position) + start : converted<R>(corners_[next(k)].position) + end;
  for (const Corner& corner : corners_) seen.offsets.push_back(seen.position - converted<R>(corner.position));
  // Without the rounding of positions.
  seen.offsets[k] = start;
  seen.offsets[next(k)] = end;
  set_angles<R>(seen, nullptr, k);
  return seen;
}

#define CAGEPROOF_INSTANTIATE(R)                                    \
  template SeenPoint<R> PolygonFrame::see<R>(const Vec3<R>&) const; \
  template SeenPoint<R> PolygonFrame::see_on_edge<R>(int, const R&, const R&) const;
CAGEPROOF_INSTANTIATE(double)
CAGEPROOF_INSTANTIATE(Mp50)
CAGEPROOF_INSTANTIATE(Mp100)
#undef CAGEPROOF_INSTANTIATE

}  // namespace cageproof::solved::goursat
