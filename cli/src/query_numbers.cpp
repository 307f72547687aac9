// SPDX-License-Identifier: MIT
#include "query_numbers.h"

#include "cageproof/core/geometry/quad_geometry.h"

#include <fmt/format.h>

#include <algorithm>

namespace cageproof::cli {
namespace {

// The corners as doubles: exactly where they are doubles, else by their distances from the first, whose digits say more
// of the shape than those of places far away.
Quad<double> corners_of(const QueryText& text) {
  std::array<Vec3<Mp200>, 4> exact;
  Quad<double> rounded;
  bool is_double = true;
  for (std::size_t k = 0; k < 4; ++k)
    for (int c = 0; c < 3; ++c) {
      exact[k][c] = *parse_scalar<Mp200>(text.corners[k][c]);
      rounded[k][c] = static_cast<double>(exact[k][c]);
      is_double = is_double && Mp200(rounded[k][c]) == exact[k][c];
    }
  if (is_double) return rounded;
  for (std::size_t k = 0; k < 4; ++k)
    for (int c = 0; c < 3; ++c) rounded[k][c] = static_cast<double>(Mp200(exact[k][c] - exact[0][c]));
  return rounded;
}

}  // namespace

void check_allows_invalid_quads(bool allowed, const Formula& formula) {
  if (allowed && formula.element != ElementKind::Quad)
    throw InputError(fmt::format("--allow-invalid-quads: {} is not a formula on quads", formula.name));
}

std::optional<std::string> invalid_quad(const QueryText& text, const Formula& formula) {
  if (formula.element != ElementKind::Quad) return std::nullopt;
  const std::optional<std::string> reason = invalid_because(corners_of(text));
  if (!reason) return std::nullopt;
  return fmt::format("element: {} (corners counted from 0)", *reason);
}

void require_valid_quad(const QueryText& text, const Formula& formula) {
  if (const auto reason = invalid_quad(text, formula))
    throw InputError(fmt::format("{}; {} needs valid quads, --allow-invalid-quads computes with others, too", *reason,
                                 formula.name));
}

void require_extent(const QueryText& text, const Formula& formula) {
  std::vector<Vec3<Mp200>> corners;
  corners.reserve(text.corners.size());
  for (const auto& c : text.corners)
    corners.emplace_back(*parse_scalar<Mp200>(c[0]), *parse_scalar<Mp200>(c[1]), *parse_scalar<Mp200>(c[2]));
  const ElementType& type = type_of(formula.element);
  if (type.degenerate(corners)) throw InputError(std::string(type.degenerate_text));
}

}  // namespace cageproof::cli
