// SPDX-License-Identifier: MIT
// A library for `cageproof judge`: the angle that a segment of the plane is seen under. Replace the formula by yours.
//
//   c++ -O2 -std=c++17 -shared -fPIC -I. mine.cpp -o libmine.so
//   cageproof judge mine=./libmine.so
#include "cageproof_judge.h"

#include <cmath>
#include <cstddef>
#include <string_view>

namespace {

struct Vector {
  double x, y;
};

Vector vector_at(const double* numbers) { return {numbers[0], numbers[1]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
double cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
double length(const Vector& a) { return std::hypot(a.x, a.y); }

// atan2(a x b, a . b) of the ends as the point sees them (K. Hormann and A. Agathos, "The point in polygon problem for
// arbitrary polygons", Comput. Geom. 20 (2001), Section 2). a x b is the nearer end times the segment itself, which
// loses nothing far away or near an end. There is no threshold. At an end it is a right angle, half of what the inside
// sees on the segment.
double winding_angle(const Vector& first, const Vector& second, const Vector& point) {
  const Vector a = first - point, b = second - point;
  if (length(a) == 0 || length(b) == 0) return std::acos(0.0);
  return std::atan2(cross(length(a) < length(b) ? a : b, second - first), dot(a, b));
}

}  // namespace

extern "C" {

int cageproof_judge_version() { return CAGEPROOF_JUDGE_VERSION; }

const char* cageproof_judge_about() { return "winding angle by the arctangent, 1.0"; }

// The highest derivative that is given: 0 is the value, -1 says that the formula is not there.
int cageproof_judge_order(const char* formula) { return std::string_view(formula) == "segment.winding_angle" ? 0 : -1; }

int cageproof_judge_double(const cageproof_judge_block* block, const double* corners, const double* /*parameters*/,
                           const double* points, double* values, double* /*gradients*/, double* /*hessians*/) {
  for (std::size_t p = 0; p < block->count; ++p)
    values[p] = winding_angle(vector_at(corners), vector_at(corners + 2), vector_at(points + 2 * p));
  return CAGEPROOF_JUDGE_DONE;
}

}  // extern "C"
