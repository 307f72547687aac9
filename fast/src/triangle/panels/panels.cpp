// SPDX-License-Identifier: MIT
#include "cageproof/fast/triangle/panels.h"

#include "cageproof/closed_form/batch/instruction_set.h"
#include "cageproof/fast/triangle/far_form.h"

#include "request.h"

#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>

namespace cageproof::fast::triangle {
namespace {

// The most points along a panel's edges: with more, two panels take fewer.
constexpr int kMostOnEdge = 48, kCutAbove = 24;

// For each number of points, the least ellipse that they are good for.
struct LeastEllipses {
  double least[kMostOnEdge + 1];
  explicit LeastEllipses(int steepness) {
    for (int n = 2; n <= kMostOnEdge; ++n)
      least[n] = std::pow(far_error(n, 1, steepness, 0) / (kFarTolerance / 2), 0.5 / (n - 1));
  }
};

// The points per side that suffice; kMostOnEdge + 1 where kMostOnEdge do not.
int points_for(double rho, int steepness) {
  constexpr int kSteepnesses = 9;
  static const std::array<LeastEllipses, kSteepnesses> table = []<std::size_t... S>(std::index_sequence<S...>) {
    return std::array{LeastEllipses(S)...};
  }
  (std::make_index_sequence<kSteepnesses>());
  const double* const least = table[steepness].least;
  int few = 1, many = kMostOnEdge + 1;
  while (many - few > 1) {
    const int middle = (few + many) / 2;
    (rho >= least[middle] ? many : few) = middle;
  }
  return many;
}

double ellipse(double distance, double length) {
  const double slope = 2 * distance / length;
  return slope + std::sqrt(1 + slope * slope);
}

// A part of the triangle, its corners from the point in double-double.
struct Piece {
  WideVec<DoubleDouble> corner[3];
  double hat[3][3];  // of each of these corners, all three
  double area2;
};

WideVec<DoubleDouble> middle(const WideVec<DoubleDouble>& a, const WideVec<DoubleDouble>& b) {
  WideVec<DoubleDouble> m;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble sum = a[i] + b[i];
    m.c[i] = {sum.high / 2, sum.low / 2};
  }
  return m;
}

Vec3<double> difference(const WideVec<DoubleDouble>& a, const WideVec<DoubleDouble>& b) {
  return {static_cast<double>(a[0] - b[0]), static_cast<double>(a[1] - b[1]), static_cast<double>(a[2] - b[2])};
}

class Cutter {
 public:
  Cutter(const Frame<double>& frame, const PanelsWanted& wanted, Panels& panels)
      : frame_(frame), wanted_(wanted), panels_(panels) {
    for (int i = 1; i < 3; ++i)
      if (frame.edges[i].length > frame.edges[longest_].length) longest_ = i;
  }

  // False where the points do not suffice.
  bool cut(const Piece& piece, int depth) {
    const Seen seen(*this, piece);
    const double rho = ellipse(seen.distance, seen.longer);
    const int across = points_for(rho, wanted_.steepness);
    if (across <= (depth == 0 ? kMostOnEdge : kCutAbove)) {
      const int along = points_for(ellipse(seen.distance, seen.shortest), wanted_.steepness);
      if (across <= kCutAbove || across * along <= kCutAbove * kCutAbove) return add(piece, seen, across, along);
    }
    if (depth == 0 && !is_hopeful(seen.distance)) return false;
    // Each further panel takes at least kLeast points.
    constexpr int kLeast = 32, kDeepest = 48;
    if (depth == kDeepest || points_ + kLeast > wanted_.points) return false;
    points_ += kLeast;
    const int i = seen.longest, j = (i + 1) % 3;
    Piece halves[2] = {piece, piece};
    const WideVec<DoubleDouble> cut = middle(piece.corner[i], piece.corner[j]);
    const int replaced[2] = {j, i};
    for (int h = 0; h < 2; ++h) {
      halves[h].corner[replaced[h]] = cut;
      for (int c = 0; c < 3; ++c) halves[h].hat[replaced[h]][c] = (piece.hat[i][c] + piece.hat[j][c]) / 2;
      halves[h].area2 = piece.area2 / 2;
    }
    // The half at the nearer corner comes first: it takes more points, and tells earlier that they do not suffice.
    const bool first = seen.corner[i].squaredNorm() <= seen.corner[j].squaredNorm();
    const bool enough = this->cut(halves[first ? 0 : 1], depth + 1) && this->cut(halves[first ? 1 : 0], depth + 1);
    points_ -= kLeast;
    return enough;
  }

 private:
  struct Seen {
    Vec3<double> corner[3];
    double shortest, longer;  // edges' lengths
    double distance;          // no more than the panel's
    int longest, apex;        // the longest edge's first corner, and the corner opposite to the shortest edge

    Seen(const Cutter& cutter, const Piece& piece) {
      const FrameEdge<double>& axis = cutter.frame_.edges[cutter.longest_];
      double low[2], high[2], squares[3];
      for (int i = 0; i < 3; ++i) {
        corner[i] = narrow<double>(piece.corner[i]);
        const double place[2] = {corner[i].dot(axis.u), corner[i].dot(axis.nu)};
        for (int c = 0; c < 2; ++c) {
          low[c] = i == 0 ? place[c] : std::min(low[c], place[c]);
          high[c] = i == 0 ? place[c] : std::max(high[c], place[c]);
        }
      }
      longest = 0;
      int least = 0;
      for (int i = 0; i < 3; ++i) {
        squares[i] = difference(piece.corner[(i + 1) % 3], piece.corner[i]).squaredNorm();
        if (squares[i] > squares[longest]) longest = i;
        if (squares[i] < squares[least]) least = i;
      }
      shortest = std::sqrt(squares[least]);
      longer = std::sqrt(squares[longest]);
      apex = (least + 2) % 3;
      // The distance of the box that it lies in.
      const double s = std::max({low[0], -high[0], 0.}), h = std::max({low[1], -high[1], 0.}), d = cutter.frame_.d;
      distance = std::sqrt(s * s + h * h + d * d);
    }
  };

