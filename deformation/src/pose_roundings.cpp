// SPDX-License-Identifier: MIT
#include "pose_roundings.h"

#include "cageproof/core/geometry/box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace cageproof::deformation {
namespace {

// Rounding a pose's vertices may move images by so much of the posed cage's size without a warning.
constexpr double most_moved = 1e-12;

// Before each element, as far from it as it is long, or as much less as keeps them inside: samples are on the cage
// itself, where many methods' images are right whatever densities are.
std::vector<Vec3<double>> points_within(const CageCoordinates& coordinates) {
  const CageElements& elements = coordinates.elements();
  std::vector<Vec3<double>> found;
  found.reserve(elements.count());
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.corners(e);
    Vec3<double> middle = Vec3<double>::Zero();
    for (const Vec3<double>& corner : corners) middle += corner / static_cast<double>(corners.size());
    for (double step = (corners[1] - corners[0]).stableNorm(), halvings = 0; halvings < 50; step /= 2, ++halvings) {
      const Vec3<double> point = middle - step * elements.normals()[e];
      const auto phi = coordinates.at<double>(std::span(&point, 1), 0)[0];
      // One inside, nothing outside.
      if (std::accumulate(phi.tensors[0].begin(), phi.tensors[0].end(), 0.) < .5) continue;
      found.push_back(point);
      break;
    }
  }
  return found;
}

// Vertices one unit of their last digits off, each another way.
std::vector<Vec3<double>> next_to(std::vector<Vec3<double>> vertices) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::minstd_rand random(20);
  for (Vec3<double>& v : vertices)
    for (double& x : v)
      if (x != 0) x = std::nextafter(x, random() % 2 == 0 ? infinity : -infinity);
  return vertices;
}

// A pose with a report of more.
class Reported final : public Posed<double> {
 public:
  Reported(std::unique_ptr<const Posed<double>> posed, DeformationReport report)
      : posed_(std::move(posed)), report_(std::move(report)) {}

  Images<double> images(std::span<const CoordinateTable<double>> coordinates, std::size_t points,
                        int order) const override {
    return posed_->images(coordinates, points, order);
  }
  const DeformationReport& report() const override { return report_; }
  std::vector<Vec3<double>> vertices() const override { return posed_->vertices(); }
  const Posed<double>& posed() const { return *posed_; }

 private:
  std::unique_ptr<const Posed<double>> posed_;
  DeformationReport report_;
};

class Stating final : public Deformer<double> {
 public:
  Stating(std::shared_ptr<const Deformer<double>> deformer, std::shared_ptr<const PoseRoundings> roundings)
      : deformer_(std::move(deformer)), roundings_(std::move(roundings)) {}

  const CageCoordinates& coordinates() const override { return deformer_->coordinates(); }
  int max_order() const override { return deformer_->max_order(); }
  DeformationReport prepared() const override { return deformer_->prepared(); }
  std::shared_ptr<const Deformer<double>> with_parameters(const std::vector<double>& parameters) const override {
    auto other = deformer_->with_parameters(parameters);
    return other ? std::make_shared<Stating>(std::move(other), roundings_) : nullptr;
  }

  std::unique_ptr<const Posed<double>> pose(const Pose<double>& pose) const override {
    auto posed = deformer_->pose(pose);
    if (roundings_->is_rest(pose.vertices)) return posed;
    Pose<double> other = pose;
    other.vertices = next_to(pose.vertices);
    std::vector<double> moved = roundings_->images(*posed);
    const std::vector<double> images = roundings_->images(*deformer_->pose(other));
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] -= images[i];
    DeformationReport report = posed->report();
    roundings_->state(moved, pose.vertices, report);
    return std::make_unique<Reported>(std::move(posed), std::move(report));
  }
  std::unique_ptr<const PoseDerivative<double>> derivative(const Pose<double>& pose) const override {
    return deformer_->derivative(pose);
  }

 private:
  std::shared_ptr<const Deformer<double>> deformer_;
  std::shared_ptr<const PoseRoundings> roundings_;
};

}  // namespace

PoseRoundings::PoseRoundings(const CageCoordinates& coordinates, std::string where)
    : rest_(coordinates.elements().vertices()),
      within_(points_within(coordinates)),
      tables_(coordinates.at<double>(within_, 0)),
      where_(std::move(where)) {}

bool PoseRoundings::is_rest(const std::vector<Vec3<double>>& posed) const {
  for (std::size_t v = 0; v < rest_.size(); ++v)
    if (posed[v] - posed[0] != rest_[v] - rest_[0]) return false;
  return true;
}

std::vector<double> PoseRoundings::images(const Posed<double>& posed) const {
  return posed.images(tables_, within_.size(), 0).tensors[0];
}

void PoseRoundings::state(const std::vector<double>& moved, const std::vector<Vec3<double>>& posed,
                          DeformationReport& report) const {
  double most = 0;
  for (const double step : moved) most = std::max(most, std::abs(step));
  const auto [low, high] = box_of(posed);
  report.pose_rounding = most / (high - low).stableNorm();
  if (report.pose_rounding > most_moved)
    report.warnings.push_back(fmt::format(
        "posed vertices are rounded to double, and images are off by about {:.0e} of the posed cage's size with "
        "them: {}",
        report.pose_rounding, where_));
}

std::vector<Vec3<Mp50>> nudged(std::vector<Vec3<Mp50>> vertices) {
  using std::abs;
  std::minstd_rand random(20);
  for (Vec3<Mp50>& v : vertices)
    for (Mp50& x : v) {
      const double share = 2. * static_cast<double>(random()) / std::minstd_rand::max() - 1;
      x += share * unit_roundoff<double>() * abs(x);
    }
  return vertices;
}

const Posed<double>& without_report(const Posed<double>& posed) {
  const auto* const reported = dynamic_cast<const Reported*>(&posed);
  return reported == nullptr ? posed : reported->posed();
}

std::shared_ptr<const Deformer<double>> stating_pose_roundings(std::shared_ptr<const Deformer<double>> deformer,
                                                               std::string where) {
  auto roundings = std::make_shared<const PoseRoundings>(deformer->coordinates(), std::move(where));
  return std::make_shared<Stating>(std::move(deformer), std::move(roundings));
}

}  // namespace cageproof::deformation
