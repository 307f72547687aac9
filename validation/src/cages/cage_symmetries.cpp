// SPDX-License-Identifier: MIT
#include "cageproof/validation/cage_errors.h"
#include "cage_symmetries.h"

#include "element/element_sampling.h"
#include "sampling/generic_direction.h"
#include "truth/logarithmic_part.h"
#include "checks/turn.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cageproof::validation {
namespace {

constexpr double kScale = 0x1p10;  // a power of two, so that the scaled input is exact

// \param least what the difference is divided by at least, squared
template <Scalar R>
double relative_difference(const std::vector<R>& a, const std::vector<R>& b, const R& least = R(0)) {
  R error = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    error += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  if (size < least) size = least;
  using std::isfinite, std::sqrt;
  if (!isfinite(error) || !isfinite(size)) return std::numeric_limits<double>::infinity();
  return error == 0 ? 0 : static_cast<double>(R(sqrt(R(error / size))));
}

// New corners along edges come first, in the edges' order, then those within.
std::pair<int, int> rank_of_corner(const std::array<double, 4>& basis, int corners) {
  int along = 0;
  while (along < corners && (basis[along] == 0 || basis[(along + 1) % corners] == 0)) ++along;
  return {corners - static_cast<int>(std::ranges::count(std::span(basis).first(corners), 0.0)), along};
}

// The vertices, rounded so that points amid up to four of them are doubles: to a quarter of the digits that the largest
// coordinate along an axis has. Rounded corners of parts would be those of another cage, from which flat ones differ.
// The vertices themselves where that changes an edge by more than a billionth.
std::vector<Vec3<double>> with_exact_midpoints(const CageElements& elements) {
  const std::vector<Vec3<double>>& vertices = elements.vertices();
  std::vector<Vec3<double>> found = vertices;
  for (int c = 0; c < 3; ++c) {
    double largest = 0;
    for (const Vec3<double>& v : vertices) largest = std::max(largest, std::abs(v[c]));
    // In the plane all are zero along the third axis.
    if (largest == 0) continue;
    const double unit = std::ldexp(1., std::ilogb(largest) - 50);
    for (Vec3<double>& v : found)
      if (std::isnormal(unit)) v[c] = std::round(v[c] / unit) * unit;
  }
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const auto corners = elements.vertices_of(e);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const int from = corners[k], to = corners[(k + 1) % corners.size()];
      const Vec3<double> edge = vertices[to] - vertices[from];
      if (!((found[to] - found[from] - edge).stableNorm() <= 1e-9 * edge.stableNorm())) return vertices;
    }
  }
  return found;
}

// The entry for that owner.
auto& of(Owner owner, auto& of_owners) { return of_owners[static_cast<std::size_t>(owner)]; }

}  // namespace

CageSymmetries::Variant CageSymmetries::variant(std::string check, const Cage& cage, const CoordinateKind& kind,
                                                const std::string& evaluation) const {
  Variant v{std::move(check), {cage, kind, evaluation, Triangulation::Fan}, {}};
  for (const Owner owner : {Owner::Vertex, Owner::Element, Owner::Corner, Owner::Normal})
    for (int i = 0; i < static_cast<int>(base_.elements().count(owner)); ++i) of(owner, v.shares).push_back({{i, 1.0}});
  return v;
}

// Adds the shares of a part's normals in those of the whole element. The part has its own area elements, which are
// combinations of the whole's.
void CageSymmetries::add_normals_of_part(const CageElements& elements, std::size_t element, const ElementPart& part,
                                         std::vector<std::vector<Share>>& all) {
  const auto whole = elements.shares_of(element, Owner::Normal);
  if (whole.size() == 1) {
    all.push_back({{whole[0], 1.0}});
    return;
  }
  for (std::size_t k = 0; k < whole.size(); ++k) {
    Vec3<double> area = Vec3<double>::Zero();
    for (std::size_t i = 0; i < whole.size(); ++i)
      area +=
          part[k][i] * elements.area_element_of(whole[i], Owner::Normal) * elements.normal_of(whole[i], Owner::Normal);
    auto& shares = all.emplace_back();
    for (std::size_t i = 0; i < whole.size(); ++i)
      if (part[k][i] != 0)
        shares.push_back({whole[i], part[k][i] * elements.area_element_of(whole[i], Owner::Normal) / area.norm()});
  }
}

