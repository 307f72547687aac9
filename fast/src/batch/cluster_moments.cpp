// SPDX-License-Identifier: MIT
#include "cluster_moments.h"

#include "aligned.h"
#include "cluster_error.h"
#include "cluster_kernels.h"
#include "far_rules.h"
#include "kernels.h"

#include "cageproof/core/numbers/scalar.h"
#include "cageproof/core/parallel.h"

#include <algorithm>
#include <cmath>

namespace cageproof::closed_form::batch {
namespace {

// How a cluster's error is shared out: terms beyond the degree take the first part, Gauss points for faces the second.
constexpr double kForTerms = 0.875, kForPoints = 0.125;
// Clusters are taken from no nearer than their radii over this.
constexpr double kNearest = 0.75;
// The ratio at which the highest degree is to be enough for a usual cluster.
constexpr double kUsualRatio = 0.45, kUsualDensity = 0.3;

double norm_of(const double* x) { return std::hypot(x[0], x[1], x[2]); }

std::array<double, 3> centroid_of(const CageTables& tables, int f) {
  return {tables.centroid[f], tables.centroid[tables.stride + f], tables.centroid[2 * tables.stride + f]};
}

// Collects sources until the vectors that are taken together are full.
class Sources {
 public:
  explicit Sources(int order)
      : kernels_(cluster_kernels()),
        lanes_(kernels().lanes),
        together_(kMomentBlocks * lanes_),
        numbers_(zeros(kNumbers * together_)),
        scratch_(zeros(6 * (order + 1) * together_)),
        sums_(zeros((order + 1) * (order + 2) * kMomentSets * lanes_)) {
    sources_ = {order,
                numbers_.get(),
                numbers_.get() + 3 * together_,
                numbers_.get() + 6 * together_,
                numbers_.get() + (6 + kMomentSets) * together_,
                scratch_.get(),
                sums_.get()};
  }

  void add(const std::array<double, 3>& place, const double* normal, const std::array<double, kMomentSets>& charge,
           const std::array<double, kMomentSets>& dipole) {
    double* to = numbers_.get() + count_;
    const auto put = [&](const double* from, int count) {
      for (int i = 0; i < count; ++i, to += together_) *to = from[i];
    };
    put(place.data(), 3);
    put(normal, 3);
    put(charge.data(), kMomentSets);
    put(dipole.data(), kMomentSets);
    if (++count_ == together_) flush();
  }

  // The moments as FarCluster takes them.
  std::vector<double> moments() {
    // The places that are left over get sources without strength.
    for (int i = 6; i < kNumbers; ++i) std::fill_n(&numbers_[i * together_ + count_], together_ - count_, 0.0);
    flush();
    std::vector<double> found;
    found.reserve(moment_count(sources_.order));
    for (int m = 0; m <= sources_.order; ++m)
      for (int l = m; l <= sources_.order; ++l)
        for (int part = 0; part < (m == 0 ? 1 : 2); ++part)
          for (int s = 0; s < kMomentSets; ++s) {
            const double* const from = sums_.get() + (((l * (l + 1) / 2 + m) * 2 + part) * kMomentSets + s) *
                                                         static_cast<std::ptrdiff_t>(lanes_);
            double sum = 0;
            for (int p = 0; p < lanes_; ++p) sum += from[p];
            found.push_back(m == 0 ? sum : 2 * sum);
          }
    return found;
  }

 private:
  void flush() {
    kernels_.add_moments(sources_);
    count_ = 0;
  }

  static constexpr int kNumbers = 6 + 2 * kMomentSets;  // of a source
  static Aligned<double> zeros(int count) {
    Aligned<double> all = aligned<double>(static_cast<std::size_t>(count));
    std::fill_n(all.get(), count, 0.0);
    return all;
  }

  const ClusterKernels& kernels_;
  int lanes_, together_, count_ = 0;
  Aligned<double> numbers_, scratch_, sums_;
  MomentSources sources_{};
};

}  // namespace

// Sums over a cluster's faces: areas times densities.
struct ClusterMoments::Densities {
  double charge = 0, dipole = 0;
};

ClusterMoments::ClusterMoments(const ClusterTree& tree, const ClusterData& data, double error)
    : tree_(tree), data_(data), tables_(tree.whole().tables()), share_(error / kShares) {
  double size = 0;
  for (int f = 0; f < tables_.faces; ++f) {
    double largest = 0;
    for (const int v : tables_.face[f].vertex)
      largest = std::max(largest, norm_of(&data.vertex[static_cast<std::size_t>(v) * kMomentSets]));
    size = std::max(size, largest);
    // The sum of coordinates, the last function, is to be within a quarter of a whole number.
    dipole_.push_back(std::max(largest, 4 * error));
    charge_.push_back(norm_of(&data.face[static_cast<std::size_t>(f) * kMomentSets]));
  }
  degrees_[0] = degree_for(size / error);
  for (int k = 1; k < kDegrees; ++k) degrees_[k] = std::max(1, degrees_[0] * (6 - k) / 6);
  // The more an expansion costs, the more faces are summed one by one.
  least_ = degrees_[0] <= 16 ? 24 : degrees_[0] <= 28 ? 48 : 96;
  const std::size_t count = tree.clusters().size();
  std::vector<char> is_within_least(count, 0);
  for (std::size_t c = 0; c < count; ++c)
    for (const int child : tree.clusters()[c].child)
      if (child >= 0) is_within_least[child] = is_within_least[c] != 0 || tree.clusters()[c].size() <= least_;
  from_.resize(count);
  moments_.resize(count);
  for (auto& from : from_) from.fill(std::numeric_limits<double>::infinity());
  for_ranges_parallel(count, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c)
      if (is_within_least[c] == 0) prepare(static_cast<int>(c));
  });
}

