// SPDX-License-Identifier: MIT
#include "cageproof/reports/checked_file.h"

#include "aside.h"
#include "aside_notes.h"

#include "cageproof/core/input_error.h"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>

namespace cageproof::reports {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path) {
  throw InputError(fmt::format("cannot write {}: {}", path.string(), std::generic_category().message(errno)));
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

// \param named what messages call it
void write_to(File file, const fs::path& named, std::string_view bytes) {
  if (!file) fail(named);
  if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail(named);
  // A full disk may show only when the last buffer leaves.
  if (std::fclose(file.release()) != 0) fail(named);
}

// The open file that a path as /dev/stdout, /dev/fd/3 or /proc/self/fd/3 names.
std::optional<int> descriptor_of(const fs::path& path) {
  const std::string text = path.lexically_normal().string();
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    int number = 0;
    if (!text.starts_with(folder)) continue;
    const auto [end, error] = std::from_chars(text.data() + folder.size(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size()) return number;
  }
  return std::nullopt;
}

// Where bytes go.
struct Target {
  fs::path path;
  bool direct = false;            // a device, a pipe or an open file: nothing can be renamed in its place
  std::optional<int> descriptor;  // of an open file

  File opened() const {
    if (!descriptor) return File(std::fopen(path.c_str(), "wb"));
    // Another one of the same open file: what follows goes on behind what is written here.
    const int same = ::dup(*descriptor);
    return File(same < 0 ? nullptr : ::fdopen(same, "wb"));
  }
};

// Where a link leads, if need be to a file that does not exist yet: whoever made the link wants it kept.
Target target_of(const fs::path& named) {
  std::error_code error;
  fs::path path = named;
  for (int links = 0; !descriptor_of(path) && fs::is_symlink(path, error); ++links) {
    errno = ELOOP;
    if (links == 40) fail(named);
    const fs::path next = fs::read_symlink(path, error);
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  if (const auto descriptor = descriptor_of(path)) return {path, true, descriptor};
  const fs::file_type type = fs::status(path, error).type();
  const bool special = type == fs::file_type::character || type == fs::file_type::fifo ||
                       type == fs::file_type::block || type == fs::file_type::socket;
  return {path, special, std::nullopt};
}

std::vector<Target> targets_of(const std::vector<fs::path>& paths) {
  std::vector<Target> targets;
  for (const fs::path& path : paths) {
    targets.push_back(target_of(path));
    const auto place = [](const Target& target) { return fs::absolute(target.path).lexically_normal(); };
    for (std::size_t i = 0; i + 1 < targets.size(); ++i)
      if (!targets[i].direct && place(targets[i]) == place(targets.back()))
        throw InputError(fmt::format("cannot write {} and {}: they are the same file, {}", paths[i].string(),
                                     path.string(), targets[i].path.string()));
  }
  return targets;
}

}  // namespace

void write_file(const fs::path& path, std::string_view bytes) {
  write_to(File(std::fopen(path.c_str(), "wb")), path, bytes);
}

void require_writable(const std::vector<fs::path>& paths) {
  const std::vector<Target> targets = targets_of(paths);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const Target& target = targets[i];
    if (target.descriptor) continue;
    std::error_code reason;
    if (fs::is_directory(target.path, reason)) {
      errno = EISDIR;
      fail(paths[i]);
    }
    const fs::path parent = target.path.has_parent_path() ? target.path.parent_path() : fs::path(".");
    if (fs::status(parent, reason).type() == fs::file_type::not_found)
      throw InputError(
          fmt::format("cannot write {}: the folder {} does not exist", paths[i].string(), parent.string()));
    if (!target.direct && fs::exists(parent, reason) && !fs::is_directory(parent, reason))
      throw InputError(fmt::format("cannot write {}: {} is no folder", paths[i].string(), parent.string()));
    if (::access((target.direct ? target.path : parent).c_str(), target.direct ? W_OK : W_OK | X_OK) != 0)
      fail(paths[i]);
  }
}

void replace_files(const std::vector<std::pair<fs::path, std::string>>& files) {
  std::vector<fs::path> paths;
  paths.reserve(files.size());
  for (const auto& [path, bytes] : files) paths.push_back(path);
  const std::vector<Target> targets = targets_of(paths);
  const auto fresh = [&](std::size_t i) { return aside(targets[i].path, static_cast<int>(i)); };
  std::vector<std::unique_ptr<AsideNote>> notes;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (targets[i].direct) continue;
    remove_leftovers(targets[i].path);
    notes.push_back(std::make_unique<AsideNote>(fresh(i)));
  }
  std::size_t written = 0;
  const auto remove_fresh = [&](std::size_t first) {
    std::error_code ignored;
    for (std::size_t i = first; i < written; ++i)
      if (!targets[i].direct) fs::remove(fresh(i), ignored);
  };
  try {
    for (; written < files.size();) {
      const std::size_t i = written++;
      if (targets[i].direct) continue;
      write_to(File(std::fopen(fresh(i).c_str(), "wb")), paths[i], files[i].second);
      // A folder of that name is found before anything is renamed.
      std::error_code ignored;
      if (fs::is_directory(targets[i].path, ignored)) {
        errno = EISDIR;
        fail(paths[i]);
      }
    }
  } catch (const InputError&) {
    remove_fresh(0);
    throw;
  }
  {
    const auto lock = undisturbed();
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (targets[i].direct || std::rename(fresh(i).c_str(), targets[i].path.c_str()) == 0) continue;
      const int reason = errno;
      remove_fresh(i);
      errno = reason;
      fail(paths[i]);
    }
  }
  // Last, since what a device or a pipe was given cannot be taken back.
  for (std::size_t i = 0; i < files.size(); ++i)
    if (targets[i].direct) write_to(targets[i].opened(), paths[i], files[i].second);
}

void replace_file(const fs::path& path, std::string_view bytes) { replace_files({{path, std::string(bytes)}}); }

}  // namespace cageproof::reports
