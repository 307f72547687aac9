// SPDX-License-Identifier: MIT
#include "cageproof/closed_form/triangle/engine/counted.h"

#include <utility>

namespace cageproof::closed_form::triangle {
namespace {

thread_local bool follows_tracked = false;

Vec3<Counted> counted(const Vec3<double>& v) { return {v[0], v[1], v[2]}; }

constexpr const char* kFile = "closed_form/include/cageproof/closed_form/triangle/engine/exact_frame.h";

void see(Counted& x, const Mp200& exact, const char* name) { x = Counted::seen(x.value, exact, name, kFile); }
void see(Vec3<Counted>& v, const Vec3<Mp200>& exact, const char* name) {
  for (int i = 0; i < 3; ++i) see(v[i], exact[i], name);
}

}  // namespace

bool follow_tracked(bool tracked) { return std::exchange(follows_tracked, tracked); }

template <>
Counted atanh_excess<Counted>(const Counted& z) {
  return follows_tracked ? atanh_excess_by_function(z) : atanh_excess_by_series(z);
}

template <>
template <>
Frame<Counted>::Frame(const Frame<double>& other)
    : n(counted(other.n)), d(other.d), area2(other.area2), unit(other.unit), far_corner(other.far_corner) {
  for (int i = 0; i < 3; ++i) {
    const FrameEdge<double>& from = other.edges[i];
    p[i] = counted(other.p[i]);
    r[i] = other.r[i];
    edges[i] = {counted(from.u), counted(from.nu), from.length, from.h, from.s0, from.s1, from.r0, from.r1, from.D2};
  }
}

Frame<Counted> counted_frame(const Frame<double>& frame, const Triangle<double>& t, const Vec3<double>& eta) {
  const Mp200 unit(frame.unit);
  Triangle<Mp200> corners;
  for (int i = 0; i < 3; ++i) corners[i] = convert<Mp200>(t[i]) / unit;
  const Frame<Mp200> exact(corners, Vec3<Mp200>(convert<Mp200>(eta) / unit));
  Frame<Counted> f(frame);
  see(f.n, exact.n, "frame: n");
  see(f.d, exact.d, "frame: d");
  see(f.area2, exact.area2, "frame: area2");
  for (int i = 0; i < 3; ++i) {
    FrameEdge<Counted>& e = f.edges[i];
    const FrameEdge<Mp200>& from = exact.edges[i];
    see(f.p[i], exact.p[i], "frame: p");
    see(f.r[i], exact.r[i], "frame: r");
    see(e.u, from.u, "frame: edge.u");
    see(e.nu, from.nu, "frame: edge.nu");
    see(e.length, from.length, "frame: edge.length");
    see(e.h, from.h, "frame: edge.h");
    see(e.s0, from.s0, "frame: edge.s0");
    see(e.s1, from.s1, "frame: edge.s1");
    see(e.D2, from.D2, "frame: edge.D2");
  }
  // r is one number, which both edges use.
  for (int i = 0; i < 3; ++i) {
    f.edges[i].r0 = f.r[i];
    f.edges[i].r1 = f.r[(i + 1) % 3];
  }
  return f;
}

}  // namespace cageproof::closed_form::triangle
