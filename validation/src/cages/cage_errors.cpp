// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_errors.h"
#include "cageproof/validation/cage_campaign.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

// Sums of one derivative entry over all coordinates, weighted with one and with positions, and the terms' sizes. A
// number counts as that multiple of the identity, and norms are those of matrices over that of the identity.
struct Sums {
  Mat3<double> ones = Mat3<double>::Zero();
  double ones_size = 0;
  Vec3<double> positions = Vec3<double>::Zero();
  double positions_size = 0;
};

// The identity of space; in the plane the third row and column are zero.
Mat3<double> identity_of(int dim) {
  Mat3<double> identity = Mat3<double>::Zero();
  for (int i = 0; i < dim; ++i) identity(i, i) = 1;
  return identity;
}

double norm_of(const Mat3<double>& m, int dim) {
  return m.reshaped().stableNorm() / std::sqrt(static_cast<double>(dim));
}

Sums sums_of(const CageCoordinates& coordinates, const Cage& cage, const std::vector<Result<double>>& results,
             int order, int derivative) {
  Sums s;
  const int dim = coordinates.dimension();
  const std::size_t derivatives = derivative_count(dim, order);
  for (std::size_t b = 0; b < results.size(); ++b) {
    const CoordinateBlock& block = coordinates.blocks()[b];
    if (block.reproduces == Reproduces::Nothing) continue;
    const bool vertices = block.reproduces != Reproduces::Normals;
    const std::size_t width = block.entries();
    // A number stands for that multiple of the identity, or of the quarter turn.
    Mat3<double> one = identity_of(dim);
    if (block.reproduces == Reproduces::TurnedVertices) one << 0, -1, 0, 1, 0, 0, 0, 0, 0;
    for (int i = 0; i < block.size; ++i) {
      const double* from = &results[b].of(order)[i * width * derivatives + derivative];
      Mat3<double> c = *from * one;
      for (std::size_t e = 0; width > 1 && e < width; ++e) c(e / dim, e % dim) = from[e * derivatives];
      const Vec3<double> v = vertices
                                 ? cage.vertices()[i]
                                 : Vec3<double>(block.normal_factor * coordinates.elements().normal_of(i, block.owner));
      s.positions += c * v;
      s.positions_size += norm_of(c, dim) * v.stableNorm();
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

void keep_worst(CageError& worst, const CageError& error) {
  if (!(worst.roundings >= error.roundings)) worst.roundings = error.roundings;
  if (!(worst.relative >= error.relative)) worst.relative = error.relative;
}

// An error of this size, in roundings of terms of one size and relative to another.
CageError error_of(double error, double of_terms, double size) {
  return {over(error, unit_roundoff<double>() * of_terms), over(error, size)};
}

CageError laplacian_error(const CageCoordinates& coordinates, const std::vector<Result<double>>& results,
                          const TermSizes& terms) {
  using Trace = CoordinateBlock::Trace;
  CageError worst;
  const std::size_t dim = coordinates.dimension();
  for (std::size_t b = 0; b < results.size(); ++b) {
    const Trace& expected = coordinates.blocks()[b].trace;
    if (expected.kind == Trace::Kind::Unknown) continue;
    const bool has_partner = expected.kind == Trace::Kind::Block;
    const std::vector<double>* partner = has_partner ? &results[expected.block].value : nullptr;
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < results[b].value.size(); ++i) {
      double trace = partner ? -(*partner)[i] : 0;
      for (std::size_t a = 0; a < dim * dim; ++a) {
        const double h = results[b].hessian[dim * dim * i + a];
        size = std::hypot(size, h);
        if (a % (dim + 1) == 0) trace += h;
      }
      difference = std::hypot(difference, trace);
    }
    const double of_terms = terms.blocks[b][2] + (has_partner ? terms.blocks[expected.block][0] : 0);
    keep_worst(worst, error_of(difference, of_terms, size));
  }
  return worst;
}

// In roundings of the terms of their sum.
CageError negative_part(const CageCoordinates& coordinates, const std::vector<Result<double>>& blocks,
                        double of_terms) {
  double least = 0;
  bool any = false;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const CoordinateBlock& block = coordinates.blocks()[b];
    if (block.reproduces != Reproduces::Vertices || block.entries() != 1) continue;
    any = true;
    for (const double x : blocks[b].value)
      if (!(x >= least)) least = x;  // also what is no number
  }
  return any ? error_of(-least, of_terms, 1) : CageError();
}

}  // namespace

