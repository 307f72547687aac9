// SPDX-License-Identifier: MIT
// The description of the rung of the ladder that a closed form was computed on.
#pragma once

#include "cageproof/closed_form/arithmetic/bounded_jet.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace cageproof::closed_form {

/// \param digits BoundedJet::digits
inline std::string arithmetic_name(int digits) {
  if (digits == digits_of<double>) return "double";
  if (digits == digits_of<DoubleDouble>) return "double-double";
  return std::to_string(digits) + " digits";
}

/// A bound of a relative error in units of double's, 2^-53.
inline std::string in_units(double bound) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g", bound * 0x1p53);
  return std::string(text.data()) + " units";
}

/// The rung, and why it is this one. \param form its name \param taken the result of the ladder \param bound of the
/// error on the first rung, in double; 1 where no digit is certain
template <int C, int D>
std::string rung_name(const std::string& form, const BoundedJet<double, C, D>& taken, double bound) {
  const std::string name = form + " in " + arithmetic_name(taken.digits) + ", ";
  if (taken.digits == digits_of<double>) return name + "with a bound of its error of " + in_units(bound);
  return name + "since in double the bound of its error is " +
         (bound < 1 ? in_units(bound) : std::string("as large as the result")) + ", more than " + in_units(kTolerance);
}

}  // namespace cageproof::closed_form
