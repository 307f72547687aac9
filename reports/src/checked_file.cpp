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

[[noreturn]] void fail(const char* action, const std::filesystem::path& path) {
  throw InputError(fmt::format("cannot {} {}: {}", action, path.string(), std::generic_category().message(errno)));
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  File file(std::fopen(path.c_str(), "wb"));
  if (!file) fail("write", path);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail("write", path);
  // A full disk may show only when the last buffer leaves.
  if (std::fclose(file.release()) != 0) fail("write", path);
}

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  remove_leftovers(path);
  const std::filesystem::path fresh = aside(path, 0);
  std::error_code ignored;
  try {
    write_file(fresh, bytes);
  } catch (const InputError&) {
    std::filesystem::remove(fresh, ignored);
    throw;
  }
  if (std::rename(fresh.c_str(), path.c_str()) == 0) return;
  const int reason = errno;
  std::filesystem::remove(fresh, ignored);
  errno = reason;
  fail("write", path);
}

std::string read_file(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) fail("read", path);
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) bytes.append(buffer, n);
  if (std::ferror(file.get())) fail("read", path);
  return bytes;
}

}  // namespace cageproof::reports
