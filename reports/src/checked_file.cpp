// SPDX-License-Identifier: MIT
#include "cageproof/reports/checked_file.h"

#include "aside.h"
#include "aside_notes.h"

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

void replace_files(const std::vector<std::pair<std::filesystem::path, std::string>>& files) {
  for (const auto& [path, bytes] : files) remove_leftovers(path);
  std::vector<std::unique_ptr<AsideNote>> notes;
  for (std::size_t i = 0; i < files.size(); ++i)
    notes.push_back(std::make_unique<AsideNote>(aside(files[i].first, static_cast<int>(i))));
  std::size_t written = 0;
  const auto remove_fresh = [&](std::size_t first) {
    std::error_code ignored;
    for (std::size_t i = first; i < written; ++i)
      std::filesystem::remove(aside(files[i].first, static_cast<int>(i)), ignored);
  };
  try {
    for (const auto& [path, bytes] : files) {
      const std::filesystem::path fresh = aside(path, static_cast<int>(written));
      ++written;
      write_as(fresh, path, bytes);
      // A folder of that name is found before anything is renamed.
      std::error_code ignored;
      const bool in_the_way = std::filesystem::is_directory(path, ignored);
      errno = EISDIR;
      if (in_the_way) fail(path);
    }
  } catch (const InputError&) {
    remove_fresh(0);
    throw;
  }
  const auto lock = undisturbed();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (std::rename(aside(files[i].first, static_cast<int>(i)).c_str(), files[i].first.c_str()) == 0) continue;
    const int reason = errno;
    remove_fresh(i);
    errno = reason;
    fail(files[i].first);
  }
}

void replace_file(const std::filesystem::path& path, std::string_view bytes) {
  replace_files({{path, std::string(bytes)}});
}

}  // namespace cageproof::reports
