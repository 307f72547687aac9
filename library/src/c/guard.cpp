// SPDX-License-Identifier: MIT
#include "guard.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <mutex>
#include <new>

namespace cageproof::library::c {
namespace {

struct LastError {
  std::string text;
  const char* shown = "";
};
thread_local LastError last_error;

// Where there is no memory for a text either.
int keep(int code, const char* text) noexcept {
  try {
    last_error.text = text;
    last_error.shown = last_error.text.c_str();
  } catch (...) {
    last_error.shown = "there is too little memory for this";
  }
  return code;
}

// Handles that were given out, with their types; without one once they were freed.
struct Handles {
  std::mutex mutex;
  std::map<const void*, std::type_index> types;

  static Handles& all() {
    // Not destroyed: programs may free handles when they end.
    static auto* const handles = new Handles;
    return *handles;
  }
  bool has(const void* handle, std::type_index type) const {
    const auto found = types.find(handle);
    return found != types.end() && found->second == type;
  }
};

int number_of(const char* value, std::string_view name) {
  const std::string_view text = value;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0)
    throw InputError(fmt::format("option {}: '{}' is no whole number of 0 or more", name, text));
  return number;
}

bool flag_of(const char* value, std::string_view name) {
  const std::string_view text = value;
  if (text != "0" && text != "1") throw InputError(fmt::format("option {}: '{}' is neither 0 nor 1", name, text));
  return text == "1";
}

}  // namespace

int guarded(const std::function<void()>& task) noexcept {
  last_error.shown = "";
  try {
    task();
    return CAGEPROOF_OK;
  } catch (const InputError& e) {
    return keep(CAGEPROOF_BAD_INPUT, e.what());
  } catch (const std::bad_alloc&) {
    return keep(CAGEPROOF_NO_MEMORY, "there is too little memory for this: take fewer points at a time");
  } catch (const std::length_error&) {
    return keep(CAGEPROOF_NO_MEMORY, "there is too little memory for this: take fewer points at a time");
  } catch (const std::exception& e) {
    return keep(CAGEPROOF_INTERNAL, e.what());
  } catch (...) {
    return keep(CAGEPROOF_INTERNAL, "unknown error");
  }
}

void require(const void* pointer, const char* what) {
  if (pointer == nullptr) throw InputError(fmt::format("{}: a null pointer", what));
}

bool handles_are_watched() {
#ifdef NDEBUG
  static const bool watched = std::getenv("CAGEPROOF_CHECK_HANDLES") != nullptr;
  return watched;
#else
  return true;
#endif
}

void add_handle(const void* handle, std::type_index type) {
  Handles& all = Handles::all();
  const std::lock_guard lock(all.mutex);
  all.types.insert_or_assign(handle, type);
}

bool end_handle(const void* handle, std::type_index type) {
  Handles& all = Handles::all();
  const std::lock_guard lock(all.mutex);
  last_error.shown = "";
  if (!all.has(handle, type)) {
    keep(CAGEPROOF_BAD_INPUT, "a handle to be freed was freed before, or never made");
    return false;
  }
  all.types.insert_or_assign(handle, typeid(void));
  return true;
}

void require_alive(const void* handle, std::type_index type, const char* what) {
  Handles& all = Handles::all();
  const std::lock_guard lock(all.mutex);
  if (!all.has(handle, type)) throw InputError(fmt::format("{}: the handle was freed, or never made", what));
}

Options options_of(const cageproof_option* options, std::size_t count) {
  Options found;
  for (const auto& [name, value] : span_of(options, count, "options")) {
    require(name, "an option's name");
    require(value, name);
    const std::string_view key = name;
    if (key == "evaluation") found.evaluation = value;
    else if (key == "triangulation") found.triangulation = value;
    else if (key == "flip_inward") found.flip_inward = flag_of(value, key);
    else if (key == "allow_invalid_quads") found.allow_invalid_quads = flag_of(value, key);
    else if (key == "threads") found.threads = number_of(value, key);
    else if (key == "digits") found.digits = number_of(value, key);
    else found.parameters.emplace_back(name, value);
  }
  return found;
}

void require_names(std::span<const cageproof_option> options, std::initializer_list<std::string_view> taken) {
  for (const cageproof_option& option : options) {
    require(option.name, "an option's name");
    if (std::ranges::find(taken, std::string_view(option.name)) == taken.end())
      throw InputError(
          fmt::format("option {}: no such option here; there are {}", option.name, fmt::join(taken, ", ")));
  }
}

}  // namespace cageproof::library::c

extern "C" {

int cageproof_abi_version(void) { return CAGEPROOF_ABI_VERSION; }

const char* cageproof_error(void) { return cageproof::library::c::last_error.shown; }
}
