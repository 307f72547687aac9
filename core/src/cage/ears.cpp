// SPDX-License-Identifier: MIT
#include "ears.h"

#include "cageproof/core/geometry/orientation.h"
#include "geometry/segment_contacts.h"

#include <limits>
#include <numeric>

namespace cageproof {
namespace {

// The polygon's corners in the plane across its largest area, counter-clockwise where the polygon is so in space seen
// against that axis.
std::vector<Vec3<double>> seen_flat(std::span<const Vec3<double>> corners) {
  Vec3<double> area = Vec3<double>::Zero();
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    area += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
  Eigen::Index axis = 0;
  area.cwiseAbs().maxCoeff(&axis);
  std::vector<Vec3<double>> flat;
  for (const Vec3<double>& p : corners) {
    const double u = p[(axis + 1) % 3], v = p[(axis + 2) % 3];
    // An area that looks the other way is mirrored.
    if (area[axis] > 0) flat.emplace_back(u, v, 0);
    else flat.emplace_back(v, u, 0);
  }
  return flat;
}

// +1 where a, b, c turn to the left.
int turn(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  return -side_of_line(Segment<double>{a, b}, c);
}

class Ears {
 public:
  explicit Ears(std::span<const Vec3<double>> corners) : corners_(corners), flat_(seen_flat(corners)) {
    left_.resize(corners.size());
    std::iota(left_.begin(), left_.end(), 0);
  }

  std::vector<std::array<int, 3>> cut() {
    std::vector<std::array<int, 3>> triangles;
    if (!is_simple()) return {};
    while (left_.size() > 3) {
      const int best = shortest_ear();
      if (best < 0) return {};
      triangles.push_back(around(best));
      left_.erase(left_.begin() + best);
    }
    if (!turns_left(around(1))) return {};
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  bool is_simple() const {
    std::vector<Face> sides;
    const int count = static_cast<int>(flat_.size());
    for (int k = 0; k < count; ++k) {
      for (int other = 0; other < k; ++other)
        if (flat_[k] == flat_[other]) return false;
      sides.push_back({{k, (k + 1) % count, -1, -1}});
    }
    return !first_contact(flat_, sides);
  }
  std::array<int, 3> around(int k) const {
    const int count = static_cast<int>(left_.size());
    return {left_[(k + count - 1) % count], left_[k], left_[(k + 1) % count]};
  }
  bool turns_left(const std::array<int, 3>& t) const { return turn(flat_[t[0]], flat_[t[1]], flat_[t[2]]) > 0; }
  // Whether no other corner is in the triangle, its border included.
  bool is_empty(const std::array<int, 3>& t) const {
    for (const int v : left_) {
      if (v == t[0] || v == t[1] || v == t[2]) continue;
      bool inside = true;
      for (int e = 0; e < 3; ++e) inside = inside && turn(flat_[t[e]], flat_[t[(e + 1) % 3]], flat_[v]) >= 0;
      if (inside) return false;
    }
    return true;
  }
  int shortest_ear() const {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < static_cast<int>(left_.size()); ++k) {
      const auto t = around(k);
      const double length = (corners_[t[2]] - corners_[t[0]]).stableNorm();
      if (!(length < least) || !turns_left(t) || !is_empty(t)) continue;
      least = length;
      best = k;
    }
    return best;
  }

  std::span<const Vec3<double>> corners_;
  std::vector<Vec3<double>> flat_;
  std::vector<int> left_;  // corners that no ear has cut off
};

}  // namespace

std::vector<std::array<int, 3>> ears_of(std::span<const Vec3<double>> corners) { return Ears(corners).cut(); }

}  // namespace cageproof