  // Whether the points may suffice. Panels get smaller towards the point by halves: down to its distance across the
  // triangle's height, two or three a halving, and some more where the point is nearer than that.
  bool is_hopeful(double nearest) const {
    constexpr double kBeside = 150, kAbove = 600;  // points a halving, at the least
    const double length = frame_.edges[longest_].length, height = frame_.area2 / length;
    const double distance = std::max(nearest, std::ldexp(length, -60));
    double points = kBeside * std::max(0., std::log2(length / std::max(distance, height)));
    if (distance < height) points += kAbove * std::log2(height / distance);
    return points <= wanted_.points;
  }

  bool add(const Piece& piece, const Seen& seen, int across, int along) {
    points_ += across * along;
    if (points_ > wanted_.points) return false;
    const int a = seen.apex, b = (a + 1) % 3, c = (a + 2) % 3;
    Panel& panel = panels_.emplace_back();
    panel.corner = seen.corner[a];
    panel.side = difference(piece.corner[b], piece.corner[a]);
    panel.base = difference(piece.corner[c], piece.corner[b]);
    for (int k = 0; k < 3; ++k) {
      panel.hat[k][0] = piece.hat[a][k];
      panel.hat[k][1] = piece.hat[b][k];
      panel.hat[k][2] = piece.hat[c][k];
    }
    panel.area2 = piece.area2;
    panel.across = across;
    panel.along = along;
    return true;
  }

  const Frame<double>& frame_;
  const PanelsWanted& wanted_;
  Panels& panels_;
  int longest_ = 0, points_ = 0;
};

/// A collapsed rule's points, filled up to whole vectors.
struct CollapsedRule {
  std::vector<double> u, v, weight;

  CollapsedRule(int across, int along) {
    const auto& first = gauss_legendre<double>(across);
    const auto& second = gauss_legendre<double>(along);
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < along; ++j) {
        u.push_back(first.nodes[i]);
        v.push_back(second.nodes[j]);
        weight.push_back(first.nodes[i] * first.weights[i] * second.weights[j]);
      }
    constexpr std::size_t kVector = 8;
    while (u.size() % kVector != 0) {
      u.push_back(0.5);
      v.push_back(0.5);
      weight.push_back(0);
    }
  }
};

// The rule with `across` x `along` points, made when first asked for, and kept.
PanelRule collapsed_rule(int across, int along) {
  using Slot = std::atomic<const CollapsedRule*>;
  static std::array<std::array<Slot, kMostOnEdge + 1>, kMostOnEdge + 1> rules;
  static std::mutex mutex;
  static std::vector<std::unique_ptr<const CollapsedRule>> made;
  Slot& slot = rules[across][along];
  const CollapsedRule* rule = slot.load(std::memory_order_acquire);
  if (rule == nullptr) {
    const std::scoped_lock lock(mutex);
    rule = slot.load(std::memory_order_relaxed);
    if (rule == nullptr) {
      made.push_back(std::make_unique<const CollapsedRule>(across, along));
      rule = made.back().get();
      slot.store(rule, std::memory_order_release);
    }
  }
  return {rule->u.data(), rule->v.data(), rule->weight.data(), static_cast<int>(rule->u.size())};
}

PanelSum panel_sum() {
#if defined(__x86_64__)
  const closed_form::batch::InstructionSet set = closed_form::batch::instruction_set();
  if (set == closed_form::batch::InstructionSet::Avx512) return panel_sum_avx512;
  if (set == closed_form::batch::InstructionSet::Avx2) return panel_sum_avx2;
#endif
  return panel_sum_plain;
}

}  // namespace

Panels cut_to_panels(const Frame<double>& frame, const Triangle<double>& t, const Vec3<double>& eta,
                     const PanelsWanted& wanted) {
  Piece whole{};
  const double scale = 1 / frame.unit;
  for (int i = 0; i < 3; ++i) {
    whole.corner[i] = wide_difference<double>(t[i] * scale, eta * scale);
    whole.hat[i][i] = 1;
  }
  whole.area2 = frame.area2;
  Panels panels;
  if (!Cutter(frame, wanted, panels).cut(whole, 0)) panels.clear();
  return panels;
}

void sum_panels(const Panels& panels, int power, int degree, bool sized, PanelSums& to) {
  static const PanelSum sum = panel_sum();
  PanelRequest request{};
  request.power = power;
  request.degree = degree;
  request.sums = &to.sums[0][0];
  request.sizes = sized ? &to.sizes[0][0] : nullptr;
  for (const Panel& panel : panels) {
    request.rule = collapsed_rule(panel.across, panel.along);
    for (int c = 0; c < 3; ++c) {
      request.a[c] = panel.corner[c];
      request.side[c] = panel.side[c];
      request.base[c] = panel.base[c];
      for (int k = 0; k < 3; ++k) request.hat[k][c] = panel.hat[k][c];
    }
    request.area2 = panel.area2;
    sum(request);
  }
}

}  // namespace cageproof::fast::triangle
