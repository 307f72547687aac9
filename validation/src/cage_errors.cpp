// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_campaign.h"

#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Sums of one derivative entry over all coordinates, weighted with one and with positions, and the terms' sizes. A
// number counts as that multiple of the identity, and norms are those of matrices over that of the identity.
struct Sums {
  Mat3<double> ones = Mat3<double>::Zero();
  double ones_size = 0;
  Vec3<double> positions = Vec3<double>::Zero();
  double positions_size = 0;
};

// Of the space; in the plane the third row and column are zero.
Mat3<double> identity_of(int dim) {
  Mat3<double> identity = Mat3<double>::Zero();
  for (int i = 0; i < dim; ++i) identity(i, i) = 1;
  return identity;
}

double norm_of(const Mat3<double>& m, int dim) { return m.norm() / std::sqrt(static_cast<double>(dim)); }

Sums sums_of(const CageCoordinates& coordinates, const Cage& cage, const std::vector<Result<double>>& results,
             int order, int derivative) {
  Sums s;
  const int dim = coordinates.dimension();
  const std::size_t derivatives = derivative_count(dim, order);
  for (std::size_t b = 0; b < results.size(); ++b) {
    const CoordinateBlock& block = coordinates.blocks()[b];
    if (block.reproduces == Reproduces::Nothing) continue;
    const bool vertices = block.reproduces == Reproduces::Vertices;
    const std::size_t width = block.entries();
    for (int i = 0; i < block.size; ++i) {
      const double* from = &results[b].of(order)[i * width * derivatives + derivative];
      Mat3<double> c = *from * identity_of(dim);
      for (std::size_t e = 0; width > 1 && e < width; ++e) c(e / dim, e % dim) = from[e * derivatives];
      const Vec3<double> v =
          vertices ? cage.vertices()[i] : Vec3<double>(block.normal_factor * coordinates.elements().normals()[i]);
      s.positions += c * v;
      s.positions_size += norm_of(c, dim) * v.norm();
      if (!vertices) continue;
      s.ones += c;
      s.ones_size += norm_of(c, dim);
    }
  }
  return s;
}

double over(double error, double size) {
  if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
  return error == 0 ? 0 : error / size;
}

double laplacian_error(const CageCoordinates& coordinates, const std::vector<Result<double>>& results) {
  using Trace = CoordinateBlock::Trace;
  double worst = nan;
  const std::size_t dim = coordinates.dimension();
  for (std::size_t b = 0; b < results.size(); ++b) {
    const Trace& expected = coordinates.blocks()[b].trace;
    if (expected.kind == Trace::Kind::Unknown) continue;
    const std::vector<double>* partner = expected.kind == Trace::Kind::Block ? &results[expected.block].value : nullptr;
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < results[b].value.size(); ++i) {
      double trace = partner ? -(*partner)[i] : 0;
      for (std::size_t a = 0; a < dim * dim; ++a) {
        const double h = results[b].hessian[dim * dim * i + a];
        size += h * h;
        if (a % (dim + 1) == 0) trace += h;
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
  if (!coordinates.kind().missing_because.empty() && std::isnan(blocks[0].value[0])) return errors;
  const int dim = coordinates.dimension();
  for (int o = 0; o <= order; ++o) {
    const int entries = static_cast<int>(derivative_count(dim, o));
    double ones = 0, positions = 0, ones_size = 0, positions_size = 0;
    for (int e = 0; e < entries; ++e) {
      const Sums s = sums_of(coordinates, cage, blocks, o, e);
      const double one = norm_of(s.ones - (o == 0 ? expected : 0) * identity_of(dim), dim);
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
  const auto truth = reference.at<Mp50>(convert<Mp50>(point), order);
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
