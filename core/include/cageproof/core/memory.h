// SPDX-License-Identifier: MIT
// The memory that this process may use, and refusals of tables that would not fit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cageproof {

/// Returns how many bytes of memory this process may use at most: those of the machine, of the container that it runs
/// in, or of `ulimit -v`, whichever are fewest.
std::uint64_t usable_memory();

/// "3.4 MB", "113 GB": three digits, with powers of 1000.
std::string size_text(double bytes);

/// Refuses what takes more than half of usable_memory(), before the work. \param bytes also beyond what integers hold
/// \param what it is, as "a table of 5 x 7 numbers" \param advice what to do instead
/// \throws InputError with what it is, the size, half of the memory, and the advice
void require_memory(double bytes, std::string_view what, std::string_view advice);

}  // namespace cageproof
