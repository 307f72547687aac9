// SPDX-License-Identifier: MIT
// The run-time switch of a build that carries many mutants: each site asks whether its own mutant is the one that is
// on. Included before every file of such a build, and by nothing else.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace cageproof_mutants {

inline constexpr int no_mutant = 0, tracing = -1, most_mutants = 8192;

/// The number in CAGEPROOF_MUTANT; `tracing` where CAGEPROOF_MUTANT_TRACE names a file. Constant-initialised, so that
/// it is there before any initialiser asks.
inline int active = no_mutant;
inline unsigned char reached[most_mutants] = {};

/// Appends the numbers of the sites that this process reached, as one line in one write.
inline void write_trace() {
  const char* path = std::getenv("CAGEPROOF_MUTANT_TRACE");
  std::FILE* file = path ? std::fopen(path, "a") : nullptr;
  if (!file) return;
  static char line[most_mutants * 5 + 2];
  std::size_t length = 0;
  for (int id = 1; id < most_mutants; ++id)
    if (reached[id]) length += static_cast<std::size_t>(std::snprintf(line + length, 6, "%d ", id));
  line[length++] = '\n';
  std::setvbuf(file, nullptr, _IOFBF, sizeof line);
  std::fwrite(line, 1, length, file);
  std::fclose(file);
}

[[gnu::constructor(101)]] static void start() {
  if (std::getenv("CAGEPROOF_MUTANT_TRACE")) {
    if (active == tracing) return;
    active = tracing;
    std::atexit(write_trace);
  } else if (const char* id = std::getenv("CAGEPROOF_MUTANT")) {
    active = std::atoi(id);
  }
}

/// Whether mutant `id` is on.
inline bool on(int id) {
  const int now = active;
  if (now == tracing) [[unlikely]]
    reached[id] = 1;
  return now == id;
}

/// The same where the compiler may evaluate the function: no mutant is ever on there.
constexpr bool on_at_run_time(int id) { return !std::is_constant_evaluated() && on(id); }

/// An expression's value, so that both branches of a site have one type: expression templates are evaluated.
template <class T>
constexpr auto value(T&& x) {
  if constexpr (requires { x.eval(); }) return std::remove_cvref_t<decltype(x.eval())>(x.eval());
  else return std::remove_cvref_t<T>(std::forward<T>(x));
}

/// x times factor, in x's own type.
template <class T>
constexpr auto scaled(const T& x, double factor) {
  if constexpr (std::is_arithmetic_v<T>) {
    static_assert(std::is_floating_point_v<T>);
    return static_cast<T>(x * static_cast<T>(factor));
  } else if constexpr (requires { typename T::Scalar; }) {
    return T(x * static_cast<typename T::Scalar>(factor));
  } else {
    return T(x * T(factor));
  }
}

}  // namespace cageproof_mutants
