// SPDX-License-Identifier: MIT
// Whole coordinates of a cage: by every evaluation, and by rules as quick as they get.
#pragma once

#include "deformer_benchmarks.h"

namespace cageproof::benchmarks {

/// Registers with Google Benchmark, for every kind that is a sum and that the cage accepts,
///   `cage/<kind>/<evaluation>/<value|gradient|hessian>/<cage>`        coordinates, row-major
///   `cage/<kind>/<evaluation>/<value|gradient|hessian>/apply/<cage>`  functions that they make of the posed cage
///   `cage/<kind>/gauss-<N>/value/<cage>`        green, biharmonic and somigliana with N x N points each, N = 4, 8,
///                                               20, on vectors of points; somigliana by three-quad-7500, too
///   `cage/<kind>/gauss-<N>-plain/value/<cage>`  the same, written plainly
/// with timed_evaluations. One thread. Whole evaluations take all points, in blocks of no more memory than 128 MB,
/// which is there already and set to zero before, neither of which is timed; others take as many points, spread evenly,
/// as make some ten thousand pairs. Derivatives include what is below them.
///
/// Counters: `ns_per_pair`, processor time of a (point, element), where quads that are split are two, and `points`.
/// With --benchmark_repetitions there is a row `best`, the least.
/// \returns the names, in order of registration
std::vector<std::string> register_cage_benchmarks(const std::shared_ptr<const DeformedCage>& what);

/// Registers `scaling/<kind>/<points|faces|threads>/<evaluation>/<count>`: values of green, biharmonic, somigliana,
/// mean_value and the kinds that keep quads by timed_evaluations, whole ones and the recommended one: over points, 1 to
/// 1,000,000, and threads, in an icosphere (a cube of quads for kinds that keep them), and over faces, 12 to 100,000,
/// in icospheres (cubes) cut finer, in `long-` and `graded-` ones, and in the given cages, `<cage>-`. Sums of single
/// elements take fewer. Cages are made as benchmarks run, and points get fewer where faces are many, so that a pass
/// takes some ten million pairs. Time is the processor's, over threads the clock's: counters `ns_per_pair`, `points`,
/// `elements` and `threads`. And `scaling/inside/faces/tree/<count>`: exact winding numbers. \returns the names
std::vector<std::string> register_scaling_benchmarks(
    const std::vector<std::shared_ptr<const DeformedCage>>& given = {});

}  // namespace cageproof::benchmarks
