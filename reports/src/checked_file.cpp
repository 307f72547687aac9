// SPDX-License-Identifier: MIT
#include "cageproof/reports/checked_file.h"

#include "aside.h"
#include "aside_notes.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace cageproof::reports {

namespace fs = std::filesystem;

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

// A device or a pipe: nothing can be renamed in its place.
bool is_special(const fs::path& path) {
  std::error_code ignored;
  const fs::file_type type = fs::status(path, ignored).type();
  return type == fs::file_type::character || type == fs::file_type::fifo || type == fs::file_type::block ||
         type == fs::file_type::socket;
}

// Where a link leads, if need be to a file that does not exist yet: whoever made the link wants it kept.
fs::path target_of(fs::path path) {
  std::error_code error;
  for (int links = 0; links < 40 && fs::is_symlink(path, error) && !is_special(path); ++links) {
    const fs::path next = fs::read_symlink(path, error);
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) { write_as(path, path, bytes); }

void require_writable(const fs::path& path) {
  const fs::path target = target_of(path);
  std::error_code ignored;
  errno = EISDIR;
  if (fs::is_directory(target, ignored)) fail(path);
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(parent, ignored))
    throw InputError(fmt::format("cannot write {}: the folder {} does not exist", path.string(), parent.string()));
  if (::access((is_special(target) ? target : parent).c_str(), W_OK) != 0) fail(path);
}

void replace_files(const std::vector<std::pair<fs::path, std::string>>& files) {
  std::vector<fs::path> targets;
  for (const auto& [path, bytes] : files) targets.push_back(target_of(path));
  for (const fs::path& target : targets) remove_leftovers(target);
  const auto fresh = [&](std::size_t i) { return aside(targets[i], static_cast<int>(i)); };
  std::vector<std::unique_ptr<AsideNote>> notes;
  for (std::size_t i = 0; i < files.size(); ++i) notes.push_back(std::make_unique<AsideNote>(fresh(i)));
  std::size_t written = 0;
  const auto remove_fresh = [&](std::size_t first) {
    std::error_code ignored;
    for (std::size_t i = first; i < written; ++i)
      if (!is_special(targets[i])) fs::remove(fresh(i), ignored);
  };
  try {
    for (const auto& [path, bytes] : files) {
      // What is no file of a folder, as /dev/stdout, takes its bytes where it is.
      const bool direct = is_special(targets[written]);
      const fs::path place = direct ? targets[written] : fresh(written);
      ++written;
      write_as(place, path, bytes);
      // A folder of that name is found before anything is renamed.
      std::error_code ignored;
      const bool in_the_way = fs::is_directory(targets[written - 1], ignored);
      errno = EISDIR;
      if (in_the_way) fail(path);
    }
  } catch (const InputError&) {
    remove_fresh(0);
    throw;
  }
  const auto lock = undisturbed();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (is_special(targets[i]) || std::rename(fresh(i).c_str(), targets[i].c_str()) == 0) continue;
    const int reason = errno;
    remove_fresh(i);
    errno = reason;
    fail(files[i].first);
  }
}

void replace_file(const fs::path& path, std::string_view bytes) { replace_files({{path, std::string(bytes)}}); }

}  // namespace cageproof::reports