void ClusterMoments::prepare(int c) {
  const Cluster& cluster = tree_.clusters()[c];
  Densities densities;
  for (const int f : tree_.faces(cluster)) {
    const double area = tables_.face[f].area2 / 2;
    densities.charge += area * charge_[f];
    densities.dipole += area * dipole_[f];
  }
  double least = distance_for(cluster, densities, degrees_[0]);
  // Points inside the cage are no farther.
  const std::array<double, 3> centre = tree_.whole().centre();
  const double farthest =
      tree_.whole().radius() +
      std::hypot(centre[0] - cluster.centre[0], centre[1] - cluster.centre[1], centre[2] - cluster.centre[2]);
  std::vector<int> rules;
  while (least < farthest && !find_rules(cluster, least, rules)) least *= 1.25;
  if (!(least < farthest)) return;
  for (int k = 0; k < kDegrees; ++k) {
    const double distance = k == 0 ? least : std::max(least, distance_for(cluster, densities, degrees_[k]));
    from_[c][k] = distance * distance;
  }
  expand(c, rules);
}

int ClusterMoments::degree_for(double errors) {
  int degree = 2;
  while (degree < kMostMomentOrder &&
         kUsualDensity * errors * cut_off_double(degree, kUsualRatio) > kForTerms / kShares)
    ++degree;
  return degree;
}

// By bisection: what is cut off falls with the distance.
double ClusterMoments::distance_for(const Cluster& cluster, const Densities& densities, int degree) const {
  const auto is_enough = [&](double rho) {
    return densities.charge * cluster.radius * cut_off_single(degree, rho) / rho +
               densities.dipole * cut_off_double(degree, rho) <=
           kForTerms * share_ * cluster.area;
  };
  double low = 0, high = kNearest;
  if (is_enough(high)) return cluster.radius / high;
  for (int i = 0; i < 30; ++i) {
    const double middle = (low + high) / 2;
    (is_enough(middle) ? low : high) = middle;
  }
  return cluster.radius / low;
}

// The least rules whose points stand for the faces from that distance on. Both are expanded alike up to the rule's
// degree, about the face's centroid, and weights are positive. \return false where some face has none
bool ClusterMoments::find_rules(const Cluster& cluster, double distance, std::vector<int>& rules) const {
  rules.clear();
  for (const int f : tree_.faces(cluster)) {
    const std::array<double, 3> centroid = centroid_of(tables_, f);
    const double nearest = distance - std::hypot(centroid[0] - cluster.centre[0], centroid[1] - cluster.centre[1],
                                                 centroid[2] - cluster.centre[2]);
    const double size = 1 / std::sqrt(tables_.over_square[f]), rho = size / nearest;
    if (!(nearest > 0 && rho < kNearest)) return false;
    const auto is_enough = [&](const FarRule& rule) {
      return 2 * distance * distance *
                 (charge_[f] * cut_off_single(rule.degree, rho) / nearest +
                  dipole_[f] * cut_off_double(rule.degree, rho) / (nearest * nearest)) <=
             kForPoints * share_;
    };
    const FarRule* const found = std::find_if(tables_.rules, tables_.rules + kFarRules, is_enough);
    if (found == tables_.rules + kFarRules) return false;
    rules.push_back(static_cast<int>(found - tables_.rules));
  }
  return true;
}

void ClusterMoments::expand(int number, const std::vector<int>& rules) {
  const Cluster& cluster = tree_.clusters()[number];
  const double over = 1 / cluster.radius;
  Sources sources(degrees_[0]);
  const std::span<const int> faces = tree_.faces(cluster);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const FaceTable<double>& face = tables_.face[faces[i]];
    const FarRule& rule = tables_.rules[rules[i]];
    std::array<const double*, 3> corner, density;
    for (int k = 0; k < 3; ++k) {
      corner[k] = tables_.vertex + 3 * static_cast<std::ptrdiff_t>(face.vertex[k]);
      density[k] = &data_.vertex[static_cast<std::size_t>(face.vertex[k]) * kMomentSets];
    }
    const double* const pole = &data_.face[static_cast<std::size_t>(faces[i]) * kMomentSets];
    for (int node = 0; node < rule.nodes; ++node) {
      const double a = rule.along[0][node], b = rule.along[1][node];
      const double weight = rule.weight[node][3] * face.area2 / (8 * pi<double>()) * over;
      std::array<double, 3> place;
      for (int c = 0; c < 3; ++c)
        place[c] = over * (corner[0][c] - cluster.centre[c] + a * (corner[1][c] - corner[0][c]) +
                           b * (corner[2][c] - corner[0][c]));
      std::array<double, kMomentSets> charge, dipole;
      for (int s = 0; s < kMomentSets; ++s) {
        charge[s] = weight * pole[s];
        dipole[s] = -weight * over *
                    (density[0][s] + a * (density[1][s] - density[0][s]) + b * (density[2][s] - density[0][s]));
      }
      sources.add(place, face.n, charge, dipole);
    }
  }
  moments_[number] = sources.moments();
}

}  // namespace cageproof::closed_form::batch
