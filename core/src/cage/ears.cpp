// SPDX-License-Identifier: MIT
#include "ears.h"

#include "cageproof/core/geometry/orientation.h"
#include "geometry/segment_contacts.h"

#include <algorithm>
#include <limits>
#include <set>

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
    const int count = static_cast<int>(corners.size());
    for (int k = 0; k < count; ++k) {
      before_.push_back((k + count - 1) % count);
      after_.push_back((k + 1) % count);
    }
    lengths_.resize(corners.size());
  }

  std::vector<std::array<int, 3>> cut() {
    if (!is_simple()) return {};
    std::vector<std::array<int, 3>> triangles;
    const int count = static_cast<int>(corners_.size());
    for (int k = 0; k < count; ++k)
      if (!turns_left(k)) reflex_.push_back(k);
    for (int k = 0; k < count; ++k) measure(k);
    for (int left = count; left > 3; --left) {
      const int best = static_cast<int>(std::ranges::min_element(lengths_) - lengths_.begin());
      if (!(lengths_[best] < kNoEar)) return {};
      triangles.push_back(around(best));
      const int before = before_[best], after = after_[best];
      lengths_[best] = kNoEar;
      after_[before] = after;
      before_[after] = before;
      std::erase_if(reflex_, [&](int k) { return (k == before || k == after) && turns_left(k); });
      // Only the neighbours' ears are others now.
      measure(before);
      measure(after);
      last_ = after;
    }
    if (!turns_left(last_)) return {};
    triangles.push_back(around(last_));
    return triangles;
  }

 private:
  static constexpr double kNoEar = std::numeric_limits<double>::infinity();

  bool is_simple() const {
    std::vector<Face> sides;
    std::set<std::array<double, 2>> places;
    const int count = static_cast<int>(flat_.size());
    for (int k = 0; k < count; ++k) {
      if (!places.insert({flat_[k][0], flat_[k][1]}).second) return false;
      sides.push_back({{k, (k + 1) % count, -1, -1}});
    }
    return !first_contact(flat_, sides);
  }
  std::array<int, 3> around(int k) const { return {before_[k], k, after_[k]}; }
  bool turns_left(int k) const { return turn(flat_[before_[k]], flat_[k], flat_[after_[k]]) > 0; }
  // Whether no corner is in the triangle, its border included: one that is not reflex would not be the only one.
  bool is_empty(const std::array<int, 3>& t) const {
    return std::ranges::none_of(reflex_, [&](int v) {
      if (v == t[0] || v == t[1] || v == t[2]) return false;
      for (int e = 0; e < 3; ++e)
        if (turn(flat_[t[e]], flat_[t[(e + 1) % 3]], flat_[v]) < 0) return false;
      return true;
    });
  }
  // The length of the diagonal that cuts an ear off.
  void measure(int k) {
    lengths_[k] =
        turns_left(k) && is_empty(around(k)) ? (corners_[after_[k]] - corners_[before_[k]]).stableNorm() : kNoEar;
  }

  std::span<const Vec3<double>> corners_;
  std::vector<Vec3<double>> flat_;
  std::vector<int> before_, after_;  // neighbours among the corners that are left
  std::vector<int> reflex_;          // corners that are left and do not turn left
  std::vector<double> lengths_;      // of each corner's diagonal; kNoEar where it has no ear, or is cut off
  int last_ = 0;
};

}  // namespace

std::vector<std::array<int, 3>> ears_of(std::span<const Vec3<double>> corners) { return Ears(corners).cut(); }

}  // namespace cageproof
