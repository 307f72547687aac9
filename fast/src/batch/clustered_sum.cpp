// SPDX-License-Identifier: MIT
#include "clustered_sum.h"

#include "blocks.h"
#include "cluster_kernels.h"
#include "cluster_moments.h"
#include "near_points.h"

#include "cageproof/core/numbers/scalar.h"
#include "cageproof/core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace cageproof::closed_form::batch {
namespace {

// Points that go down the tree together: enough of them to fill vectors wherever they part.
constexpr std::size_t kTogether = 1024;
// An image is this many functions: its components.
constexpr int kComponents = 3;

std::vector<double> by_faces(const AppliesData& exact, const CageData& data, std::span<const Vec3<double>> points) {
  AppliedTable table;
  table.stride[0] = kComponents;
  table.tensors[0].assign(points.size() * kComponents, 0.0);
  exact.apply(points, 0, data, table);
  return std::move(table.tensors[0]);
}

class ExactSum final : public StatedSum {
 public:
  ExactSum(const AppliesData& exact, CageData data) : exact_(exact), data_(std::move(data)) {}
  void fill(std::span<const Vec3<double>> points, int jobs, std::span<double> values,
            std::span<double> errors) const override {
    std::ranges::fill(errors, 0.0);
    for_each_parallel((points.size() + kTogether - 1) / kTogether, jobs, [&](std::size_t i) {
      const std::size_t first = i * kTogether;
      const auto found = by_faces(exact_, data_, points.subspan(first, std::min(kTogether, points.size() - first)));
      std::ranges::copy(found, values.begin() + static_cast<std::ptrdiff_t>(first * kComponents));
    });
  }
  int degree() const override { return 0; }

 private:
  const AppliesData& exact_;
  CageData data_;
};

// Data of all functions in the unit of the tree. Positions are taken from their middle, and come back times the sum of
// coordinates, a whole number.
struct Shifted {
  std::array<double, kComponents> middle;
  ClusterData data;

  Shifted(const ClusterTree& tree, const CageData& given) {
    const Geometry& whole = tree.whole();
    for (int c = 0; c < kComponents; ++c) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (int v = 0; v < whole.vertices(); ++v) {
        low = std::min(low, given.blocks[0][v * kComponents + c]);
        high = std::max(high, given.blocks[0][v * kComponents + c]);
      }
      middle[c] = low / 2 + high / 2;
    }
    for (int v = 0; v < whole.vertices(); ++v) {
      for (int c = 0; c < kComponents; ++c) data.vertex.push_back(given.blocks[0][v * kComponents + c] - middle[c]);
      data.vertex.push_back(1);
    }
    for (int f = 0; f < whole.faces(); ++f) {
      for (int c = 0; c < kComponents; ++c)
        data.face.push_back(std::ldexp(given.blocks[1][f * kComponents + c], whole.exponent()));
      data.face.push_back(0);
    }
  }
};

// Some points on their way down the tree.
class Descent {
 public:
  Descent(const ClusterTree& tree, const ClusterMoments& moments, const ClusterData& data)
      : tree_(tree),
        moments_(moments),
        data_(data),
        kernels_(kernels()),
        cluster_kernels_(cluster_kernels()),
        lanes_(static_cast<std::size_t>(kernels_.lanes)),
        points_(aligned<double>(3 * lanes_)),
        found_(aligned<double>(kMomentSets * lanes_)) {}

  void run(std::span<const Vec3<double>> points) {
    points_of_ = points;
    sums_.assign(points.size() * kMomentSets, 0.0);
    angles_.assign(points.size(), 0.0);
    left_.assign(points.size(), 0);
    places_.resize(points.size() * 3);
    std::vector<int>& all = level(0).rest;
    all.clear();
    const int exponent = tree_.whole().exponent();
    for (std::size_t p = 0; p < points.size(); ++p) {
      bool exact = true;
      for (int c = 0; c < 3; ++c) {
        places_[3 * p + c] = std::ldexp(points[p][c], -exponent);
        exact = exact && std::ldexp(places_[3 * p + c], exponent) == points[p][c];
      }
      if (exact) all.push_back(static_cast<int>(p));
      else left_[p] = 1;
    }
    visit(0, 0);
  }

  const double* sums(std::size_t p) const { return &sums_[p * kMomentSets]; }
  // Areas of far clusters over the squares of their distances, over 4 pi.
  double angle(std::size_t p) const { return angles_[p] / (4 * pi<double>()); }
  bool is_left(std::size_t p) const { return left_[p] != 0; }

