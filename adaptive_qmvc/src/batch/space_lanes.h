// SPDX-License-Identifier: MIT
// Vectors of space for a vector of points, and how they are read from a chunk.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"

#include "tables.h"

namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD {

namespace lanes = closed_form::batch::CAGEPROOF_SIMD;
using lanes::kLanes;
using lanes::Lanes;
using lanes::Mask;
using lanes::root;
using lanes::select;
using lanes::splat;

/// A vector of space for each point.
struct Three {
  Lanes x, y, z;
};

inline Lanes dot(const Three& a, const Three& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Lanes dot(const double* a, const Three& b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }

inline Lanes load(const double* from) {
  Lanes x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}
inline Lanes gather(const double* from, const int (&at)[kLanes]) {
  Lanes x;
  for (int i = 0; i < kLanes; ++i) x[i] = from[at[i]];
  return x;
}

/// `origin` seen from points of a chunk that follow each other.
inline Three points_from(const Chunk& chunk, int first, const double* origin) {
  const double* const at = chunk.at + first;
  return {origin[0] - load(at), origin[1] - load(at + chunk.stride), origin[2] - load(at + 2 * chunk.stride)};
}

}  // namespace cageproof::adaptive_qmvc::batch::CAGEPROOF_SIMD
