// SPDX-License-Identifier: MIT
#include "cageproof/core/whole_file.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace cageproof {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw InputError(fmt::format("cannot read {}: {}", path.string(), std::generic_category().message(errno)));
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) fail(path);
  std::string bytes;
  char buffer[1 << 16];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) bytes.append(buffer, n);
  if (std::ferror(file.get())) fail(path);
  return bytes;
}

}  // namespace cageproof
