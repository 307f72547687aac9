// SPDX-License-Identifier: MIT
// A cage: a closed, oriented boundary, validated once: in space a manifold surface of triangles and quads, in the plane
// polygons.
#pragma once

#include "cageproof/core/vector.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof {

enum class ElementKind;

/// One element of a cage's boundary: as many vertex indices as it has corners, the others -1. Triangles and quads run
/// counter-clockwise seen from outside; segments have the cage on their left.
struct Face {
  std::array<int, 4> vertices{-1, -1, -1, -1};
  /// Corners: indices that are not -1.
  int size() const {
    int count = 0;
    while (count < 4 && vertices[count] >= 0) ++count;
    return count;
  }
  /// The element with so many corners.
  ElementKind kind() const;
};

/// What may be repaired instead of rejected.
struct CageOptions {
  bool flip_inward = false;  ///< reverse all faces of a cage whose normals point inward
  /// Quads may have coinciding corners, three on a line, cross themselves or fold over; for coordinates that keep
  /// quads.
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

  /// A polygon in the plane, or several (one within another bounds a hole, and runs clockwise).
  /// \param vertices with third coordinate zero \param segments from vertex to vertex
  /// \throws InputError naming the first segment (or vertex) at fault: empty input, a coordinate that is not finite or
  /// not in the plane; index out of
  ///   range or repeated, unused vertex; a segment without length; a vertex where not exactly one segment ends and one
  ///   begins; no area, or clockwise orientation (negative area) unless options.flip_inward. Exact. Intersections are
  ///   not looked for.
  static Cage make_polygon(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> segments,
                           CageOptions options = {});

  const std::string& name() const { return name_; }
  /// Of the space that the cage lies in: 2 or 3.
  int dimension() const { return dimension_; }
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
  /// The faces as elements: as they are, or quads split by `rule`. `face_of[e]` is the face that element e is, or is
  /// part of.
  struct Parts {
    std::vector<Face> elements;
    std::vector<int> face_of;
  };
  Parts parts(bool keep_quads, Triangulation rule) const;
  /// The same cage with other vertices and faces, of the same dimension. \throws InputError as make
  Cage with(std::vector<Vec3<double>> vertices, std::vector<Face> faces) const;

 private:
  Cage() = default;
  int dimension_ = 3;
  std::string name_;
  std::vector<Vec3<double>> vertices_;
  std::vector<Face> faces_;
  bool allows_invalid_quads_ = false;
};

/// The quads that are not valid (invalid_because), each as "face f: reason"; empty for none.
std::vector<std::string> invalid_quads(const Cage& cage);

}  // namespace cageproof