std::array<std::optional<double>, 2> boundary_residuals(const CageCoordinates& coordinates) {
  std::array<std::optional<double>, 2> worst;
  // Others would solve their systems once more to say nothing of it.
  if (!coordinates.measures_boundary()) return worst;
  const auto keep = [](std::optional<double>& of, double found) {
    // A NaN stays, once it is found.
    if (!of || (!std::isnan(*of) && !(found <= *of))) of = found;
  };
  for (const SolvedSystem& system : coordinates.solved()) {
    keep(worst[0], system.boundary_values);
    // Harmonic functions have only values as data.
    if (!std::isnan(system.boundary_gradients)) keep(worst[1], system.boundary_gradients);
  }
  return worst;
}

std::optional<CageCoordinates> prior_of(const Cage& cage, const CoordinateKind& kind, Triangulation rule) {
  if (kind.missing_because.empty() || kind.inside_alone) return std::nullopt;
  return CageCoordinates(cage, coordinate_kind_named("quad_mean_value"), CoordinateOptions{.triangulation = rule});
}

bool may_be_missing(const std::optional<CageCoordinates>& prior, const Vec3<double>& point) {
  if (!prior) return false;
  const std::vector<double> weights = prior->at<double>(point, 0).front().value;
  // Next to a zero rounding decides.
  return std::ranges::any_of(weights, [](double w) { return w < 1e-10; });
}

double expected_sum(const CoordinateKind& kind, Place place) {
  return kind.normalised || place != Place::Outside ? 1 : 0;
}

double expected_sum(const CoordinateKind& kind, const CageLocator& locator, const Vec3<double>& point) {
  return kind.normalised ? 1 : locator.winding(point);
}

namespace {

// \param terms sizes at the point, where they are known
CageErrors errors_with(const CageCoordinates& coordinates, const Cage& cage, const std::vector<Result<double>>& blocks,
                       const Vec3<double>& point, double expected, int order, const TermSizes* terms) {
  CageErrors errors{};
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
      // Not by squares, which may leave the range of numbers.
      ones = std::hypot(ones, one);
      positions = std::hypot(positions, position.stableNorm());
      ones_size = std::hypot(ones_size, s.ones_size);
      positions_size = std::hypot(positions_size, s.positions_size);
    }
    // A rule's coordinates may be larger than the terms that the recommended ones have.
    const double terms_of_ones = terms ? std::max(terms->ones[o], ones_size) : ones_size;
    errors.partition[o] = error_of(ones, terms_of_ones, o == 0 ? 1 : ones_size);
    if (o == 0) errors.negative = negative_part(coordinates, blocks, terms_of_ones);
    errors.reproduction[o] =
        error_of(positions, terms ? terms->positions[o] : positions_size, o == 0 ? cage.size() : positions_size);
  }
  if (order >= 2 && terms) errors.laplacian = laplacian_error(coordinates, blocks, *terms);
  return errors;
}

}  // namespace

CageErrors errors_of(const CageCoordinates& coordinates, const Cage& cage, const std::vector<Result<double>>& blocks,
                     const Vec3<double>& point, double expected, int order) {
  return errors_with(coordinates, cage, blocks, point, expected, order, nullptr);
}

CageErrors errors_at(const CageCoordinates& coordinates, const Cage& cage, const Vec3<double>& point, double expected,
                     int order, const CageTerms* terms) {
  const auto blocks = coordinates.at<double>(point, order);
  if (!coordinates.kind().missing_because.empty() && std::isnan(blocks[0].value[0])) return {};
  if (terms == nullptr) return errors_of(coordinates, cage, blocks, point, expected, order);
  const TermSizes of_terms = terms->at(point, order);
  return errors_with(coordinates, cage, blocks, point, expected, order, &of_terms);
}

std::array<CageError, 3> truth_errors_at(const CageCoordinates& coordinates, const CageCoordinates& reference,
                                         const Vec3<double>& point, int order, const CageTerms* terms) {
  std::array<CageError, 3> worst;
  const auto found = coordinates.at<double>(point, order);
  const auto truth = reference.at<Mp50>(convert<Mp50>(point), order);
  const TermSizes of_terms = terms ? terms->at(point, order) : TermSizes{};
  for (int o = 0; o <= order; ++o)
    for (std::size_t b = 0; b < found.size(); ++b) {
      Mp50 error = 0, size = 0;
      for (std::size_t i = 0; i < found[b].of(o).size(); ++i) {
        const Mp50 d = Mp50(found[b].of(o)[i]) - truth[b].of(o)[i];
        error += d * d;
        size += truth[b].of(o)[i] * truth[b].of(o)[i];
      }
      if (!isfinite(size)) continue;
      const auto norm = static_cast<double>(Mp50(sqrt(size)));
      keep_worst(worst[o],
                 error_of(static_cast<double>(Mp50(sqrt(error))), terms ? of_terms.blocks[b][o] : norm, norm));
    }
  return worst;
}

}  // namespace cageproof::validation
