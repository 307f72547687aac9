// SPDX-License-Identifier: MIT
// Between the C interface and C++: errors as codes and texts, arrays as spans, options by name.
#pragma once

#include "cageproof.h"
#include "cageproof/cageproof.h"

#include <functional>
#include <memory>
#include <span>
#include <typeindex>

struct cageproof_cage {  // NOLINT(readability-identifier-naming): of the C interface
  cageproof::library::Cage cage;
};

namespace cageproof::library::c {

/// Runs it; keeps the text of what it throws for this thread. \return the code of the C interface
int guarded(const std::function<void()>& task) noexcept;

/// \throws InputError for a null pointer \param what names it
void require(const void* pointer, const char* what);

/// Whether handles are watched: in debug builds of the library, and where the environment has CAGEPROOF_CHECK_HANDLES.
bool handles_are_watched();
void add_handle(const void* handle, std::type_index type);
/// \return whether the handle lived until now; if not, cageproof_error() says so
bool end_handle(const void* handle, std::type_index type);
/// \throws InputError for a handle that was freed or never made
void require_alive(const void* handle, std::type_index type, const char* what);

/// A new handle for the caller.
template <class T>
T* handed_out(T* made) {
  std::unique_ptr<T> handle(made);
  if (handles_are_watched()) add_handle(handle.get(), typeid(T));
  return handle.release();
}

/// Where handles are watched, the memory of one that was freed is not used again: its address stays that of a dead one.
template <class T>
void free_handle(T* handle) {
  if (!handles_are_watched()) delete handle;
  else if (handle != nullptr && end_handle(handle, typeid(T))) std::destroy_at(handle);
}

/// \throws InputError for a null pointer, and where handles are watched for one that was freed or never made
template <class T>
void require_handle(const T* handle, const char* what) {
  require(handle, what);
  if (handles_are_watched()) require_alive(handle, typeid(T), what);
}

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
