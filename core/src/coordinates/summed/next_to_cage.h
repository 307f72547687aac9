// SPDX-License-Identifier: MIT
// Finds elements that a point is so near to that derivatives of w/W lose digits of the weights to the quotient. Weights
// grow like one over the distance d; their roundings are divided by d in gradients, and by d^2 in Hessians.
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
    std::vector<char> elements;  ///< which elements take them, one per element; empty where none does
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
