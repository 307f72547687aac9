// SPDX-License-Identifier: MIT
// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cageproof::reports {

/// An error with two significant digits, rounded up, so that a broken bound never looks kept: "3.2", "64", "1.4e5",
/// "inf".
std::string short_error(double error);

/// Decimal digits of a scalar that a relative error leaves, rounded down to a tenth: "0", "12.3", "all".
std::string digits_kept(double relative, std::string_view scalar);

/// Four digits at most: "64", "1e-12", "-16.32".
std::string short_number(double x);

/// "0", "12", "12,345,678".
std::string grouped(std::uint64_t count);

/// "value", "gradient", "Hessian".
std::string_view order_name(int order);

/// The name as a file name: everything but letters, digits, '.', '_' and '-' becomes '-'; never empty or hidden.
std::string file_name(std::string_view name);

}  // namespace cageproof::reports
