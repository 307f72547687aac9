// SPDX-License-Identifier: MIT
// Memory that vectors of any instruction set may lie in.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace cageproof::closed_form::batch {

struct FreeAligned {
  void operator()(void* memory) const { ::operator delete (memory, std::align_val_t{64}); }
};

template <class T>
using Aligned = std::unique_ptr<T[], FreeAligned>;

/// Not set to anything.
template <class T>
Aligned<T> aligned(std::size_t count) {
  return Aligned<T>(static_cast<T*>(::operator new (count * sizeof(T), std::align_val_t{64})));
}

}  // namespace cageproof::closed_form::batch
