// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_campaign.h"

#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Sums of one derivative entry over all coordinates, weighted with one and with positions, and the terms' sizes.
struct Sums {
  double ones = 0, ones_size = 0;
  Vec3<double> positions = Vec3<double>::Zero();
  double positions_size = 0;
};

Sums sums_of(const CageCoordinates& coordinates, const Cage& cage, const std::vector<Result<double>>& blocks, int order,
             int entry) {
  Sums s;
  const int entries = order == 0 ? 1 : order == 1 ? 3 : 9;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto reproduces = coordinates.kind().blocks[b].reproduces;
    if (reproduces == CoordinateBlock::Reproduces::Nothing) continue;
    const bool vertices = reproduces == CoordinateBlock::Reproduces::Vertices;
    for (int i = 0; i < coordinates.size(static_cast<int>(b)); ++i) {
      const double c = blocks[b].of(order)[static_cast<std::size_t>(i) * entries + entry];
      const Vec3<double>& v = vertices ? cage.vertices()[i] : coordinates.normals()[i];
      s.positions += c * v;
      s.positions_size += std::abs(c) * v.norm();
      if (!vertices) continue;
      s.ones += c;
      s.ones_size += std::abs(c);
    }
  }
  return s;
}

double over(double error, double size) {
  if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
  return error == 0 ? 0 : error / size;
}

double laplacian_error(const CageCoordinates& coordinates, const std::vector<Result<double>>& blocks) {
  double worst = nan;
  const auto& kind = coordinates.kind();
  for (std::size_t b = 0; b < blocks.size() && !kind.normalised; ++b) {
    const Formula& formula = *find_formula(kind.blocks[b].formula);
    const std::vector<double>* partner = nullptr;
    if (formula.laplacian.kind == Laplacian::Kind::Unknown) continue;
    for (std::size_t other = 0; other < blocks.size(); ++other)
      if (kind.blocks[other].formula == formula.laplacian.formula) partner = &blocks[other].value;
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < blocks[b].value.size(); ++i) {
      double trace = partner ? -(*partner)[i] : 0;
      for (int a = 0; a < 9; ++a) {
        const double h = blocks[b].hessian[9 * i + a];
        size += h * h;
        if (a % 4 == 0) trace += h;
      }
      difference += trace * trace;
    }
    const double error = over(std::sqrt(difference), std::sqrt(size));
    if (!(worst >= error)) worst = error;
  }
  return worst;
}

}  // namespace

double expected_sum(const CoordinateKind& kind, Place place) {
  return kind.normalised || place != Place::Outside ? 1 : 0;
}

CageErrors errors_at(const CageCoordinates& coordinates, const Cage& cage, const Vec3<double>& point, double expected,
                     int order) {
  CageErrors errors{{nan, nan, nan}, {nan, nan, nan}, nan};
  const auto blocks = coordinates.at<double>(point, order);
  for (int o = 0; o <= order; ++o) {
    const int entries = o == 0 ? 1 : o == 1 ? 3 : 9;
    double ones = 0, positions = 0, ones_size = 0, positions_size = 0;
    for (int e = 0; e < entries; ++e) {
      const Sums s = sums_of(coordinates, cage, blocks, o, e);
      const double one = o == 0 ? s.ones - expected : s.ones;
      Vec3<double> position = s.positions;
      if (o == 0) position -= expected * point;
      if (o == 1) position[e] -= expected;
      ones += one * one;
      positions += position.squaredNorm();
      ones_size += s.ones_size * s.ones_size;
      positions_size += s.positions_size * s.positions_size;
    }
    errors.partition[o] = over(std::sqrt(ones), o == 0 ? 1 : std::sqrt(ones_size));
    errors.reproduction[o] = over(std::sqrt(positions), o == 0 ? cage.size() : std::sqrt(positions_size));
  }
  if (order >= 2) errors.laplacian = laplacian_error(coordinates, blocks);
  return errors;
}

std::array<double, 3> truth_errors_at(const CageCoordinates& coordinates, const CageCoordinates& reference,
                                      const Vec3<double>& point, int order) {
  std::array<double, 3> worst{nan, nan, nan};
  const auto found = coordinates.at<double>(point, order);
  const auto truth = reference.at<Mp50>(point, order);
  for (int o = 0; o <= order; ++o)
    for (std::size_t b = 0; b < found.size(); ++b) {
      Mp50 error = 0, size = 0;
      for (std::size_t i = 0; i < found[b].of(o).size(); ++i) {
        const Mp50 d = Mp50(found[b].of(o)[i]) - truth[b].of(o)[i];
        error += d * d;
        size += truth[b].of(o)[i] * truth[b].of(o)[i];
      }
      if (!isfinite(size)) continue;
      const double relative = over(static_cast<double>(Mp50(sqrt(error))), static_cast<double>(Mp50(sqrt(size))));
      if (!(worst[o] >= relative)) worst[o] = relative;
    }
  return worst;
}

}  // namespace cageproof::validation
