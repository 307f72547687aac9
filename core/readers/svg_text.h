// SPDX-License-Identifier: MIT
// What SVG writes in attributes: numbers, path data, lists of points and transforms. Debian's libraries flatten curves
// (nanosvg), draw (librsvg), or do not round decimals correctly (SVG++); so it is read here, and what is not a straight
// edge is refused by name. All arithmetic is rational: relative coordinates and transforms are exact, and rounded once.
#pragma once

#include "geometry/exact_signs.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cageproof::svg {

using exact::Rational;

/// The fault of an attribute, for messages: "an elliptical arc (command A); ...".
struct Fault {
  std::string reason;
};

struct Point {
  Rational x, y;
};

struct Subpath {
  std::vector<Point> points;
  bool closed = false;  ///< by the command Z
};

/// The subpaths of path data, without those that have no segment. \throws Fault
std::vector<Subpath> parse_path(std::string_view data);

/// A list of points, as polygons and polylines have. \throws Fault for an odd number of coordinates
std::vector<Point> parse_points(std::string_view text);

/// A length in user units, as attributes of rectangles are: px is one, cm, mm, Q, in, pt and pc are as many as at 96 an
/// inch, and % is of `whole`. \throws Fault for other units, and for % where nobody knows the whole
Rational parse_length(std::string_view text, const std::optional<Rational>& whole);

/// x -> a x + c y + e, y -> b x + d y + f.
struct Transform {
  Rational a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  Point operator()(const Point& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First `inner`, then this one.
  Transform after(const Transform& inner) const;

  /// How long its longest number is, numerator and denominator. Products of many transforms grow without end.
  std::size_t bits() const;
  static constexpr std::size_t kMostBits = 20000;
  static constexpr const char* kTooMany =
      "the product of these transforms has numbers of more than 20000 bits; apply them in the program that wrote it";
};

/// A list of matrix, translate, scale, rotate, skewX and skewY; angles in degrees, quarter turns exact, others to 200
/// digits. \throws Fault
Transform parse_transform(std::string_view text);

}  // namespace cageproof::svg
