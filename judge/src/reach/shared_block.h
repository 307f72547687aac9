// SPDX-License-Identifier: MIT
// How a block of elements and points lies in the memory that a library's process shares with who asks it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cageproof::judge {

/// The first bytes. Whoever asks copies what it needs and trusts none of it.
struct SharedHeader {
  enum Op : std::int32_t { About, Order, Evaluate, Coordinates };
  std::uint64_t sequence;
  std::int32_t op, order, single, dimension, corner_count, parameter_count, components;
  std::int32_t result;    ///< of Order
  std::uint64_t groups;   ///< elements, each with points
  std::uint64_t current;  ///< the element that is being asked
  double nanoseconds;     ///< within the library
  char formula[128];
  char text[512];  ///< About, and why the process died where it knows
};

inline constexpr std::size_t header_words = 128;                 ///< of eight bytes
inline constexpr std::size_t shared_words = (8ULL << 20U) / 8U;  ///< of the whole memory
static_assert(sizeof(SharedHeader) <= 8 * header_words);

/// Fills outputs before the library is called: a NaN that no arithmetic gives.
inline constexpr std::uint64_t unset_double = 0x7ff8c0ffee15bad5;
inline constexpr std::uint32_t unset_float = 0x7fc0bad5;

/// Places of an element's numbers, in words from the begin of the memory. A cage's vertices are corners, its faces'
/// vertices parameters, its coordinates components.
struct GroupLayout {
  std::size_t count, code, flags, corners, parameters, points;
  std::array<std::size_t, 3> tensors, sizes;
  std::size_t end;

  GroupLayout(std::size_t begin, const SharedHeader& h, std::size_t point_count)
      : count(begin), code(begin + 1), flags(begin + 2), corners(begin + 3) {
    const auto dimension = static_cast<std::size_t>(h.dimension);
    parameters = corners + dimension * static_cast<std::size_t>(h.corner_count);
    points = parameters + static_cast<std::size_t>(h.parameter_count);
    std::size_t at = points + dimension * point_count;
    std::size_t size = point_count * static_cast<std::size_t>(h.components);
    for (std::size_t o = 0; o < 3; ++o, size *= dimension) {
      tensors[o] = at;
      sizes[o] = o <= static_cast<std::size_t>(h.order) ? size : 0;
      at += sizes[o];
    }
    end = at;
  }
};

/// Bits of a group's flags.
inline constexpr std::uint64_t changed_input = 1;

/// Descriptors of a host, set by who starts it.
namespace descriptor {
inline constexpr int lifeline = 3;  ///< closed when the host is to end all
inline constexpr int status = 4;    ///< where the host says what became of the code
inline constexpr int requests = 5;
inline constexpr int answers = 6;
inline constexpr int memory = 7;  ///< a library's
}  // namespace descriptor

}  // namespace cageproof::judge
