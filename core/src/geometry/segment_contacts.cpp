// SPDX-License-Identifier: MIT
#include "segment_contacts.h"

#include "meeting_boxes.h"

#include "cageproof/core/geometry/orientation.h"

namespace cageproof {
namespace {

using How = SegmentContact::How;

class Pairs {
 public:
  explicit Pairs(const std::vector<Vec3<double>>& vertices) : vertices_(vertices) {}

  // How two segments meet; which ones they are is left to the caller.
  std::optional<SegmentContact> contact(const Face& a, const Face& b) const {
    for (const int i : {0, 1})
      for (const int j : {0, 1})
        if (a.vertices[i] == b.vertices[j]) return beyond(a.vertices[i], a.vertices[1 - i], b.vertices[1 - j]);
    const std::array of_b{side(a, b.vertices[0]), side(a, b.vertices[1])};
    const std::array of_a{side(b, a.vertices[0]), side(b, a.vertices[1])};
    if (of_b == std::array{0, 0}) return on_a_line(a, b);
    for (const int i : {0, 1}) {
      if (of_b[i] == 0 && is_within(a, b.vertices[i])) return SegmentContact{0, 0, How::Touch, b.vertices[i]};
      if (of_a[i] == 0 && is_within(b, a.vertices[i])) return SegmentContact{0, 0, How::Touch, a.vertices[i]};
    }
    if (of_a[0] * of_a[1] < 0 && of_b[0] * of_b[1] < 0) return SegmentContact{0, 0, How::Cross};
    return std::nullopt;
  }

 private:
  const Vec3<double>& at(int vertex) const { return vertices_[vertex]; }
  int side(const Face& segment, int vertex) const {
    return side_of_line({at(segment.vertices[0]), at(segment.vertices[1])}, at(vertex));
  }

  // Segments from a common vertex to p and to q.
  std::optional<SegmentContact> beyond(int common, int p, int q) const {
    if (p == q) return SegmentContact{0, 0, How::Overlap};
    const bool one_line = side_of_line({at(common), at(p)}, at(q)) == 0;
    if (one_line && is_before(common, p) == is_before(common, q)) return SegmentContact{0, 0, How::Overlap, common};
    return std::nullopt;
  }
  std::optional<SegmentContact> on_a_line(const Face& a, const Face& b) const {
    const auto [a_low, a_high] = in_order(a);
    const auto [b_low, b_high] = in_order(b);
    if (is_before(a_high, b_low) || is_before(b_high, a_low)) return std::nullopt;
    return SegmentContact{0, 0, How::Overlap};
  }

  // Along a line, the order of places by their coordinates is one of its two directions.
  bool is_before(int v, int w) const { return at(v)[0] != at(w)[0] ? at(v)[0] < at(w)[0] : at(v)[1] < at(w)[1]; }
  std::pair<int, int> in_order(const Face& segment) const {
    const auto [v, w] = std::pair{segment.vertices[0], segment.vertices[1]};
    return is_before(v, w) ? std::pair{v, w} : std::pair{w, v};
  }
  // Of a vertex on the segment's line.
  bool is_within(const Face& segment, int vertex) const {
    const auto [low, high] = in_order(segment);
    return !is_before(vertex, low) && !is_before(high, vertex);
  }

  const std::vector<Vec3<double>>& vertices_;
};

}  // namespace

std::optional<SegmentContact> first_contact(const std::vector<Vec3<double>>& vertices,
                                            const std::vector<Face>& segments) {
  const Pairs pairs(vertices);
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(segments.size());
  for (const Face& segment : segments)
    boxes.emplace_back(vertices[segment.vertices[0]]).extend(vertices[segment.vertices[1]]);
  std::optional<SegmentContact> found;
  for_meeting_boxes(boxes, [&](int first, int second) {
    if (found) return;
    found = pairs.contact(segments[first], segments[second]);
    if (!found) return;
    found->first = first;
    found->second = second;
  });
  return found;
}

}  // namespace cageproof
