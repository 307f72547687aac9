// SPDX-License-Identifier: MIT
// Test vectors of whole cages: all coordinates of points, as the defining integrals give them.
#pragma once

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/judge/cage_request.h"
#include "cageproof/judge/vectors.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cageproof::judge {

/// One point of a cage with its coordinates.
struct CageVector {
  Vec3<double> point;
  std::string regime;                ///< "inside", "outside", "near-face" ...
  std::vector<std::string> defects;  ///< known defects that fail here, by name
  std::vector<Mp100> value;          ///< [coordinate], block by block; on the cage the limit from inside
  /// By block: |truth| + size sum_k |d truth/d x_k|, over the coordinates x_k of the point, `size` the cage's diagonal.
  std::vector<Mp100> denominators;
};

/// The vectors of one kind in one cage.
struct CageVectorSet {
  std::string cage;  ///< its name
  const CoordinateKind* kind = nullptr;
  CageRequest question;  ///< the cage, without points
  std::vector<CoordinateBlock> blocks;
  std::vector<CageVector> vectors;
  std::size_t candidates = 0, without_defect = 0;  ///< as of VectorSet
  std::size_t without_truth = 0;                   ///< candidates at which two computations of the truth disagree
};

/// A wrong way to compute the coordinates of a cage.
struct CageDefect {
  std::string name, description;
};
/// All defects that vectors of cages aim at: defects of elements, summed over a cage, and defects that only cages have.
std::vector<CageDefect> cage_defects();

/// Kinds that have vectors.
std::vector<std::string_view> vector_kinds();
/// The cages: "tetrahedron", "small-tetrahedron", "cube", "l-block"; with quads "bent-box", "quad-l-block"; in the
/// plane "l-shape", "star".
std::vector<std::string_view> vector_cages();
/// Whether a kind has vectors in a cage: kinds that keep quads in those with quads, others in the other ones.
bool has_vectors(std::string_view kind, std::string_view cage);

/// Makes the vectors of a kind in one cage. Truths are sums of closed forms, of quads line forms, in 100 digits. Points
/// where sums of the defining integrals, in 50 digits, do not agree to 28 are left out and counted, and so are those
/// that no defect fails. Kinds that are no sums have a second route in the place of integrals.
/// \throws InputError for a kind or a cage that has none
CageVectorSet make_cage_vectors(std::string_view kind, std::string_view cage, const VectorOptions& options);

/// JSON, one vector per line. \param command what made it
std::string cage_vectors_json(const CageVectorSet& set, const VectorOptions& options, std::string_view version,
                              std::string_view command);
/// Lines of words: KIND.CAGE, the numbers of vectors, of coordinates of a point, of corners of the largest face, of
/// vertices, faces, and coordinates of each block; all vertices; all faces, a triangle among quads with -1 last; then
/// per vector flags, the point, each truth as a sum of two doubles, and denominators.
std::string cage_vectors_text(const CageVectorSet& set);

/// Row-major tables for .npy.
struct CageVectorTables {
  std::size_t dimension = 0, corners = 0, coordinates = 0;  ///< columns of points and vertices, of faces, of truths
  std::vector<double> vertices, points;
  std::vector<std::int32_t> faces;  ///< a triangle among quads has -1 last
  std::vector<double> truths;       ///< each number as a sum of two doubles
  std::vector<double> denominators;
};
CageVectorTables cage_vectors_tables(const CageVectorSet& set);

}  // namespace cageproof::judge
