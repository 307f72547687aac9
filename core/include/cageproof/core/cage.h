// SPDX-License-Identifier: MIT
// A cage: a closed, oriented, manifold surface of triangles and quads, validated once.
#pragma once

#include "cageproof/core/linear.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof {

/// Three or four vertex indices, counter-clockwise seen from outside; a triangle's fourth is -1.
struct Face {
  std::array<int, 4> vertices{-1, -1, -1, -1};
  int size() const { return vertices[3] < 0 ? 3 : 4; }
};

/// What may be repaired instead of rejected.
struct CageOptions {
  bool flip_inward = false;  ///< reverse all faces of a cage whose normals point inward
  /// Quads may have coinciding corners, three on a line, cross themselves or fold over; for coordinates that keep quads.
  bool allow_invalid_quads = false;
};

/// How quads become triangles: by the shorter of the two diagonals (compared exactly; ties: the one at the quad's first
/// corner), or always the one at the quad's first corner. The chosen diagonal of an arrowhead may lie outside it.
enum class Triangulation { Shortest, Fan };

/// "shortest", "fan".
std::string_view name_of(Triangulation rule);

/// A valid cage. Immutable; made by `make` alone.
class Cage {
 public:
  /// Validates and builds.
  /// \param name shown in messages and reports (a file's path, or an embedded cage's name)
  /// \throws InputError naming the first face (or vertex) at fault, counted from 0, and the reason: empty input,
  ///   non-finite coordinate; index out of range or repeated within a face, unused vertex; two corners of a face that
  ///   coincide, three on a line, a quad that crosses itself or folds by more than a right angle along both diagonals;
  ///   edge with one face (hole) or more than two (non-manifold), inconsistent orientation, vertex whose faces form
  ///   more than one fan; no volume, or inward orientation (negative volume) unless options.flip_inward. These tests
  ///   are exact: no threshold depends on the unit of length.
  /// Several components are one cage; the sign of the total volume decides, so that a cavity's faces may point into it.
  /// Intersections between different faces are not looked for.
  static Cage make(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> faces,
                   CageOptions options = {});

  const std::string& name() const { return name_; }
  const std::vector<Vec3<double>>& vertices() const { return vertices_; }
  const std::vector<Face>& faces() const { return faces_; }
  bool has_quads() const;
  /// Whether it was made with CageOptions::allow_invalid_quads.
  bool allows_invalid_quads() const { return allows_invalid_quads_; }
  /// The corners of face f. \pre it is a quad
  std::array<Vec3<double>, 4> quad(std::size_t f) const;
  /// Length of the bounding box's diagonal.
  double size() const;
  /// The faces as triangles; quads are split by `rule`. `face_of[t]` is the face that triangle t comes from.
  struct Triangles {
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> face_of;
  };
  Triangles triangulate(Triangulation rule) const;

 private:
  Cage() = default;
  std::string name_;
  std::vector<Vec3<double>> vertices_;
  std::vector<Face> faces_;
  bool allows_invalid_quads_ = false;
};

/// The quads that are not valid (invalid_because), each as "face f: reason"; empty for none.
std::vector<std::string> invalid_quads(const Cage& cage);

}  // namespace cageproof