CageSymmetries::Subdivision CageSymmetries::subdivision(const CageElements& elements) {
  Subdivision finer{elements.vertices(), {}, {}};
  auto& of_vertices = of(Owner::Vertex, finer.shares);
  for (int i = 0; i < static_cast<int>(finer.vertices.size()); ++i) of_vertices.push_back({{i, 1.0}});
  // By the vertices that have a share in it, in rising order: neighbours give theirs the other way round.
  std::map<std::vector<int>, int> known;
  for (int i = 0; i < static_cast<int>(finer.vertices.size()); ++i) known[{i}] = i;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const ElementType& type = elements.type(e);
    const auto vertices = elements.vertices_of(e);
    const auto key_of = [&](const std::array<double, 4>& basis) {
      std::vector<int> key;
      for (int k = 0; k < type.corners; ++k)
        if (basis[k] != 0) key.push_back(vertices[k]);
      std::ranges::sort(key);
      return key;
    };
    std::vector<std::array<double, 4>> corners;
    for (const ElementPart& part : type.parts) corners.insert(corners.end(), part.begin(), part.begin() + type.corners);
    std::ranges::stable_sort(corners, {}, [&](const auto& basis) { return rank_of_corner(basis, type.corners); });
    for (const auto& basis : corners) {
      const auto [place, is_new] = known.try_emplace(key_of(basis), static_cast<int>(finer.vertices.size()));
      if (!is_new) continue;
      Vec3<double> at = Vec3<double>::Zero();
      auto& shares = of_vertices.emplace_back();
      for (int k = 0; k < type.corners; ++k) {
        if (basis[k] == 0) continue;
        at += basis[k] * elements.vertices()[vertices[k]];
        shares.push_back({vertices[k], basis[k]});
      }
      finer.vertices.push_back(at);
    }
    for (const ElementPart& part : type.parts) {
      Face& face = finer.elements.emplace_back();
      for (int k = 0; k < type.corners; ++k) {
        face.vertices[k] = known.at(key_of(part[k]));
        auto& shares = of(Owner::Corner, finer.shares).emplace_back();
        for (int i = 0; i < type.corners; ++i)
          if (part[k][i] != 0) shares.push_back({elements.shares_of(e, Owner::Corner)[i], part[k][i]});
      }
      of(Owner::Element, finer.shares).push_back({{static_cast<int>(e), 1.0}});
      add_normals_of_part(elements, e, part, of(Owner::Normal, finer.shares));
    }
  }
  return finer;
}

CageSymmetries::CageSymmetries(const Cage& cage, const CoordinateKind& kind, const std::string& evaluation,
                               Triangulation rule)
    : CageSymmetries(cage, evaluation, {cage, kind, evaluation, rule}, {cage, kind, rule, evaluation}) {}

