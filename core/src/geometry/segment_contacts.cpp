// SPDX-License-Identifier: MIT
#include "segment_contacts.h"

#include "meeting_boxes.h"

#include "cageproof/core/geometry/orientation.h"

namespace cageproof {
namespace {

using How = SegmentContact::How;

bool is_left_of(const Vec3<double>& p, const Vec3<double>& q) { return p[0] != q[0] ? p[0] < q[0] : p[1] < q[1]; }

// Whether two places lie in one direction from a third.
bool is_along(const Vec3<double>& from, const Vec3<double>& p, const Vec3<double>& q) {
  return side_of_line({from, p}, q) == 0 && is_left_of(from, p) == is_left_of(from, q);
}

class Pairs {
 public:
  Pairs(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& segments)
      : vertices_(vertices), passages_(vertices, segments) {}

  // How two segments meet; which ones they are is left to the caller.
  std::optional<SegmentContact> contact(const Face& a, const Face& b) const {
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        if (at(a.vertices[i]) == at(b.vertices[j])) {
          const auto overlap = beyond(a.vertices[i], a.vertices[1 - i], b.vertices[1 - j]);
          if (overlap || !crosses(passages_.at(a.vertices[i]), b.vertices[j])) return overlap;
          return SegmentContact{0, 0, How::Cross};
        }
    const std::array of_b{side(a, b.vertices[0]), side(a, b.vertices[1])};
    const std::array of_a{side(b, a.vertices[0]), side(b, a.vertices[1])};
    if (of_b == std::array{0, 0}) return on_a_line(a, b);
    for (const int i : {0, 1}) {
      if (of_b[i] == 0 && is_within(a, b.vertices[i])) return touch(a, b.vertices[i]);
      if (of_a[i] == 0 && is_within(b, a.vertices[i])) return touch(b, a.vertices[i]);
    }
    if (of_a[0] * of_a[1] < 0 && of_b[0] * of_b[1] < 0) return SegmentContact{0, 0, How::Cross};
    return std::nullopt;
  }

 private:
  // At a vertex within a segment. A loop that touches itself has no inside there.
  std::optional<SegmentContact> touch(const Face& segment, int vertex) const {
    if (passages_.loop(vertex) == passages_.loop(segment.vertices[0])) return SegmentContact{0, 0, How::Touch, vertex};
    if (!crosses({at(segment.vertices[0]), at(vertex), at(segment.vertices[1])}, vertex)) return std::nullopt;
    return SegmentContact{0, 0, How::Cross};
  }
  // Whether the loop of that vertex changes sides where it meets that way. Where it runs along it, other pairs say so.
  bool crosses(const Passage& way, int vertex) const {
    const Passage other = passages_.at(vertex);
    for (const Vec3<double>& towards : {other.before, other.after})
      if (is_along(way.at, way.before, towards) || is_along(way.at, way.after, towards)) return false;
    return is_left(way, other.before) != is_left(way, other.after);
  }

  const Vec3<double>& at(int vertex) const { return vertices_[vertex]; }
  int side(const Face& segment, int vertex) const {
    return side_of_line({at(segment.vertices[0]), at(segment.vertices[1])}, at(vertex));
  }

  // Segments from a common vertex to p and to q.
  std::optional<SegmentContact> beyond(int common, int p, int q) const {
    if (at(p) == at(q)) return SegmentContact{0, 0, How::Overlap};
    if (is_along(at(common), at(p), at(q))) return SegmentContact{0, 0, How::Overlap, common};
    return std::nullopt;
  }
  std::optional<SegmentContact> on_a_line(const Face& a, const Face& b) const {
    const auto [a_low, a_high] = in_order(a);
    const auto [b_low, b_high] = in_order(b);
    if (is_before(a_high, b_low) || is_before(b_high, a_low)) return std::nullopt;
    return SegmentContact{0, 0, How::Overlap};
  }

  // Along a line, the order of places by their coordinates is one of its two directions.
  bool is_before(int v, int w) const { return is_left_of(at(v), at(w)); }
  std::pair<int, int> in_order(const Face& segment) const {
    const auto [v, w] = std::pair{segment.vertices[0], segment.vertices[1]};
    return is_before(v, w) ? std::pair{v, w} : std::pair{w, v};
  }
  // Whether a vertex on the segment's line lies within the segment.
  bool is_within(const Face& segment, int vertex) const {
    const auto [low, high] = in_order(segment);
    return !is_before(vertex, low) && !is_before(high, vertex);
  }

  const std::vector<Vec3<double>>& vertices_;
  Passages passages_;
};

}  // namespace

bool is_left(const Passage& way, const Vec3<double>& towards) {
  const int turn = -side_of_line({way.before, way.at}, way.after);
  const bool of_first = side_of_line({way.before, way.at}, towards) < 0;
  const bool of_second = side_of_line({way.at, way.after}, towards) < 0;
  return turn > 0 ? of_first && of_second : of_first || of_second;
}

Passages::Passages(const std::vector<Vec3<double>>& vertices, const std::vector<Face>& segments)
    : vertices_(vertices), before_(vertices.size()), after_(vertices.size()), loops_(vertices.size(), -1) {
  for (const Face& segment : segments) {
    after_[segment.vertices[0]] = segment.vertices[1];
    before_[segment.vertices[1]] = segment.vertices[0];
  }
  for (std::size_t first = 0; first < vertices.size(); ++first)
    for (int v = static_cast<int>(first); loops_[v] < 0; v = after_[v]) loops_[v] = static_cast<int>(first);
}

std::optional<SegmentContact> first_contact(const std::vector<Vec3<double>>& vertices,
                                            const std::vector<Face>& segments) {
  const Pairs pairs(vertices, segments);
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(segments.size());
  for (const Face& segment : segments)
    boxes.emplace_back(vertices[segment.vertices[0]]).extend(vertices[segment.vertices[1]]);
  std::optional<SegmentContact> found;
  for_meeting_boxes(boxes, [&](int first, int second) {
    found = pairs.contact(segments[first], segments[second]);
    if (!found) return true;
    found->first = first;
    found->second = second;
    return false;
  });
  return found;
}

}  // namespace cageproof
