// SPDX-License-Identifier: MIT
// Solves for the convention of whole cages' coordinates: tries every order of blocks and power of areas, with the
// factor that fits.
#include "cageproof/judge/cage_convention.h"

#include "cageproof/core/coordinates/coordinates.h"
#include "cageproof/judge/convention.h"
#include "whole_cage/cage_places.h"
#include "whole_cage/questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace cageproof::judge {
namespace {

// Numbers in double, and in float.
constexpr std::array<double, 2> kTolerances{1e-9, 1e-5};

// The kind's blocks on one cage, and the areas of its faces.
struct Layout {
  std::vector<std::size_t> sizes;
  std::vector<bool> of_faces;
  std::vector<double> areas;  // in the plane lengths
  std::size_t all = 0;
};

Layout layout_of(const CageRequest& question, std::string_view kind) {
  const CageCoordinates coordinates(question.cage(), coordinate_kind_named(kind), CoordinateOptions{});
  Layout layout;
  for (const CoordinateBlock& block : coordinates.blocks()) {
    layout.sizes.push_back(static_cast<std::size_t>(block.size));
    layout.of_faces.push_back(block.owner == Owner::Element);
    layout.all += layout.sizes.back();
  }
  for (const auto& face : question.faces) {
    const auto corner = [&](int k) -> const Vec3<double>& {
      return question.vertices[static_cast<std::size_t>(face.vertices[k])];
    };
    layout.areas.push_back(question.dimension == 2 ? (corner(1) - corner(0)).norm()
                                                   : (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2);
  }
  return layout;
}

// Where each block begins, if blocks stand in that order.
std::vector<std::size_t> begins(const Layout& layout, std::span<const std::size_t> order) {
  std::vector<std::size_t> at(order.size());
  std::size_t next = 0;
  for (const std::size_t block : order) {
    at[block] = next;
    next += layout.sizes[block];
  }
  return at;
}

// A point's coordinates, ours and theirs.
struct Pair {
  Layout layout;
  std::vector<double> ours, theirs;
};

// The factor that maps a to b; NaN where none does.
double factor_between(const std::vector<double>& a, std::span<const double> b, double tolerance) {
  const double factor =
      std::inner_product(b.begin(), b.end(), a.begin(), 0.0) / std::inner_product(a.begin(), a.end(), a.begin(), 0.0);
  double off = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    off = std::max(off, std::abs(b[i] - factor * a[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return off <= tolerance * size && factor != 0 ? factor : std::nan("");
}

// One block's factor, the same at all points; NaN where none is.
double factor_of(std::span<const Pair> pairs, std::size_t block, std::span<const std::size_t> order, int area_power,
                 double tolerance) {
  std::vector<double> factors;
  std::vector<std::size_t> own(order.size());
  std::iota(own.begin(), own.end(), 0);
  for (const Pair& pair : pairs) {
    const std::size_t size = pair.layout.sizes[block];
    const std::size_t here = begins(pair.layout, own)[block], there = begins(pair.layout, order)[block];
    std::vector<double> ours(pair.ours.begin() + static_cast<std::ptrdiff_t>(here),
                             pair.ours.begin() + static_cast<std::ptrdiff_t>(here + size));
    for (std::size_t i = 0; area_power != 0 && i < size; ++i) ours[i] *= std::pow(pair.layout.areas[i], area_power);
    factors.push_back(factor_between(ours, std::span(pair.theirs).subspan(there, size), tolerance));
    if (!(std::abs(factors.back() - factors.front()) <= tolerance * std::abs(factors.front()))) return std::nan("");
  }
  const auto middle = factors.begin() + static_cast<std::ptrdiff_t>(factors.size() / 2);
  std::ranges::nth_element(factors, middle);
  return std::abs(*middle - 1) < tolerance ? 1 : *middle;
}

// The blocks in that order with the factors that fit; empty where none do.
std::vector<CageConvention::Block> fit(std::span<const Pair> pairs, std::span<const std::size_t> order,
                                       double tolerance) {
  std::vector<CageConvention::Block> blocks;
  for (const std::size_t block : order) {
    CageConvention::Block found{block, std::nan(""), 0};
    for (const int power : {0, 1, -1}) {
      if (power != 0 && !pairs[0].layout.of_faces[block]) continue;
      found.factor = factor_of(pairs, block, order, power, tolerance);
      found.area_power = power;
      if (!std::isnan(found.factor)) break;
    }
    if (std::isnan(found.factor)) return {};
    blocks.push_back(found);
  }
  return blocks;
}

std::string block_text(const CageConvention::Block& block, std::string_view label, int dimension, double within) {
  std::string text;
  if (block.factor != 1) {
    const std::string name = name_of_constant(block.factor, within);
    text = name.empty() ? fmt::format(" times {:.12g} (a constant without a name)", block.factor) : " times " + name;
  }
  const std::string_view size = dimension == 2 ? "the segment's length" : "the face's area";
  if (block.area_power > 0) text += fmt::format(" times {}", size);
  if (block.area_power < 0) text += fmt::format(" divided by {}", size);
  return text.empty() ? text : fmt::format("{}{}", label, text);
}

// Which habit changes the signs of just these blocks; empty for none.
std::string_view sign_hint(const std::vector<CageConvention::Block>& blocks, const CoordinateKind& kind,
                           int dimension) {
  if (kind.normalised) return "";
  const ElementKind element = dimension == 2 ? ElementKind::Segment : ElementKind::Triangle;
  bool is_any = false, is_all = true, turns = true;
  for (const CageConvention::Block& block : blocks) {
    const bool is_negative = block.factor < 0;
    is_any = is_any || is_negative;
    is_all = is_all && is_negative;
    turns = turns && is_negative == (find_formula(element, kind.blocks[block.ours].kernel)->flip_sign < 0);
  }
  if (!is_any) return "";
  if (is_all) return " (the other sign of the fundamental solution)";
  return turns ? " (normals that point inward)" : "";
}

std::string sentence_of(const std::vector<CageConvention::Block>& blocks, std::string_view kind, int dimension,
                        double within) {
  const CoordinateKind& row = coordinate_kind_named(kind);
  std::string text = "yours is ours", order;
  const char* word = " with ";
  bool is_ordered = true;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    // Kinds that are not sums have one block.
    const std::string_view label = row.is_sum() ? row.blocks[blocks[k].ours].label : "the coordinates";
    if (const std::string part = block_text(blocks[k], label, dimension, within); !part.empty()) {
      text += word + part;
      word = ", ";
    }
    order += (k > 0 ? ", " : "") + std::string(label);
    is_ordered = is_ordered && blocks[k].ours == k;
  }
  text += sign_hint(blocks, row, dimension);
  if (!is_ordered) text += word + ("the order " + order);
  if (within == kTolerances.back()) text += "; to six digits";
  return text;
}

}  // namespace

bool CageConvention::is_ours() const {
  for (std::size_t k = 0; k < blocks.size(); ++k)
    if (blocks[k].ours != k || blocks[k].factor != 1 || blocks[k].area_power != 0) return false;
  return true;
}

std::vector<double> CageConvention::in_ours(const CageRequest& question, std::string_view kind,
                                            std::vector<double> theirs) const {
  if (is_ours()) return theirs;
  const Layout layout = layout_of(question, kind);
  if (theirs.size() != layout.all) return theirs;
  std::vector<std::size_t> own(blocks.size()), order;
  std::iota(own.begin(), own.end(), 0);
  for (const Block& block : blocks) order.push_back(block.ours);
  const auto here = begins(layout, own), there = begins(layout, order);
  std::vector<double> ours(theirs.size());
  for (const Block& block : blocks)
    for (std::size_t i = 0; i < layout.sizes[block.ours]; ++i)
      ours[here[block.ours] + i] = theirs[there[block.ours] + i] / block.factor /
                                   (block.area_power == 0 ? 1 : std::pow(layout.areas[i], block.area_power));
  return ours;
}

std::optional<CageConvention> find_cage_convention(const WholeCageFunction& theirs, std::string_view kind,
                                                   int dimension) {
  std::vector<Pair> pairs;
  for (CageSample& sample : cage_samples(kind, 1, dimension)) {
    if (sample.face >= 0) continue;
    Pair pair{layout_of(sample.question, kind), std::move(sample.truth), theirs(sample.question)};
    if (pair.theirs.size() != pair.layout.all) return std::nullopt;
    pairs.push_back(std::move(pair));
  }
  std::vector<std::size_t> order(pairs[0].layout.sizes.size());
  std::iota(order.begin(), order.end(), 0);
  for (const double tolerance : kTolerances) do {
      auto blocks = fit(pairs, order, tolerance);
      if (blocks.empty()) continue;
      std::string sentence = sentence_of(blocks, kind, dimension, tolerance);
      return CageConvention{std::move(blocks), std::move(sentence)};
    } while (std::ranges::next_permutation(order).found);
  return std::nullopt;
}

}  // namespace cageproof::judge
