// SPDX-License-Identifier: MIT
// The numbers of a query in the scalar that it is evaluated in.
#pragma once

#include "json_line.h"

#include "cageproof/core/input_error.h"
#include "cageproof/core/numbers/scalar_text.h"

#include <cmath>
#include <optional>

namespace cageproof::cli {

/// \throws InputError for an element without extent: in 200 digits, since a small triangle's area underflows in double,
/// and is none the less an area
void require_extent(const QueryText& text, const Formula& formula);

/// Help text of --allow-invalid-quads in `eval` and `explain`.
inline constexpr const char* allow_invalid_quads_text = "compute with quads that are not valid; for formulas on quads";

/// \throws InputError when the flag is given for a formula that is on no quads
void check_allows_invalid_quads(bool allowed, const Formula& formula);

/// Why the element is no valid quad (core's invalid_because, decided exactly where the corners are doubles), as
/// `coordinates` says it; nothing for valid ones and for other elements.
std::optional<std::string> invalid_quad(const QueryText& text, const Formula& formula);

/// \throws InputError with that reason
void require_valid_quad(const QueryText& text, const Formula& formula);

/// Owns the arrays that its query points to.
template <Scalar R>
class QueryNumbers {
 public:
  /// \throws InputError as require_extent, and for a coordinate that the scalar cannot hold
  QueryNumbers(const QueryText& text, const Formula& formula) {
    require_extent(text, formula);
    corners_.reserve(text.corners.size());
    for (const auto& corner : text.corners) corners_.push_back(numbers(corner));
    point_ = numbers(text.point);
    parameters_.reserve(text.parameters.size());
    for (const std::string& p : text.parameters) parameters_.push_back(*parse_scalar<R>(p));
  }

  /// Valid while this object lives.
  Query<R> query(int order) const { return {corners_, point_, order, parameters_}; }

 private:
  static Vec3<R> numbers(const std::array<std::string, 3>& text) {
    Vec3<R> v;
    for (int c = 0; c < 3; ++c) {
      using std::isfinite;
      v[c] = *parse_scalar<R>(text[c]);
      if (!isfinite(v[c])) throw InputError("a coordinate is too large for this scalar");
    }
    return v;
  }

  std::vector<Vec3<R>> corners_;
  Vec3<R> point_;
  std::vector<R> parameters_;
};

}  // namespace cageproof::cli
