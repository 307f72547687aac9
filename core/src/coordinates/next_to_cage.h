// SPDX-License-Identifier: MIT
// Which elements of a cage a point is next to, where derivatives of w/W lose digits of weights to the quotient: weights
// grow like one over the distance d, so that roundings of theirs are over d in gradients and over d^2 in Hessians.
#pragma once

#include "cageproof/core/cage/cage_elements.h"

#include <array>
#include <span>
#include <vector>

namespace cageproof {

class NextToCage {
 public:
  /// \param exponent coordinates are measured in 2^exponent, in which their squares stay in range
  NextToCage(const CageElements& elements, int exponent);

  /// The elements next to a point.
  struct Found {
    int order = 3;               ///< the lowest derivative that takes more digits; 3 where none does
    std::vector<char> elements;  ///< which elements take them, one an element; empty where none does
  };
  Found at(const Vec3<double>& point, int order) const;

 private:
  struct Element {
    std::array<Vec3<double>, 4> corners;
    int count;
    Vec3<double> centre = Vec3<double>::Zero();
    double radius = 0, length = 0;  // of a ball about it, and its longest edge

    double distance(const Vec3<double>& point) const;
  };

  int exponent_;
  bool is_simplex_;
  std::vector<Element> elements_;
};

}  // namespace cageproof
