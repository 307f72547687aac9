// SPDX-License-Identifier: MIT
#include "cageproof/adaptive_qmvc/maximum_entropy.h"

#include "cageproof/core/coordinates.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::adaptive_qmvc {
namespace {

using Vec = Vec3<double>;
constexpr int kSteps = 500;

struct Vertex {
  Vec offset;  // from the point, in sizes
  double log_prior;
  std::size_t index;
};

// log Z at t, its gradient -sum lambda_i offset_i, and the coordinates.
struct Potential {
  double value;
  Vec gradient = Vec::Zero();
  std::vector<double> lambda;

  Potential(const std::vector<Vertex>& vertices, const Vec& t) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vertex& v : vertices) lambda.push_back(v.log_prior - t.dot(v.offset)), highest = std::max(highest, lambda.back());
    double sum = 0;
    for (double& l : lambda) sum += l = std::exp(l - highest);
    value = highest + std::log(sum);
    for (std::size_t i = 0; i < vertices.size(); ++i) gradient -= (lambda[i] /= sum) * vertices[i].offset;
  }

  // The covariance of the offsets; a trace of its size keeps it definite where the vertices in play span no volume.
  Vec newton_step(const std::vector<Vertex>& vertices) const {
    Mat3<double> hessian = Mat3<double>::Zero();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec d = vertices[i].offset + gradient;
      hessian += lambda[i] * d * d.transpose();
    }
    hessian += (1e-16 * hessian.trace() + std::numeric_limits<double>::min()) * Mat3<double>::Identity();
    return -hessian.ldlt().solve(gradient);
  }
};

}  // namespace

std::vector<double> maximum_entropy(std::span<const Vec> vertices, std::span<const double> prior, const Vec& point, double size) {
  const std::vector<double> none(prior.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<Vertex> active;
  double least = 0;
  for (std::size_t i = 0; i < prior.size(); ++i) {
    if (!std::isfinite(prior[i])) return none;
    if (!(prior[i] > 0)) continue;
    active.push_back({(vertices[i] - point) / size, std::log(prior[i]), i});
    least = active.size() == 1 ? active.back().log_prior : std::min(least, active.back().log_prior);
  }
  if (active.empty()) return none;
  Vec t = Vec::Zero();
  Potential at(active, t);
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  for (int step = 0; step < kSteps && at.gradient.norm() > 4 * u; ++step) {
    // Within the hull some vertex lies against t, so that Z is at least its prior: below the least prior there is no solution.
    if (at.value < least - 1e-6) return none;
    const Vec p = at.newton_step(active);
    bool better = false;
    for (double length = 1; length > 1e-12 && !better; length /= 2) {
      const Potential next(active, t + length * p);
      better = next.value <= at.value + 1e-4 * length * at.gradient.dot(p) && next.value < at.value;
      better = better || next.gradient.norm() < 0.9 * at.gradient.norm();
      if (!better) continue;
      t += length * p;
      at = next;
    }
    if (!better) break;
  }
  if (!(at.gradient.norm() <= 1e-13)) return none;
  std::vector<double> coordinates(prior.size(), 0.0);
  for (std::size_t i = 0; i < active.size(); ++i) coordinates[active[i].index] = at.lambda[i];
  return coordinates;
}

namespace {

const RegisterCoordinateKind kind{
    {.name = "maximum_entropy",
     .source = "Hormann, Sukumar 2008; [T18] Section 5",
     .blocks = {{"lambda", "triangle.mean_value", CoordinateBlock::Reproduces::Vertices, nullptr, "quad.mean_value"}},
     .normalised = true,
     .direct = [](const Cage& cage, std::string_view evaluation) -> DirectCoordinates {
       const auto prior =
           std::make_shared<const CageCoordinates>(cage, *find_coordinate_kind("quad_mean_value"), evaluation, Triangulation::Shortest);
       return [prior, vertices = cage.vertices(), size = cage.size()](const Vec& point) {
         std::vector<double> m = prior->at<double>(point, 0).front().value;
         for (double& x : m) x = x < 0 ? 0 : x;
         return maximum_entropy(vertices, m, point, size);
       };
     },
     .missing_because = "outside the convex hull of the vertices whose quad mean value coordinates are positive, there are no positive coordinates"}};

}  // namespace
}  // namespace cageproof::adaptive_qmvc
