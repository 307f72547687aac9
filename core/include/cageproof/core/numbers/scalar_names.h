// SPDX-License-Identifier: MIT
// The scalar types every formula is generic over, without what multiprecision is made of: scalar.h has that too.
#pragma once

#include "cageproof/core/numbers/mp_names.h"

#include <array>
#include <concepts>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

namespace cageproof {

template <class T>
inline constexpr bool is_multiprecision = false;
template <unsigned Digits>
inline constexpr bool is_multiprecision<Mp<Digits>> = true;

/// Whether T takes double's place in templates over scalars, to find out what happens to double there.
template <class T>
inline constexpr bool stands_for_double = false;

/// The number types that a formula may be evaluated in.
template <class T>
concept Scalar = std::same_as<T, float> || std::same_as<T, double> || std::same_as<T, Mp50> || std::same_as<T, Mp100> ||
    std::same_as<T, Mp200> || stands_for_double<T>;

enum class ScalarKind { Float, Double, Digits50, Digits100, Digits200 };

/// All kinds, in the order of rising precision.
inline constexpr std::array scalar_kinds{ScalarKind::Float, ScalarKind::Double, ScalarKind::Digits50,
                                         ScalarKind::Digits100, ScalarKind::Digits200};

/// "float", "double", "mp50", "mp100", "mp200": the command line's and the reports' names.
constexpr std::string_view name_of(ScalarKind kind) {
  constexpr std::array<std::string_view, 5> names{"float", "double", "mp50", "mp100", "mp200"};
  return names[static_cast<std::size_t>(kind)];
}

/// The inverse of name_of; nothing for an unknown name.
constexpr std::optional<ScalarKind> scalar_named(std::string_view name) {
  for (const ScalarKind kind : scalar_kinds)
    if (name_of(kind) == name) return kind;
  return std::nullopt;
}

template <Scalar R>
constexpr ScalarKind kind_of() {
  if constexpr (std::same_as<R, float>) return ScalarKind::Float;
  else if constexpr (std::same_as<R, double>) return ScalarKind::Double;
  else if constexpr (std::same_as<R, Mp50>) return ScalarKind::Digits50;
  else if constexpr (std::same_as<R, Mp100>) return ScalarKind::Digits100;
  else return ScalarKind::Digits200;
}

/// Calls `f.template operator()<R>()` with the scalar type that `kind` names.
template <class F>
decltype(auto) with_scalar(ScalarKind kind, F&& f) {
  switch (kind) {
    case ScalarKind::Float: return f.template operator()<float>();
    case ScalarKind::Double: return f.template operator()<double>();
    case ScalarKind::Digits50: return f.template operator()<Mp50>();
    case ScalarKind::Digits100: return f.template operator()<Mp100>();
    case ScalarKind::Digits200: break;
  }
  return f.template operator()<Mp200>();
}

/// u: half an ulp of one, the largest relative error of one rounding to nearest.
template <Scalar R>
R unit_roundoff() {
  return std::numeric_limits<R>::epsilon() / 2;
}

/// The ratio of a circle's circumference to its diameter, rounded to R.
template <Scalar R>
R pi() {
  if constexpr (is_multiprecision<R>) return MpConstants<std::numeric_limits<R>::digits10>::pi();
  else return std::numbers::pi_v<R>;
}

/// The natural logarithm of two, rounded to R.
template <Scalar R>
R ln_two() {
  if constexpr (is_multiprecision<R>) return MpConstants<std::numeric_limits<R>::digits10>::ln_two();
  else return std::numbers::ln2_v<R>;
}

}  // namespace cageproof
