// SPDX-License-Identifier: MIT
// Which faces are near to each point of a block, and which rules the others take, for one instruction set.
#pragma once

#include "cageproof/closed_form/batch/lanes.h"
#include "cageproof/closed_form/batch/tables.h"

#include "far_rules.h"

namespace cageproof::closed_form::batch::CAGEPROOF_SIMD {

/// Squares of distances below this, in cages of about one, leave single precision, with which roots begin.
inline constexpr double kLeastFarSquare = 1e-24;

/// How many rules are taken of a point before that is decided.
inline constexpr int kFirstRules = -1;

/// A small number for each point.
using Small = signed char __attribute__((vector_size(kLanes)));

inline unsigned long long bytes_of(Small m) {
  unsigned long long bytes = 0;
  __builtin_memcpy(&bytes, &m, sizeof m);
  return bytes;
}
inline Mask widened(Small m) { return __builtin_convertvector(m, Mask); }

/// The faces that are near, for each point of a block separately: a point's result does not depend on the others.
struct NearFaces {
  int* faces;                    ///< the faces that are near to a point
  int count;                     ///< the number of these
  Small* rule;                   ///< of faces: the first rule that is good enough; kFarRules where none is
  Small rules;                   ///< the number of rules in use: a face is near where its rule is not one of them
  Small* sign;                   ///< of edges: how often they are run through by near faces, less how often backwards
  Lanes faces_of;                ///< how many faces are near
  Mask between;                  ///< whether there are rules, not quick ones, for some of them
  unsigned char *vertex, *edge;  ///< whether they are a near face's

  Small is_near(int f) const { return rule[f] >= rules; }
};

inline long near_bytes(int vertices, int edges, int faces) {
  return static_cast<long>(sizeof(int)) * (faces + 1) + static_cast<long>(sizeof(Small)) * (faces + kLanes + edges) +
         vertices + edges;
}

/// The first rule that is good enough for each point, of each face.
inline void find_rules(const Block& block, Small* rule) {
  const CageTables& cage = *block.cage;
  Lanes least[kFarRules];
  const int order = block.order + static_cast<int>(block.layers == Layers::MeanValue);
  for (int r = 0; r < kFarRules; ++r) {
    const double ratio = cage.rules[r].least[order];
    least[r] = splat(ratio * ratio);
  }
  auto* const to = reinterpret_cast<signed char*>(rule);
  for (int f = 0; f < cage.faces; f += kLanes) {
    Lanes c[3], over;
    for (int i = 0; i < 3; ++i) __builtin_memcpy(&c[i], cage.centroid + i * cage.stride + f, sizeof c[i]);
    __builtin_memcpy(&over, cage.over_square + f, sizeof over);
    Lanes ratio[kLanes], farthest{};
    for (int p = 0; p < kLanes; ++p) {
      Lanes square{};
      for (int i = 0; i < 3; ++i) {
        const Lanes x = c[i] - block.points[i * kLanes + p];
        square += x * x;
      }
      ratio[p] = select(square > kLeastFarSquare, square * over, Lanes{});
      farthest = select(ratio[p] > farthest, ratio[p], farthest);
    }
    if (!any(farthest >= least[kFarRules - 1])) {
      __builtin_memset(to + f * kLanes, kFarRules, kLanes * kLanes);
      continue;
    }
    for (int p = 0; p < kLanes; ++p) {
      Mask missed{};  // rules that are not good enough, each counted as -1
      for (int r = 0; r < kFarRules; ++r) missed += ratio[p] < least[r];
      const Small found = __builtin_convertvector(-missed, Small);
      for (int i = 0; i < kLanes; ++i) to[(f + i) * kLanes + p] = found[i];
    }
  }
}

/// Points that are next to a face: no rule is good enough for it.
inline Small next_to_faces(const CageTables& cage, const Small* rule) {
  const Small none = Small{} + static_cast<signed char>(kFarRules);
  Small found{};
  for (int f = 0; f < cage.faces; ++f) found |= rule[f] == none;
  return found;
}

/// \param scratch near_bytes of it, aligned to 64 bytes \param rules how many are taken, for each point; kFirstRules
/// becomes `quick`, or `few` at points next to faces: these faces' coordinates are so large that little of the others'
/// digits is asked
inline NearFaces find_near_faces(const Block& block, void* scratch, Small& rules, int quick, int few) {
  const CageTables& cage = *block.cage;
  NearFaces near{};
  near.faces = static_cast<int*>(scratch);
  near.rule = reinterpret_cast<Small*>(near.faces + cage.faces + cage.faces % 2);
  near.sign = near.rule + cage.faces + kLanes;
  near.vertex = reinterpret_cast<unsigned char*>(near.sign + cage.edges);
  near.edge = near.vertex + cage.vertices;
  find_rules(block, near.rule);
  const Small first = rules == Small{} + static_cast<signed char>(kFirstRules);
  if (bytes_of(first) != 0) {
    const Small next = first & next_to_faces(cage, near.rule);
    rules = (rules & ~first) | (first & ~next & (Small{} + static_cast<signed char>(quick))) |
            (next & (Small{} + static_cast<signed char>(few)));
  }
  // Near faces are summed in twice the digits at points that are far from the cage.
  for (int i = 0; i < kLanes; ++i)
    if ((block.whole >> i & 1u) != 0) rules[i] = kFarRules;
  near.rules = rules;
  __builtin_memset(near.sign, 0, sizeof(Small) * cage.edges);
  __builtin_memset(near.vertex, 0, static_cast<unsigned long>(cage.vertices) + cage.edges);
  const Small none = Small{} + static_cast<signed char>(kFarRules);
  Mask count{}, between{};
  for (int f = 0; f < cage.faces; ++f) {
    const Small is = near.is_near(f);
    if (bytes_of(is) == 0) continue;
    count -= widened(is);
    between |= widened(is & (near.rule[f] < none));
    near.faces[near.count++] = f;
    const FaceTable<double>& face = cage.face[f];
    for (int i = 0; i < 3; ++i) {
      near.vertex[face.vertex[i]] = 1;
      near.edge[face.edge[i]] = 1;
      // Truth is -1.
      near.sign[face.edge[i]] += face.along[i] > 0 ? Small(-is) : is;
    }
  }
  near.faces_of = __builtin_convertvector(count, Lanes);
  near.between = between & widened(rules < none);
  return near;
}

}  // namespace cageproof::closed_form::batch::CAGEPROOF_SIMD