CageSymmetries::CageSymmetries(const Cage& cage, const std::string& evaluation, CageCoordinates base, CageTerms terms)
    : size_(cage.size()), base_(std::move(base)), terms_(std::move(terms)) {
  const CoordinateKind& kind = base_.kind();
  const Turn turn(cage.dimension());
  const CageElements& elements = base_.elements();
  std::vector<Vec3<double>> scaled, turned;
  for (const auto& v : cage.vertices()) {
    scaled.push_back(kScale * v);
    turned.push_back(turn(v));
  }
  std::vector<Face> permuted = elements.all();
  std::vector<std::vector<Share>> permuted_corners, permuted_normals;
  bool any_cyclic = false;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const bool cyclic = sampling_of(elements.type(e).kind).cyclic;
    const auto numbers = elements.shares_of(e, Owner::Corner);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      permuted_corners.push_back({{numbers[cyclic ? (k + 1) % numbers.size() : k], 1.0}});
    const auto normals = elements.shares_of(e, Owner::Normal);
    for (std::size_t k = 0; k < normals.size(); ++k)
      permuted_normals.push_back({{normals[cyclic ? (k + 1) % normals.size() : k], 1.0}});
    if (!cyclic) continue;
    any_cyclic = true;
    const auto corners = std::span(permuted[e].vertices).first(elements.type(e).corners);
    std::ranges::rotate(corners, corners.begin() + 1);
  }
  variants_.push_back(variant("cage_scaling", cage.with(scaled, elements.all()), kind, evaluation));
  variants_.back().unit = kScale;
  variants_.push_back(variant("cage_rigid_motion", cage.with(turned, elements.all()), kind, evaluation));
  variants_.back().turned = true;
  if (any_cyclic) {
    variants_.push_back(variant("cage_corner_permutation", cage.with(cage.vertices(), permuted), kind, evaluation));
    of(Owner::Corner, variants_.back().shares) = std::move(permuted_corners);
    of(Owner::Normal, variants_.back().shares) = std::move(permuted_normals);
  }
  // Kinds that are not sums over elements may change when elements are subdivided, so the check skips them.
  if (!kind.is_sum()) return;
  const std::vector<Vec3<double>> rounded = with_exact_midpoints(elements);
  std::optional<CageCoordinates> of;
  if (rounded != elements.vertices())
    of.emplace(cage.with(rounded, elements.all()), kind, evaluation, Triangulation::Fan);
  Subdivision finer = subdivision(of ? of->elements() : elements);
  variants_.push_back(variant("cage_subdivision", cage.with(finer.vertices, finer.elements), kind, evaluation));
  variants_.back().shares = std::move(finer.shares);
  variants_.back().of = std::move(of);
}

std::vector<std::string> CageSymmetries::checks_of(const CageCoordinates& coordinates) {
  const CageElements& elements = coordinates.elements();
  std::vector<std::string> checks{"cage_scaling", "cage_rigid_motion"};
  for (std::size_t e = 0; e < elements.count() && checks.size() == 2; ++e)
    if (sampling_of(elements.type(e).kind).cyclic) checks.emplace_back("cage_corner_permutation");
  if (coordinates.kind().is_sum()) checks.emplace_back("cage_subdivision");
  return checks;
}

// A variant's coordinates as the base's should be: without the turn and the unit, shares added where they belong.
std::vector<double> CageSymmetries::folded(const Variant& v, std::size_t b, const Result<double>& found,
                                           const Vec3<double>& point) const {
  const CoordinateBlock& block = base_.blocks()[b];
  const std::size_t width = block.entries();
  std::vector<double> result(block.size * width, 0.0);
  const std::vector<double> plain =
      v.turned ? Turn(base_.dimension()).undo(found.value, block.shape.space_indices()) : found.value;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const double x = plain[i] / std::pow(v.unit, block.degree);
    for (const Share& share : of(block.owner, v.shares)[i / width])
      result[share.coordinate * width + i % width] += x * share.weight;
  }
  const Added logarithms = added(v, b, point);
  for (std::size_t i = 0; i < logarithms.value.size(); ++i) result[i] -= logarithms.value[i];
  return result;
}

CageSymmetries::Added CageSymmetries::added(const Variant& v, std::size_t b, const Vec3<double>& point) const {
  const CoordinateBlock& block = base_.blocks()[b];
  if (v.unit == 1 || block.logarithmic.factor == 0) return {};
  const std::size_t width = block.entries();
  Added sum{std::vector<double>(block.size * width, 0.0), std::vector<double>(block.size * width, 0.0)};
  const CageElements& elements = base_.elements();
  Shape shape = block.shape;
  for (std::size_t e = 0; e < elements.count(); ++e) {
    const std::span<const int> slots = elements.shares_of(e, block.owner);
    shape.per_corner = slots.size() > 1;
    const std::vector<double> part = logarithmic_part(block.logarithmic, shape, elements.corners(e), point, 0);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::size_t to = slots[i / width] * width + i % width;
      const double term = std::log(v.unit) * part[i];
      sum.value[to] += term;
      sum.size[to] += std::abs(term);
    }
  }
  return sum;
}

