// SPDX-License-Identifier: MIT
#include "cageproof/core/numbers/random_stream.h"
#include "cageproof/validation/machine_facts.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <vector>

#if __has_include(<sys/platform/x86.h>)
#ifdef __clang__
#define _Bool bool  // NOLINT: glibc's header is C's here, and Clang has no _Bool in C++
#endif
#include <sys/platform/x86.h>
#undef _Bool
#endif

namespace cageproof::validation {
namespace {

// glibc picks a variant of each function by these features. It also takes its tunables into account, which the
// processor's own word would miss.
std::string features() {
#ifdef CPU_FEATURE_ACTIVE
  std::vector<std::string> names;
  if (CPU_FEATURE_ACTIVE(FMA)) names.emplace_back("FMA");
  if (CPU_FEATURE_ACTIVE(FMA4)) names.emplace_back("FMA4");
  if (CPU_FEATURE_ACTIVE(AVX2)) names.emplace_back("AVX2");
  return names.empty() ? "without FMA" : fmt::format("{}", fmt::join(names, ", "));
#else
  return "features unknown";
#endif
}

// The bits of what the functions return at fixed inputs. Variants round a few results in a thousand otherwise, so that
// thousands of inputs tell them apart.
std::uint64_t fingerprint() {
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&](double x) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 1099511628211U;
    hash ^= hash >> 29;
  };
  for (std::uint64_t i = 0; i < 8192; ++i) {
    RandomStream random(1, "elementary functions", i);
    const double x = std::exp2(random.uniform(-20, 20)), y = random.uniform(-2, 2);
    for (const double value :
         {std::log(x), std::log1p(x), std::log10(x), std::exp(y), std::pow(x, y), std::sin(x), std::cos(x), std::tan(y),
          std::atan(x), std::atan2(y, x), std::asinh(x), std::atanh(y / 2.5), std::acos(y / 2), std::hypot(x, y),
          std::cbrt(x), std::sinh(y), std::cosh(y)})
      add(value);
  }
  return hash;
}

}  // namespace

std::string elementary_function_variant() { return fmt::format("{}; fingerprint {:016x}", features(), fingerprint()); }

}  // namespace cageproof::validation
