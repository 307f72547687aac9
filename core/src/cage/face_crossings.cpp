// SPDX-License-Identifier: MIT
#include "face_crossings.h"

#include "cageproof/core/input_error.h"
#include "face_pieces.h"
#include "geometry/meeting_boxes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Triangle_3.h>
#include <CGAL/intersections.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace cageproof {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

// A triangle of a face, by its vertices.
struct Piece {
  int face;
  std::array<int, 3> vertices;
};

class Soup {
 public:
  Soup(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& faces) {
    points_.reserve(vertices.size());
    for (const Vec3<double>& v : vertices) points_.emplace_back(v[0], v[1], v[2]);
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const auto& piece : all_pieces_of(vertices, faces[f])) {
        pieces_.push_back({static_cast<int>(f), piece});
        Eigen::AlignedBox3d& box = boxes_.emplace_back();
        for (const int v : piece) box.extend(vertices[v]);
      }
  }

  std::vector<FaceCrossing> crossings() const {
    std::set<std::pair<int, int>> found;
    for_meeting_boxes(boxes_, [&](int a, int b) {
      const auto pair = std::minmax(pieces_[a].face, pieces_[b].face);
      if (pair.first != pair.second && !found.contains(pair) && meet(pieces_[a], pieces_[b])) found.insert(pair);
      constexpr std::size_t most = 300'000;
      if (found.size() > most)
        throw InputError(
            fmt::format("more than {} pairs of faces cross or touch each other, as faces {} and {} do: this is no "
                        "surface; does the file hold it many times? (faces counted from 0)",
                        most, found.begin()->first, found.begin()->second));
      return true;
    });
    std::vector<FaceCrossing> result;
    result.reserve(found.size());
    for (const auto& [first, second] : found) result.push_back({first, second});
    return result;
  }

 private:
  Kernel::Triangle_3 triangle(const Piece& p) const {
    return {points_[p.vertices[0]], points_[p.vertices[1]], points_[p.vertices[2]]};
  }

  // Whether two triangles meet in more than the vertices or the edge that they share.
  bool meet(const Piece& a, const Piece& b) const {
    // Shared vertices first, in the same order in both.
    std::array<int, 3> of_a = a.vertices, of_b = b.vertices;
    int shared = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = shared; j < 3; ++j)
        if (of_a[i] == of_b[j]) {
          std::swap(of_a[i], of_a[shared]);
          std::swap(of_b[j], of_b[shared]);
          ++shared;
          break;
        }
    const auto edge = [&](const std::array<int, 3>& of) { return Kernel::Segment_3(points_[of[1]], points_[of[2]]); };
    switch (shared) {
      case 0: return CGAL::do_intersect(triangle(a), triangle(b));
      case 1: return CGAL::do_intersect(edge(of_a), triangle(b)) || CGAL::do_intersect(edge(of_b), triangle(a));
      case 2: return overlap(of_a, of_b[2]);
      default: return true;
    }
  }

  // Whether the triangle and that of its first two corners with `apex` lie in one plane, on the same side of the edge.
  bool overlap(const std::array<int, 3>& corners, int apex) const {
    const Point &p = points_[corners[0]], &q = points_[corners[1]], &r = points_[corners[2]], &s = points_[apex];
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
  }

  std::vector<Point> points_;
  std::vector<Piece> pieces_;
  std::vector<Eigen::AlignedBox3d> boxes_;  ///< of the pieces
};

}  // namespace

std::vector<FaceCrossing> face_crossings(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& faces) {
  return Soup(vertices, faces).crossings();
}

}  // namespace cageproof