 private:
  struct Level {
    std::vector<int> rest;  // points too near for the cluster's expansion
    std::array<std::vector<int>, ClusterMoments::kDegrees> far;
  };

  Level& level(std::size_t depth) {
    while (levels_.size() <= depth) levels_.emplace_back();
    return levels_[depth];
  }

  // Sums a cluster at the points that are left at a level.
  void visit(int number, std::size_t depth) {
    const Cluster& cluster = tree_.clusters()[number];
    const auto& from = moments_.from(number);
    Level& within = level(depth + 1);
    within.rest.clear();
    for (auto& list : within.far) list.clear();
    for (const int p : level(depth).rest) {
      const double* const x = &places_[3 * static_cast<std::size_t>(p)];
      double square = 0;
      for (int c = 0; c < 3; ++c) square += (x[c] - cluster.centre[c]) * (x[c] - cluster.centre[c]);
      if (!(square >= from[0])) {
        within.rest.push_back(p);
        continue;
      }
      angles_[p] += cluster.area / square;
      int k = 0;
      while (k + 1 < ClusterMoments::kDegrees && square >= from[k + 1]) ++k;
      within.far[k].push_back(p);
    }
    for (int k = 0; k < ClusterMoments::kDegrees; ++k)
      if (!within.far[k].empty()) add_far(cluster, number, k, within.far[k]);
    if (within.rest.empty()) return;
    if (cluster.size() <= moments_.least() || !cluster.has_others_within())
      return add_near(tree_.part(cluster.part), tree_.faces(cluster), within.rest);
    for (const int child : cluster.child) visit(child, depth + 1);
  }

  void add_far(const Cluster& cluster, int number, int k, const std::vector<int>& points) {
    const FarCluster far{moments_.degrees()[k], moments_.degrees()[0], moments_.moments(number),
                         cluster.centre.data(), 1 / cluster.radius,    points_.get(),
                         found_.get()};
    for (std::size_t first = 0; first < points.size(); first += lanes_) {
      const std::size_t count = std::min(lanes_, points.size() - first);
      for (std::size_t i = 0; i < lanes_; ++i)
        for (std::size_t c = 0; c < 3; ++c)
          points_[c * lanes_ + i] = places_[3 * static_cast<std::size_t>(points[first + std::min(i, count - 1)]) + c];
      cluster_kernels_.sum_far_cluster(far);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t s = 0; s < kMomentSets; ++s)
          sums_[static_cast<std::size_t>(points[first + i]) * kMomentSets + s] += found_[s * lanes_ + i];
    }
  }

  void add_near(const ClusterPart& part, std::span<const int> faces, const std::vector<int>& points) {
    Request request{.layers = Layers::Harmonic, .order = 0, .beta = {}, .long_beta = {}, .layout = {}};
    request.layout.first[0][1] = part.geometry.vertices();
    request.layout.count = part.geometry.vertices() + part.geometry.faces();
    BlockRunner runner(part.geometry, nullptr, request, kernels_);
    std::array<std::vector<double>, 2> data;
    for (const int v : part.vertices)
      data[0].insert(data[0].end(), &data_.vertex[v * kMomentSets], &data_.vertex[v * kMomentSets] + kMomentSets);
    for (const int f : faces)
      data[1].insert(data[1].end(), &data_.face[f * kMomentSets], &data_.face[f * kMomentSets] + kMomentSets);
    std::vector<Vec3<double>> here;
    std::vector<long> rows;
    for (std::size_t first = 0; first < points.size(); first += lanes_) {
      here.clear();
      rows.clear();
      for (std::size_t i = first; i < std::min(first + lanes_, points.size()); ++i) {
        rows.push_back(points[i]);
        here.push_back(points_of_[static_cast<std::size_t>(points[i])]);
      }
      const unsigned left = runner.run(here);
      for (std::size_t i = 0; i < here.size(); ++i)
        if ((left >> i & 1u) != 0) left_[static_cast<std::size_t>(rows[i])] = 1;
      for (int b = 0; b < 2; ++b)
        kernels_.multiply({.to = sums_.data(),
                           .stride = kMomentSets,
                           .point = rows.data(),
                           .coordinates = b == 0 ? part.geometry.vertices() : part.geometry.faces(),
                           .rows = 1,
                           .columns = 1,
                           .sets = kMomentSets,
                           .width = 1,
                           .from = runner.columns() + request.layout.first[0][b] * static_cast<std::ptrdiff_t>(lanes_),
                           .data = data[b].data(),
                           .factor = 1 / (4 * pi<double>())},
                          static_cast<int>(here.size()));
    }
  }

  const ClusterTree& tree_;
  const ClusterMoments& moments_;
  const ClusterData& data_;
  const Kernels& kernels_;
  const ClusterKernels& cluster_kernels_;
  std::size_t lanes_;
  Aligned<double> points_, found_;
  std::span<const Vec3<double>> points_of_;
  std::vector<double> places_, sums_, angles_;
  std::vector<char> left_;
  std::deque<Level> levels_;
};

