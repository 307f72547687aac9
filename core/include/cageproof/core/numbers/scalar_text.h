// SPDX-License-Identifier: MIT
// Scalars as text: exact in, shortest round-trip out.
#pragma once

#include "cageproof/core/numbers/scalar.h"

#include <string>

namespace cageproof {

/// Reads a whole decimal ("0.1", "1e-300") or hexadecimal ("0x1.8p-3") number, correctly rounded to R; "nan", "inf",
/// "-inf" too. Nothing when the text is anything else.
template <Scalar R>
std::optional<R> parse_scalar(std::string_view text);

/// The shortest decimal that parse_scalar<R> reads back exactly (float, double), or max_digits10 digits
/// (multiprecision); "nan", "inf", "-inf".
template <Scalar R>
std::string format_scalar(const R& x);

/// The number with that many significant digits, 1 to 100, rounded to nearest: "1.2345e-03"; "nan", "inf", "-inf".
std::string format_digits(const Mp100& x, int digits);

/// The exact hexadecimal form of a double: "0x1.8p-3".
std::string format_hex(double x);

}  // namespace cageproof
