// SPDX-License-Identifier: MIT
#include "reach/sha256.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

namespace cageproof::judge {
namespace {

// The first 32 bits of the fractions of roots of the first primes: square roots begin a hash, cube roots are its
// rounds'.
struct Roots {
  std::array<std::uint32_t, 8> square{};
  std::array<std::uint32_t, 64> cube{};
};

__extension__ using Wide = unsigned __int128;

// The fraction's first 32 bits of the root that `power(x) <= prime` decides, by bisection in whole numbers.
constexpr std::uint32_t fraction_of_root(std::uint64_t prime, int degree) {
  std::uint64_t root = 0;  // times 2^32
  for (int bit = 37; bit >= 0; --bit) {
    const std::uint64_t next = root | (std::uint64_t{1} << bit);
    const Wide square = static_cast<Wide>(next) * next;
    bool fits = false;
    if (degree == 2) {
      fits = square <= static_cast<Wide>(prime) << 64U;
    } else {
      // square * next <= prime * 2^96, by square <= floor(prime * 2^96 / next).
      const Wide top = static_cast<Wide>(prime) << 96U;
      fits = square <= top / next;
    }
    if (fits) root = next;
  }
  return static_cast<std::uint32_t>(root);
}

constexpr Roots roots_of_primes() {
  Roots roots;
  std::size_t count = 0;
  for (std::uint64_t n = 2; count < roots.cube.size(); ++n) {
    bool is_prime = true;
    for (std::uint64_t d = 2; d * d <= n; ++d) is_prime = is_prime && n % d != 0;
    if (!is_prime) continue;
    if (count < roots.square.size()) roots.square[count] = fraction_of_root(n, 2);
    roots.cube[count++] = fraction_of_root(n, 3);
  }
  return roots;
}

void add_block(std::array<std::uint32_t, 8>& state, const unsigned char* block, const Roots& roots) {
  std::array<std::uint32_t, 64> w{};
  for (std::size_t i = 0; i < 16; ++i)
    w[i] = std::uint32_t{block[4 * i]} << 24U | std::uint32_t{block[4 * i + 1]} << 16U |
           std::uint32_t{block[4 * i + 2]} << 8U | std::uint32_t{block[4 * i + 3]};
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + w[i - 7] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3U)) +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10U));
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t first =
        h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + roots.cube[i] + w[i];
    const std::uint32_t second =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + first;
    d = c;
    c = b;
    b = a;
    a = first + second;
  }
  const std::array added{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += added[i];
}

}  // namespace

std::string sha256(std::string_view bytes) {
  static const Roots roots = roots_of_primes();
  std::array<std::uint32_t, 8> state = roots.square;
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
  std::size_t at = 0;
  for (; at + 64 <= bytes.size(); at += 64) add_block(state, data + at, roots);
  // The rest, a one, zeros, and the length in bits.
  std::array<unsigned char, 128> tail{};
  const std::size_t rest = bytes.size() - at, tail_size = rest < 56 ? 64 : 128;
  for (std::size_t i = 0; i < rest; ++i) tail[i] = data[at + i];
  tail[rest] = 0x80;
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
  for (std::size_t i = 0; i < 8; ++i) tail[tail_size - 1 - i] = static_cast<unsigned char>(bits >> (8 * i));
  for (at = 0; at < tail_size; at += 64) add_block(state, tail.data() + at, roots);
  std::string text;
  for (const std::uint32_t word : state) text += fmt::format("{:08x}", word);
  return text;
}

}  // namespace cageproof::judge
