// SPDX-License-Identifier: MIT
// Between the C interface and C++: errors as codes and texts, arrays as spans, options by name.
#pragma once

#include "cageproof.h"
#include "cageproof/cageproof.h"

#include <functional>
#include <span>

struct cageproof_cage {  // NOLINT(readability-identifier-naming): of the C interface
  cageproof::library::Cage cage;
};

namespace cageproof::library::c {

/// Runs it; keeps the text of what it throws for this thread. \return the code of the C interface
int guarded(const std::function<void()>& task) noexcept;

/// \throws InputError for a null pointer \param what names it
void require(const void* pointer, const char* what);

/// \throws InputError for a null pointer with a size
template <class T>
std::span<T> span_of(T* data, std::size_t size, const char* what) {
  if (size > 0) require(data, what);
  return data == nullptr ? std::span<T>() : std::span<T>(data, size);
}

/// \throws InputError for null names and values, and values that are not what the option takes
Options options_of(const cageproof_option* options, std::size_t count);

/// \throws InputError for the first option whose name is not among those that are taken
void require_names(std::span<const cageproof_option> options, std::initializer_list<std::string_view> taken);

}  // namespace cageproof::library::c
