// SPDX-License-Identifier: MIT
// Which faces are near for all points of a block, and which rules the others take, for one instruction set.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"
#include "cageproof/closed_form/batch/tables.h"

#include "far_rules.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Squares of distances below this, in cages of about one, leave single precision, with which roots begin.
inline constexpr double kLeastFarSquare = 1e-24;

/// What a block sees of a cage.
struct NearFaces {
  int* faces;                    ///< those that are near
  int count;                     ///< how many they are
  int between;                   ///< how many of them there are rules for that are not quick
  int rules;                     ///< rules that are taken: kQuickRules, or kFarRules
  int* sign;                     ///< of edges: how often they are run through by near faces, less how often backwards
  unsigned char* rule;           ///< of faces: the first that is good enough; kFarRules where none is
  unsigned char *vertex, *edge;  ///< whether they are a near face's

  bool is_near(int f) const { return rule[f] >= rules; }
};

inline long near_bytes(int vertices, int edges, int faces) {
  return static_cast<long>(sizeof(int)) * (faces + edges) + faces + kLanes + vertices + edges;
}

/// The first rule that is good enough for the nearest of the points, for each face.
inline void find_rules(const Block& block, unsigned char* rule) {
  const CageTables& cage = *block.cage;
  Lanes least[kFarRules];
  for (int r = 0; r < kFarRules; ++r) {
    const double ratio = cage.rules[r].least[block.order];
    least[r] = splat(ratio * ratio);
  }
  for (int f = 0; f < cage.faces; f += kLanes) {
    Lanes c[3], over, nearest = splat(__builtin_inf());
    for (int i = 0; i < 3; ++i) __builtin_memcpy(&c[i], cage.centroid + i * cage.stride + f, sizeof c[i]);
    __builtin_memcpy(&over, cage.over_square + f, sizeof over);
    for (int p = 0; p < kLanes; ++p) {
      Lanes square{};
      for (int i = 0; i < 3; ++i) {
        const Lanes x = c[i] - block.points[i * kLanes + p];
        square += x * x;
      }
      nearest = select(square < nearest, square, nearest);
    }
    const Lanes ratio = nearest * over;
    Mask missed{};  // rules that are not good enough, each counted as -1
    for (int r = 0; r < kFarRules; ++r) missed += ratio < least[r];
    missed = (nearest > kLeastFarSquare) ? missed : Mask{} - kFarRules;
    for (int i = 0; i < kLanes && f + i < cage.faces; ++i) rule[f + i] = static_cast<unsigned char>(-missed[i]);
  }
}

/// \param scratch near_bytes of it, aligned to eight bytes \param rules how many are taken
inline NearFaces find_near_faces(const Block& block, void* scratch, int rules) {
  const CageTables& cage = *block.cage;
  NearFaces near{};
  near.rules = rules;
  near.faces = static_cast<int*>(scratch);
  near.sign = near.faces + cage.faces;
  near.rule = reinterpret_cast<unsigned char*>(near.sign + cage.edges);
  near.vertex = near.rule + cage.faces + kLanes;
  near.edge = near.vertex + cage.vertices;
  find_rules(block, near.rule);
  __builtin_memset(near.sign, 0, sizeof(int) * cage.edges);
  __builtin_memset(near.vertex, 0, static_cast<unsigned long>(cage.vertices) + cage.edges);
  for (int f = 0; f < cage.faces; ++f) {
    if (!near.is_near(f)) continue;
    if (near.rules != kFarRules && near.rule[f] != kFarRules) ++near.between;
    near.faces[near.count++] = f;
    const FaceTable<double>& face = cage.face[f];
    for (int i = 0; i < 3; ++i) {
      near.vertex[face.vertex[i]] = 1;
      near.edge[face.edge[i]] = 1;
      near.sign[face.edge[i]] += static_cast<int>(face.along[i]);
    }
  }
  return near;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