class ClusteredSum final : public StatedSum {
 public:
  ClusteredSum(std::shared_ptr<const ClusterTree> tree, const AppliesData& exact, CageData data, double error)
      : tree_(std::move(tree)),
        exact_(exact),
        data_(std::move(data)),
        shifted_(*tree_, data_),
        moments_(*tree_, shifted_.data, error),
        error_(error) {}

  int degree() const override { return moments_.degrees()[0]; }

  void fill(std::span<const Vec3<double>> points, int jobs, std::span<double> values,
            std::span<double> errors) const override {
    const std::vector<std::size_t> order = along_a_curve(points);
    for_each_parallel((points.size() + kTogether - 1) / kTogether, jobs, [&](std::size_t i) {
      const auto numbers = std::span(order).subspan(i * kTogether, std::min(kTogether, points.size() - i * kTogether));
      fill_some(points, numbers, values, errors);
    });
  }

 private:
  void fill_some(std::span<const Vec3<double>> points, std::span<const std::size_t> numbers, std::span<double> values,
                 std::span<double> errors) const {
    std::vector<Vec3<double>> here;
    here.reserve(numbers.size());
    for (const std::size_t p : numbers) here.push_back(points[p]);
    Descent descent(*tree_, moments_, shifted_.data);
    descent.run(here);
    std::vector<std::size_t> left;
    std::vector<Vec3<double>> left_points;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double* const sums = descent.sums(i);
      const double turns = std::nearbyint(sums[kComponents]), off = error_ / ClusterMoments::kShares * descent.angle(i);
      if (descent.is_left(i) || !(std::abs(sums[kComponents] - turns) < 0.3) || !(off <= error_)) {
        left.push_back(numbers[i]);
        left_points.push_back(here[i]);
        continue;
      }
      for (int c = 0; c < kComponents; ++c) values[numbers[i] * kComponents + c] = sums[c] + turns * shifted_.middle[c];
      errors[numbers[i]] = off;
    }
    if (left.empty()) return;
    const std::vector<double> found = by_faces(exact_, data_, left_points);
    for (std::size_t i = 0; i < left.size(); ++i) {
      std::copy_n(&found[i * kComponents], kComponents, &values[left[i] * kComponents]);
      errors[left[i]] = 0;
    }
  }

  std::shared_ptr<const ClusterTree> tree_;
  const AppliesData& exact_;
  CageData data_;
  Shifted shifted_;
  ClusterMoments moments_;
  double error_;
};

// Half the diagonal of the box of the vertices' images.
double size_of(const CageData& data) {
  std::array<double, kComponents> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < data.blocks[0].size(); ++i) {
    low[i % kComponents] = std::min(low[i % kComponents], data.blocks[0][i]);
    high[i % kComponents] = std::max(high[i % kComponents], data.blocks[0][i]);
  }
  return std::hypot(high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2, high[2] / 2 - low[2] / 2);
}

// By microseconds of a core, as measured on spheres of 320 to 81,920 faces: a pair of point and face takes 0.045, a
// face's share in expansions 0.0042 p^3, and a point by clusters 8 + 0.015 p^2, with p their degree.
bool is_quicker(double faces, std::size_t points, double degree) {
  const double expanding = 0.0042 * degree * degree * degree, of_point = 8 + 0.015 * degree * degree;
  return static_cast<double>(points) * (0.045 * faces - of_point) > expanding * faces;
}

}  // namespace

std::unique_ptr<const StatedSum> clustered_sum(const Lazy<std::shared_ptr<const ClusterTree>>& tree, int faces,
                                               const AppliesData& exact, const CageData& data, double error,
                                               std::size_t points) {
  if (!is_quicker(faces, points, ClusterMoments::degree_for(size_of(data) / error)))
    return std::make_unique<ExactSum>(exact, data);
  return std::make_unique<ClusteredSum>(tree.get(), exact, data, error);
}

}  // namespace cageproof::closed_form::batch
