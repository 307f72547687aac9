// SPDX-License-Identifier: MIT
// A cage: a closed, oriented boundary, validated once: in space a surface of triangles and quads, in the plane
// polygons.
#pragma once

#include "cageproof/core/numbers/vector.h"

#include <array>
#include <optional>
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

/// Repairs that make_cage may make instead of rejecting a cage.
struct CageOptions {
  /// Reverse the faces of parts that are oriented the wrong way: outer shells whose normals point inward, and cavities
  /// whose normals point into the solid. In the plane also single segments, so that all of a polygon follow each other.
  bool flip_inward = false;
  /// Quads may have coinciding corners, three on a line, cross themselves or fold over; for coordinates that keep
  /// quads.
  bool allow_invalid_quads = false;
  /// The line of each face in its file, for messages; empty where it is not known.
  std::vector<std::size_t> face_lines = {};
  /// The number in its file of each face, for messages and for those who have the file's faces; several faces have the
  /// number of one that was cut in triangles. Empty where faces are those of the file.
  std::vector<int> face_numbers = {};
};

/// How quads become triangles: by the shorter of the two diagonals (compared exactly; ties: the one at the quad's first
/// corner), or the one at the quad's first corner. Where a triangle of the chosen one would be turned against both, as
/// the diagonal outside an arrowhead makes it, the other one is taken.
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
  ///   edge with one face (hole), or along which other numbers of faces run one way than the other; a face given twice;
  ///   a part without volume, or oriented the wrong way unless options.flip_inward. These tests are exact: no threshold
  ///   depends on the unit of length.
  /// Faces that hang together by edges are a part of the cage; where parts share edges or vertices, meeting_warning
  /// says so. Parts that lie within no other, or within an even number of others, are shells, and their normals point
  /// outward (positive volume); the others bound cavities, and their normals point into them. Parts that cross count as
  /// beside each other, not within. Any other orientation would make coordinates sum to 2 or -1 somewhere. Faces may
  /// cross each other: crossing_faces names them.
  static Cage make(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> faces,
                   CageOptions options = {});

  /// A polygon in the plane, or several: those within an odd number of others bound holes, and run clockwise.
  /// \param vertices with third coordinate zero \param segments from vertex to vertex, in any order
  /// \throws InputError naming the first vertex or segment at fault, and the reason: empty input, a coordinate that is
  ///   not finite or not in the plane; index out of range or repeated, unused vertex; a segment without length, two
  ///   vertices of a polygon at one place; a vertex where not exactly one segment ends and one begins; two segments
  ///   that cross or overlap, or touch within one polygon; a polygon that runs the wrong way. Polygons may touch others
  ///   in points. With options.flip_inward segments and polygons that run the wrong way are turned instead. Exact, as
  ///   make is.
  /// In space faces that cross bring a warning, in the plane an error: a polygon is drawn in one piece, by hand or by a
  /// program, and one that crosses itself is an accident.
  static Cage make_polygon(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> segments,
                           CageOptions options = {});

  const std::string& name() const { return name_; }
  /// The dimension of the space that the cage lies in: 2 or 3.
  int dimension() const { return dimension_; }
  const std::vector<Vec3<double>>& vertices() const { return vertices_; }
  const std::vector<Face>& faces() const { return faces_; }
  /// CageOptions::face_lines.
  const std::vector<std::size_t>& face_lines() const { return face_lines_; }
  /// The number in its file of face f (CageOptions::face_numbers).
  int face_number(std::size_t f) const { return face_numbers_.empty() ? static_cast<int>(f) : face_numbers_[f]; }
  /// "face 3 (line 12)", by the file's number; without the line where it is not known.
  std::string face_label(std::size_t f) const;
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
  /// The same cage with other vertices and faces, of the same dimension: moved, turned, subdivided. \throws InputError
  /// as make and make_polygon, which look for no contacts here: walls as thin as a rounding may have come to touch.
  Cage with(std::vector<Vec3<double>> vertices, std::vector<Face> faces) const;

 private:
  Cage() = default;
  static Cage polygon(std::string name, std::vector<Vec3<double>> vertices, std::vector<Face> segments,
                      CageOptions options, bool look_for_contacts);
  int dimension_ = 3;
  std::string name_;
  std::vector<Vec3<double>> vertices_;
  std::vector<Face> faces_;
  std::vector<std::size_t> face_lines_;
  std::vector<int> face_numbers_;
  bool allows_invalid_quads_ = false;
};

/// The quads that are not valid (invalid_because), each as "face f: reason"; empty for none.
std::vector<std::string> invalid_quads(const Cage& cage);

/// One line that counts the quads that fold along either diagonal and names the first of them; nothing where none does.
/// Only cages that were made with CageOptions::allow_invalid_quads have some.
std::optional<std::string> folding_warning(const Cage& cage);

/// One line that counts the edges of more than two faces and the vertices whose faces form more than one fan, and names
/// the first of them; nothing where the cage is a manifold.
std::optional<std::string> meeting_warning(const Cage& cage);

/// The pairs of faces that cross or touch each other (face_crossings), each as "faces f and g", with the lines of the
/// file where they are known; empty for none, and in the plane, where make_polygon refuses them. Crossings are not an
/// error: integrals over such a surface exist and keep their properties. One differs: a partition of unity sums to how
/// often the cage winds around the point, which is 2 where two of its parts overlap.
std::vector<std::string> crossing_faces(const Cage& cage);

/// One line that names the first of them and says what it means; nothing where no faces cross.
std::optional<std::string> crossing_warning(const Cage& cage);

}  // namespace cageproof
