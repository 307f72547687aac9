// SPDX-License-Identifier: MIT
#include "cageproof/reports/checked_file.h"

#include "aside.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace cageproof::reports {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw InputError(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(errno)));
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

// \param named what messages call it
void write_as(const std::filesystem::path& path, const std::filesystem::path& named, std::string_view bytes) {
  File file(std::fopen(path.c_str(), "wb"));
  if (!file) fail(named);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail(named);
  // A full disk may show only when the last buffer leaves.
  if (std::fclose(file.release()) != 0) fail(named);
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) { write_as(path, path, bytes); }

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  remove_leftovers(path);
  const std::filesystem::path fresh = aside(path, 0);
  std::error_code ignored;
  try {
    write_as(fresh, path, bytes);
  } catch (const InputError&) {
    std::filesystem::remove(fresh, ignored);
    throw;
  }
  if (std::rename(fresh.c_str(), path.c_str()) == 0) return;
  const int reason = errno;
  std::filesystem::remove(fresh, ignored);
  errno = reason;
  fail(path);
}

}  // namespace cageproof::reports