std::map<std::string, CageError> CageSymmetries::errors_at(const Vec3<double>& point) const {
  std::map<std::string, CageError> errors;
  const auto of_base = base_.at<double>(point, 0);
  const TermSizes terms = terms_.at(point, 0);
  for (const Variant& v : variants_) {
    const Vec3<double> changed = v.turned ? Turn(base_.dimension())(point) : Vec3<double>(v.unit * point);
    const auto found = v.coordinates.at<double>(changed, 0);
    const auto expected = v.of ? v.of->at<double>(point, 0) : of_base;
    CageError& worst = errors[v.check];
    if (!base_.kind().missing_because.empty() && std::isnan(expected[0].value[0]) && std::isnan(found[0].value[0])) {
      worst = {};
      continue;
    }
    worst = {0, 0};
    for (std::size_t b = 0; b < found.size(); ++b) {
      const double relative = relative_difference(folded(v, b, found[b], point), expected[b].value);
      worst.relative = std::max(worst.relative, relative);
      // A term that is added and taken away again is rounded as well; where ln r is zero, it is the only one.
      const double terms_of_both = terms.blocks[b][0] + length_of(added(v, b, point).size);
      worst.roundings =
          std::max(worst.roundings, relative / unit_roundoff<double>() * length_of(expected[b].value) / terms_of_both);
    }
  }
  return errors;
}

std::array<double, 3> CageSymmetries::differences_at(const Vec3<double>& point) const {
  const Vec3<Mp100> eta = convert<Mp100>(point);
  // Far below the distance to the cage, far above the rounding of 100 digits.
  const Mp100 step = Mp100(size_) * Mp100("1e-30");
  const auto exact = base_.at<Mp100>(eta, 2);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  // A point without coordinates has no derivatives either.
  if (!base_.kind().missing_because.empty() && isnan(exact[0].value[0])) return {none, none, none};
  // One direction that no symmetry knows tells as much of a tensor as all axes do, from a third of the sums.
  const int dim = base_.dimension();
  const auto direction = generic_direction<Mp100>(point, dim);
  const auto up = base_.at<Mp100>(Vec3<Mp100>(eta + step * direction), 1),
             down = base_.at<Mp100>(Vec3<Mp100>(eta - step * direction), 1);
  std::array<double, 3> worst{none, 0, 0};
  const Mp100 size2 = Mp100(size_) * Mp100(size_);
  for (std::size_t b = 0; b < exact.size(); ++b)
    for (int o = 1; o <= 2; ++o) {
      std::vector<Mp100> differences;
      differences.reserve(up[b].of(o - 1).size());
      for (std::size_t i = 0; i < up[b].of(o - 1).size(); ++i)
        differences.push_back((up[b].of(o - 1)[i] - down[b].of(o - 1)[i]) / (2 * step));
      // Relative to the whole tensor. In a tetrahedron mean value coordinates are affine: their Hessian is nothing but
      // rounding, and no yardstick.
      Mp100 own = 0, below = 0;
      for (const Mp100& x : exact[b].of(o)) own += x * x;
      for (const Mp100& x : exact[b].of(o - 1)) below += x * x;
      // Outside, coordinates that sum to zero may be nothing but rounding altogether.
      Mp100 nothing = base_.blocks()[b].degree == 0 ? Mp100("1e-32") : Mp100(0);
      for (int i = 0; i < o; ++i) nothing /= size2;
      worst[o] = std::max(worst[o], relative_difference(differences, along(direction, exact[b].of(o), dim),
                                                        std::max({own, Mp100(below / size2), nothing})));
    }
  return worst;
}

}  // namespace cageproof::validation
