// SPDX-License-Identifier: MIT
// Integrals over an edge less their leading terms, the length over and times the mean distance of its ends. From afar
// these terms of a face's edges all but cancel, since edges times their normals sum to nothing; so faces take only
// differences of them (face_terms.h). Read before edge_terms.h; for vectors of doubles after lanes.h.
#pragma once

namespace cageproof::closed_form::batch {

/// An edge's logarithm L = int 1/r, and what is left of it without length * 2/(r0 + r1).
template <class V>
struct Logarithm {
  V whole, tail;
};

// In arithmetics that have digits to spare.
template <class V>
V reciprocal(const V& x) {
  return V(V{} + 1.0) / x;
}
/// \param mean 2/sum
template <class V>
Logarithm<V> logarithm_of(const V& num, const V& den, const V& length, const V& sum, const V& mean) {
  const V whole = log_of_quotient(num, den, length, sum);
  return {whole, whole - length * mean};
}
/// The rest of int r without length * sum/2. \param distance int r \param square of the line's distance
/// \param reach r0 r1 + p0 p1
template <class V>
V bulge_of(const V& distance, const V& length, const V& sum, const V&, const V&, const V&, const V&) {
  return distance - length * sum * 0.5;
}

/// Whether gradients of edges' integrals are reduced, too, where all edges of a face are short for their distance.
template <class V>
inline constexpr bool kReducesGradients = false;

#if defined(CAGEPROOF_SIMD)
template <>
inline constexpr bool kReducesGradients<CAGEPROOF_SIMD::Lanes> = true;
inline CAGEPROOF_SIMD::Lanes reciprocal(const CAGEPROOF_SIMD::Lanes& x) { return CAGEPROOF_SIMD::reciprocal(x); }
inline Logarithm<CAGEPROOF_SIMD::Lanes> logarithm_of(const CAGEPROOF_SIMD::Lanes& num, const CAGEPROOF_SIMD::Lanes& den,
                                                     const CAGEPROOF_SIMD::Lanes& length,
                                                     const CAGEPROOF_SIMD::Lanes& sum,
                                                     const CAGEPROOF_SIMD::Lanes& mean) {
  const CAGEPROOF_SIMD::Mask small = 5 * length < sum;
  CAGEPROOF_SIMD::Lanes after;
  const CAGEPROOF_SIMD::Lanes whole = CAGEPROOF_SIMD::log_of_quotient(num, den, length, sum, small, &after);
  return {whole, CAGEPROOF_SIMD::select(small, after, whole - length * mean)};
}
/// With z = length/sum: square/2 (L - 2 z - z length^2/reach), where the edge is short for its distance.
inline CAGEPROOF_SIMD::Lanes bulge_of(const CAGEPROOF_SIMD::Lanes& distance, const CAGEPROOF_SIMD::Lanes& length,
                                      const CAGEPROOF_SIMD::Lanes& sum, const CAGEPROOF_SIMD::Lanes& square,
                                      const CAGEPROOF_SIMD::Lanes& tail, const CAGEPROOF_SIMD::Lanes& mean,
                                      const CAGEPROOF_SIMD::Lanes& reach) {
  const CAGEPROOF_SIMD::Lanes third = 0.5 * length * mean * (length * length);
  const CAGEPROOF_SIMD::Lanes bulge = 0.5 * square * (tail - third * CAGEPROOF_SIMD::reciprocal(reach));
  return CAGEPROOF_SIMD::select(5 * length < sum, bulge, distance - 0.5 * length * sum);
}
#endif

}  // namespace cageproof::closed_form::batch
